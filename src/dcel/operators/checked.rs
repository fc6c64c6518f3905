//! Code shared by operators: resolving keys, checking room, and listing boundary components.

use crate::dcel::error::{OperatorError, StaleKey};
use crate::dcel::structure::Dcel;
use crate::store::{BoundarySlot, FaceKey, FaceSlot, HalfEdgeKey, HalfEdgeSlot, OUTER, Room, VertexKey, VertexSlot};

impl Dcel {
    pub(super) fn vertex_slot(&self, key: VertexKey) -> Result<VertexSlot, OperatorError> {
        self.store.find_vertex(key).ok_or(OperatorError::Stale(StaleKey::Vertex(key)))
    }

    pub(super) fn half_edge_slot(&self, key: HalfEdgeKey) -> Result<HalfEdgeSlot, OperatorError> {
        self.store.find_half_edge(key).ok_or(OperatorError::Stale(StaleKey::HalfEdge(key)))
    }

    pub(super) fn face_slot(&self, key: FaceKey) -> Result<FaceSlot, OperatorError> {
        self.store.find_face(key).ok_or(OperatorError::Stale(StaleKey::Face(key)))
    }

    /// Checks that there is room for these records. O(1).
    ///
    /// # Errors
    /// [`OperatorError::Full`], with the kind of record for which there is no room.
    pub fn room_for(&self, need: Room) -> Result<(), OperatorError> {
        self.store.room_for(need).map_err(OperatorError::Full)
    }

    pub(super) fn is_outer(&self, b: BoundarySlot) -> bool {
        self.store.place(b) == OUTER
    }

    pub(super) fn list(&mut self, f: FaceSlot, b: BoundarySlot, outer: bool) {
        if outer {
            self.store.list_outer(f, b);
        } else {
            self.store.list_inner(f, b);
        }
    }
}
