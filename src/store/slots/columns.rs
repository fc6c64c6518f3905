//! Slots of 32 bits, and how links are written with them.

use crate::store::issuer::with_room;
use crate::store::links::{BoundaryStart, VertexLink};
use crate::store::place;
use alloc::vec::Vec;

/// Marks a link that leads to the rarer of two kinds of record.
pub(super) const OTHER: u32 = 1 << 31;

/// Slots must leave room for [`OTHER`], and edges for two half-edges each.
pub(super) const MOST: usize = OTHER as usize - 2;
pub(super) const MOST_EDGES: usize = MOST / 2;

const _: () = assert!(MOST < place::MOST as usize);

/// Stands for the outer half-edge of a face that was removed.
pub(super) const VACANT: u32 = u32::MAX - 1;

macro_rules! slot_types {
    ($($(#[$doc:meta])* $name:ident;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[repr(transparent)]
        pub struct $name(pub(super) u32);
    )*};
}

slot_types! {
    /// The slot of a vertex.
    VertexSlot;
    /// The slot of a half-edge.
    HalfEdgeSlot;
    /// The slot of a boundary component.
    BoundarySlot;
    /// The slot of a face.
    FaceSlot;
}

/// Writes to a column, growing it by one where the slot is new.
pub(super) fn put<T>(column: &mut Vec<T>, slot: u32, value: T) {
    match column.get_mut(slot as usize) {
        Some(entry) => *entry = value,
        None => column.push(value),
    }
}

/// A column with room for `room` slots beyond the first, which slotmap does not use.
pub(super) fn column<T: Clone>(room: usize, unused: T, count: usize) -> Vec<T> {
    let mut column = with_room(room.saturating_add(count));
    column.resize(count, unused);
    column
}

pub(super) const fn vertex_link_bits(link: VertexLink<HalfEdgeSlot, BoundarySlot>) -> u32 {
    match link {
        VertexLink::Leaving(h) => h.0,
        VertexLink::Isolated(b) => b.0 | OTHER,
    }
}

pub(super) const fn start_bits(start: BoundaryStart<HalfEdgeSlot, VertexSlot>) -> u32 {
    match start {
        BoundaryStart::HalfEdge(h) => h.0,
        BoundaryStart::Vertex(v) => v.0 | OTHER,
    }
}
