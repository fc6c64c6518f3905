//! The mapping from indices of a view to keys.

use crate::store::{BoundaryKey, FaceKey, HalfEdgeKey, VertexKey};
use alloc::vec::Vec;

/// The keys in the [`Dcel`](crate::dcel::Dcel) of the records of a view, by index.
///
/// Records that the view does not have, such as missing twins along a border, are omitted.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Keys {
    pub(super) vertices: Vec<Option<VertexKey>>,
    pub(super) half_edges: Vec<Option<HalfEdgeKey>>,
    pub(super) boundaries: Vec<Option<BoundaryKey>>,
    pub(super) faces: Vec<Option<FaceKey>>,
}

impl Keys {
    /// Returns the key of the vertex with this index in the view; `None` if the slot was vacant. O(1).
    #[must_use]
    pub fn vertex(&self, index: usize) -> Option<VertexKey> {
        self.vertices.get(index).copied().flatten()
    }

    /// Returns the key of the half-edge with this index in the view; `None` if the slot was vacant. O(1).
    #[must_use]
    pub fn half_edge(&self, index: usize) -> Option<HalfEdgeKey> {
        self.half_edges.get(index).copied().flatten()
    }

    /// Returns the key of the boundary component with this index in the view; `None` if the slot was vacant, or if the
    /// view has no records of boundary components. O(1).
    #[must_use]
    pub fn boundary(&self, index: usize) -> Option<BoundaryKey> {
        self.boundaries.get(index).copied().flatten()
    }

    /// Returns the key of the face with this index in the view; `None` if the slot was vacant. O(1).
    #[must_use]
    pub fn face(&self, index: usize) -> Option<FaceKey> {
        self.faces.get(index).copied().flatten()
    }
}
