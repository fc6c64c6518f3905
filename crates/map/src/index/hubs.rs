//! The vertices of high degree, with what leaves them in angular order, and in a tree of boxes of their own.
//!
//! In the rotation of a vertex, a direction is found by going around: O(degree). And the boxes around the spokes of a star all
//! overlap, so an R-tree that has them tries a good part of them for each segment that ends at the hub. But none of them meets
//! such a segment, unless it lies along one: so it is the tree that is left out, and the angular order that tells.

use super::tree::{BoxedRecord, RecordTree};
use core::cmp::Ordering;
use std::collections::BTreeSet;
use twinedge::dcel::{HalfEdge, Vertex};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::compare_angle;

/// A direction from a point, by another point in that direction. Those of one hub have one centre.
///
/// Half-edges in the same direction, which an edit may leave for a moment, are told apart by their indices.
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

/// A vertex from which many half-edges leave, or did.
#[derive(Clone)]
pub(crate) struct Hub {
    pub(super) centre: Point,
    leaving: BTreeSet<Direction>,
    /// Its edges, but those that are in the tree of another hub, or were before it was one.
    pub(super) tree: RecordTree,
}

impl Hub {
    /// With all that leaves a vertex in order, and some of its edges. O(degree · log).
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

    /// Takes off a half-edge that left towards a point, and tells how many are left. O(log degree).
    pub(super) fn remove(&mut self, half_edge: u32, head: Point) -> usize {
        self.leaving.remove(&Direction { centre: self.centre, head, half_edge });
        self.leaving.len()
    }

    /// The index of the half-edge towards a point, or of the one before it. O(log degree).
    pub(super) fn towards(&self, head: Point) -> Option<usize> {
        let upto = Direction { centre: self.centre, head, half_edge: u32::MAX };
        let direction = self.leaving.range(..=upto).next_back().or_else(|| self.leaving.last())?;
        Some(direction.half_edge as usize)
    }

    /// The half-edges in order.
    #[cfg(test)]
    pub(super) fn rotation(&self) -> Vec<u32> {
        self.leaving.iter().map(|direction| direction.half_edge).collect()
    }
}
