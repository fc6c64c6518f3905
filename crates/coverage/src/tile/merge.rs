//! Merging summaries.

use super::ends::{around, compare_edges};
use super::error::MergeError;
use super::fault::{SeamFault, SeamRule};
use super::grid::Tile;
use super::summary::{Border, Contact, Joins, Summary};
use crate::Limits;
use core::cmp::Ordering;
use std::collections::BTreeMap;
use twinedge_geometry::Point;

impl Summary {
    /// Merges two summaries of different tiles, which may be far apart. O(n log n) for the listed records of both, expected.
    ///
    /// ```
    /// use twinedge_coverage::Limits;
    /// use twinedge_map::{Feature, Shape};
    /// use twinedge_coverage::tile::{Cuts, Grid, MergeError, Summary};
    ///
    /// let grid = Grid::new([0.0, 0.0], [2.0, 1.0], 2, 1)?;
    /// let square = Shape::polygon([[0.5, 0.0], [1.5, 0.0], [1.5, 1.0], [0.5, 1.0]]);
    /// let pieces = Cuts::new(2.0)?.pieces(&grid, 0, &Feature { shapes: vec![square], ..Feature::default() })?;
    /// let limits = Limits::default();
    /// let halves: Vec<Summary> = grid.tiles().map(|tile| Summary::new(&grid, tile, &pieces, &limits).unwrap()).collect();
    /// assert_eq!(halves[0].contact_count(), 2);
    /// let whole = halves[0].clone().merge(halves[1].clone())?;
    /// assert_eq!(whole.contact_count(), 0);
    /// assert!(matches!(whole.merge(halves[1].clone()), Err(MergeError::Twice(_))));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`MergeError`].
    pub fn merge(self, other: Self) -> Result<Self, MergeError> {
        self.belongs_to(&other)?;
        let mut both = beside(self, other);
        let mut joins = Joins::new(&both);
        let mut open: BTreeMap<[Tile; 2], Border> = BTreeMap::new();
        for border in core::mem::take(&mut both.borders) {
            match open.remove(&[border.beyond, border.tile]) {
                Some(there) if there.tile < border.tile => both.join(&there, &border, &mut joins),
                Some(there) => both.join(&border, &there, &mut joins),
                None => drop(open.insert([border.tile, border.beyond], border)),
            }
        }
        both.borders = open.into_values().collect();
        Ok(both.settled(&mut joins))
    }

    /// Checks that both have one grid and the same limits, and no tile in common.
    pub(super) fn belongs_to(&self, other: &Self) -> Result<(), MergeError> {
        let all = [self, other].map(|one| {
            let Limits { gap_width, lake_width, sliver_area, thinness, accepted_gaps } = &one.limits;
            let points =
                |points: &[Point]| points.iter().map(|p| format!("({}, {})", p.x, p.y)).collect::<Vec<_>>().join(" ");
            let number = |limit: &Option<f64>| limit.map_or_else(|| "none".to_owned(), |limit| limit.to_string());
            [
                ("the grid", one.grid.to_string()),
                ("gap_width", number(gap_width)),
                ("lake_width", number(lake_width)),
                ("sliver_area", number(sliver_area)),
                ("thinness", thinness.to_string()),
                ("accepted_gaps", points(accepted_gaps)),
            ]
        });
        let [ones, others] = all;
        if let Some((one, other)) = ones.into_iter().zip(others).find(|(one, other)| one != other) {
            return Err(MergeError::Different { what: one.0.to_owned(), one: one.1, other: other.1 });
        }
        if self.grid != other.grid {
            let other = format!("another of {}", other.grid);
            return Err(MergeError::Different { what: "the grid".to_owned(), one: self.grid.to_string(), other });
        }
        match self.tiles.iter().find(|tile| other.tiles.binary_search(tile).is_ok()) {
            Some(tile) => Err(MergeError::Twice(*tile)),
            None => Ok(()),
        }
    }
}

/// Concatenates both, with the records of the second renumbered to follow the records of the first.
fn beside(mut one: Summary, mut other: Summary) -> Summary {
    let [faces, components, cycles, regions, claimed] =
        [one.faces.len(), one.components.len(), one.cycles.len(), one.regions.len(), one.claimed.len()]
            .map(|count| count as u32);
    for border in &mut other.borders {
        border.faces.iter_mut().for_each(|face| *face += faces);
        for contact in &mut border.contacts {
            contact.component += components;
            contact.cycles = contact.cycles.map(|cycle| cycle + cycles);
        }
    }
    other.cycles.iter_mut().for_each(|component| *component += components);
    other.claimed.iter_mut().filter_map(|one| one.like.as_mut()).for_each(|like| *like += claimed);
    other.faces.iter_mut().flat_map(|face| &mut face.regions).for_each(|region| *region += regions);
    one.tiles.append(&mut other.tiles);
    one.corners = around([one.corners, other.corners].into_iter().flatten().flatten());
    one.borders.append(&mut other.borders);
    one.faces.append(&mut other.faces);
    one.components.append(&mut other.components);
    one.cycles.append(&mut other.cycles);
    one.regions.append(&mut other.regions);
    one.closed.append(&mut other.closed);
    one.slivers.append(&mut other.slivers);
    one.lengths.append(&mut other.lengths);
    one.areas.append(&mut other.areas);
    one.claimed.append(&mut other.claimed);
    for (exponent, edges) in other.extents {
        one.count_edges(exponent, edges);
    }
    one.absent.append(&mut other.absent);
    one.defects.append(&mut other.defects);
    one.unmatched.append(&mut other.unmatched);
    one.crossings.append(&mut other.crossings);
    one.uneven.append(&mut other.uneven);
    one.seams.append(&mut other.seams);
    one.plane_seams.append(&mut other.plane_seams);
    one.totals.add(&other.totals);
    one.is_plane &= other.is_plane;
    one
}

impl Summary {
    /// Joins the records on both sides of a border.
    fn join(&mut self, here: &Border, there: &Border, joins: &mut Joins) {
        let fault = |rule, border: &Border, contact: Option<&&Contact>| SeamFault {
            rule,
            tile: border.tile,
            beyond: border.beyond,
            edge: contact.map(|contact| contact.edge),
        };
        let is_same = |a: &Contact, b: &Contact| compare_edges(&a.edge, &b.edge).is_eq();
        let [these, those] = [here, there].map(sorted);
        let (mut i, mut j) = (0, 0);
        let mut is_matched = true;
        loop {
            let (a, b) = (these.get(i), those.get(j));
            let order = match (a, b) {
                (None, None) => break,
                (Some(_), None) => Ordering::Less,
                (None, Some(_)) => Ordering::Greater,
                (Some(a), Some(b)) => compare_edges(&a.edge, &b.edge),
            };
            match (order, a, b) {
                (Ordering::Equal, Some(a), Some(b)) => {
                    joins.components.union(a.component, b.component);
                    for way in 0..2 {
                        joins.cycles.union(a.cycles[way], b.cycles[way]);
                    }
                    if a.features != b.features {
                        self.seams.push(fault(SeamRule::Features, here, Some(a)));
                    }
                }
                (Ordering::Less, ..) => self.seams.push(fault(SeamRule::Contact, here, a)),
                _ => self.seams.push(fault(SeamRule::Contact, there, b)),
            }
            is_matched &= order.is_eq();
            i += usize::from(order.is_le());
            j += usize::from(order.is_ge());
        }
        if !self.is_plane || !is_matched {
            return;
        }
        let mut pairs = here.contacts.iter().zip(&there.contacts);
        if let Some((a, _)) = pairs.find(|(a, b)| !is_same(a, b)) {
            self.plane_seams.push(fault(SeamRule::Order, here, Some(&a)));
            return;
        }
        let before = [None].into_iter().chain(here.contacts.iter().map(Some));
        for ((a, b), contact) in here.faces.iter().zip(&there.faces).zip(before) {
            let [one, other] = [a, b].map(|face| &self.faces[*face as usize]);
            if one.features == other.features {
                joins.faces.union(*a, *b);
                for (region, same) in one.regions.iter().zip(&other.regions) {
                    joins.regions.union(*region, *same);
                }
            } else {
                self.plane_seams.push(fault(SeamRule::Features, here, contact.as_ref()));
            }
        }
    }
}

/// Returns the contacts in order of their edges.
fn sorted(border: &Border) -> Vec<&Contact> {
    let mut contacts: Vec<&Contact> = border.contacts.iter().collect();
    contacts.sort_by(|a, b| compare_edges(&a.edge, &b.edge));
    contacts
}
