//! A subject and the handles that it gave out.

use crate::dcel::Corner;
use crate::program::subject::{CornerOf, Subject};
use alloc::vec::Vec;

/// A subject together with all handles it ever gave out, in order of creation.
///
/// What a program chooses depends on these lists and on what the subject says of corners, faces and vertices. It does not
/// depend on the values of the handles, so a program does the same to every correct subject.
#[derive(Clone, Debug)]
pub struct Runner<K: Subject> {
    pub(in crate::program) subject: K,
    pub(in crate::program) half_edges: Vec<K::HalfEdge>,
    pub(in crate::program) isolated: Vec<K::Vertex>,
    pub(in crate::program) retired_half_edges: Vec<K::HalfEdge>,
    pub(in crate::program) retired_vertices: Vec<K::Vertex>,
    pub(in crate::program) retired_faces: Vec<K::Face>,
}

impl<K: Subject> Runner<K> {
    /// Starts with a subject that is the empty map.
    pub const fn new(subject: K) -> Self {
        Self::starting_with(subject, Vec::new(), Vec::new())
    }

    /// Starts with these half-edges, the two of an edge side by side, and isolated vertices.
    pub(in crate::program) const fn starting_with(
        subject: K,
        half_edges: Vec<K::HalfEdge>,
        isolated: Vec<K::Vertex>,
    ) -> Self {
        Self {
            subject,
            half_edges,
            isolated,
            retired_half_edges: Vec::new(),
            retired_vertices: Vec::new(),
            retired_faces: Vec::new(),
        }
    }

    /// Forgets all stale handles.
    pub(in crate::program) fn forget_retired(&mut self) {
        self.retired_half_edges.clear();
        self.retired_vertices.clear();
        self.retired_faces.clear();
    }

    /// The subject.
    pub const fn subject(&self) -> &K {
        &self.subject
    }

    /// The subject, for good.
    pub fn into_subject(self) -> K {
        self.subject
    }

    /// The half-edges in order of creation; the two of an edge side by side.
    pub fn half_edges(&self) -> &[K::HalfEdge] {
        &self.half_edges
    }

    /// The isolated vertices in the order in which they became so.
    pub fn isolated(&self) -> &[K::Vertex] {
        &self.isolated
    }

    /// The half-edges that were removed.
    pub fn retired_half_edges(&self) -> &[K::HalfEdge] {
        &self.retired_half_edges
    }

    /// The vertices that were removed.
    pub fn retired_vertices(&self) -> &[K::Vertex] {
        &self.retired_vertices
    }

    /// The faces that were removed.
    pub fn retired_faces(&self) -> &[K::Face] {
        &self.retired_faces
    }

    /// All corners, those of half-edges first.
    pub fn corners(&self) -> impl Iterator<Item = CornerOf<K>> + '_ {
        let isolated = self.isolated.iter().copied().map(Corner::Isolated);
        self.half_edges.iter().copied().map(Corner::At).chain(isolated)
    }
}
