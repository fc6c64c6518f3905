//! A view that panics on calls that its contract rules out.

use twinedge::delegate_view;
use twinedge::validate::{BoundaryPlace, Link, Start, View};

/// Answers like the view, but panics when asked about a vacant slot, or beyond the end of a list.
pub(crate) struct OnlyLive<'a, V>(pub(crate) &'a V);

impl<V: View> OnlyLive<'_, V> {
    #[track_caller]
    fn vertex(&self, vertex: usize) -> &V {
        assert!(self.is_vertex(vertex), "vertex {vertex} is vacant");
        self.0
    }
    #[track_caller]
    fn half_edge(&self, half_edge: usize) -> &V {
        assert!(self.is_half_edge(half_edge), "half-edge {half_edge} is vacant");
        self.0
    }
    #[track_caller]
    fn component(&self, boundary: usize) -> &V {
        assert!(self.is_boundary(boundary), "boundary component {boundary} is vacant");
        self.0
    }
    #[track_caller]
    fn of_face(&self, face: usize) -> &V {
        assert!(self.is_face(face), "face {face} is vacant");
        self.0
    }
    #[track_caller]
    fn listed(&self, face: usize, position: usize) -> &V {
        let count = self.of_face(face).inner_count(face);
        assert!(position < count, "face {face} lists {count} inner boundary components, and is asked for {position}");
        self.0
    }
}

impl<V: View> View for OnlyLive<'_, V> {
    delegate_view!(|this| this.0; only parts, vertex_slots, half_edge_slots, boundary_slots, face_slots);

    fn is_vertex(&self, vertex: usize) -> bool {
        assert!(vertex < self.vertex_slots(), "there is no slot {vertex} for a vertex");
        self.0.is_vertex(vertex)
    }
    fn is_half_edge(&self, half_edge: usize) -> bool {
        assert!(half_edge < self.half_edge_slots(), "there is no slot {half_edge} for a half-edge");
        self.0.is_half_edge(half_edge)
    }
    fn is_boundary(&self, boundary: usize) -> bool {
        assert!(boundary < self.boundary_slots(), "there is no slot {boundary} for a boundary component");
        self.0.is_boundary(boundary)
    }
    fn is_face(&self, face: usize) -> bool {
        assert!(face < self.face_slots(), "there is no slot {face} for a face");
        self.0.is_face(face)
    }
    fn origin(&self, half_edge: usize) -> Link {
        self.half_edge(half_edge).origin(half_edge)
    }
    fn twin(&self, half_edge: usize) -> Link {
        self.half_edge(half_edge).twin(half_edge)
    }
    fn next(&self, half_edge: usize) -> Link {
        self.half_edge(half_edge).next(half_edge)
    }
    fn prev(&self, half_edge: usize) -> Link {
        self.half_edge(half_edge).prev(half_edge)
    }
    fn boundary(&self, half_edge: usize) -> Link {
        self.half_edge(half_edge).boundary(half_edge)
    }
    fn face(&self, half_edge: usize) -> Link {
        self.half_edge(half_edge).face(half_edge)
    }
    fn leaving(&self, vertex: usize) -> Link {
        self.vertex(vertex).leaving(vertex)
    }
    fn isolated(&self, vertex: usize) -> Link {
        self.vertex(vertex).isolated(vertex)
    }
    fn boundary_face(&self, boundary: usize) -> Link {
        self.component(boundary).boundary_face(boundary)
    }
    fn boundary_start(&self, boundary: usize) -> Option<Start> {
        self.component(boundary).boundary_start(boundary)
    }
    fn boundary_place(&self, boundary: usize) -> Option<BoundaryPlace> {
        self.component(boundary).boundary_place(boundary)
    }
    fn outer(&self, face: usize) -> Link {
        self.of_face(face).outer(face)
    }
    fn inner_count(&self, face: usize) -> usize {
        self.of_face(face).inner_count(face)
    }
    fn inner(&self, face: usize, position: usize) -> Link {
        self.listed(face, position).inner(face, position)
    }
    fn outer_half_edge(&self, face: usize) -> Link {
        self.of_face(face).outer_half_edge(face)
    }
    fn inner_start(&self, face: usize, position: usize) -> Option<Start> {
        self.listed(face, position).inner_start(face, position)
    }
}
