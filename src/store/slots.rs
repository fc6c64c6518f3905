//! The records of a structure: keys, and columns of links.

use super::attributes::Attributes;
use super::columns::{
    BoundaryRow, BoundarySlot, BoundaryStart, FaceRow, FaceSlot, HalfEdgeSlot, InnerLists, MOST, MOST_EDGES, OTHER,
    OUTER, RecordKind, Room, UNLISTED, VACANT, VertexLink, VertexSlot, column, put, start_bits, vertex_link_bits,
};
use super::issuer::{Issuer, structure_offset};
use super::keys::{BoundaryKey, FaceKey, HalfEdgeKey, VertexKey, key, parts};
use super::log::{KeptLog, Written};
use crate::numbers::NIL;
use crate::validate::HalfEdgeColumns;
use alloc::boxed::Box;
use alloc::vec::Vec;

/// The records of a structure. Every slot passed to a method must be live.
#[derive(Clone, Debug)]
pub(crate) struct Store {
    pub(super) edges: Issuer,
    pub(super) origin: Vec<u32>,
    pub(super) next: Vec<u32>,
    pub(super) prev: Vec<u32>,
    pub(super) boundary: Vec<u32>,

    pub(super) vertices: Issuer,
    pub(super) vertex_link: Vec<u32>,

    pub(super) boundaries: Issuer,
    pub(super) boundary_rows: Vec<BoundaryRow>,

    pub(super) faces: Issuer,
    pub(super) face_rows: Vec<FaceRow>,
    pub(super) inner: InnerLists,
    pub(super) unbounded: FaceSlot,

    pub(crate) most: Room,
    /// The attribute values, if there are any. Operators apply their steps to them before they write.
    pub(super) attributes: Option<Box<Attributes>>,
    /// The log of overwritten numbers, if there is one.
    pub(crate) log: KeptLog,
}

impl Store {
    #[inline]
    pub(crate) const fn is_logged(&self) -> bool {
        self.log.get().is_some()
    }

    #[inline]
    pub(crate) fn attributes(&self) -> Option<&Attributes> {
        self.attributes.as_deref()
    }

    pub(crate) fn attributes_mut(&mut self) -> Option<&mut Attributes> {
        self.attributes.as_deref_mut()
    }

    /// The attributes, created if missing.
    pub(crate) fn kept_attributes(&mut self) -> &mut Attributes {
        self.attributes.get_or_insert_default()
    }

    pub(crate) const fn take_attributes(&mut self) -> Option<Box<Attributes>> {
        self.attributes.take()
    }

    pub(crate) fn set_attributes(&mut self, attributes: Option<Box<Attributes>>) {
        self.attributes = attributes;
    }

    /// Copies the records in the same slots, without attributes.
    pub(crate) fn without_attributes(&self) -> Self {
        let mut copy = self.clone();
        copy.attributes = None;
        copy
    }

    pub(crate) fn with_room(need: Room) -> Self {
        let offset = structure_offset();
        let half_edges = need.edges.saturating_mul(2);
        let faces = need.faces.saturating_add(1);
        let mut store = Self {
            edges: Issuer::with_room(need.edges, offset),
            origin: column(half_edges, NIL, 2),
            next: column(half_edges, NIL, 2),
            prev: column(half_edges, NIL, 2),
            boundary: column(half_edges, NIL, 2),
            vertices: Issuer::with_room(need.vertices, offset),
            vertex_link: column(need.vertices, NIL, 1),
            boundaries: Issuer::with_room(need.boundaries, offset),
            boundary_rows: column(need.boundaries, BoundaryRow::UNUSED, 1),
            faces: Issuer::with_room(faces, offset),
            face_rows: column(faces, FaceRow { outer: VACANT, ..FaceRow::EMPTY }, 1),
            inner: InnerLists::default(),
            unbounded: FaceSlot(NIL),
            most: Room { vertices: MOST, edges: MOST_EDGES, boundaries: MOST, faces: MOST },
            attributes: None,
            log: KeptLog::default(),
        };
        store.unbounded = store.add_face();
        store
    }

    pub(crate) fn unbounded(&self) -> FaceSlot {
        self.unbounded
    }

    pub(crate) fn limit(&mut self, most: Room) {
        let [vertices, boundaries, faces] = [most.vertices, most.boundaries, most.faces].map(|most| most.min(MOST));
        // The unbounded face exists.
        self.most = Room { vertices, edges: most.edges.min(MOST_EDGES), boundaries, faces: faces.max(1) };
    }

    /// Checks that these additional records fit; the error is the first kind that does not.
    #[inline]
    pub(crate) fn room_for(&self, more: Room) -> Result<(), RecordKind> {
        let fits = |count: usize, more: usize, most: usize| more == 0 || count.saturating_add(more) <= most;
        if !fits(self.vertices.len(), more.vertices, self.most.vertices) {
            Err(RecordKind::Vertex)
        } else if !fits(self.edges.len(), more.edges, self.most.edges) {
            Err(RecordKind::Edge)
        } else if !fits(self.boundaries.len(), more.boundaries, self.most.boundaries) {
            Err(RecordKind::Boundary)
        } else if !fits(self.faces.len(), more.faces, self.most.faces) {
            Err(RecordKind::Face)
        } else {
            Ok(())
        }
    }

    pub(crate) fn find_vertex(&self, key: VertexKey) -> Option<VertexSlot> {
        let (slot, generation) = parts(key);
        (self.vertices.generation(slot) == generation).then_some(VertexSlot(slot))
    }

    pub(crate) fn find_half_edge(&self, key: HalfEdgeKey) -> Option<HalfEdgeSlot> {
        let (slot, generation) = parts(key);
        (self.edges.generation(slot >> 1) == generation).then_some(HalfEdgeSlot(slot))
    }

    pub(crate) fn find_boundary(&self, key: BoundaryKey) -> Option<BoundarySlot> {
        let (slot, generation) = parts(key);
        (self.boundaries.generation(slot) == generation).then_some(BoundarySlot(slot))
    }

    pub(crate) fn find_face(&self, key: FaceKey) -> Option<FaceSlot> {
        let (slot, generation) = parts(key);
        (self.faces.generation(slot) == generation).then_some(FaceSlot(slot))
    }

    #[inline]
    pub(crate) fn vertex_key(&self, v: VertexSlot) -> VertexKey {
        key(v.0, self.vertices.generation(v.0))
    }

    #[inline]
    pub(crate) fn half_edge_key(&self, h: HalfEdgeSlot) -> HalfEdgeKey {
        key(h.0, self.edges.generation(h.0 >> 1))
    }

    #[inline]
    pub(crate) fn boundary_key(&self, b: BoundarySlot) -> BoundaryKey {
        key(b.0, self.boundaries.generation(b.0))
    }

    #[inline]
    pub(crate) fn face_key(&self, f: FaceSlot) -> FaceKey {
        key(f.0, self.faces.generation(f.0))
    }

    pub(crate) fn vertex_count(&self) -> usize {
        self.vertices.len()
    }

    pub(crate) fn edge_count(&self) -> usize {
        self.edges.len()
    }

    pub(crate) fn boundary_count(&self) -> usize {
        self.boundaries.len()
    }

    pub(crate) fn face_count(&self) -> usize {
        self.faces.len()
    }

    pub(crate) fn vertex_slots(&self) -> usize {
        self.vertices.end()
    }

    pub(crate) fn half_edge_slots(&self) -> usize {
        2 * self.edges.end()
    }

    pub(crate) fn boundary_slots(&self) -> usize {
        self.boundaries.end()
    }

    pub(crate) fn face_slots(&self) -> usize {
        self.faces.end()
    }

    #[inline]
    pub(crate) fn vertex_at(&self, index: usize) -> Option<VertexSlot> {
        let slot = u32::try_from(index).ok()?;
        self.vertices.is_live(slot).then_some(VertexSlot(slot))
    }

    #[inline]
    pub(crate) fn half_edge_at(&self, index: usize) -> Option<HalfEdgeSlot> {
        let slot = u32::try_from(index).ok()?;
        self.edges.is_live(slot >> 1).then_some(HalfEdgeSlot(slot))
    }

    #[inline]
    pub(crate) fn boundary_at(&self, index: usize) -> Option<BoundarySlot> {
        let slot = u32::try_from(index).ok()?;
        self.boundaries.is_live(slot).then_some(BoundarySlot(slot))
    }

    #[inline]
    pub(crate) fn face_at(&self, index: usize) -> Option<FaceSlot> {
        let row = self.face_rows.get(index)?;
        (row.outer != VACANT).then_some(FaceSlot(index as u32))
    }

    pub(crate) fn half_edge_columns(&self) -> HalfEdgeColumns<'_> {
        HalfEdgeColumns {
            origin: &self.origin,
            next: &self.next,
            prev: &self.prev,
            boundary: &self.boundary,
            face: &[],
            live_edges: Some(self.edges.generations()),
        }
    }

    #[inline]
    pub(crate) fn origin_in(&self, index: usize) -> Option<usize> {
        self.origin.get(index).map(|link| *link as usize)
    }

    #[inline]
    pub(crate) fn twin_in(&self, index: usize) -> Option<usize> {
        (index < self.origin.len()).then_some(index ^ 1)
    }

    #[inline]
    pub(crate) fn next_in(&self, index: usize) -> Option<usize> {
        self.next.get(index).map(|link| *link as usize)
    }

    #[inline]
    pub(crate) fn prev_in(&self, index: usize) -> Option<usize> {
        self.prev.get(index).map(|link| *link as usize)
    }

    #[inline]
    pub(crate) fn boundary_in(&self, index: usize) -> Option<usize> {
        self.boundary.get(index).map(|link| *link as usize)
    }

    /// Adds a vertex. The caller must have checked room, as for every `add_` method.
    pub(crate) fn add_vertex(&mut self, link: VertexLink<HalfEdgeSlot, BoundarySlot>) -> VertexSlot {
        self.save_vacant(RecordKind::Vertex);
        let slot = self.vertices.issue();
        put(&mut self.vertex_link, slot, vertex_link_bits(link));
        self.note_issued(RecordKind::Vertex, slot);
        VertexSlot(slot)
    }

    /// Adds an isolated vertex and its inner boundary component.
    pub(crate) fn add_isolated(&mut self, f: FaceSlot) -> (VertexSlot, BoundarySlot) {
        self.save_vacant(RecordKind::Vertex);
        self.save_vacant(RecordKind::Boundary);
        let v = VertexSlot(self.vertices.issue());
        let b = BoundarySlot(self.boundaries.issue());
        put(&mut self.vertex_link, v.0, vertex_link_bits(VertexLink::Isolated(b)));
        let place = self.inner_count(f) as u32;
        put(&mut self.boundary_rows, b.0, BoundaryRow { face: f, start: start_bits(BoundaryStart::Vertex(v)), place });
        self.inner.push(&mut self.face_rows[f.index()].inner, b);
        self.note_issued(RecordKind::Vertex, v.0);
        self.note_issued(RecordKind::Boundary, b.0);
        self.note(Written::Listed, f.0, b.0);
        (v, b)
    }

    /// Adds an edge: two half-edges that are each other's twin, next and prev. Returns the half-edge that leaves `from`.
    pub(crate) fn add_edge(&mut self, from: VertexSlot, to: VertexSlot, b: BoundarySlot) -> HalfEdgeSlot {
        self.save_vacant(RecordKind::Edge);
        let edge = self.edges.issue();
        let h = edge << 1;
        for (slot, origin) in [(h, from), (h | 1, to)] {
            put(&mut self.origin, slot, origin.0);
            put(&mut self.next, slot, slot ^ 1);
            put(&mut self.prev, slot, slot ^ 1);
            put(&mut self.boundary, slot, b.0);
        }
        self.note_issued(RecordKind::Edge, edge);
        HalfEdgeSlot(h)
    }

    /// Adds a boundary component that no face lists yet.
    pub(crate) fn add_boundary(&mut self, f: FaceSlot, start: BoundaryStart<HalfEdgeSlot, VertexSlot>) -> BoundarySlot {
        self.save_vacant(RecordKind::Boundary);
        let slot = self.boundaries.issue();
        put(&mut self.boundary_rows, slot, BoundaryRow { face: f, start: start_bits(start), place: UNLISTED });
        self.note_issued(RecordKind::Boundary, slot);
        BoundarySlot(slot)
    }

    /// Adds a face without boundary components.
    pub(crate) fn add_face(&mut self) -> FaceSlot {
        let slot = self.faces.issue();
        put(&mut self.face_rows, slot, FaceRow::EMPTY);
        self.note_issued(RecordKind::Face, slot);
        self.note(Written::Outer, slot, VACANT);
        FaceSlot(slot)
    }

    pub(crate) fn remove_vertex(&mut self, v: VertexSlot) {
        self.note(Written::VertexLink, v.0, self.vertex_link[v.index()]);
        self.note_retired(RecordKind::Vertex, v.0);
        self.vertices.retire(v.0);
    }

    pub(crate) fn remove_edge(&mut self, h: HalfEdgeSlot) {
        for h in [h, self.twin(h)] {
            let i = h.index();
            self.note_all([
                (Written::Origin, h.0, self.origin[i]),
                (Written::Next, h.0, self.next[i]),
                (Written::Prev, h.0, self.prev[i]),
                (Written::Boundary, h.0, self.boundary[i]),
            ]);
        }
        self.note_retired(RecordKind::Edge, h.0 >> 1);
        self.edges.retire(h.0 >> 1);
    }

    /// Removes a boundary component that no face lists.
    pub(crate) fn remove_boundary(&mut self, b: BoundarySlot) {
        let row = self.boundary_rows[b.index()];
        self.note_all([
            (Written::Start, b.0, row.start),
            (Written::BoundaryFace, b.0, row.face.0),
            (Written::Place, b.0, row.place),
        ]);
        self.note_retired(RecordKind::Boundary, b.0);
        self.boundaries.retire(b.0);
    }

    /// Removes a face without inner boundary components.
    pub(crate) fn remove_face(&mut self, f: FaceSlot) {
        self.note(Written::Outer, f.0, self.face_rows[f.index()].outer);
        self.note_retired(RecordKind::Face, f.0);
        self.face_rows[f.index()].outer = VACANT;
        self.faces.retire(f.0);
    }

    #[inline]
    pub(crate) fn origin(&self, h: HalfEdgeSlot) -> VertexSlot {
        VertexSlot(self.origin[h.index()])
    }

    #[inline]
    #[allow(clippy::unused_self, reason = "it is asked as the other links are")]
    pub(crate) const fn twin(&self, h: HalfEdgeSlot) -> HalfEdgeSlot {
        HalfEdgeSlot(h.0 ^ 1)
    }

    #[inline]
    pub(crate) fn next(&self, h: HalfEdgeSlot) -> HalfEdgeSlot {
        HalfEdgeSlot(self.next[h.index()])
    }

    #[inline]
    pub(crate) fn prev(&self, h: HalfEdgeSlot) -> HalfEdgeSlot {
        HalfEdgeSlot(self.prev[h.index()])
    }

    #[inline]
    pub(crate) fn boundary(&self, h: HalfEdgeSlot) -> BoundarySlot {
        BoundarySlot(self.boundary[h.index()])
    }

    #[inline]
    pub(crate) fn vertex_link(&self, v: VertexSlot) -> VertexLink<HalfEdgeSlot, BoundarySlot> {
        let bits = self.vertex_link[v.index()];
        if bits & OTHER == 0 {
            VertexLink::Leaving(HalfEdgeSlot(bits))
        } else {
            VertexLink::Isolated(BoundarySlot(bits ^ OTHER))
        }
    }

    #[inline]
    pub(crate) fn face(&self, b: BoundarySlot) -> FaceSlot {
        self.boundary_rows[b.index()].face
    }

    #[inline]
    pub(crate) fn start(&self, b: BoundarySlot) -> BoundaryStart<HalfEdgeSlot, VertexSlot> {
        let bits = self.boundary_rows[b.index()].start;
        if bits & OTHER == 0 {
            BoundaryStart::HalfEdge(HalfEdgeSlot(bits))
        } else {
            BoundaryStart::Vertex(VertexSlot(bits ^ OTHER))
        }
    }

    #[inline]
    pub(crate) fn place(&self, b: BoundarySlot) -> u32 {
        self.boundary_rows[b.index()].place
    }

    #[inline]
    pub(crate) fn outer(&self, f: FaceSlot) -> Option<BoundarySlot> {
        self.outer_half_edge(f).map(|h| self.boundary(h))
    }

    #[inline]
    pub(crate) fn outer_half_edge(&self, f: FaceSlot) -> Option<HalfEdgeSlot> {
        let bits = self.face_rows[f.index()].outer;
        // The high bit is set if there is no outer boundary component, or if it is an isolated vertex, which is invalid.
        (bits & OTHER == 0).then_some(HalfEdgeSlot(bits))
    }

    #[inline]
    pub(super) fn inner_list(&self, f: FaceSlot) -> &[BoundarySlot] {
        self.inner.of(&self.face_rows[f.index()].inner)
    }

    #[inline]
    pub(crate) fn inner_count(&self, f: FaceSlot) -> usize {
        self.inner_list(f).len()
    }

    #[inline]
    pub(crate) fn last_inner(&self, f: FaceSlot) -> Option<BoundarySlot> {
        self.inner_list(f).last().copied()
    }

    #[inline]
    pub(crate) fn inner(&self, f: FaceSlot, position: usize) -> Option<BoundarySlot> {
        self.inner_list(f).get(position).copied()
    }

    pub(crate) fn set_origin(&mut self, h: HalfEdgeSlot, v: VertexSlot) {
        self.note(Written::Origin, h.0, self.origin[h.index()]);
        self.origin[h.index()] = v.0;
    }

    /// Makes `n` follow `h` on its cycle: sets `next(h)` and `prev(n)`.
    pub(crate) fn join(&mut self, h: HalfEdgeSlot, n: HalfEdgeSlot) {
        self.note_all([(Written::Next, h.0, self.next[h.index()]), (Written::Prev, n.0, self.prev[n.index()])]);
        self.next[h.index()] = n.0;
        self.prev[n.index()] = h.0;
    }

    pub(crate) fn set_boundary(&mut self, h: HalfEdgeSlot, b: BoundarySlot) {
        self.note(Written::Boundary, h.0, self.boundary[h.index()]);
        self.boundary[h.index()] = b.0;
    }

    pub(crate) fn set_vertex_link(&mut self, v: VertexSlot, link: VertexLink<HalfEdgeSlot, BoundarySlot>) {
        self.note(Written::VertexLink, v.0, self.vertex_link[v.index()]);
        self.vertex_link[v.index()] = vertex_link_bits(link);
    }

    pub(crate) fn set_start(&mut self, b: BoundarySlot, start: BoundaryStart<HalfEdgeSlot, VertexSlot>) {
        self.note(Written::Start, b.0, self.boundary_rows[b.index()].start);
        self.boundary_rows[b.index()].start = start_bits(start);
        if self.boundary_rows[b.index()].place == OUTER {
            let f = self.boundary_rows[b.index()].face;
            self.note(Written::Outer, f.0, self.face_rows[f.index()].outer);
            if let BoundaryStart::HalfEdge(h) = start {
                self.face_rows[f.index()].outer = h.0;
            }
        }
    }

    /// Marks a boundary component at its place. The caller puts the place back before the operator ends, so the log has no entry.
    pub(crate) fn mark_place(&mut self, b: BoundarySlot, mark: u32) {
        self.boundary_rows[b.index()].place = mark;
    }

    /// Makes `b`, a cycle, the outer boundary component of `f`.
    pub(crate) fn list_outer(&mut self, f: FaceSlot, b: BoundarySlot) {
        self.note_all([
            (Written::Outer, f.0, self.face_rows[f.index()].outer),
            (Written::BoundaryFace, b.0, self.boundary_rows[b.index()].face.0),
            (Written::Place, b.0, self.boundary_rows[b.index()].place),
        ]);
        self.face_rows[f.index()].outer = self.boundary_rows[b.index()].start;
        self.boundary_rows[b.index()].face = f;
        self.boundary_rows[b.index()].place = OUTER;
    }

    pub(crate) fn list_inner(&mut self, f: FaceSlot, b: BoundarySlot) {
        self.note_all([
            (Written::BoundaryFace, b.0, self.boundary_rows[b.index()].face.0),
            (Written::Place, b.0, self.boundary_rows[b.index()].place),
            (Written::Listed, f.0, b.0),
        ]);
        self.boundary_rows[b.index()].place = self.inner_count(f) as u32;
        self.boundary_rows[b.index()].face = f;
        self.inner.push(&mut self.face_rows[f.index()].inner, b);
    }

    /// Removes `b` from the lists of its face. The last inner boundary component takes its place. O(1).
    pub(crate) fn unlist(&mut self, b: BoundarySlot) {
        let f = self.boundary_rows[b.index()].face;
        let place = self.boundary_rows[b.index()].place;
        if place == OUTER {
            self.note(Written::Outer, f.0, self.face_rows[f.index()].outer);
            self.face_rows[f.index()].outer = NIL;
        } else {
            self.note(Written::Unlisted, f.0, b.0);
            if let Some(last) = self.inner_list(f).last().copied() {
                self.note(Written::Place, last.0, self.boundary_rows[last.index()].place);
            }
            if let Some(moved) = self.inner.swap_remove(&mut self.face_rows[f.index()].inner, place) {
                self.boundary_rows[moved.index()].place = place;
            }
        }
        self.note(Written::Place, b.0, place);
        self.boundary_rows[b.index()].place = UNLISTED;
    }
}
