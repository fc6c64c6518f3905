//! The summary of one tile, from the pieces of features in it.

use super::NIL;
use super::bounds::{is_left_of, is_under};
use super::claimed::{Claimed, compare};
use super::cuts::Cuts;
use super::ends::around;
use super::error::TileError;
use super::faces::Faces;
use super::grid::{Grid, Tile};
use super::large::least_areas;
use super::local::{Cycles, Local};
use super::piece::{self, Piece};
use super::region::{Claim, Region};
use super::side::Side;
use super::summary::{Border, Component, Contact, Joins, Summary};
use crate::Limits;
use petgraph::unionfind::UnionFind;
use twinedge_geometry::Point;
use twinedge_map::{BuildError, Builder, Feature, FeatureId, Shape, UnmatchedVertex};

impl Summary {
    /// Creates the summary of a tile from its pieces of features, as [`Cuts::pieces`] returns them; pieces of other tiles have no effect.
    ///
    /// O(n log n) for the pieces.
    ///
    /// # Errors
    /// [`TileError`].
    pub fn new<'p>(
        grid: &Grid,
        tile: Tile,
        pieces: impl IntoIterator<Item = &'p Piece>,
        limits: &Limits,
    ) -> Result<Self, TileError> {
        let pieces = sorted(grid, tile, pieces)?;
        let local = Local::new(&pieces, grid.bounds(tile), None)?;
        let mut summary = Self::of_pieces(grid, tile, limits, &pieces);
        for piece in &pieces {
            let Some(whole) = &piece.whole else { continue };
            summary.corners = around([summary.corners, whole.corners].into_iter().flatten().flatten());
            if whole.corners.is_none() {
                summary.absent.push((piece.feature, whole.unreadable.clone()));
            }
            if !whole.defects.is_empty() {
                summary.defects.push((piece.feature, whole.defects.clone()));
            }
            for (exponent, edges) in &whole.extents {
                summary.count_edges(*exponent, *edges);
            }
        }
        summary.crossings = local.crossings();
        let traced = local.trace();
        let faces = local.is_plane.then(|| Faces::new(&local, &traced));
        Ok(local.summarize(tile, summary, &traced, faces.as_ref()))
    }

    /// Creates the summary of a tile whose edges are cut where they meet, by complete [`Cuts`]. The summary has no defects (C6), which
    /// belong to the input, but has the unmatched vertices (C7). If a tile was left out of a round of cuts, edges still meet other than
    /// at vertices there.
    ///
    /// O(n log n) for the pieces.
    ///
    /// # Errors
    /// [`TileError`]; with [`BuildError::OutOfReach`](twinedge_map::BuildError::OutOfReach) for larger coordinates.
    pub fn cut<'p>(
        grid: &Grid,
        tile: Tile,
        pieces: impl IntoIterator<Item = &'p Piece>,
        limits: &Limits,
        cuts: &Cuts,
    ) -> Result<Self, TileError> {
        let pieces = sorted(grid, tile, pieces)?;
        cuts.check(pieces.iter().flat_map(|piece| piece.chains()).flatten().copied())?;
        let local = Local::new(&pieces, grid.bounds(tile), Some(cuts))?;
        let mut summary = Self::of_pieces(grid, tile, limits, &pieces);
        summary.crossings = local.crossings();
        let traced = local.trace();
        let faces = local.is_plane.then(|| Faces::new(&local, &traced));
        if let Some(faces) = &faces {
            let overlap = |one: &UnmatchedVertex| {
                let pair = [one.of, one.lacked_by].map(|feature| feature.index() as u32);
                let point = local.number(cuts.snapped(one.at));
                point.is_some_and(|point| faces.around(&local, point).any(|face| face.is_shared_by(pair)))
            };
            summary.unmatched = unmatched(&pieces)?;
            // A vertex belongs to the tile in which it is once it was moved.
            summary.unmatched.retain(|one| local.bounds.contains(cuts.snapped(one.at)) && !overlap(one));
        }
        Ok(local.summarize(tile, summary, &traced, faces.as_ref()))
    }
}

/// Returns the pieces of a tile, by their features.
fn sorted<'p>(
    grid: &Grid,
    tile: Tile,
    pieces: impl IntoIterator<Item = &'p Piece>,
) -> Result<Vec<&'p Piece>, TileError> {
    let mut pieces = piece::of_tile(grid, tile, pieces)?;
    pieces.sort_by_key(|piece| piece.feature);
    match pieces.windows(2).find(|pair| pair[0].feature == pair[1].feature) {
        Some(pair) => Err(TileError::SameNumber(pair[0].feature)),
        None => Ok(pieces),
    }
}

/// Returns the unmatched vertices of pieces that are not cut.
fn unmatched(pieces: &[&Piece]) -> Result<Vec<UnmatchedVertex>, BuildError> {
    let mut builder = Builder::new();
    for piece in pieces {
        // Only vertices and edges matter, so a chain there and back stands for its part of a ring.
        let there_and_back = |chain: &Vec<Point>| chain.iter().chain(chain.iter().rev()).copied().collect();
        let polygons = piece.parts.iter().filter(|part| part.is_polygon);
        let shapes = polygons.map(|part| Shape::Polygon(part.chains.iter().map(there_and_back).collect())).collect();
        builder.feature(&Feature { shapes, ..Feature::default() })?;
    }
    let in_whole = |mut one: UnmatchedVertex| {
        for feature in [&mut one.of, &mut one.lacked_by] {
            *feature = FeatureId::new(pieces[feature.index()].feature);
        }
        one
    };
    Ok(builder.unmatched().into_iter().map(in_whole).collect())
}

impl Summary {
    /// Creates a summary of a tile that knows only which features it has pieces of.
    fn of_pieces(grid: &Grid, tile: Tile, limits: &Limits, pieces: &[&Piece]) -> Self {
        let claimed = |piece: &&Piece| {
            let Piece { feature, first, of, .. } = **piece;
            Claimed { feature, first, of, like: None, seen: 1 }
        };
        let claimed = pieces.iter().map(claimed).collect();
        Self { tiles: vec![tile], claimed, ..Self::empty(grid.clone(), limits.clone()) }
    }
}

impl Local {
    /// Counts records inside the tile, and lists records cut by the border.
    fn summarize(&self, tile: Tile, mut summary: Summary, traced: &Cycles, faces: Option<&Faces>) -> Summary {
        let Cycles { leaves, closed } = traced;
        // Edges first, then points.
        let edges = self.segments.len();
        let mut sets = UnionFind::new(edges + self.points.len());
        let mut components = vec![Component::default(); edges + self.points.len()];
        for (point, _) in self.inside() {
            for h in self.leaving(point) {
                sets.union(h >> 1, edges as u32 + point);
            }
        }
        for (point, at) in self.inside() {
            let root = sets.find_mut(edges as u32 + point) as usize;
            components[root].add(&Component { vertices: 1, least: Some(at), ..Component::default() });
        }
        for (number, segment) in (0..).zip(&self.segments) {
            let root = sets.find_mut(number) as usize;
            components[root].edges += u64::from(self.bounds.contains(segment.ends[0]));
        }
        for start in closed {
            components[sets.find_mut(start >> 1) as usize].cycles += 1;
        }
        let mut number_of = vec![NIL; components.len()];
        for (_, segment, _) in &self.contacts {
            let root = sets.find_mut(*segment) as usize;
            if number_of[root] == NIL {
                number_of[root] = summary.components.len() as u32;
                summary.components.push(components[root]);
            }
        }
        for root in 0..components.len() {
            let component = &components[root];
            if sets.find_mut(root as u32) as usize == root && number_of[root] == NIL && component.vertices > 0 {
                summary.close(component);
            }
        }
        // A cycle has the number of the contact where it enters.
        let mut enters = vec![0; leaves.len()];
        for (enter, leave) in (0..).zip(leaves) {
            enters[*leave as usize] = enter;
        }
        let mut component_of = |segment: u32| number_of[sets.find_mut(segment) as usize];
        summary.cycles = self.contacts.iter().map(|(_, segment, _)| component_of(*segment)).collect();
        let contact = |number: usize| {
            let (_, segment, is_entry) = self.contacts[number];
            let cycles = [number as u32, enters[number]];
            Contact {
                edge: self.segments[segment as usize].ends,
                features: self.features_along(segment),
                component: component_of(segment),
                cycles: if is_entry { cycles } else { [cycles[1], cycles[0]] },
            }
        };
        summary.borders = self.borders(&summary.grid, tile, faces, contact);
        summary.is_plane = faces.is_some();
        let mut joins = match faces {
            Some(faces) => self.claim(faces, &mut summary),
            None => Joins::new(&summary),
        };
        summary.settled(&mut joins)
    }

    /// Returns the borders with the tiles around, each a stretch of a side.
    fn borders(
        &self,
        grid: &Grid,
        tile: Tile,
        faces: Option<&Faces>,
        mut contact: impl FnMut(usize) -> Contact,
    ) -> Vec<Border> {
        let mut borders = Vec::new();
        let mut first = 0;
        for side in Side::ALL {
            let count = self.contacts[first..].iter().take_while(|contact| contact.0 == side).count();
            let of_side = first..first + count;
            first += count;
            let beyond = grid.beyond(tile, side);
            if beyond.is_empty() {
                continue;
            }
            // The corners between the tiles beyond, and the number of them before each contact.
            let corners: Vec<Point> = beyond.iter().skip(1).map(|tile| grid.bounds(*tile).low).collect();
            let passed = |number: usize| {
                let ends = self.segments[self.contacts[number].1 as usize].ends;
                let line = match side {
                    Side::Left => self.bounds.low.x,
                    Side::Right => self.bounds.high.x,
                    Side::Bottom => self.bounds.low.y,
                    Side::Top => self.bounds.high.y,
                };
                let is_passed = |corner: &Point| {
                    if side.is_upright() { !is_under(ends, line, corner.y) } else { !is_left_of(ends, corner.x, line) }
                };
                corners.partition_point(is_passed)
            };
            let is_reversed = matches!(side, Side::Top | Side::Left);
            let mut of_others: Vec<Vec<usize>> = vec![Vec::new(); beyond.len()];
            for number in of_side {
                of_others[passed(number)].push(number);
            }
            // Counter-clockwise, as contacts are.
            let mut from = first - count;
            let mut stretches: Vec<(Tile, Vec<usize>)> = beyond.into_iter().zip(of_others).collect();
            if is_reversed {
                stretches.reverse();
            }
            for (other, of_other) in stretches {
                // Where faces are unknown, contacts are in no order.
                let along = from..from + of_other.len();
                from = along.end;
                let mut border = Border {
                    tile,
                    beyond: other,
                    contacts: of_other.into_iter().map(&mut contact).collect(),
                    faces: faces.map(|faces| faces.along(along)).unwrap_or_default(),
                };
                if is_reversed {
                    border.contacts.reverse();
                    border.faces.reverse();
                }
                borders.push(border);
            }
        }
        borders
    }

    /// Finds the regions of the faces, and joins equal ones.
    fn claim(&self, faces: &Faces, summary: &mut Summary) -> Joins {
        let mut regions = Vec::new();
        let mut all = faces.all.clone();
        let mut covered = vec![Vec::new(); summary.claimed.len()];
        for (number, face) in (0..).zip(&mut all) {
            for claim in Claim::all(&face.features) {
                face.regions.push(regions.len() as u32);
                regions.push(Region { is_unbounded: face.is_unbounded, ..Region::new(claim) });
            }
            for feature in &face.features {
                if let Ok(place) = summary.claimed.binary_search_by_key(feature, |one| one.feature) {
                    covered[place].push(number);
                }
            }
        }
        compare(&mut summary.claimed, covered);
        for (number, segment) in (0..).zip(&self.segments) {
            if !self.bounds.contains(segment.ends[0]) {
                continue;
            }
            let [left, right] = faces.beside(number).map(|part| &all[part as usize]);
            for region in left.regions.iter().chain(&right.regions) {
                regions[*region as usize].put(segment.ends, [&left.features, &right.features]);
            }
            if summary.limits.gap_width.is_none() {
                let [a, b] = segment.ends;
                summary.lengths.push((b.x - a.x).hypot(b.y - a.y));
            }
        }
        if let Some(limit) = summary.limits.sliver_area {
            for (face, _) in all.iter().zip(least_areas(self, faces)).filter(|(_, area)| *area > 2.0 * limit) {
                for region in &face.regions {
                    let region = &mut regions[*region as usize];
                    region.is_large = matches!(region.claim, Claim::Part(_));
                }
            }
        }
        (summary.faces, summary.regions) = (all, regions);
        let mut joins = Joins::new(summary);
        for segment in 0..self.segments.len() as u32 {
            let [left, right] = faces.beside(segment).map(|part| &summary.faces[part as usize]);
            let claim = |region: u32| &summary.regions[region as usize].claim;
            let (mut left, mut right) = (&left.regions[..], &right.regions[..]);
            // Both are in order of their claims.
            while let ([one, rest @ ..], [other, others @ ..]) = (left, right) {
                let order = claim(*one).cmp(claim(*other));
                if order.is_eq() {
                    joins.regions.union(*one, *other);
                }
                left = if order.is_le() { rest } else { left };
                right = if order.is_ge() { others } else { right };
            }
        }
        joins
    }
}
