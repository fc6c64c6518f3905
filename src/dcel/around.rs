//! Walks from an element: around its vertex, along its cycle, over its face.

use super::circulators::{Cycle, Rotation};
use super::elements::{Boundary, Face, HalfEdge, Vertex};
use crate::store::Store;

impl<'a, S: Store> Vertex<'a, S> {
    /// The half-edges that leave the vertex, counter-clockwise; `rev()` for clockwise. O(1) per step.
    #[must_use]
    pub fn rotation(self) -> Rotation<'a, S> {
        Rotation::new(self.leaving())
    }

    /// The vertices at the other ends of its edges, counter-clockwise; one that parallel edges lead to comes as often, and a
    /// loop gives the vertex itself, twice. O(degree).
    pub fn neighbours(self) -> impl Iterator<Item = Self> {
        self.rotation().map(HalfEdge::target)
    }

    /// How many half-edges leave the vertex: a loop counts twice. O(degree).
    #[must_use]
    pub fn degree(self) -> usize {
        self.rotation().count()
    }
}

impl<'a, S: Store> HalfEdge<'a, S> {
    /// The half-edges that leave the same vertex, counter-clockwise from this one on. O(1) per step.
    #[must_use]
    #[inline]
    pub fn rotation(self) -> Rotation<'a, S> {
        Rotation::new(Some(self))
    }

    /// The half-edges of its cycle, from this one on; `rev()` goes the other way. O(1) per step.
    #[must_use]
    #[inline]
    pub fn boundary_cycle(self) -> Cycle<'a, S> {
        Cycle::new(Some(self))
    }
}

impl<'a, S: Store> Boundary<'a, S> {
    /// The half-edges of its cycle; none if it is an isolated vertex. O(1) per step.
    #[must_use]
    #[inline]
    pub fn half_edges(self) -> Cycle<'a, S> {
        Cycle::new(self.start())
    }
}

impl<'a, S: Store> Face<'a, S> {
    /// All its boundary components, the outer one first. O(1) per step.
    pub fn boundaries(self) -> impl Iterator<Item = Boundary<'a, S>> {
        self.outer().into_iter().chain(self.inner())
    }

    /// All half-edges that have the face to their left. O(1) per step.
    pub fn half_edges(self) -> impl Iterator<Item = HalfEdge<'a, S>> {
        self.boundaries().flat_map(Boundary::half_edges)
    }

    /// The faces across its half-edges, in order of these: one that shares several edges comes as often, and the face
    /// itself comes where both sides of an edge lie in it. O(1) per step.
    pub fn neighbours(self) -> impl Iterator<Item = Self> {
        self.half_edges().map(|h| h.twin().face())
    }
}
