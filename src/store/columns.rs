//! 32-bit slots, the links stored in them, the lists of inner boundary components, and the limits on records.

use super::issuer::with_room;
use crate::numbers::NIL;
use alloc::vec::Vec;
use core::fmt;

/// Marks a link to the rarer of two kinds of record.
pub(super) const OTHER: u32 = 1 << 31;

/// Slots must leave room for [`OTHER`], and edges for two half-edges each.
pub(super) const MOST: usize = OTHER as usize - 2;
pub(super) const MOST_EDGES: usize = MOST / 2;

/// Marks the outer boundary component.
///
/// The place of a boundary component in the lists of its face is one number: a position among the inner boundary components, or one
/// of these constants. While an operator runs, places of outer boundary components also link a queue: the number is then the slot of
/// the next boundary component.
pub(crate) const OUTER: u32 = u32::MAX;

/// Marks the end of an operator's queue.
pub(crate) const LAST: u32 = u32::MAX - 1;

/// Marks a component that no face lists.
pub(crate) const UNLISTED: u32 = u32::MAX - 2;

const _: () = assert!(MOST < UNLISTED as usize);

/// Stands for the outer half-edge of a removed face.
pub(super) const VACANT: u32 = u32::MAX - 1;

macro_rules! slot_types {
    ($($(#[$doc:meta])* $name:ident;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[repr(transparent)]
        pub(crate) struct $name(pub(super) u32);

        impl $name {
            #[inline]
            pub(crate) const fn index(self) -> usize {
                self.0 as usize
            }
        }
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

/// The link stored in a vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VertexLink<H = u32, B = u32> {
    /// A half-edge that leaves it.
    Leaving(H),
    /// The boundary component of an isolated vertex.
    Isolated(B),
}

/// The start of a boundary component.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BoundaryStart<H = u32, V = u32> {
    /// A half-edge of its cycle.
    HalfEdge(H),
    /// An isolated vertex.
    Vertex(V),
}

/// Numbers of records of each kind: records about to be added, or the limits of a structure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Room {
    /// Vertices.
    pub vertices: usize,
    /// Edges.
    pub edges: usize,
    /// Boundary components.
    pub boundaries: usize,
    /// Faces, including the unbounded face.
    pub faces: usize,
}

impl Room {
    /// No records.
    pub const NONE: Self = Self { vertices: 0, edges: 0, boundaries: 0, faces: 0 };
}

/// The kind of record for which there is no room.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum RecordKind {
    /// Vertices.
    Vertex,
    /// Edges.
    Edge,
    /// Boundary components.
    Boundary,
    /// Faces.
    Face,
}

impl fmt::Display for RecordKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Vertex => "vertices",
            Self::Edge => "edges",
            Self::Boundary => "boundary components",
            Self::Face => "faces",
        })
    }
}

/// Writes to a column, appending if the slot is new.
pub(super) fn put<T>(column: &mut Vec<T>, slot: u32, value: T) {
    match column.get_mut(slot as usize) {
        Some(entry) => *entry = value,
        None => column.push(value),
    }
}

/// A column with room for `room` slots after the first, which slotmap does not use.
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

/// The entry of an empty list.
const NONE: BoundarySlot = BoundarySlot(NIL);

/// The list of each face, by slot. Most lists are empty and most others have one entry; only longer ones are on the
/// heap.
#[derive(Clone, Debug, Default)]
pub(super) struct InnerLists {
    /// Per face: no entry, its only entry, or (high bit) the number of its list.
    faces: Vec<BoundarySlot>,
    lists: Vec<Vec<BoundarySlot>>,
    /// The unused lists, which are empty.
    free: Vec<u32>,
}

impl InnerLists {
    pub(super) const fn new(faces: Vec<BoundarySlot>) -> Self {
        Self { faces, lists: Vec::new(), free: Vec::new() }
    }

    pub(super) const fn unused() -> BoundarySlot {
        NONE
    }

    /// Adds faces with empty lists up to this number of slots.
    pub(super) fn resize(&mut self, faces: usize) {
        self.faces.resize(faces, NONE);
    }

    pub(super) fn add(&mut self, face: u32) {
        put(&mut self.faces, face, NONE);
    }

    #[inline]
    pub(super) fn of(&self, face: u32) -> &[BoundarySlot] {
        let entry = &self.faces[face as usize];
        if *entry == NONE {
            &[]
        } else if entry.0 & OTHER == 0 {
            core::slice::from_ref(entry)
        } else {
            &self.lists[(entry.0 ^ OTHER) as usize]
        }
    }

    /// Appends an entry to the list of a face. O(1), amortised.
    pub(super) fn push(&mut self, face: u32, b: BoundarySlot) {
        let entry = &mut self.faces[face as usize];
        if *entry == NONE {
            *entry = b;
        } else if entry.0 & OTHER == 0 {
            let list = self.free.pop().unwrap_or_else(|| {
                self.lists.push(Vec::new());
                self.lists.len() as u32 - 1
            });
            self.lists[list as usize].extend([*entry, b]);
            *entry = BoundarySlot(list | OTHER);
        } else {
            self.lists[(entry.0 ^ OTHER) as usize].push(b);
        }
    }

    /// Removes an entry from the list of a face, and returns the entry that takes its place, previously the last. O(1).
    pub(super) fn swap_remove(&mut self, face: u32, place: u32) -> Option<BoundarySlot> {
        let entry = &mut self.faces[face as usize];
        if entry.0 & OTHER == 0 {
            *entry = NONE;
            return None;
        }
        let number = entry.0 ^ OTHER;
        let list = self.lists.get_mut(number as usize)?;
        list.swap_remove(place as usize);
        if list.is_empty() {
            *list = Vec::new();
            self.free.push(number);
            *entry = NONE;
            return None;
        }
        list.get(place as usize).copied()
    }
    pub(super) fn pop(&mut self, face: u32) {
        let last = self.of(face).len().saturating_sub(1);
        self.swap_remove(face, last as u32);
    }

    /// Undoes a [`swap_remove`](Self::swap_remove). O(1), amortised.
    pub(super) fn put_back(&mut self, face: u32, place: u32, b: BoundarySlot) {
        self.push(face, b);
        let entry = self.faces[face as usize];
        let list = if entry.0 & OTHER == 0 { None } else { self.lists.get_mut((entry.0 ^ OTHER) as usize) };
        if let Some(list) = list {
            let last = list.len() - 1;
            list.swap(place as usize, last);
        }
    }
}
