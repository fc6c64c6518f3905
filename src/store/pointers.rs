//! Pointer-style: boxed records joined by raw pointers, as the literature draws them.
//!
//! ```text
//!   keys                    columns of pointers    records, each in a box of its own
//!   half-edge slotmap  [h][t]…   [•][•]…  ───────►  ┌─────────┐ twin  ┌─────────┐
//!   vertex slotmap     [v]…      [•]…               │ key     │◄─────►│ key     │
//!   …                                               │ origin •│─► v   │ origin •│─► w
//!                                                   │ next   •│─►     │ next   •│─►
//!                                                   │ prev   •│─►     │ prev   •│─►
//!                                                   └─────────┘       └─────────┘
//! ```
//!
//! A slot is a pointer to its record, and a step is a bare dereference.
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

use super::issuer::{Issuer, structure_offset, with_room};
use super::keys::{key, parts};
use super::links::{BoundaryStart, Links, Need, OUTER, RecordKind, VertexLink, room};
use super::{BoundaryKey, FaceKey, HalfEdgeKey, Store, VertexKey};
use alloc::boxed::Box;
use alloc::vec::Vec;
use core::cell::{Cell, RefCell};
use core::fmt;
use core::ptr::NonNull;
use slotmap::Key;

/// As for the default store: places stay clear of the two values that mean something else.
const MOST: usize = u32::MAX as usize / 2 - 2;

/// A pointer to a record.
pub struct Ref<R>(NonNull<R>);

impl<R> Ref<R> {
    /// What a link holds until it is set. It is never followed: whoever issues a record sets all its links.
    const UNSET: Self = Self(NonNull::dangling());
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

type VertexRef = Ref<VertexRecord>;
type HalfEdgeRef = Ref<HalfEdgeRecord>;
type BoundaryRef = Ref<BoundaryRecord>;
type FaceRef = Ref<FaceRecord>;

/// A vertex.
pub struct VertexRecord {
    key: Cell<VertexKey>,
    link: Cell<VertexLink<HalfEdgeRef, BoundaryRef>>,
}

/// A half-edge.
pub struct HalfEdgeRecord {
    key: Cell<HalfEdgeKey>,
    origin: Cell<VertexRef>,
    twin: Cell<HalfEdgeRef>,
    next: Cell<HalfEdgeRef>,
    prev: Cell<HalfEdgeRef>,
    boundary: Cell<BoundaryRef>,
}

/// A boundary component.
pub struct BoundaryRecord {
    key: Cell<BoundaryKey>,
    face: Cell<FaceRef>,
    start: Cell<BoundaryStart<HalfEdgeRef, VertexRef>>,
    place: Cell<u32>,
}

/// A face.
pub struct FaceRecord {
    key: Cell<FaceKey>,
    outer: Cell<Option<BoundaryRef>>,
    inner: RefCell<Vec<BoundaryRef>>,
}

/// What the four kinds of record have in common.
trait Record {
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
            place: Cell::new(OUTER),
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
struct Records<R: Record> {
    issuer: Issuer<R::Key>,
    /// Owned. That of slot 1 comes first, because slotmap does not use slot 0.
    boxes: Vec<Ref<R>>,
}

impl<R: Record> Records<R> {
    fn with_room(room: usize, offset: u32) -> Self {
        Self { issuer: Issuer::with_room(room, offset), boxes: with_room(room) }
    }

    fn put_in_box(record: R) -> Ref<R> {
        Ref(NonNull::from(Box::leak(Box::new(record))))
    }

    /// Issues a key and gives a record that shows it. The caller sets all its links.
    fn issue(&mut self) -> Ref<R> {
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

    fn retire(&mut self, r: Ref<R>) {
        self.issuer.retire(self.slot(r));
    }

    #[inline]
    #[allow(clippy::unused_self, reason = "the reference that comes out borrows the records, which keeps them")]
    fn follow(&self, r: Ref<R>) -> &R {
        // SAFETY: `r` points to a box of this store (2), which is freed only when `self`, borrowed for as long as the
        // reference, is dropped (1). Nobody makes a `&mut` of it (3). It was initialised when the box was made.
        unsafe { r.0.as_ref() }
    }

    fn key(&self, r: Ref<R>) -> R::Key {
        self.follow(r).key().get()
    }

    fn slot(&self, r: Ref<R>) -> u32 {
        parts(self.key(r)).0
    }

    fn index(&self, r: Ref<R>) -> usize {
        self.slot(r) as usize
    }

    /// The record of a slot, live or not.
    fn in_slot(&self, slot: u32) -> Option<Ref<R>> {
        self.boxes.get((slot as usize).checked_sub(1)?).copied()
    }

    fn with_key(&self, key: R::Key) -> Option<Ref<R>> {
        let (slot, generation) = parts(key);
        if self.issuer.generation(slot) == generation { self.in_slot(slot) } else { None }
    }

    fn at(&self, index: usize) -> Option<Ref<R>> {
        let slot = u32::try_from(index).ok()?;
        if self.issuer.is_live(slot) { self.in_slot(slot) } else { None }
    }

    /// Records of its own with the same keys in the same slots. The caller sets all their links.
    fn unlinked_copy(&self) -> Self {
        let boxes = self.boxes.iter().map(|r| Self::put_in_box(R::new(self.key(*r)))).collect();
        Self { issuer: self.issuer.clone(), boxes }
    }

    /// The record of this copy that stands for `r` of the original.
    fn counterpart(&self, original: &Self, r: Ref<R>) -> Ref<R> {
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

/// Pointer-style: boxed records joined by raw pointers.
///
/// Nearly three times the memory of [`SlotStore`](super::SlotStore), and slower where a map does not fit into the cache. It
/// is here to be measured against, and to show that the operators do not depend on how records are kept.
///
/// The memory of records that were removed is used again, and given back when the store is dropped.
///
/// It is neither `Send` nor `Sync`:
///
/// ```compile_fail,E0277
/// fn cross_threads(map: impl Send) {}
/// cross_threads(twinedge::dcel::Dcel::<twinedge::store::PointerStore>::default());
/// ```
pub struct PointerStore {
    vertices: Records<VertexRecord>,
    half_edges: Records<HalfEdgeRecord>,
    boundaries: Records<BoundaryRecord>,
    faces: Records<FaceRecord>,
    unbounded: FaceRef,
}

impl Store for PointerStore {}

impl fmt::Debug for PointerStore {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("PointerStore")
            .field("vertices", &self.vertex_count())
            .field("edges", &self.edge_count())
            .field("boundaries", &self.boundary_count())
            .field("faces", &self.face_count())
            .finish_non_exhaustive()
    }
}

/// A copy has records of its own with the same keys. O(slots).
impl Clone for PointerStore {
    fn clone(&self) -> Self {
        let mut copy = Self {
            vertices: self.vertices.unlinked_copy(),
            half_edges: self.half_edges.unlinked_copy(),
            boundaries: self.boundaries.unlinked_copy(),
            faces: self.faces.unlinked_copy(),
            unbounded: Ref::UNSET,
        };
        copy.unbounded = copy.faces.counterpart(&self.faces, self.unbounded);
        let vertex = |v| copy.vertices.counterpart(&self.vertices, v);
        let half_edge = |h| copy.half_edges.counterpart(&self.half_edges, h);
        let boundary = |b| copy.boundaries.counterpart(&self.boundaries, b);
        let face = |f| copy.faces.counterpart(&self.faces, f);
        // Retired records too: then all links of all records lead to records, in the copy as in the original.
        for v in self.vertices.boxes.iter().copied() {
            copy.vertices.follow(vertex(v)).link.set(match self.vertex_link(v) {
                VertexLink::Leaving(h) => VertexLink::Leaving(half_edge(h)),
                VertexLink::Isolated(b) => VertexLink::Isolated(boundary(b)),
            });
        }
        for h in self.half_edges.boxes.iter().copied() {
            let record = copy.half_edges.follow(half_edge(h));
            record.origin.set(vertex(self.origin(h)));
            record.twin.set(half_edge(self.twin(h)));
            record.next.set(half_edge(self.next(h)));
            record.prev.set(half_edge(self.prev(h)));
            record.boundary.set(boundary(self.boundary(h)));
        }
        for b in self.boundaries.boxes.iter().copied() {
            let record = copy.boundaries.follow(boundary(b));
            record.face.set(face(self.face(b)));
            record.start.set(match self.start(b) {
                BoundaryStart::HalfEdge(h) => BoundaryStart::HalfEdge(half_edge(h)),
                BoundaryStart::Vertex(v) => BoundaryStart::Vertex(vertex(v)),
            });
            record.place.set(self.place(b));
        }
        for f in self.faces.boxes.iter().copied() {
            let record = copy.faces.follow(face(f));
            record.outer.set(self.outer(f).map(boundary));
            record.inner.replace(self.faces.follow(f).inner.borrow().iter().copied().map(boundary).collect());
        }
        copy
    }
}

impl Links for PointerStore {
    type Vertex = VertexRef;
    type HalfEdge = HalfEdgeRef;
    type Boundary = BoundaryRef;
    type Face = FaceRef;

    fn with_room(need: Need) -> Self {
        let offset = structure_offset();
        let mut store = Self {
            vertices: Records::with_room(need.vertices, offset),
            half_edges: Records::with_room(need.edges.saturating_mul(2), offset),
            boundaries: Records::with_room(need.boundaries, offset),
            faces: Records::with_room(need.faces.saturating_add(1), offset),
            unbounded: Ref::UNSET,
        };
        store.unbounded = store.add_face();
        store
    }

    fn unbounded(&self) -> FaceRef {
        self.unbounded
    }

    fn room_for(&self, need: Need) -> Result<(), RecordKind> {
        room(self, need, Need { vertices: MOST, edges: MOST / 2, boundaries: MOST, faces: MOST })
    }

    fn find_vertex(&self, key: VertexKey) -> Option<VertexRef> {
        self.vertices.with_key(key)
    }

    fn find_half_edge(&self, key: HalfEdgeKey) -> Option<HalfEdgeRef> {
        self.half_edges.with_key(key)
    }

    fn find_boundary(&self, key: BoundaryKey) -> Option<BoundaryRef> {
        self.boundaries.with_key(key)
    }

    fn find_face(&self, key: FaceKey) -> Option<FaceRef> {
        self.faces.with_key(key)
    }

    #[inline]
    fn vertex_key(&self, v: VertexRef) -> VertexKey {
        self.vertices.key(v)
    }

    #[inline]
    fn half_edge_key(&self, h: HalfEdgeRef) -> HalfEdgeKey {
        self.half_edges.key(h)
    }

    #[inline]
    fn boundary_key(&self, b: BoundaryRef) -> BoundaryKey {
        self.boundaries.key(b)
    }

    #[inline]
    fn face_key(&self, f: FaceRef) -> FaceKey {
        self.faces.key(f)
    }

    fn vertex_count(&self) -> usize {
        self.vertices.issuer.len()
    }

    fn edge_count(&self) -> usize {
        self.half_edges.issuer.len() / 2
    }

    fn boundary_count(&self) -> usize {
        self.boundaries.issuer.len()
    }

    fn face_count(&self) -> usize {
        self.faces.issuer.len()
    }

    fn vertex_slots(&self) -> usize {
        self.vertices.issuer.end()
    }

    fn half_edge_slots(&self) -> usize {
        self.half_edges.issuer.end()
    }

    fn boundary_slots(&self) -> usize {
        self.boundaries.issuer.end()
    }

    fn face_slots(&self) -> usize {
        self.faces.issuer.end()
    }

    fn vertex_at(&self, index: usize) -> Option<VertexRef> {
        self.vertices.at(index)
    }

    fn half_edge_at(&self, index: usize) -> Option<HalfEdgeRef> {
        self.half_edges.at(index)
    }

    fn boundary_at(&self, index: usize) -> Option<BoundaryRef> {
        self.boundaries.at(index)
    }

    fn face_at(&self, index: usize) -> Option<FaceRef> {
        self.faces.at(index)
    }

    fn vertex_index(&self, v: VertexRef) -> usize {
        self.vertices.index(v)
    }

    fn half_edge_index(&self, h: HalfEdgeRef) -> usize {
        self.half_edges.index(h)
    }

    fn boundary_index(&self, b: BoundaryRef) -> usize {
        self.boundaries.index(b)
    }

    fn face_index(&self, f: FaceRef) -> usize {
        self.faces.index(f)
    }

    fn add_vertex(&mut self, link: VertexLink<HalfEdgeRef, BoundaryRef>) -> VertexRef {
        let v = self.vertices.issue();
        self.vertices.follow(v).link.set(link);
        v
    }

    fn add_isolated(&mut self, f: FaceRef) -> (VertexRef, BoundaryRef) {
        let v = self.vertices.issue();
        let b = self.add_boundary(f, BoundaryStart::Vertex(v));
        self.set_vertex_link(v, VertexLink::Isolated(b));
        self.list_inner(f, b);
        (v, b)
    }

    fn add_edge(&mut self, from: VertexRef, to: VertexRef, b: BoundaryRef) -> HalfEdgeRef {
        let (h, t) = (self.half_edges.issue(), self.half_edges.issue());
        for (one, other, origin) in [(h, t, from), (t, h, to)] {
            let record = self.half_edges.follow(one);
            record.origin.set(origin);
            record.twin.set(other);
            record.next.set(other);
            record.prev.set(other);
            record.boundary.set(b);
        }
        h
    }

    fn add_boundary(&mut self, f: FaceRef, start: BoundaryStart<HalfEdgeRef, VertexRef>) -> BoundaryRef {
        let b = self.boundaries.issue();
        let record = self.boundaries.follow(b);
        record.face.set(f);
        record.start.set(start);
        record.place.set(OUTER);
        b
    }

    fn add_face(&mut self) -> FaceRef {
        let f = self.faces.issue();
        let record = self.faces.follow(f);
        record.outer.set(None);
        record.inner.replace(Vec::new());
        f
    }

    fn remove_vertex(&mut self, v: VertexRef) {
        self.vertices.retire(v);
    }

    fn remove_edge(&mut self, h: HalfEdgeRef) {
        self.half_edges.retire(self.twin(h));
        self.half_edges.retire(h);
    }

    fn remove_boundary(&mut self, b: BoundaryRef) {
        self.boundaries.retire(b);
    }

    fn remove_face(&mut self, f: FaceRef) {
        self.faces.retire(f);
    }

    #[inline]
    fn origin(&self, h: HalfEdgeRef) -> VertexRef {
        self.half_edges.follow(h).origin.get()
    }

    #[inline]
    fn twin(&self, h: HalfEdgeRef) -> HalfEdgeRef {
        self.half_edges.follow(h).twin.get()
    }

    #[inline]
    fn next(&self, h: HalfEdgeRef) -> HalfEdgeRef {
        self.half_edges.follow(h).next.get()
    }

    #[inline]
    fn prev(&self, h: HalfEdgeRef) -> HalfEdgeRef {
        self.half_edges.follow(h).prev.get()
    }

    #[inline]
    fn boundary(&self, h: HalfEdgeRef) -> BoundaryRef {
        self.half_edges.follow(h).boundary.get()
    }

    #[inline]
    fn vertex_link(&self, v: VertexRef) -> VertexLink<HalfEdgeRef, BoundaryRef> {
        self.vertices.follow(v).link.get()
    }

    #[inline]
    fn face(&self, b: BoundaryRef) -> FaceRef {
        self.boundaries.follow(b).face.get()
    }

    #[inline]
    fn start(&self, b: BoundaryRef) -> BoundaryStart<HalfEdgeRef, VertexRef> {
        self.boundaries.follow(b).start.get()
    }

    #[inline]
    fn place(&self, b: BoundaryRef) -> u32 {
        self.boundaries.follow(b).place.get()
    }

    #[inline]
    fn outer(&self, f: FaceRef) -> Option<BoundaryRef> {
        self.faces.follow(f).outer.get()
    }

    #[inline]
    fn inner_count(&self, f: FaceRef) -> usize {
        self.faces.follow(f).inner.borrow().len()
    }

    #[inline]
    fn inner(&self, f: FaceRef, position: usize) -> Option<BoundaryRef> {
        self.faces.follow(f).inner.borrow().get(position).copied()
    }

    fn set_origin(&mut self, h: HalfEdgeRef, v: VertexRef) {
        self.half_edges.follow(h).origin.set(v);
    }

    fn join(&mut self, h: HalfEdgeRef, n: HalfEdgeRef) {
        self.half_edges.follow(h).next.set(n);
        self.half_edges.follow(n).prev.set(h);
    }

    fn set_boundary(&mut self, h: HalfEdgeRef, b: BoundaryRef) {
        self.half_edges.follow(h).boundary.set(b);
    }

    fn set_vertex_link(&mut self, v: VertexRef, link: VertexLink<HalfEdgeRef, BoundaryRef>) {
        self.vertices.follow(v).link.set(link);
    }

    fn set_start(&mut self, b: BoundaryRef, start: BoundaryStart<HalfEdgeRef, VertexRef>) {
        self.boundaries.follow(b).start.set(start);
    }

    fn set_place(&mut self, b: BoundaryRef, place: u32) {
        self.boundaries.follow(b).place.set(place);
    }

    fn list_outer(&mut self, f: FaceRef, b: BoundaryRef) {
        self.faces.follow(f).outer.set(Some(b));
        let record = self.boundaries.follow(b);
        record.face.set(f);
        record.place.set(OUTER);
    }

    fn list_inner(&mut self, f: FaceRef, b: BoundaryRef) {
        let mut inner = self.faces.follow(f).inner.borrow_mut();
        let record = self.boundaries.follow(b);
        record.face.set(f);
        record.place.set(inner.len() as u32);
        inner.push(b);
    }

    fn unlist(&mut self, b: BoundaryRef) {
        let record = self.boundaries.follow(b);
        let face = self.faces.follow(record.face.get());
        let place = record.place.replace(OUTER);
        if place == OUTER {
            face.outer.set(None);
            return;
        }
        let mut inner = face.inner.borrow_mut();
        inner.swap_remove(place as usize);
        if let Some(moved) = inner.get(place as usize) {
            self.boundaries.follow(*moved).place.set(place);
        } else if inner.is_empty() {
            *inner = Vec::new();
        }
    }
}
