//! Fixed arrays: no heap at all, which is what a model checker can digest.
//!
//! ```text
//!   vertices   generations [1][1][2]   records [ ][ ][ ]   free [2]        V = 3, two live
//!   edges      generations [1][0]      records [h t][· ·]  free [1]        E = 2, one live; twin(h) is h ^ 1
//!   …
//! ```
//!
//! Links are 8-bit slots, so there are at most 255 records of a kind. Free slots are kept on a stack, so that no key is
//! issued, checked or retired by a loop, which a model checker would have to unroll.
//!
//! Slots, and with them indices, count from 0. The keys count from 1 (half-edges from 2), as slotmap's do, because its
//! secondary maps pass over the first slot when they are iterated.

use super::issuer::structure_offset;
use super::keys::{BoundaryKey, FaceKey, HalfEdgeKey, VertexKey, key, parts};
use super::links::{BoundaryStart, Links, Need, RecordKind, Store, VertexLink, room};
use super::place::{OUTER, UNLISTED};
use slotmap::Key;

/// As many records of one kind as 8-bit slots tell apart, and their number fits too.
const MOST: usize = u8::MAX as usize;
const MOST_EDGES: usize = MOST / 2;

macro_rules! slot_types {
    ($($(#[$doc:meta])* $name:ident;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub struct $name(u8);
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

#[derive(Clone, Copy, Debug)]
struct VertexRecord {
    link: VertexLink<HalfEdgeSlot, BoundarySlot>,
}

#[derive(Clone, Copy, Debug)]
struct HalfEdgeRecord {
    origin: VertexSlot,
    next: HalfEdgeSlot,
    prev: HalfEdgeSlot,
    boundary: BoundarySlot,
}

#[derive(Clone, Copy, Debug)]
struct BoundaryRecord {
    face: FaceSlot,
    start: BoundaryStart<HalfEdgeSlot, VertexSlot>,
    place: u32,
}

#[derive(Clone, Copy, Debug)]
struct FaceRecord<const B: usize> {
    outer: Option<BoundarySlot>,
    inner: [BoundarySlot; B],
    inner_count: u8,
}

impl VertexRecord {
    const UNUSED: Self = Self { link: VertexLink::Isolated(BoundarySlot(0)) };
}

impl HalfEdgeRecord {
    const UNUSED: Self =
        Self { origin: VertexSlot(0), next: HalfEdgeSlot(0), prev: HalfEdgeSlot(0), boundary: BoundarySlot(0) };
}

impl BoundaryRecord {
    const UNUSED: Self = Self { face: FaceSlot(0), start: BoundaryStart::Vertex(VertexSlot(0)), place: UNLISTED };
}

impl<const B: usize> FaceRecord<B> {
    const UNUSED: Self = Self { outer: None, inner: [BoundarySlot(0); B], inner_count: 0 };
}

/// The records of one kind, and what issues, checks and retires their slots.
#[derive(Clone, Debug)]
struct Pool<R, const N: usize> {
    records: [R; N],
    /// Per slot: how often it was issued and retired. Odd if live.
    generations: [u32; N],
    /// A stack of the free slots. What was retired last is issued first, as slotmap does it.
    free: [u8; N],
    free_count: u8,
}

impl<R: Copy, const N: usize> Pool<R, N> {
    fn new(unused: R) -> Self {
        let free = core::array::from_fn(|i| (N - 1 - i) as u8);
        Self { records: [unused; N], generations: [0; N], free, free_count: N as u8 }
    }

    fn len(&self) -> usize {
        N - usize::from(self.free_count)
    }

    fn issue(&mut self, record: R) -> u8 {
        self.free_count -= 1;
        let slot = self.free[usize::from(self.free_count)];
        self.records[usize::from(slot)] = record;
        self.generations[usize::from(slot)] = self.generations[usize::from(slot)].wrapping_add(1);
        slot
    }

    fn retire(&mut self, slot: u8) {
        self.generations[usize::from(slot)] = self.generations[usize::from(slot)].wrapping_add(1);
        self.free[usize::from(self.free_count)] = slot;
        self.free_count += 1;
    }

    /// The slot with this index, if it is live.
    fn live(&self, index: usize) -> Option<u8> {
        (self.generations.get(index)? % 2 == 1).then_some(index as u8)
    }

    /// The slot with this index, if it shows this generation.
    fn checked(&self, index: usize, generation: u32) -> Option<u8> {
        let slot = self.live(index)?;
        (self.generations[index] == generation).then_some(slot)
    }

    fn get(&self, slot: u8) -> &R {
        &self.records[usize::from(slot)]
    }

    fn get_mut(&mut self, slot: u8) -> &mut R {
        &mut self.records[usize::from(slot)]
    }
}

/// A store of fixed size, without heap: room for `V` vertices, `E` edges, `B` boundary components and `F` faces, the
/// unbounded one included.
///
/// What does not fit is refused with [`OperatorError::Full`](crate::dcel::OperatorError::Full). Sizes that cannot be are
/// refused by the compiler: at least one face, at most 255 records of a kind, at most 127 edges.
///
/// The inner boundary components of the faces take `B * F` bytes, the rest about 18 bytes per edge, 7 per vertex, 17 per
/// boundary component and 8 per face.
///
/// ```
/// use twinedge::dcel::{Dcel, RecordKind, OperatorError};
/// use twinedge::store::FixedStore;
///
/// let mut map: Dcel<FixedStore<2, 1, 2, 1>> = Dcel::default();
/// let outside = map.unbounded_face().key();
/// map.add_isolated_vertex(outside)?;
/// map.add_isolated_vertex(outside)?;
/// assert_eq!(map.add_isolated_vertex(outside), Err(OperatorError::Full(RecordKind::Vertex)));
/// # Ok::<(), OperatorError>(())
/// ```
///
/// ```compile_fail
/// // No map is without its unbounded face.
/// let _ = twinedge::dcel::Dcel::<twinedge::store::FixedStore<1, 1, 1, 0>>::default();
/// ```
#[derive(Clone, Debug)]
pub struct FixedStore<const V: usize, const E: usize, const B: usize, const F: usize> {
    vertices: Pool<VertexRecord, V>,
    edges: Pool<[HalfEdgeRecord; 2], E>,
    boundaries: Pool<BoundaryRecord, B>,
    faces: Pool<FaceRecord<B>, F>,
    unbounded: FaceSlot,
    offset: u32,
}

impl<const V: usize, const E: usize, const B: usize, const F: usize> FixedStore<V, E, B, F> {
    const SIZES_FIT: () = {
        assert!(F >= 1, "there is always an unbounded face");
        assert!(V <= MOST && B <= MOST && F <= MOST, "at most 255 records of a kind");
        assert!(E <= MOST_EDGES, "at most 127 edges");
    };

    fn generation<K: Key>(&self, key: K) -> (usize, u32) {
        let (slot, generation) = parts(key);
        (slot as usize, generation.wrapping_sub(self.offset))
    }

    fn key<K: Key>(&self, slot: u32, generation: u32) -> K {
        key(slot, generation.wrapping_add(self.offset))
    }

    fn half_edge_record(&self, h: HalfEdgeSlot) -> &HalfEdgeRecord {
        &self.edges.get(h.0 >> 1)[usize::from(h.0 & 1)]
    }

    fn half_edge_record_mut(&mut self, h: HalfEdgeSlot) -> &mut HalfEdgeRecord {
        &mut self.edges.get_mut(h.0 >> 1)[usize::from(h.0 & 1)]
    }
}

impl<const V: usize, const E: usize, const B: usize, const F: usize> Store for FixedStore<V, E, B, F> {}

impl<const V: usize, const E: usize, const B: usize, const F: usize> Links for FixedStore<V, E, B, F> {
    type Vertex = VertexSlot;
    type HalfEdge = HalfEdgeSlot;
    type Boundary = BoundarySlot;
    type Face = FaceSlot;

    fn with_room(_: Need) -> Self {
        let () = Self::SIZES_FIT;
        let mut store = Self {
            vertices: Pool::new(VertexRecord::UNUSED),
            edges: Pool::new([HalfEdgeRecord::UNUSED; 2]),
            boundaries: Pool::new(BoundaryRecord::UNUSED),
            faces: Pool::new(FaceRecord::UNUSED),
            unbounded: FaceSlot(0),
            // To a model checker, which sees no other structure, a counter shared between threads is noise.
            offset: if cfg!(kani) { 0 } else { structure_offset() },
        };
        store.unbounded = store.add_face();
        store
    }

    fn unbounded(&self) -> FaceSlot {
        self.unbounded
    }

    fn room_for(&self, need: Need) -> Result<(), RecordKind> {
        room(self, need, Need { vertices: V, edges: E, boundaries: B, faces: F })
    }

    fn find_vertex(&self, key: VertexKey) -> Option<VertexSlot> {
        let (slot, generation) = self.generation(key);
        self.vertices.checked(slot.checked_sub(1)?, generation).map(VertexSlot)
    }

    fn find_half_edge(&self, key: HalfEdgeKey) -> Option<HalfEdgeSlot> {
        let (slot, generation) = self.generation(key);
        let edge = self.edges.checked((slot >> 1).checked_sub(1)?, generation)?;
        Some(HalfEdgeSlot(edge << 1 | (slot & 1) as u8))
    }

    fn find_boundary(&self, key: BoundaryKey) -> Option<BoundarySlot> {
        let (slot, generation) = self.generation(key);
        self.boundaries.checked(slot.checked_sub(1)?, generation).map(BoundarySlot)
    }

    fn find_face(&self, key: FaceKey) -> Option<FaceSlot> {
        let (slot, generation) = self.generation(key);
        self.faces.checked(slot.checked_sub(1)?, generation).map(FaceSlot)
    }

    fn vertex_key(&self, v: VertexSlot) -> VertexKey {
        self.key(u32::from(v.0) + 1, self.vertices.generations[usize::from(v.0)])
    }

    fn half_edge_key(&self, h: HalfEdgeSlot) -> HalfEdgeKey {
        self.key(u32::from(h.0) + 2, self.edges.generations[usize::from(h.0 >> 1)])
    }

    fn boundary_key(&self, b: BoundarySlot) -> BoundaryKey {
        self.key(u32::from(b.0) + 1, self.boundaries.generations[usize::from(b.0)])
    }

    fn face_key(&self, f: FaceSlot) -> FaceKey {
        self.key(u32::from(f.0) + 1, self.faces.generations[usize::from(f.0)])
    }

    fn vertex_count(&self) -> usize {
        self.vertices.len()
    }

    fn edge_count(&self) -> usize {
        self.edges.len()
    }

    fn boundary_count(&self) -> usize {
        self.boundaries.len()
    }

    fn face_count(&self) -> usize {
        self.faces.len()
    }

    fn vertex_slots(&self) -> usize {
        V
    }

    fn half_edge_slots(&self) -> usize {
        2 * E
    }

    fn boundary_slots(&self) -> usize {
        B
    }

    fn face_slots(&self) -> usize {
        F
    }

    fn vertex_at(&self, index: usize) -> Option<VertexSlot> {
        self.vertices.live(index).map(VertexSlot)
    }

    fn half_edge_at(&self, index: usize) -> Option<HalfEdgeSlot> {
        self.edges.live(index >> 1).map(|edge| HalfEdgeSlot(edge << 1 | (index & 1) as u8))
    }

    fn boundary_at(&self, index: usize) -> Option<BoundarySlot> {
        self.boundaries.live(index).map(BoundarySlot)
    }

    fn face_at(&self, index: usize) -> Option<FaceSlot> {
        self.faces.live(index).map(FaceSlot)
    }

    fn vertex_index(&self, v: VertexSlot) -> usize {
        usize::from(v.0)
    }

    fn half_edge_index(&self, h: HalfEdgeSlot) -> usize {
        usize::from(h.0)
    }

    fn boundary_index(&self, b: BoundarySlot) -> usize {
        usize::from(b.0)
    }

    fn face_index(&self, f: FaceSlot) -> usize {
        usize::from(f.0)
    }

    fn add_vertex(&mut self, link: VertexLink<HalfEdgeSlot, BoundarySlot>) -> VertexSlot {
        VertexSlot(self.vertices.issue(VertexRecord { link }))
    }

    fn add_isolated(&mut self, f: FaceSlot) -> (VertexSlot, BoundarySlot) {
        let v = VertexSlot(self.vertices.issue(VertexRecord::UNUSED));
        let b = self.add_boundary(f, BoundaryStart::Vertex(v));
        self.set_vertex_link(v, VertexLink::Isolated(b));
        self.list_inner(f, b);
        (v, b)
    }

    fn add_edge(&mut self, from: VertexSlot, to: VertexSlot, b: BoundarySlot) -> HalfEdgeSlot {
        let h = HalfEdgeSlot(self.edges.issue([HalfEdgeRecord::UNUSED; 2]) << 1);
        let t = self.twin(h);
        *self.half_edge_record_mut(h) = HalfEdgeRecord { origin: from, next: t, prev: t, boundary: b };
        *self.half_edge_record_mut(t) = HalfEdgeRecord { origin: to, next: h, prev: h, boundary: b };
        h
    }

    fn add_boundary(&mut self, f: FaceSlot, start: BoundaryStart<HalfEdgeSlot, VertexSlot>) -> BoundarySlot {
        BoundarySlot(self.boundaries.issue(BoundaryRecord { face: f, start, place: UNLISTED }))
    }

    fn add_face(&mut self) -> FaceSlot {
        FaceSlot(self.faces.issue(FaceRecord::UNUSED))
    }

    fn remove_vertex(&mut self, v: VertexSlot) {
        self.vertices.retire(v.0);
    }

    fn remove_edge(&mut self, h: HalfEdgeSlot) {
        self.edges.retire(h.0 >> 1);
    }

    fn remove_boundary(&mut self, b: BoundarySlot) {
        self.boundaries.retire(b.0);
    }

    fn remove_face(&mut self, f: FaceSlot) {
        self.faces.retire(f.0);
    }

    fn origin(&self, h: HalfEdgeSlot) -> VertexSlot {
        self.half_edge_record(h).origin
    }

    fn twin(&self, h: HalfEdgeSlot) -> HalfEdgeSlot {
        HalfEdgeSlot(h.0 ^ 1)
    }

    fn next(&self, h: HalfEdgeSlot) -> HalfEdgeSlot {
        self.half_edge_record(h).next
    }

    fn prev(&self, h: HalfEdgeSlot) -> HalfEdgeSlot {
        self.half_edge_record(h).prev
    }

    fn boundary(&self, h: HalfEdgeSlot) -> BoundarySlot {
        self.half_edge_record(h).boundary
    }

    fn vertex_link(&self, v: VertexSlot) -> VertexLink<HalfEdgeSlot, BoundarySlot> {
        self.vertices.get(v.0).link
    }

    fn face(&self, b: BoundarySlot) -> FaceSlot {
        self.boundaries.get(b.0).face
    }

    fn start(&self, b: BoundarySlot) -> BoundaryStart<HalfEdgeSlot, VertexSlot> {
        self.boundaries.get(b.0).start
    }

    fn place(&self, b: BoundarySlot) -> u32 {
        self.boundaries.get(b.0).place
    }

    fn outer(&self, f: FaceSlot) -> Option<BoundarySlot> {
        self.faces.get(f.0).outer
    }

    fn inner_count(&self, f: FaceSlot) -> usize {
        usize::from(self.faces.get(f.0).inner_count)
    }

    fn inner(&self, f: FaceSlot, position: usize) -> Option<BoundarySlot> {
        if position < self.inner_count(f) { self.faces.get(f.0).inner.get(position).copied() } else { None }
    }

    fn set_origin(&mut self, h: HalfEdgeSlot, v: VertexSlot) {
        self.half_edge_record_mut(h).origin = v;
    }

    fn join(&mut self, h: HalfEdgeSlot, n: HalfEdgeSlot) {
        self.half_edge_record_mut(h).next = n;
        self.half_edge_record_mut(n).prev = h;
    }

    fn set_boundary(&mut self, h: HalfEdgeSlot, b: BoundarySlot) {
        self.half_edge_record_mut(h).boundary = b;
    }

    fn set_vertex_link(&mut self, v: VertexSlot, link: VertexLink<HalfEdgeSlot, BoundarySlot>) {
        self.vertices.get_mut(v.0).link = link;
    }

    fn set_start(&mut self, b: BoundarySlot, start: BoundaryStart<HalfEdgeSlot, VertexSlot>) {
        self.boundaries.get_mut(b.0).start = start;
    }

    fn set_place(&mut self, b: BoundarySlot, place: u32) {
        self.boundaries.get_mut(b.0).place = place;
    }

    fn list_outer(&mut self, f: FaceSlot, b: BoundarySlot) {
        self.faces.get_mut(f.0).outer = Some(b);
        let record = self.boundaries.get_mut(b.0);
        (record.face, record.place) = (f, OUTER);
    }

    fn list_inner(&mut self, f: FaceSlot, b: BoundarySlot) {
        let face = self.faces.get_mut(f.0);
        face.inner[usize::from(face.inner_count)] = b;
        let record = self.boundaries.get_mut(b.0);
        (record.face, record.place) = (f, u32::from(face.inner_count));
        face.inner_count += 1;
    }

    fn unlist(&mut self, b: BoundarySlot) {
        let record = self.boundaries.get_mut(b.0);
        let place = core::mem::replace(&mut record.place, UNLISTED);
        let face = self.faces.get_mut(record.face.0);
        if place == OUTER {
            face.outer = None;
            return;
        }
        face.inner_count -= 1;
        let last = face.inner[usize::from(face.inner_count)];
        if last != b {
            face.inner[place as usize] = last;
            self.boundaries.get_mut(last.0).place = place;
        }
    }
}
