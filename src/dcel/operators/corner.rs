//! Corners, the places where edges attach, and the checks shared by operators: keys, room, and the lists of faces.

use crate::dcel::access::{OperatorError, StaleKey};
use crate::dcel::structure::Dcel;
use crate::store::{
    BoundarySlot, FaceKey, FaceSlot, HalfEdgeKey, HalfEdgeSlot, OUTER, Room, Store, VertexKey, VertexLink, VertexSlot,
};

/// A place at a vertex where an edge can be attached.
///
/// ```text
///        \ ccw(h)
///         \    corner of h: to its left, between it and the half-edge
///          \ ∙               that leaves the vertex next counter-clockwise
///           v ──────► h
/// ```
///
/// Keys convert: a half-edge stands for the corner at its origin, an isolated vertex for its only corner.
///
/// The type is generic because programs name corners of any structure by its own handles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Corner<H = HalfEdgeKey, V = VertexKey> {
    /// At the origin of the half-edge, to its left: on the boundary cycle, between `prev(h)` and `h`.
    At(H),
    /// All around an isolated vertex.
    Isolated(V),
}

impl From<HalfEdgeKey> for Corner {
    fn from(h: HalfEdgeKey) -> Self {
        Self::At(h)
    }
}

impl From<VertexKey> for Corner {
    fn from(v: VertexKey) -> Self {
        Self::Isolated(v)
    }
}

#[derive(Clone, Copy)]
pub(super) enum CheckedCorner {
    At(HalfEdgeSlot),
    Isolated(VertexSlot, BoundarySlot),
}

impl CheckedCorner {
    pub(super) fn vertex(self, store: &Store) -> VertexSlot {
        match self {
            Self::At(h) => store.origin(h),
            Self::Isolated(v, _) => v,
        }
    }

    pub(super) fn boundary(self, store: &Store) -> BoundarySlot {
        match self {
            Self::At(h) => store.boundary(h),
            Self::Isolated(_, b) => b,
        }
    }
}

impl Dcel {
    pub(super) fn checked_corner(&self, corner: Corner) -> Result<CheckedCorner, OperatorError> {
        match corner {
            Corner::At(h) => self.half_edge_slot(h).map(CheckedCorner::At),
            Corner::Isolated(key) => {
                let v = self.vertex_slot(key)?;
                match self.store.vertex_link(v) {
                    VertexLink::Isolated(b) => Ok(CheckedCorner::Isolated(v, b)),
                    VertexLink::Leaving(_) => Err(OperatorError::NotIsolated(key)),
                }
            }
        }
    }
}

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
