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

/// The links of a boundary component, together because operators read and write them together.
#[derive(Clone, Copy, Debug)]
pub(super) struct BoundaryRow {
    pub(super) face: FaceSlot,
    pub(super) start: u32,
    pub(super) place: u32,
}

impl BoundaryRow {
    pub(super) const UNUSED: Self = Self { face: FaceSlot(NIL), start: NIL, place: UNLISTED };
}

/// The links of a face, together for the same reason.
#[derive(Clone, Copy, Debug)]
pub(super) struct FaceRow {
    /// The half-edge where the outer boundary component starts, as in the textbooks, for most walks around faces. The
    /// boundary component is found through it.
    pub(super) outer: u32,
    /// The list of inner boundary components: no entry, its only entry, or (high bit) the number of a list.
    pub(super) inner: BoundarySlot,
}

impl FaceRow {
    pub(super) const EMPTY: Self = Self { outer: NIL, inner: NONE };
}

/// The entry of an empty list.
const NONE: BoundarySlot = BoundarySlot(NIL);

/// The longer lists of inner boundary components. Most faces have none, and most others have one, stored in the face.
#[derive(Clone, Debug, Default)]
pub(super) struct InnerLists {
    lists: Vec<Vec<BoundarySlot>>,
    /// The unused lists, which are empty.
    free: Vec<u32>,
}

impl InnerLists {
    /// The list of a face with this entry.
    #[inline]
    pub(super) fn of<'a>(&'a self, entry: &'a BoundarySlot) -> &'a [BoundarySlot] {
        if *entry == NONE {
            &[]
        } else if entry.0 & OTHER == 0 {
            core::slice::from_ref(entry)
        } else {
            &self.lists[(entry.0 ^ OTHER) as usize]
        }
    }

    /// Appends `b` to the list of a face. O(1), amortised.
    pub(super) fn push(&mut self, entry: &mut BoundarySlot, b: BoundarySlot) {
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

    /// Removes a place from the list of a face, and returns the boundary component that takes it, previously the last. O(1).
    pub(super) fn swap_remove(&mut self, entry: &mut BoundarySlot, place: u32) -> Option<BoundarySlot> {
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

    pub(super) fn pop(&mut self, entry: &mut BoundarySlot) {
        let last = self.of(entry).len().saturating_sub(1);
        self.swap_remove(entry, last as u32);
    }

    /// Undoes a [`swap_remove`](Self::swap_remove). O(1), amortised.
    pub(super) fn put_back(&mut self, entry: &mut BoundarySlot, place: u32, b: BoundarySlot) {
        self.push(entry, b);
        let list = if entry.0 & OTHER == 0 { None } else { self.lists.get_mut((entry.0 ^ OTHER) as usize) };
        if let Some(list) = list {
            let last = list.len() - 1;
            list.swap(place as usize, last);
        }
    }
}
