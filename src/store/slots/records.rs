//! All records of a structure at once.

use super::columns::{BoundarySlot, FaceSlot, HalfEdgeSlot, NIL, VertexSlot};
use super::store::SlotStore;
use crate::store::links::{Links, Need, RecordKind};
use crate::store::place::UNLISTED;
use alloc::vec::Vec;

/// The slots of the records of a store, in the order in which they were issued. The first face is the unbounded one.
pub(crate) struct Slots {
    pub(crate) vertices: Vec<VertexSlot>,
    /// The two of an edge side by side.
    pub(crate) half_edges: Vec<HalfEdgeSlot>,
    pub(crate) boundaries: Vec<BoundarySlot>,
    pub(crate) faces: Vec<FaceSlot>,
}

impl SlotStore {
    /// A store with that many records beside the unbounded face. The caller sets all their links.
    ///
    /// # Errors
    /// The kind of record of which there are more than a store can hold.
    pub(crate) fn with_records(need: Need) -> Result<(Self, Slots), RecordKind> {
        let store = Self::with_room(need);
        store.room_for(need)?;
        Ok(store.issue(need))
    }

    /// The same store with that many records more, for which there is room. The caller sets all their links.
    pub(crate) fn issue(mut self, need: Need) -> (Self, Slots) {
        let store = &mut self;
        let edges = (0..need.edges).map(|_| store.edges.issue() << 1);
        let slots = Slots {
            half_edges: edges.flat_map(|h| [HalfEdgeSlot(h), HalfEdgeSlot(h | 1)]).collect(),
            vertices: (0..need.vertices).map(|_| VertexSlot(store.vertices.issue())).collect(),
            boundaries: (0..need.boundaries).map(|_| BoundarySlot(store.boundaries.issue())).collect(),
            faces: core::iter::once(store.unbounded)
                .chain((0..need.faces).map(|_| FaceSlot(store.faces.issue())))
                .collect(),
        };
        store.fill_columns();
        (self, slots)
    }

    /// Makes the columns as long as there are slots.
    pub(super) fn fill_columns(&mut self) {
        let half_edges = 2 * self.edges.end();
        self.origin.resize(half_edges, VertexSlot(NIL));
        self.next.resize(half_edges, HalfEdgeSlot(NIL));
        self.prev.resize(half_edges, HalfEdgeSlot(NIL));
        self.boundary.resize(half_edges, BoundarySlot(NIL));
        self.vertex_link.resize(self.vertices.end(), NIL);
        let boundaries = self.boundaries.end();
        self.boundary_face.resize(boundaries, FaceSlot(NIL));
        self.start.resize(boundaries, NIL);
        self.place.resize(boundaries, UNLISTED);
        self.outer.resize(self.faces.end(), NIL);
        self.inner.resize(self.faces.end());
    }
}
