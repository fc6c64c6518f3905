//! The structure as a view for the validator.

use super::structure::Dcel;
use crate::store::{BoundaryStart, OUTER, VertexLink};
use crate::validate::{
    BoundaryPlace, Collect, Expectation, HalfEdgeColumns, Link, Parts, Report, Start, View, validate,
};

/// Indices are the values of [`HalfEdge::index`](super::HalfEdge::index) and its siblings. Answers for vacant slots are
/// unspecified.
impl View for Dcel {
    fn half_edge_columns(&self) -> Option<HalfEdgeColumns<'_>> {
        Some(self.store.half_edge_columns())
    }
    fn parts(&self) -> Parts {
        Parts::ALL
    }
    fn vertex_slots(&self) -> usize {
        self.store.vertex_slots()
    }
    fn half_edge_slots(&self) -> usize {
        self.store.half_edge_slots()
    }
    fn boundary_slots(&self) -> usize {
        self.store.boundary_slots()
    }
    fn face_slots(&self) -> usize {
        self.store.face_slots()
    }
    #[inline]
    fn is_vertex(&self, vertex: usize) -> bool {
        self.store.vertex_at(vertex).is_some()
    }
    #[inline]
    fn is_half_edge(&self, half_edge: usize) -> bool {
        self.store.half_edge_at(half_edge).is_some()
    }
    #[inline]
    fn is_boundary(&self, boundary: usize) -> bool {
        self.store.boundary_at(boundary).is_some()
    }
    #[inline]
    fn is_face(&self, face: usize) -> bool {
        self.store.face_at(face).is_some()
    }
    #[inline]
    fn origin(&self, half_edge: usize) -> Link {
        self.store.origin_in(half_edge)
    }
    #[inline]
    fn twin(&self, half_edge: usize) -> Link {
        self.store.twin_in(half_edge)
    }
    #[inline]
    fn next(&self, half_edge: usize) -> Link {
        self.store.next_in(half_edge)
    }
    #[inline]
    fn prev(&self, half_edge: usize) -> Link {
        self.store.prev_in(half_edge)
    }
    #[inline]
    fn boundary(&self, half_edge: usize) -> Link {
        self.store.boundary_in(half_edge)
    }
    #[inline]
    fn leaving(&self, vertex: usize) -> Link {
        match self.store.vertex_link(self.store.vertex_at(vertex)?) {
            VertexLink::Leaving(h) => Some(h.index()),
            VertexLink::Isolated(_) => None,
        }
    }
    #[inline]
    fn isolated(&self, vertex: usize) -> Link {
        match self.store.vertex_link(self.store.vertex_at(vertex)?) {
            VertexLink::Leaving(_) => None,
            VertexLink::Isolated(b) => Some(b.index()),
        }
    }
    #[inline]
    fn boundary_face(&self, boundary: usize) -> Link {
        Some(self.store.face(self.store.boundary_at(boundary)?).index())
    }
    #[inline]
    fn boundary_start(&self, boundary: usize) -> Option<Start> {
        Some(match self.store.start(self.store.boundary_at(boundary)?) {
            BoundaryStart::HalfEdge(h) => Start::HalfEdge(h.index()),
            BoundaryStart::Vertex(v) => Start::Vertex(v.index()),
        })
    }
    #[inline]
    fn boundary_place(&self, boundary: usize) -> Option<BoundaryPlace> {
        Some(match self.store.place(self.store.boundary_at(boundary)?) {
            OUTER => BoundaryPlace::Outer,
            i => BoundaryPlace::Inner(i as usize),
        })
    }
    #[inline]
    fn outer(&self, face: usize) -> Link {
        self.store.outer(self.store.face_at(face)?).map(|b| b.index())
    }
    #[inline]
    fn inner_count(&self, face: usize) -> usize {
        self.store.face_at(face).map_or(0, |f| self.store.inner_count(f))
    }
    #[inline]
    fn inner(&self, face: usize, position: usize) -> Link {
        self.store.inner(self.store.face_at(face)?, position).map(|b| b.index())
    }
}

impl Dcel {
    /// Checks every rule from R1 to T4. O(n).
    ///
    /// Operators never break a rule, so the report is always valid; useful in tests.
    ///
    /// ```
    /// use twinedge::dcel::Dcel;
    ///
    /// assert!(Dcel::new().validate().is_valid());
    /// ```
    #[must_use]
    pub fn validate(&self) -> Report {
        validate(self, &Expectation::plane(), Collect::All)
    }
}
