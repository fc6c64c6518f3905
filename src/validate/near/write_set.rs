//! The records that a change has written.

use alloc::vec::Vec;

/// The write set of a change, by index: all records that were added, removed, or had a link changed since the structure was last
/// found right. A vertex that lies elsewhere is among them, and so is a half-edge whose bends are others.
///
/// An index may occur several times. A record that is named without having changed costs time and does no harm. If one that has
/// changed is missing, the answer of [`validate_near`](super::validate_near) means nothing.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct WriteSet {
    /// Vertices.
    pub vertices: Vec<usize>,
    /// Half-edges.
    pub half_edges: Vec<usize>,
    /// Boundary components.
    pub boundaries: Vec<usize>,
    /// Faces whose outer boundary component has changed, or whose list has become longer or shorter.
    pub faces: Vec<usize>,
    /// Entries of the lists of inner boundary components that were written: the face and the position.
    pub listed: Vec<(usize, usize)>,
}

impl WriteSet {
    /// Forgets all of them. Keeps the memory.
    pub fn clear(&mut self) {
        self.vertices.clear();
        self.half_edges.clear();
        self.boundaries.clear();
        self.faces.clear();
        self.listed.clear();
    }

    /// Adds the records of another. O(records).
    pub fn extend(&mut self, more: Self) {
        self.vertices.extend(more.vertices);
        self.half_edges.extend(more.half_edges);
        self.boundaries.extend(more.boundaries);
        self.faces.extend(more.faces);
        self.listed.extend(more.listed);
    }

    /// Returns true if there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        let Self { vertices, half_edges, boundaries, faces, listed } = self;
        vertices.is_empty() && half_edges.is_empty() && boundaries.is_empty() && faces.is_empty() && listed.is_empty()
    }
}
