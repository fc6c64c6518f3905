//! Creates all records of a structure at once: in order, or in the slots of a saved structure.

use super::columns::{BoundaryRow, BoundarySlot, FaceRow, FaceSlot, HalfEdgeSlot, RecordKind, Room, VertexSlot};
#[cfg(feature = "serde")]
use super::columns::{MOST, MOST_EDGES, VACANT};
#[cfg(feature = "serde")]
use super::issuer::Issuer;
use super::slots::Store;
use crate::numbers::NIL;
#[cfg(feature = "serde")]
use alloc::vec::Vec;

/// The slots of the records of a restored store, by number.
#[cfg(feature = "serde")]
pub(crate) struct SavedSlots {
    pub(crate) vertices: Vec<VertexSlot>,
    /// The two half-edges of an edge are adjacent.
    pub(crate) half_edges: Vec<HalfEdgeSlot>,
    pub(crate) boundaries: Vec<BoundarySlot>,
    pub(crate) faces: Vec<FaceSlot>,
}

/// Maps the numbers of records to slots. Face 0 is the unbounded face.
pub(crate) trait Numbered {
    fn vertex(&self, number: u32) -> VertexSlot;
    /// The half-edges of an edge have the numbers `2e` and `2e + 1`.
    fn half_edge(&self, number: u32) -> HalfEdgeSlot;
    fn boundary(&self, number: u32) -> BoundarySlot;
    fn face(&self, number: u32) -> FaceSlot;
}

#[cfg(feature = "serde")]
impl Numbered for SavedSlots {
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

/// The slots of a newly filled store: the first ones, in order. Slot 0 of each kind is vacant, and so is the first pair of
/// half-edges.
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

impl Store {
    /// Creates a store with this number of records besides the unbounded face, in the slots of [`InOrder`]. The caller sets all
    /// links.
    ///
    /// # Errors
    /// The kind of record with too many records.
    pub(crate) fn with_records(need: Room) -> Result<Self, RecordKind> {
        let store = Self::with_room(need);
        store.room_for(need)?;
        Ok(store.filled(need))
    }

    /// Adds this number of records to an empty store, which must have room.
    pub(crate) fn filled(mut self, need: Room) -> Self {
        self.edges.issue_many(need.edges);
        self.vertices.issue_many(need.vertices);
        self.boundaries.issue_many(need.boundaries);
        self.faces.issue_many(need.faces);
        self.fill_columns();
        self
    }

    /// Extends the columns to the number of slots.
    pub(super) fn fill_columns(&mut self) {
        let half_edges = 2 * self.edges.end();
        self.origin.resize(half_edges, NIL);
        self.next.resize(half_edges, NIL);
        self.prev.resize(half_edges, NIL);
        self.boundary.resize(half_edges, NIL);
        self.vertex_link.resize(self.vertices.end(), NIL);
        self.boundary_rows.resize(self.boundaries.end(), BoundaryRow::UNUSED);
        self.face_rows.resize(self.faces.end(), FaceRow::EMPTY);
    }
}

/// The generations of all slots, live and vacant, from which keys are made.
#[cfg(feature = "serde")]
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Generations {
    /// The number that the structure adds to its generations; even.
    pub(crate) offset: u32,
    pub(crate) vertices: Vec<u32>,
    pub(crate) edges: Vec<u32>,
    pub(crate) boundaries: Vec<u32>,
    pub(crate) faces: Vec<u32>,
}

/// The live slots of a restored store, by the numbers of their records. The first face is the unbounded face.
#[cfg(feature = "serde")]
pub(crate) struct Live {
    pub(crate) vertices: Vec<u32>,
    pub(crate) half_edges: Vec<u32>,
    pub(crate) boundaries: Vec<u32>,
    pub(crate) faces: Vec<u32>,
}

#[cfg(feature = "serde")]
impl Store {
    pub(crate) fn generations(&self) -> Generations {
        Generations {
            offset: self.vertices.offset(),
            vertices: self.vertices.generations().to_vec(),
            edges: self.edges.generations().to_vec(),
            boundaries: self.boundaries.generations().to_vec(),
            faces: self.faces.generations().to_vec(),
        }
    }

    /// Creates a store with these generations, and returns the slots of its live records. The caller sets all links. `None` if no
    /// store can have these generations. O(slots).
    pub(crate) fn restored(generations: Generations, live: &Live) -> Option<(Self, SavedSlots)> {
        let Generations { offset, vertices, edges, boundaries, faces } = generations;
        let too_many =
            vertices.len() > MOST || edges.len() > MOST_EDGES || boundaries.len() > MOST || faces.len() > MOST;
        if offset % 2 == 1 || too_many {
            return None;
        }
        let vacant_faces: Vec<usize> = (0..faces.len()).filter(|f| faces[*f] % 2 == 0).collect();
        let mut store = Self::with_room(Room::NONE);
        store.vertices = Issuer::restored(vertices, offset)?;
        store.edges = Issuer::restored(edges, offset)?;
        store.boundaries = Issuer::restored(boundaries, offset)?;
        store.faces = Issuer::restored(faces, offset)?;
        store.unbounded = FaceSlot(*live.faces.first()?);
        store.fill_columns();
        for f in vacant_faces {
            store.face_rows[f].outer = VACANT;
        }
        let slots = SavedSlots {
            vertices: live.vertices.iter().copied().map(VertexSlot).collect(),
            half_edges: live.half_edges.iter().copied().map(HalfEdgeSlot).collect(),
            boundaries: live.boundaries.iter().copied().map(BoundarySlot).collect(),
            faces: live.faces.iter().copied().map(FaceSlot).collect(),
        };
        Some((store, slots))
    }
}
