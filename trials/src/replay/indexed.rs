//! Handles as the indices of the validator.

use crate::{RawPointers, ReportAudit};
use twinedge::dcel::{Audited, Dcel};
use twinedge::program::Subject;
use twinedge::validate::View;

/// A structure with a [`View`] index for each handle.
pub trait Indexed: Subject {
    /// Returns the index of a vertex; `None` for a stale handle.
    fn vertex_index(&self, vertex: Self::Vertex) -> Option<usize>;
    /// Returns the index of a half-edge; `None` for a stale handle.
    fn half_edge_index(&self, half_edge: Self::HalfEdge) -> Option<usize>;
    /// Returns the index of a face; `None` for a stale handle.
    fn face_index(&self, face: Self::Face) -> Option<usize>;
}

impl Indexed for Dcel {
    fn vertex_index(&self, vertex: Self::Vertex) -> Option<usize> {
        self.vertex(vertex).ok().map(|v| v.index())
    }
    fn half_edge_index(&self, half_edge: Self::HalfEdge) -> Option<usize> {
        self.half_edge(half_edge).ok().map(|h| h.index())
    }
    fn face_index(&self, face: Self::Face) -> Option<usize> {
        self.face(face).ok().map(|f| f.index())
    }
}

impl Indexed for ReportAudit {
    fn vertex_index(&self, vertex: Self::Vertex) -> Option<usize> {
        self.dcel().vertex_index(vertex)
    }
    fn half_edge_index(&self, half_edge: Self::HalfEdge) -> Option<usize> {
        self.dcel().half_edge_index(half_edge)
    }
    fn face_index(&self, face: Self::Face) -> Option<usize> {
        self.dcel().face_index(face)
    }
}

impl Indexed for Audited {
    fn vertex_index(&self, vertex: Self::Vertex) -> Option<usize> {
        self.get().vertex_index(vertex)
    }
    fn half_edge_index(&self, half_edge: Self::HalfEdge) -> Option<usize> {
        self.get().half_edge_index(half_edge)
    }
    fn face_index(&self, face: Self::Face) -> Option<usize> {
        self.get().face_index(face)
    }
}

impl Indexed for RawPointers {
    fn vertex_index(&self, vertex: usize) -> Option<usize> {
        self.is_vertex(vertex).then_some(vertex)
    }
    fn half_edge_index(&self, half_edge: usize) -> Option<usize> {
        self.is_half_edge(half_edge).then_some(half_edge)
    }
    fn face_index(&self, face: usize) -> Option<usize> {
        self.is_face(face).then_some(face)
    }
}
