//! The vertices of high degree, with their half-edges in angular order and their edges in trees of their own.
//!
//! Finding a direction in the rotation of a vertex takes O(degree). The boxes around the spokes of a star all overlap, so an
//! R-tree tests a large part of them for each segment that ends at the hub. But no spoke meets such a segment elsewhere, unless
//! it lies along it. So searches leave out the hub's tree and use the angular order.

use super::tree::{BoxedRecord, RecordTree};
use core::cmp::Ordering;
use std::collections::BTreeSet;
use twinedge::dcel::{HalfEdge, Vertex};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::compare_angle;

/// A direction from the hub's centre towards another point.
///
/// Half-edges in the same direction, which edits may create temporarily, are ordered by their indices.
#[derive(Clone, Copy, Debug)]
struct Direction {
    centre: Point,
    head: Point,
    half_edge: u32,
}

impl Ord for Direction {
    fn cmp(&self, other: &Self) -> Ordering {
        compare_angle(self.centre, self.head, other.head).then(self.half_edge.cmp(&other.half_edge))
    }
}

impl PartialOrd for Direction {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Direction {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Direction {}

/// A vertex of high degree, now or earlier.
#[derive(Clone)]
pub(crate) struct Hub {
    pub(super) centre: Point,
    leaving: BTreeSet<Direction>,
    /// Its edges, except edges in the tree of another hub or from before it became a hub.
    pub(super) tree: RecordTree,
}

impl Hub {
    /// Sorts all half-edges that leave a vertex, and takes some of its edges. O(degree · log).
    pub(super) fn new(v: Vertex<'_>, points: &[Point], edges: Vec<BoxedRecord>) -> Self {
        let centre = points[v.index()];
        let direction =
            |h: HalfEdge<'_>| Direction { centre, head: points[h.target().index()], half_edge: h.index() as u32 };
        Self { centre, leaving: v.rotation().map(direction).collect(), tree: RecordTree::new(edges) }
    }

    /// Adds a half-edge that leaves towards a point. O(log degree).
    pub(super) fn add(&mut self, half_edge: u32, head: Point) {
        self.leaving.insert(Direction { centre: self.centre, head, half_edge });
    }

    /// Removes a half-edge that left towards a point. Returns the number of remaining half-edges. O(log degree).
    pub(super) fn remove(&mut self, half_edge: u32, head: Point) -> usize {
        self.leaving.remove(&Direction { centre: self.centre, head, half_edge });
        self.leaving.len()
    }

    /// Returns the index of the half-edge towards a point, or of the half-edge before that direction. O(log degree).
    pub(super) fn towards(&self, head: Point) -> Option<usize> {
        let upto = Direction { centre: self.centre, head, half_edge: u32::MAX };
        let direction = self.leaving.range(..=upto).next_back().or_else(|| self.leaving.last())?;
        Some(direction.half_edge as usize)
    }

    /// Returns the half-edges in order.
    #[cfg(test)]
    pub(super) fn rotation(&self) -> Vec<u32> {
        self.leaving.iter().map(|direction| direction.half_edge).collect()
    }
}
