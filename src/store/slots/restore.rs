//! The keys of a structure as they were when it was saved.

use super::columns::{BoundarySlot, FaceSlot, HalfEdgeSlot, MOST, MOST_EDGES, VACANT, VertexSlot};
use super::records::Slots;
use super::store::SlotStore;
use crate::store::issuer::Issuer;
use crate::store::links::{Links, Need};
use alloc::vec::Vec;

/// The generations of all slots, live and vacant: what keys are made of.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Generations {
    /// The number that the structure adds to its generations. Even.
    pub(crate) offset: u32,
    /// By slot of a vertex. Odd if live.
    pub(crate) vertices: Vec<u32>,
    /// By slot of an edge.
    pub(crate) edges: Vec<u32>,
    /// By slot of a boundary component.
    pub(crate) boundaries: Vec<u32>,
    /// By slot of a face.
    pub(crate) faces: Vec<u32>,
}

/// The live slots of a restored store, by the numbers that their records have elsewhere. The first face is the unbounded one.
pub(crate) struct Live {
    pub(crate) vertices: Vec<u32>,
    pub(crate) half_edges: Vec<u32>,
    pub(crate) boundaries: Vec<u32>,
    pub(crate) faces: Vec<u32>,
}

impl SlotStore {
    /// The generations of all slots. O(slots).
    pub(crate) fn generations(&self) -> Generations {
        Generations {
            offset: self.vertices.offset(),
            vertices: self.vertices.generations().to_vec(),
            edges: self.edges.generations().to_vec(),
            boundaries: self.boundaries.generations().to_vec(),
            faces: self.faces.generations().to_vec(),
        }
    }

    /// A store whose slots have these generations, and the slots of its live records. The caller sets all their links.
    /// None if no store can have such generations. O(slots).
    pub(crate) fn restored(generations: Generations, live: &Live) -> Option<(Self, Slots)> {
        let Generations { offset, vertices, edges, boundaries, faces } = generations;
        let too_many =
            vertices.len() > MOST || edges.len() > MOST_EDGES || boundaries.len() > MOST || faces.len() > MOST;
        if offset % 2 == 1 || too_many {
            return None;
        }
        let vacant_faces: Vec<usize> = (0..faces.len()).filter(|f| faces[*f] % 2 == 0).collect();
        let mut store = Self::with_room(Need::NONE);
        store.vertices = Issuer::restored(vertices, offset)?;
        store.edges = Issuer::restored(edges, offset)?;
        store.boundaries = Issuer::restored(boundaries, offset)?;
        store.faces = Issuer::restored(faces, offset)?;
        store.unbounded = FaceSlot(*live.faces.first()?);
        store.fill_columns();
        for f in vacant_faces {
            store.outer[f] = VACANT;
        }
        let slots = Slots {
            vertices: live.vertices.iter().copied().map(VertexSlot).collect(),
            half_edges: live.half_edges.iter().copied().map(HalfEdgeSlot).collect(),
            boundaries: live.boundaries.iter().copied().map(BoundarySlot).collect(),
            faces: live.faces.iter().copied().map(FaceSlot).collect(),
        };
        Some((store, slots))
    }
}
