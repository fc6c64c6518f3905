//! The store over records in boxes.

use super::records::{
    BoundaryRecord, BoundaryRef, FaceRecord, FaceRef, HalfEdgeRecord, HalfEdgeRef, Records, Ref, VertexRecord,
    VertexRef,
};
use crate::store::issuer::structure_offset;
use crate::store::keys::{BoundaryKey, FaceKey, HalfEdgeKey, VertexKey};
use crate::store::links::{BoundaryStart, Links, Need, RecordKind, Store, VertexLink, room};
use crate::store::place::{self, OUTER, UNLISTED};
use alloc::vec::Vec;
use core::fmt;

/// As for the default store: places stay clear of the two values that mean something else.
const MOST: usize = u32::MAX as usize / 2 - 2;

const _: () = assert!(MOST < place::MOST as usize);

/// Pointer-style: boxed records joined by raw pointers.
///
/// Nearly three times the memory of [`SlotStore`](crate::store::SlotStore), and slower where a map does not fit into the cache. It
/// is here for comparison, and to show that the operators do not depend on how records are kept.
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
        record.place.set(UNLISTED);
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
        let place = record.place.replace(UNLISTED);
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
