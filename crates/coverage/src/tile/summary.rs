//! The combined data of some tiles.

use super::NIL;
use super::claimed::{Claimed, add_up};
use super::ends::{Ends, compare_edges, compare_points};
use super::fault::{Crossing, SeamFault, Uneven};
use super::grid::{Grid, Tile};
use super::region::{Claim, Region, Sliver, examined};
use crate::{Defect, Limits};
use core::cmp::Ordering;
use petgraph::unionfind::UnionFind;
use twinedge_geometry::Point;
use twinedge_map::UnmatchedVertex;

/// The summary of one tile, or of several merged tiles: records wholly inside are counted, and records cut by the border are
/// listed, so that they can be joined with the records on the other side.
///
/// Equal tiles have equal summaries, independent of the order of merging.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(remote = "Self"))]
pub struct Summary {
    pub(super) grid: Grid,
    pub(super) limits: Limits,
    /// Sorted.
    pub(super) tiles: Vec<Tile>,
    /// The corners of the box around the features whose first tile it has.
    pub(super) corners: Option<[Point; 2]>,
    pub(super) totals: Totals,
    /// The borders with tiles not yet merged, in order of both tiles.
    pub(super) borders: Vec<Border>,
    /// The parts of faces, the components and the cycles that some border cuts, numbered as the borders first name them.
    pub(super) faces: Vec<Face>,
    pub(super) components: Vec<Component>,
    pub(super) cycles: Vec<u32>,
    pub(super) regions: Vec<Region>,
    /// The unclaimed regions and the overlaps that no border cuts.
    pub(super) closed: Vec<Region>,
    /// The parts of features that are thin and, if the area of slivers is given, small.
    pub(super) slivers: Vec<Sliver>,
    /// The lengths of all edges, and the areas of all parts, in order, as far as limits are chosen by them.
    pub(super) lengths: Vec<f64>,
    pub(super) areas: Vec<f64>,
    pub(super) claimed: Vec<Claimed>,
    /// The [`Outcome`](super::Outcome)'s extents, for the features whose first tile it has.
    pub(super) extents: Vec<(u16, u64)>,
    /// The features without points, and the reason if a geometry could not be read.
    pub(super) absent: Vec<(u32, Option<String>)>,
    /// The features whose shapes are invalid by the rules of the OGC (C6).
    pub(super) defects: Vec<(u32, Vec<Defect>)>,
    /// The unmatched vertices (C7), if edges were cut.
    pub(super) unmatched: Vec<UnmatchedVertex>,
    /// False if edges seen so far meet other than at shared endpoints. Faces are unknown then.
    pub(super) is_plane: bool,
    pub(super) crossings: Vec<Crossing>,
    pub(super) uneven: Vec<Uneven>,
    pub(super) seams: Vec<SeamFault>,
    /// The faults of faces and of the order of contacts, which only plane maps have.
    pub(super) plane_seams: Vec<SeamFault>,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Totals {
    pub(super) vertices: u64,
    pub(super) edges: u64,
    pub(super) cycles: u64,
    pub(super) components: u64,
    pub(super) isolated_vertices: u64,
    pub(super) faces: u64,
    pub(super) unbounded_faces: u64,
}

/// The largest sum. No real map comes near it; sums from a forged file saturate.
pub(super) const MOST: u64 = 1 << 53;

fn sum(a: u64, b: u64) -> u64 {
    a.saturating_add(b).min(MOST)
}

impl Totals {
    const NOTHING: Self =
        Self { vertices: 0, edges: 0, cycles: 0, components: 0, isolated_vertices: 0, faces: 0, unbounded_faces: 0 };

    /// Returns true if no number exceeds the largest sum.
    #[cfg(feature = "serde")]
    pub(super) fn is_in_range(&self) -> bool {
        let Self { vertices, edges, cycles, components, isolated_vertices, faces, unbounded_faces } = *self;
        [vertices, edges, cycles, components, isolated_vertices, faces, unbounded_faces].iter().all(|n| *n <= MOST)
    }

    pub(super) fn add(&mut self, other: &Self) {
        *self = Self {
            vertices: sum(self.vertices, other.vertices),
            edges: sum(self.edges, other.edges),
            cycles: sum(self.cycles, other.cycles),
            components: sum(self.components, other.components),
            isolated_vertices: sum(self.isolated_vertices, other.isolated_vertices),
            faces: sum(self.faces, other.faces),
            unbounded_faces: sum(self.unbounded_faces, other.unbounded_faces),
        };
    }
}

#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Border {
    pub(super) tile: Tile,
    /// The tile beyond it: two tiles have at most one stretch of a side in common.
    pub(super) beyond: Tile,
    /// From the bottom up, or from left to right; sorted by edge if faces are unknown.
    pub(super) contacts: Vec<Contact>,
    /// The faces before, between and after the contacts; empty if faces are unknown.
    pub(super) faces: Vec<u32>,
}

#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Contact {
    pub(super) edge: Ends,
    pub(super) features: Vec<u32>,
    pub(super) component: u32,
    /// The cycles of its half-edges; the half-edge that leaves the smaller end comes first.
    pub(super) cycles: [u32; 2],
}

/// Parts of one face.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Face {
    pub(super) features: Vec<u32>,
    pub(super) is_unbounded: bool,
    /// The regions that contain it, in order of its [claims](Claim::all).
    pub(super) regions: Vec<u32>,
}

#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Component {
    pub(super) vertices: u64,
    pub(super) edges: u64,
    pub(super) cycles: u64,
    pub(super) least: Option<Point>,
}

impl Face {
    /// Returns true if two different features cover it.
    pub(super) fn is_shared_by(&self, [one, other]: [u32; 2]) -> bool {
        one != other && [one, other].iter().all(|feature| self.features.binary_search(feature).is_ok())
    }
}

impl Component {
    pub(super) fn add(&mut self, other: &Self) {
        self.vertices = sum(self.vertices, other.vertices);
        self.edges = sum(self.edges, other.edges);
        self.cycles = sum(self.cycles, other.cycles);
        self.least = match (self.least, other.least) {
            (Some(a), Some(b)) => Some(if compare_points(a, b).is_le() { a } else { b }),
            (a, b) => a.or(b),
        };
    }
}

pub(super) fn compare_unmatched(a: &UnmatchedVertex, b: &UnmatchedVertex) -> Ordering {
    compare_points(a.at, b.at)
        .then_with(|| (a.of, a.lacked_by).cmp(&(b.of, b.lacked_by)))
        .then_with(|| compare_edges(&a.segment, &b.segment))
}

/// Faces, components and cycles of a summary that are equal.
pub(super) struct Joins {
    pub(super) faces: UnionFind<u32>,
    pub(super) components: UnionFind<u32>,
    pub(super) cycles: UnionFind<u32>,
    pub(super) regions: UnionFind<u32>,
}

impl Joins {
    pub(super) fn new(summary: &Summary) -> Self {
        Self {
            faces: UnionFind::new(summary.faces.len()),
            components: UnionFind::new(summary.components.len()),
            cycles: UnionFind::new(summary.cycles.len()),
            regions: UnionFind::new(summary.regions.len()),
        }
    }
}

/// New numbers, in order of first use.
struct Numbers {
    of: Vec<u32>,
    old: Vec<u32>,
}

impl Numbers {
    fn new(count: usize) -> Self {
        Self { of: vec![NIL; count], old: Vec::new() }
    }

    fn get(&mut self, sets: &mut UnionFind<u32>, i: u32) -> u32 {
        let i = sets.find_mut(i);
        let number = &mut self.of[i as usize];
        if *number == NIL {
            *number = self.old.len() as u32;
            self.old.push(i);
        }
        *number
    }

    fn is_open(&self, i: u32) -> bool {
        self.of[i as usize] != NIL
    }
}

impl Summary {
    /// Creates a summary of no tiles.
    pub(super) fn empty(grid: Grid, limits: Limits) -> Self {
        Self {
            grid,
            limits,
            tiles: Vec::new(),
            corners: None,
            totals: Totals::NOTHING,
            borders: Vec::new(),
            faces: Vec::new(),
            components: Vec::new(),
            cycles: Vec::new(),
            regions: Vec::new(),
            closed: Vec::new(),
            slivers: Vec::new(),
            lengths: Vec::new(),
            areas: Vec::new(),
            claimed: Vec::new(),
            extents: Vec::new(),
            absent: Vec::new(),
            defects: Vec::new(),
            unmatched: Vec::new(),
            is_plane: true,
            crossings: Vec::new(),
            uneven: Vec::new(),
            seams: Vec::new(),
            plane_seams: Vec::new(),
        }
    }

    pub(super) fn count_edges(&mut self, exponent: u16, edges: u64) {
        match self.extents.binary_search_by_key(&exponent, |known| known.0) {
            Ok(place) => self.extents[place].1 = sum(self.extents[place].1, edges),
            Err(place) => self.extents.insert(place, (exponent, edges)),
        }
    }

    /// Returns the grid.
    #[must_use]
    pub const fn grid(&self) -> &Grid {
        &self.grid
    }

    /// Returns its tiles, in order.
    #[must_use]
    pub fn tiles(&self) -> &[Tile] {
        &self.tiles
    }

    /// Returns the number of places where the border of its tiles cuts an edge.
    #[must_use]
    pub fn contact_count(&self) -> usize {
        self.borders.iter().map(|border| border.contacts.len()).sum()
    }

    /// Renumbers the records named by borders after joining, and counts the records that no border names any more.
    pub(super) fn settled(mut self, joins: &mut Joins) -> Self {
        if !self.is_plane {
            self.forget_faces();
            (joins.faces, joins.regions) = (UnionFind::new(0), UnionFind::new(0));
        }
        self.borders.sort_by_key(|border| (border.tile, border.beyond));
        let mut faces = Numbers::new(self.faces.len());
        let mut components = Numbers::new(self.components.len());
        let mut cycles = Numbers::new(self.cycles.len());
        for border in &mut self.borders {
            for face in &mut border.faces {
                *face = faces.get(&mut joins.faces, *face);
            }
            for contact in &mut border.contacts {
                contact.component = components.get(&mut joins.components, contact.component);
                contact.cycles = contact.cycles.map(|cycle| cycles.get(&mut joins.cycles, cycle));
            }
        }
        for cycle in &cycles.old {
            // The contacts of a cycle also name its component, unless the summary was forged.
            components.get(&mut joins.components, self.cycles[*cycle as usize]);
        }
        // Everything is added to its representative.
        let all = core::mem::take(&mut self.components);
        let mut whole = vec![Component::default(); all.len()];
        for (i, part) in (0..).zip(&all) {
            whole[joins.components.find_mut(i) as usize].add(part);
        }
        for (i, component) in (0..).zip(&self.cycles) {
            if joins.cycles.find_mut(i) == i && !cycles.is_open(i) {
                let cycles = &mut whole[joins.components.find_mut(*component) as usize].cycles;
                *cycles = sum(*cycles, 1);
            }
        }
        for i in 0..all.len() as u32 {
            if joins.components.find_mut(i) == i && !components.is_open(i) {
                self.close(&whole[i as usize]);
            }
        }
        let of_cycle = |i: &u32| components.of[joins.components.find_mut(self.cycles[*i as usize]) as usize];
        self.cycles = cycles.old.iter().map(of_cycle).collect();
        self.components = components.old.iter().map(|i| whole[*i as usize]).collect();

        let all = core::mem::take(&mut self.faces);
        let mut is_unbounded = vec![false; all.len()];
        for (i, face) in (0..).zip(&all) {
            is_unbounded[joins.faces.find_mut(i) as usize] |= face.is_unbounded;
        }
        for i in 0..all.len() as u32 {
            if joins.faces.find_mut(i) == i && !faces.is_open(i) {
                self.close_face(is_unbounded[i as usize]);
            }
        }
        let mut regions = Numbers::new(self.regions.len());
        let open = |i: &u32| {
            let Face { features, regions: of, .. } = &all[*i as usize];
            let of = of.iter().map(|region| regions.get(&mut joins.regions, *region)).collect();
            Face { features: features.clone(), is_unbounded: is_unbounded[*i as usize], regions: of }
        };
        self.faces = faces.old.iter().map(open).collect();
        self.settle_regions(&mut joins.regions, &regions);
        self.lengths.sort_by(f64::total_cmp);
        self.areas.sort_by(f64::total_cmp);
        self.closed.sort_by(Region::compare);
        self.slivers.sort_by(Sliver::compare);
        add_up(&mut self.claimed);
        self.absent.sort();
        self.defects.sort_by_key(|(feature, _)| *feature);
        self.unmatched.sort_by(compare_unmatched);
        self.tiles.sort_unstable();
        self.crossings.sort_by(Crossing::compare);
        self.crossings.dedup();
        self.uneven.sort_by(Uneven::compare);
        self.seams.sort_by(SeamFault::compare);
        self.plane_seams.sort_by(SeamFault::compare);
        self
    }

    /// Joins the parts of regions, and examines the regions that no face names any more.
    fn settle_regions(&mut self, sets: &mut UnionFind<u32>, open: &Numbers) {
        let mut whole: Vec<Option<Region>> = Vec::new();
        whole.resize_with(self.regions.len(), || None);
        for (i, part) in (0..).zip(core::mem::take(&mut self.regions)) {
            match &mut whole[sets.find_mut(i) as usize] {
                Some(region) => region.add(part),
                none => *none = Some(part),
            }
        }
        for region in whole.iter_mut().flatten() {
            region.sort();
        }
        self.regions = open.old.iter().filter_map(|i| whole[*i as usize].take()).collect();
        for region in whole.into_iter().flatten() {
            if !matches!(region.claim, Claim::Part(_)) {
                self.closed.push(region);
            } else if !region.is_large {
                let (area, sliver) = examined(&region, &self.limits);
                self.slivers.extend(sliver);
                if self.limits.sliver_area.is_none() {
                    self.areas.push(area);
                }
            }
        }
    }

    pub(super) fn close(&mut self, component: &Component) {
        let Component { vertices, edges, cycles, least } = *component;
        let is_isolated = edges == 0;
        let isolated_vertices = u64::from(is_isolated);
        self.totals.add(&Totals { vertices, edges, cycles, components: 1, isolated_vertices, ..Totals::NOTHING });
        let is_even = if is_isolated { (vertices, cycles) == (1, 0) } else { vertices + cycles == edges + 2 };
        if !is_even {
            self.uneven.push(Uneven { vertices, edges, cycles, at: least });
        }
    }

    pub(super) fn close_face(&mut self, is_unbounded: bool) {
        self.totals.add(&Totals { faces: 1, unbounded_faces: u64::from(is_unbounded), ..Totals::NOTHING });
    }

    /// Drops all data about faces, and sorts contacts without it.
    fn forget_faces(&mut self) {
        self.faces.clear();
        self.regions.clear();
        self.closed.clear();
        self.slivers.clear();
        self.plane_seams.clear();
        self.lengths.clear();
        self.areas.clear();
        self.claimed.iter_mut().for_each(|one| one.like = None);
        (self.totals.faces, self.totals.unbounded_faces) = (0, 0);
        for border in &mut self.borders {
            border.faces.clear();
            border.contacts.sort_by(|a, b| compare_edges(&a.edge, &b.edge));
        }
    }
}
