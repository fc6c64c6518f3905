//! The store over columns.

use super::columns::{
    BoundarySlot, FaceSlot, HalfEdgeSlot, MOST, MOST_EDGES, OTHER, VACANT, VertexSlot, column, put, start_bits,
    vertex_link_bits,
};
use super::inner::InnerLists;
use crate::slots::NIL;
#[cfg(feature = "near")]
use crate::store::attributes::Attributes;
use crate::store::issuer::{Issuer, structure_offset};
use crate::store::keys::{BoundaryKey, FaceKey, HalfEdgeKey, VertexKey, key, parts};
#[cfg(feature = "near")]
use crate::store::links::AttributeStore;
use crate::store::links::{BoundaryStart, Links, Need, RecordKind, Store, VertexLink, room};
use crate::store::place::{OUTER, UNLISTED};
#[cfg(feature = "near")]
use alloc::boxed::Box;
use alloc::vec::Vec;

/// The default store: slotmap keys over columns of 32-bit slots.
#[derive(Clone, Debug)]
pub struct SlotStore {
    pub(super) edges: Issuer,
    pub(super) origin: Vec<VertexSlot>,
    pub(super) next: Vec<HalfEdgeSlot>,
    pub(super) prev: Vec<HalfEdgeSlot>,
    pub(super) boundary: Vec<BoundarySlot>,

    pub(super) vertices: Issuer,
    pub(super) vertex_link: Vec<u32>,

    pub(super) boundaries: Issuer,
    pub(super) boundary_face: Vec<FaceSlot>,
    pub(super) start: Vec<u32>,
    pub(super) place: Vec<u32>,

    pub(super) faces: Issuer,
    /// The half-edge where the outer boundary component starts, as in the textbooks: most walks around a face need nothing
    /// else. The boundary component is had through it.
    pub(super) outer: Vec<u32>,
    pub(super) inner: InnerLists,
    pub(super) unbounded: FaceSlot,

    #[cfg(feature = "near")]
    pub(super) attributes: Option<Box<Attributes>>,
}

impl SlotStore {
    /// A stand-in that takes the place of another store for a moment: it has no unbounded face, and must not be asked for
    /// anything. It takes no memory.
    #[allow(dead_code, reason = "for the layers above, which a smaller selection of features leaves out")]
    pub(crate) const fn hollow() -> Self {
        Self {
            edges: Issuer::hollow(),
            origin: Vec::new(),
            next: Vec::new(),
            prev: Vec::new(),
            boundary: Vec::new(),
            vertices: Issuer::hollow(),
            vertex_link: Vec::new(),
            boundaries: Issuer::hollow(),
            boundary_face: Vec::new(),
            start: Vec::new(),
            place: Vec::new(),
            faces: Issuer::hollow(),
            outer: Vec::new(),
            inner: InnerLists::new(Vec::new()),
            unbounded: FaceSlot(NIL),
            #[cfg(feature = "near")]
            attributes: None,
        }
    }
}

#[cfg(feature = "near")]
impl SlotStore {
    pub(crate) const fn take_attributes(&mut self) -> Option<Box<Attributes>> {
        self.attributes.take()
    }

    pub(crate) fn set_attributes(&mut self, attributes: Option<Box<Attributes>>) {
        self.attributes = attributes;
    }
}

impl Store for SlotStore {}

#[cfg(feature = "near")]
impl AttributeStore for SlotStore {
    fn kept_attributes(&mut self) -> &mut Attributes {
        self.attributes.get_or_insert_default()
    }
}

impl Links for SlotStore {
    type Vertex = VertexSlot;
    type HalfEdge = HalfEdgeSlot;
    type Boundary = BoundarySlot;
    type Face = FaceSlot;

    #[cfg(feature = "near")]
    #[inline]
    fn attributes(&self) -> Option<&Attributes> {
        self.attributes.as_deref()
    }

    #[cfg(feature = "near")]
    fn attributes_mut(&mut self) -> Option<&mut Attributes> {
        self.attributes.as_deref_mut()
    }

    #[cfg(feature = "near")]
    fn trial(&self) -> Option<Self> {
        let mut copy = self.clone();
        copy.attributes = None;
        Some(copy)
    }

    fn with_room(need: Need) -> Self {
        let offset = structure_offset();
        let half_edges = need.edges.saturating_mul(2);
        let faces = need.faces.saturating_add(1);
        let mut store = Self {
            edges: Issuer::with_room(need.edges, offset),
            origin: column(half_edges, VertexSlot(NIL), 2),
            next: column(half_edges, HalfEdgeSlot(NIL), 2),
            prev: column(half_edges, HalfEdgeSlot(NIL), 2),
            boundary: column(half_edges, BoundarySlot(NIL), 2),
            vertices: Issuer::with_room(need.vertices, offset),
            vertex_link: column(need.vertices, NIL, 1),
            boundaries: Issuer::with_room(need.boundaries, offset),
            boundary_face: column(need.boundaries, FaceSlot(NIL), 1),
            start: column(need.boundaries, NIL, 1),
            place: column(need.boundaries, NIL, 1),
            faces: Issuer::with_room(faces, offset),
            outer: column(faces, VACANT, 1),
            inner: InnerLists::new(column(faces, InnerLists::unused(), 1)),
            unbounded: FaceSlot(NIL),
            #[cfg(feature = "near")]
            attributes: None,
        };
        store.unbounded = store.add_face();
        store
    }

    fn unbounded(&self) -> FaceSlot {
        self.unbounded
    }

    fn room_for(&self, need: Need) -> Result<(), RecordKind> {
        room(self, need, Need { vertices: MOST, edges: MOST_EDGES, boundaries: MOST, faces: MOST })
    }

    fn find_vertex(&self, key: VertexKey) -> Option<VertexSlot> {
        let (slot, generation) = parts(key);
        (self.vertices.generation(slot) == generation).then_some(VertexSlot(slot))
    }

    fn find_half_edge(&self, key: HalfEdgeKey) -> Option<HalfEdgeSlot> {
        let (slot, generation) = parts(key);
        (self.edges.generation(slot >> 1) == generation).then_some(HalfEdgeSlot(slot))
    }

    fn find_boundary(&self, key: BoundaryKey) -> Option<BoundarySlot> {
        let (slot, generation) = parts(key);
        (self.boundaries.generation(slot) == generation).then_some(BoundarySlot(slot))
    }

    fn find_face(&self, key: FaceKey) -> Option<FaceSlot> {
        let (slot, generation) = parts(key);
        (self.faces.generation(slot) == generation).then_some(FaceSlot(slot))
    }

    #[inline]
    fn vertex_key(&self, v: VertexSlot) -> VertexKey {
        key(v.0, self.vertices.generation(v.0))
    }

    #[inline]
    fn half_edge_key(&self, h: HalfEdgeSlot) -> HalfEdgeKey {
        key(h.0, self.edges.generation(h.0 >> 1))
    }

    #[inline]
    fn boundary_key(&self, b: BoundarySlot) -> BoundaryKey {
        key(b.0, self.boundaries.generation(b.0))
    }

    #[inline]
    fn face_key(&self, f: FaceSlot) -> FaceKey {
        key(f.0, self.faces.generation(f.0))
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
        self.vertices.end()
    }

    fn half_edge_slots(&self) -> usize {
        2 * self.edges.end()
    }

    fn boundary_slots(&self) -> usize {
        self.boundaries.end()
    }

    fn face_slots(&self) -> usize {
        self.faces.end()
    }

    #[inline]
    fn vertex_at(&self, index: usize) -> Option<VertexSlot> {
        let slot = u32::try_from(index).ok()?;
        self.vertices.is_live(slot).then_some(VertexSlot(slot))
    }

    #[inline]
    fn half_edge_at(&self, index: usize) -> Option<HalfEdgeSlot> {
        let slot = u32::try_from(index).ok()?;
        self.edges.is_live(slot >> 1).then_some(HalfEdgeSlot(slot))
    }

    #[inline]
    fn boundary_at(&self, index: usize) -> Option<BoundarySlot> {
        let slot = u32::try_from(index).ok()?;
        self.boundaries.is_live(slot).then_some(BoundarySlot(slot))
    }

    #[inline]
    fn face_at(&self, index: usize) -> Option<FaceSlot> {
        let outer = *self.outer.get(index)?;
        (outer != VACANT).then_some(FaceSlot(index as u32))
    }

    #[inline]
    fn origin_in(&self, index: usize) -> Option<usize> {
        self.origin.get(index).map(|v| v.0 as usize)
    }

    #[inline]
    fn twin_in(&self, index: usize) -> Option<usize> {
        (index < self.origin.len()).then_some(index ^ 1)
    }

    #[inline]
    fn next_in(&self, index: usize) -> Option<usize> {
        self.next.get(index).map(|h| h.0 as usize)
    }

    #[inline]
    fn prev_in(&self, index: usize) -> Option<usize> {
        self.prev.get(index).map(|h| h.0 as usize)
    }

    #[inline]
    fn boundary_in(&self, index: usize) -> Option<usize> {
        self.boundary.get(index).map(|b| b.0 as usize)
    }

    #[inline]
    fn vertex_index(&self, v: VertexSlot) -> usize {
        v.0 as usize
    }

    #[inline]
    fn half_edge_index(&self, h: HalfEdgeSlot) -> usize {
        h.0 as usize
    }

    #[inline]
    fn boundary_index(&self, b: BoundarySlot) -> usize {
        b.0 as usize
    }

    #[inline]
    fn face_index(&self, f: FaceSlot) -> usize {
        f.0 as usize
    }

    fn add_vertex(&mut self, link: VertexLink<HalfEdgeSlot, BoundarySlot>) -> VertexSlot {
        let slot = self.vertices.issue();
        put(&mut self.vertex_link, slot, vertex_link_bits(link));
        VertexSlot(slot)
    }

    fn add_isolated(&mut self, f: FaceSlot) -> (VertexSlot, BoundarySlot) {
        let v = VertexSlot(self.vertices.issue());
        let b = self.add_boundary(f, BoundaryStart::Vertex(v));
        put(&mut self.vertex_link, v.0, vertex_link_bits(VertexLink::Isolated(b)));
        self.list_inner(f, b);
        (v, b)
    }

    fn add_edge(&mut self, from: VertexSlot, to: VertexSlot, b: BoundarySlot) -> HalfEdgeSlot {
        let h = self.edges.issue() << 1;
        for (slot, origin) in [(h, from), (h | 1, to)] {
            put(&mut self.origin, slot, origin);
            put(&mut self.next, slot, HalfEdgeSlot(slot ^ 1));
            put(&mut self.prev, slot, HalfEdgeSlot(slot ^ 1));
            put(&mut self.boundary, slot, b);
        }
        HalfEdgeSlot(h)
    }

    fn add_boundary(&mut self, f: FaceSlot, start: BoundaryStart<HalfEdgeSlot, VertexSlot>) -> BoundarySlot {
        let slot = self.boundaries.issue();
        put(&mut self.boundary_face, slot, f);
        put(&mut self.start, slot, start_bits(start));
        put(&mut self.place, slot, UNLISTED);
        BoundarySlot(slot)
    }

    fn add_face(&mut self) -> FaceSlot {
        let slot = self.faces.issue();
        put(&mut self.outer, slot, NIL);
        self.inner.add(slot);
        FaceSlot(slot)
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
        self.outer[f.0 as usize] = VACANT;
        self.faces.retire(f.0);
    }

    #[inline]
    fn origin(&self, h: HalfEdgeSlot) -> VertexSlot {
        self.origin[h.0 as usize]
    }

    #[inline]
    fn twin(&self, h: HalfEdgeSlot) -> HalfEdgeSlot {
        HalfEdgeSlot(h.0 ^ 1)
    }

    #[inline]
    fn next(&self, h: HalfEdgeSlot) -> HalfEdgeSlot {
        self.next[h.0 as usize]
    }

    #[inline]
    fn prev(&self, h: HalfEdgeSlot) -> HalfEdgeSlot {
        self.prev[h.0 as usize]
    }

    #[inline]
    fn boundary(&self, h: HalfEdgeSlot) -> BoundarySlot {
        self.boundary[h.0 as usize]
    }

    #[inline]
    fn vertex_link(&self, v: VertexSlot) -> VertexLink<HalfEdgeSlot, BoundarySlot> {
        let bits = self.vertex_link[v.0 as usize];
        if bits & OTHER == 0 {
            VertexLink::Leaving(HalfEdgeSlot(bits))
        } else {
            VertexLink::Isolated(BoundarySlot(bits ^ OTHER))
        }
    }

    #[inline]
    fn face(&self, b: BoundarySlot) -> FaceSlot {
        self.boundary_face[b.0 as usize]
    }

    #[inline]
    fn start(&self, b: BoundarySlot) -> BoundaryStart<HalfEdgeSlot, VertexSlot> {
        let bits = self.start[b.0 as usize];
        if bits & OTHER == 0 {
            BoundaryStart::HalfEdge(HalfEdgeSlot(bits))
        } else {
            BoundaryStart::Vertex(VertexSlot(bits ^ OTHER))
        }
    }

    #[inline]
    fn place(&self, b: BoundarySlot) -> u32 {
        self.place[b.0 as usize]
    }

    #[inline]
    fn outer(&self, f: FaceSlot) -> Option<BoundarySlot> {
        self.outer_half_edge(f).map(|h| self.boundary(h))
    }

    #[inline]
    fn outer_half_edge(&self, f: FaceSlot) -> Option<HalfEdgeSlot> {
        let bits = self.outer[f.0 as usize];
        // The high bit is set if there is none, and if the outer boundary component is an isolated vertex, against the rules.
        (bits & OTHER == 0).then_some(HalfEdgeSlot(bits))
    }

    #[inline]
    fn inner_count(&self, f: FaceSlot) -> usize {
        self.inner.of(f.0).len()
    }

    #[inline]
    fn inner(&self, f: FaceSlot, position: usize) -> Option<BoundarySlot> {
        self.inner.of(f.0).get(position).copied()
    }

    fn set_origin(&mut self, h: HalfEdgeSlot, v: VertexSlot) {
        self.origin[h.0 as usize] = v;
    }

    fn join(&mut self, h: HalfEdgeSlot, n: HalfEdgeSlot) {
        self.next[h.0 as usize] = n;
        self.prev[n.0 as usize] = h;
    }

    fn set_boundary(&mut self, h: HalfEdgeSlot, b: BoundarySlot) {
        self.boundary[h.0 as usize] = b;
    }

    fn set_vertex_link(&mut self, v: VertexSlot, link: VertexLink<HalfEdgeSlot, BoundarySlot>) {
        self.vertex_link[v.0 as usize] = vertex_link_bits(link);
    }

    fn set_start(&mut self, b: BoundarySlot, start: BoundaryStart<HalfEdgeSlot, VertexSlot>) {
        self.start[b.0 as usize] = start_bits(start);
        if self.place[b.0 as usize] == OUTER {
            if let BoundaryStart::HalfEdge(h) = start {
                self.outer[self.boundary_face[b.0 as usize].0 as usize] = h.0;
            }
        }
    }

    fn set_place(&mut self, b: BoundarySlot, place: u32) {
        self.place[b.0 as usize] = place;
    }

    fn list_outer(&mut self, f: FaceSlot, b: BoundarySlot) {
        self.outer[f.0 as usize] = self.start[b.0 as usize];
        self.boundary_face[b.0 as usize] = f;
        self.place[b.0 as usize] = OUTER;
    }

    fn list_inner(&mut self, f: FaceSlot, b: BoundarySlot) {
        self.place[b.0 as usize] = self.inner_count(f) as u32;
        self.boundary_face[b.0 as usize] = f;
        self.inner.push(f.0, b);
    }

    fn unlist(&mut self, b: BoundarySlot) {
        let f = self.boundary_face[b.0 as usize];
        let place = core::mem::replace(&mut self.place[b.0 as usize], UNLISTED);
        if place == OUTER {
            self.outer[f.0 as usize] = NIL;
        } else if let Some(moved) = self.inner.swap_remove(f.0, place) {
            self.place[moved.0 as usize] = place;
        }
    }
}
