//! All records of a structure at once.

use super::columns::{BoundarySlot, FaceSlot, HalfEdgeSlot, VertexSlot};
use super::store::SlotStore;
use crate::slots::NIL;
use crate::store::links::{Links, Need, RecordKind};
use crate::store::place::UNLISTED;
#[cfg(feature = "serde")]
use alloc::vec::Vec;

/// The slots of the records of a store that was saved, by number.
#[cfg(feature = "serde")]
pub(crate) struct Slots {
    pub(crate) vertices: Vec<VertexSlot>,
    /// The two of an edge side by side.
    pub(crate) half_edges: Vec<HalfEdgeSlot>,
    pub(crate) boundaries: Vec<BoundarySlot>,
    pub(crate) faces: Vec<FaceSlot>,
}

/// The slots of records by their numbers. Face 0 is the unbounded one.
pub(crate) trait Numbered {
    fn vertex(&self, number: u32) -> VertexSlot;
    /// The two of an edge have the numbers `2e` and `2e + 1`.
    fn half_edge(&self, number: u32) -> HalfEdgeSlot;
    fn boundary(&self, number: u32) -> BoundarySlot;
    fn face(&self, number: u32) -> FaceSlot;
}

#[cfg(feature = "serde")]
impl Numbered for Slots {
    fn vertex(&self, number: u32) -> VertexSlot {
        self.vertices[number as usize]
    }

    fn half_edge(&self, number: u32) -> HalfEdgeSlot {
        self.half_edges[number as usize]
    }

    fn boundary(&self, number: u32) -> BoundarySlot {
        self.boundaries[number as usize]
    }

    fn face(&self, number: u32) -> FaceSlot {
        self.faces[number as usize]
    }
}

/// The slots of a store that has just been filled: the first ones, in order. Slot 0 of each kind is vacant, and so is the first pair
/// of half-edges.
pub(crate) struct InOrder;

impl Numbered for InOrder {
    fn vertex(&self, number: u32) -> VertexSlot {
        VertexSlot(number + 1)
    }

    fn half_edge(&self, number: u32) -> HalfEdgeSlot {
        HalfEdgeSlot(number + 2)
    }

    fn boundary(&self, number: u32) -> BoundarySlot {
        BoundarySlot(number + 1)
    }

    fn face(&self, number: u32) -> FaceSlot {
        FaceSlot(number + 1)
    }
}

impl SlotStore {
    /// A store with that many records beside the unbounded face, in the slots of [`InOrder`]. The caller sets all their links.
    ///
    /// # Errors
    /// The kind of record of which there are more than a store can hold.
    pub(crate) fn with_records(need: Need) -> Result<Self, RecordKind> {
        let store = Self::with_room(need);
        store.room_for(need)?;
        Ok(store.filled(need))
    }

    /// An empty store with that many records more, for which there is room.
    pub(crate) fn filled(mut self, need: Need) -> Self {
        self.edges.issue_many(need.edges);
        self.vertices.issue_many(need.vertices);
        self.boundaries.issue_many(need.boundaries);
        self.faces.issue_many(need.faces);
        self.fill_columns();
        self
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
