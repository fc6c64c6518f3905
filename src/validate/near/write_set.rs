//! The records written by a change.

use alloc::vec::Vec;

/// The write set of a change, by index: all records that were added or removed, or whose links changed, since the structure was
/// last found valid. It also contains vertices that moved and half-edges with new bends.
///
/// Repetitions are allowed. Naming an unchanged record costs time but does no harm. If a changed record is missing, the answer
/// of [`validate_near`](super::validate_near) is meaningless.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct WriteSet {
    /// Vertices.
    pub vertices: Vec<usize>,
    /// Half-edges.
    pub half_edges: Vec<usize>,
    /// Boundary components.
    pub boundaries: Vec<usize>,
    /// Faces whose outer boundary component or list length has changed.
    pub faces: Vec<usize>,
    /// Written entries of the lists of inner boundary components: the face and the position.
    pub listed: Vec<(usize, usize)>,
}

impl WriteSet {
    /// Removes all records, but keeps the memory.
    pub fn clear(&mut self) {
        self.vertices.clear();
        self.half_edges.clear();
        self.boundaries.clear();
        self.faces.clear();
        self.listed.clear();
    }

    /// Adds the records of another write set. O(records).
    pub fn extend(&mut self, more: Self) {
        self.vertices.extend(more.vertices);
        self.half_edges.extend(more.half_edges);
        self.boundaries.extend(more.boundaries);
        self.faces.extend(more.faces);
        self.listed.extend(more.listed);
    }

    /// Returns true if there are no records.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        let Self { vertices, half_edges, boundaries, faces, listed } = self;
        vertices.is_empty() && half_edges.is_empty() && boundaries.is_empty() && faces.is_empty() && listed.is_empty()
    }
}
