//! Records in boxes, and pointers to them: all the unsafe that [`PointerStore`](super::PointerStore) needs.
//!
//! # Why the unsafe here is sound
//!
//! 1. *A slot can be dereferenced as long as its store lives.* A box once made is freed by one piece of code, the `Drop` of
//!    [`Records`], and never moves. What is retired stays in its column and is used again with the next key of its index.
//!    So even the slot of a retired record leads to a record: to the wrong one perhaps, but to memory that is a record of
//!    that kind.
//! 2. *A slot is used with the store that it is of.* [`Links`] cannot be named outside this crate, and outside it there is
//!    neither a store nor a slot to be had. Inside, slots live in the links of their own store, in references that borrow
//!    the structure around that store, and in an operator's variables until it ends, while it borrows that structure.
//! 3. *There is never a `&mut` to a record*, so no reference to one can be invalidated: what changes is in cells, and all
//!    access goes through shared references, of which the same record may have any number. Cells and raw pointers keep a
//!    store on one thread: it is neither `Send` nor `Sync`.

#![allow(unsafe_code, reason = "this is the file to which the crate's raw pointers are confined")]

use crate::store::issuer::{Issuer, with_room};
use crate::store::keys::{BoundaryKey, FaceKey, HalfEdgeKey, VertexKey, key, parts};
use crate::store::links::{BoundaryStart, VertexLink};
use crate::store::place::UNLISTED;
use alloc::boxed::Box;
use alloc::vec::Vec;
use core::cell::{Cell, RefCell};
use core::fmt;
use core::ptr::NonNull;
use slotmap::Key;

/// A pointer to a record.
pub struct Ref<R>(NonNull<R>);

impl<R> Ref<R> {
    /// The value of a link until it is set. It is never followed: the caller of `issue` sets all links of the record.
    pub(super) const UNSET: Self = Self(NonNull::dangling());
}

impl<R> Clone for Ref<R> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<R> Copy for Ref<R> {}

impl<R> PartialEq for Ref<R> {
    fn eq(&self, other: &Self) -> bool {
        self.0 == other.0
    }
}

impl<R> Eq for Ref<R> {}

impl<R> fmt::Debug for Ref<R> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

pub(super) type VertexRef = Ref<VertexRecord>;
pub(super) type HalfEdgeRef = Ref<HalfEdgeRecord>;
pub(super) type BoundaryRef = Ref<BoundaryRecord>;
pub(super) type FaceRef = Ref<FaceRecord>;

/// A vertex.
pub struct VertexRecord {
    pub(super) key: Cell<VertexKey>,
    pub(super) link: Cell<VertexLink<HalfEdgeRef, BoundaryRef>>,
}

/// A half-edge.
pub struct HalfEdgeRecord {
    pub(super) key: Cell<HalfEdgeKey>,
    pub(super) origin: Cell<VertexRef>,
    pub(super) twin: Cell<HalfEdgeRef>,
    pub(super) next: Cell<HalfEdgeRef>,
    pub(super) prev: Cell<HalfEdgeRef>,
    pub(super) boundary: Cell<BoundaryRef>,
}

/// A boundary component.
pub struct BoundaryRecord {
    pub(super) key: Cell<BoundaryKey>,
    pub(super) face: Cell<FaceRef>,
    pub(super) start: Cell<BoundaryStart<HalfEdgeRef, VertexRef>>,
    pub(super) place: Cell<u32>,
}

/// A face.
pub struct FaceRecord {
    pub(super) key: Cell<FaceKey>,
    pub(super) outer: Cell<Option<BoundaryRef>>,
    pub(super) inner: RefCell<Vec<BoundaryRef>>,
}

/// The interface that the four kinds of record have in common.
pub(super) trait Record {
    type Key: Key;

    /// A record with this key, whose links are to be set before anything follows them.
    fn new(key: Self::Key) -> Self;
    fn key(&self) -> &Cell<Self::Key>;
}

impl Record for VertexRecord {
    type Key = VertexKey;

    fn new(key: VertexKey) -> Self {
        Self { key: Cell::new(key), link: Cell::new(VertexLink::Isolated(Ref::UNSET)) }
    }

    fn key(&self) -> &Cell<VertexKey> {
        &self.key
    }
}

impl Record for HalfEdgeRecord {
    type Key = HalfEdgeKey;

    fn new(key: HalfEdgeKey) -> Self {
        Self {
            key: Cell::new(key),
            origin: Cell::new(Ref::UNSET),
            twin: Cell::new(Ref::UNSET),
            next: Cell::new(Ref::UNSET),
            prev: Cell::new(Ref::UNSET),
            boundary: Cell::new(Ref::UNSET),
        }
    }

    fn key(&self) -> &Cell<HalfEdgeKey> {
        &self.key
    }
}

impl Record for BoundaryRecord {
    type Key = BoundaryKey;

    fn new(key: BoundaryKey) -> Self {
        Self {
            key: Cell::new(key),
            face: Cell::new(Ref::UNSET),
            start: Cell::new(BoundaryStart::Vertex(Ref::UNSET)),
            place: Cell::new(UNLISTED),
        }
    }

    fn key(&self) -> &Cell<BoundaryKey> {
        &self.key
    }
}

impl Record for FaceRecord {
    type Key = FaceKey;

    fn new(key: FaceKey) -> Self {
        Self { key: Cell::new(key), outer: Cell::new(None), inner: RefCell::new(Vec::new()) }
    }

    fn key(&self) -> &Cell<FaceKey> {
        &self.key
    }
}

/// The records of one kind: who issues, checks and retires their keys, and the boxes.
pub(super) struct Records<R: Record> {
    pub(super) issuer: Issuer,
    /// Owned. That of slot 1 comes first, because slot 0 is not used.
    pub(super) boxes: Vec<Ref<R>>,
}

impl<R: Record> Records<R> {
    pub(super) fn with_room(room: usize, offset: u32) -> Self {
        Self { issuer: Issuer::with_room(room, offset), boxes: with_room(room) }
    }

    fn put_in_box(record: R) -> Ref<R> {
        Ref(NonNull::from(Box::leak(Box::new(record))))
    }

    /// Issues a key and gives a record that shows it. The caller sets all its links.
    pub(super) fn issue(&mut self) -> Ref<R> {
        let slot = self.issuer.issue();
        let key = key(slot, self.issuer.generation(slot));
        if let Some(used) = self.in_slot(slot) {
            self.follow(used).key().set(key);
            return used;
        }
        let made = Self::put_in_box(R::new(key));
        self.boxes.push(made);
        made
    }

    pub(super) fn retire(&mut self, r: Ref<R>) {
        self.issuer.retire(self.slot(r));
    }

    #[inline]
    #[allow(clippy::unused_self, reason = "the reference that comes out borrows the records, which keeps them")]
    pub(super) fn follow(&self, r: Ref<R>) -> &R {
        // SAFETY: `r` points to a box of this store (2), which is freed only when `self`, borrowed for as long as the
        // reference, is dropped (1). Nobody makes a `&mut` of it (3). It was initialised when the box was made.
        unsafe { r.0.as_ref() }
    }

    pub(super) fn key(&self, r: Ref<R>) -> R::Key {
        self.follow(r).key().get()
    }

    fn slot(&self, r: Ref<R>) -> u32 {
        parts(self.key(r)).0
    }

    pub(super) fn index(&self, r: Ref<R>) -> usize {
        self.slot(r) as usize
    }

    /// The record of a slot, live or not.
    fn in_slot(&self, slot: u32) -> Option<Ref<R>> {
        self.boxes.get((slot as usize).checked_sub(1)?).copied()
    }

    pub(super) fn with_key(&self, key: R::Key) -> Option<Ref<R>> {
        let (slot, generation) = parts(key);
        if self.issuer.generation(slot) == generation { self.in_slot(slot) } else { None }
    }

    pub(super) fn at(&self, index: usize) -> Option<Ref<R>> {
        let slot = u32::try_from(index).ok()?;
        if self.issuer.is_live(slot) { self.in_slot(slot) } else { None }
    }

    /// Records of its own with the same keys in the same slots. The caller sets all their links.
    pub(super) fn unlinked_copy(&self) -> Self {
        let boxes = self.boxes.iter().map(|r| Self::put_in_box(R::new(self.key(*r)))).collect();
        Self { issuer: self.issuer.clone(), boxes }
    }

    /// The record of this copy that stands for `r` of the original.
    pub(super) fn counterpart(&self, original: &Self, r: Ref<R>) -> Ref<R> {
        self.boxes[original.index(r) - 1]
    }
}

impl<R: Record> Drop for Records<R> {
    fn drop(&mut self) {
        for r in self.boxes.drain(..) {
            // SAFETY: the pointer came from `Box::leak`, stands in this column once, and is freed nowhere else.
            drop(unsafe { Box::from_raw(r.0.as_ptr()) });
        }
    }
}
