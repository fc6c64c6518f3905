//! Making labels: first the columns that the structure does not store, then the ranks.
//!
//! [`check`](super::check()) does not rely on any code here. Labels of a structure that breaks rules are useless, but are still
//! made in linear time: no slot is visited twice.

use super::answers::Answers;
use super::columns::{Column, Labels, LabelsError, MOST_SLOTS};
use super::storage::Entries as _;
use crate::{NIL, column};
use alloc::vec::Vec;
use twinedge::validate::{BoundaryPlace, Part, Start, View};

impl Labels {
    /// Makes the labels of a structure.
    ///
    /// If the structure keeps all rules, [`check`](super::check()) passes with them; otherwise it never does.
    ///
    /// Cost: O(n) for n slots and list entries, about as long as [`validate`](twinedge::validate::validate). The ranks take 4
    /// bytes for each half-edge, and twice that while they are made.
    ///
    /// # Errors
    /// [`LabelsError`], if the structure does not determine how its components lie in the plane, or is too large.
    ///
    /// ```
    /// use twinedge::validate::{Link, Parts, View};
    /// use twinedge_certificate::{Column, Labels, check};
    ///
    /// /// One edge between two vertices, of which nothing is stored but twins and rotations.
    /// struct Edge;
    ///
    /// impl View for Edge {
    ///     fn parts(&self) -> Parts { Parts::NONE }
    ///     fn vertex_slots(&self) -> usize { 2 }
    ///     fn half_edge_slots(&self) -> usize { 2 }
    ///     fn origin(&self, half_edge: usize) -> Link { Some(half_edge) }
    ///     fn twin(&self, half_edge: usize) -> Link { Some(1 - half_edge) }
    ///     fn next(&self, half_edge: usize) -> Link { Some(1 - half_edge) }
    /// }
    ///
    /// let labels = Labels::new(&Edge)?;
    /// assert_eq!(labels.column(Column::HalfEdgePrev), [1, 0]);
    /// assert!(check(&Edge, &labels).is_ok());
    /// # Ok::<(), twinedge_certificate::LabelsError>(())
    /// ```
    pub fn new<V: View + ?Sized>(view: &V) -> Result<Self, LabelsError> {
        let parts = view.parts();
        if parts.has(Part::Faces) && !parts.has(Part::UnboundedFace) {
            return Err(LabelsError::NoContainment);
        }
        let mut labels = Self::of_links(view)?;
        if parts.has(Part::BoundaryComponents) {
            if !parts.has(Part::Places) {
                labels.set(Column::BoundaryPlace, places(view)?);
            }
        } else {
            labels.find_cycles(view)?;
            if parts.has(Part::Faces) {
                labels.join_named_faces(view)?;
            } else {
                labels.invent_faces(view)?;
            }
        }
        let ranks = ranks(&Answers::new(view, &labels))?;
        labels.set(Column::HalfEdgeRank, ranks);
        Ok(labels)
    }

    /// Makes the links of half-edges and vertices that the structure does not store.
    pub(super) fn of_links<V: View + ?Sized>(view: &V) -> Result<Self, LabelsError> {
        let slots = [view.vertex_slots(), view.half_edge_slots(), view.boundary_slots(), view.face_slots()];
        if slots.iter().any(|n| *n > MOST_SLOTS) {
            return Err(LabelsError::TooLarge);
        }
        let mut labels = Self::default();
        if !view.parts().has(Part::Prev) {
            labels.set(Column::HalfEdgePrev, prevs(view)?);
        }
        if !view.parts().has(Part::Leaving) {
            labels.set(Column::VertexLeaving, kept(view)?);
        }
        Ok(labels)
    }

    pub(super) fn set(&mut self, column: Column, numbers: Vec<u32>) {
        *self.column_mut(column) = numbers;
    }

    fn put(&mut self, column: Column, i: usize, number: usize) {
        if let Some(entry) = self.column_mut(column).get_mut(i) {
            *entry = number as u32;
        }
    }

    /// Adds a boundary component with this start, not yet in a face, and returns its number.
    fn add_boundary(&mut self, start: Start) -> usize {
        let (half_edge, vertex) = match start {
            Start::HalfEdge(h) => (h as u32, NIL),
            Start::Vertex(v) => (NIL, v as u32),
        };
        self.column_mut(Column::BoundaryFace).push(NIL);
        self.column_mut(Column::BoundaryStart).push(half_edge);
        self.column_mut(Column::BoundaryVertex).push(vertex);
        self.column_mut(Column::BoundaryPlace).push(NIL);
        self.column(Column::BoundaryFace).len() - 1
    }

    /// Adds a boundary component for each cycle of `next`.
    pub(super) fn find_cycles<V: View + ?Sized>(&mut self, view: &V) -> Result<(), LabelsError> {
        let mut boundary = nils(view.half_edge_slots())?;
        for start in (0..boundary.len()).filter(|h| view.is_half_edge(*h)) {
            if boundary[start] != NIL {
                continue;
            }
            let b = self.add_boundary(Start::HalfEdge(start)) as u32;
            let mut h = Some(start);
            while let Some(at) = h.filter(|h| boundary.get(*h) == Some(&NIL) && view.is_half_edge(*h)) {
                boundary[at] = b;
                h = view.next(at);
            }
        }
        self.set(Column::HalfEdgeBoundary, boundary);
        self.set(Column::VertexIsolated, nils(view.vertex_slots())?);
        Ok(())
    }

    /// Returns the boundary component with this start: of the half-edge, or a new one for an isolated vertex.
    fn boundary_at(&mut self, start: Start) -> usize {
        match start {
            Start::HalfEdge(h) => self.number(Column::HalfEdgeBoundary, h) as usize,
            Start::Vertex(v) => {
                let b = self.add_boundary(start);
                self.put(Column::VertexIsolated, v, b);
                b
            }
        }
    }

    /// Assigns to boundary components the faces that name their starts.
    fn join_named_faces<V: View + ?Sized>(&mut self, view: &V) -> Result<(), LabelsError> {
        let mut outer = nils(view.face_slots())?;
        // A list longer than the number of components names something twice.
        let most = self.column(Column::BoundaryFace).len() + view.vertex_slots();
        for (f, named) in outer.iter_mut().enumerate() {
            if view.is_face(f) {
                if let Some(h) = view.outer_half_edge(f) {
                    let b = self.boundary_at(Start::HalfEdge(h));
                    *named = b as u32;
                    self.put(Column::BoundaryFace, b, f);
                }
                for i in 0..view.inner_count(f).min(most) {
                    let b = view.inner_start(f, i).map_or(NIL as usize, |start| self.boundary_at(start));
                    self.list_inner(f, i, b);
                    if self.column(Column::FaceInner).len() > most {
                        break;
                    }
                }
            }
            let end = self.column(Column::FaceInner).len();
            self.column_mut(Column::FaceEnd).push(end as u32);
        }
        self.set(Column::FaceOuter, outer);
        Ok(())
    }

    /// Appends the boundary component to the face's list of inner ones.
    fn list_inner(&mut self, f: usize, i: usize, b: usize) {
        self.column_mut(Column::FaceInner).push(b as u32);
        self.put(Column::BoundaryFace, b, f);
        self.put(Column::BoundaryPlace, b, i);
    }

    /// Puts one cycle of each component, and all isolated vertices, into an unbounded face, number 0. Every other cycle bounds a
    /// face of its own.
    fn invent_faces<V: View + ?Sized>(&mut self, view: &V) -> Result<(), LabelsError> {
        let outside = outsides(&Answers::new(view, self))?;
        self.column_mut(Column::FaceOuter).push(NIL);
        let mut inner = 0;
        for (b, is_outside) in outside.into_iter().enumerate() {
            if is_outside {
                self.list_inner(0, inner, b);
                inner += 1;
            } else {
                let f = self.column(Column::FaceOuter).len();
                self.put(Column::BoundaryFace, b, f);
                self.column_mut(Column::FaceOuter).push(b as u32);
            }
        }
        let mut has_half_edge = column(view.vertex_slots(), false).ok_or(LabelsError::OutOfMemory)?;
        for v in (0..view.half_edge_slots()).filter(|h| view.is_half_edge(*h)).filter_map(|h| view.origin(h)) {
            if let Some(has) = has_half_edge.get_mut(v) {
                *has = true;
            }
        }
        for (v, _) in has_half_edge.iter().enumerate().filter(|(v, has)| !**has && view.is_vertex(*v)) {
            let b = self.boundary_at(Start::Vertex(v));
            self.list_inner(0, inner, b);
            inner += 1;
        }
        let faces = self.column(Column::FaceOuter).len();
        let ends = column(faces, inner as u32).ok_or(LabelsError::OutOfMemory)?;
        self.set(Column::FaceEnd, ends);
        Ok(())
    }
}

pub(super) fn nils(n: usize) -> Result<Vec<u32>, LabelsError> {
    column(n, NIL).ok_or(LabelsError::OutOfMemory)
}

fn prevs<V: View + ?Sized>(view: &V) -> Result<Vec<u32>, LabelsError> {
    let mut prev = nils(view.half_edge_slots())?;
    for h in (0..prev.len()).filter(|h| view.is_half_edge(*h)) {
        if let Some(entry) = view.next(h).and_then(|next| prev.get_mut(next)) {
            *entry = h as u32;
        }
    }
    Ok(prev)
}

fn kept<V: View + ?Sized>(view: &V) -> Result<Vec<u32>, LabelsError> {
    let mut leaving = nils(view.vertex_slots())?;
    for h in (0..view.half_edge_slots()).filter(|h| view.is_half_edge(*h)) {
        if let Some(entry) = view.origin(h).and_then(|origin| leaving.get_mut(origin)) {
            *entry = h as u32;
        }
    }
    Ok(leaving)
}

/// Returns the position of each boundary component in the list of its face.
fn places<V: View + ?Sized>(view: &V) -> Result<Vec<u32>, LabelsError> {
    let mut place = nils(view.boundary_slots())?;
    // The number of entries to read: each boundary component is listed once.
    let mut listed = place.len();
    for f in (0..view.face_slots()).filter(|f| view.is_face(*f)) {
        let count = view.inner_count(f).min(listed);
        listed -= count;
        for i in 0..count {
            if let Some(entry) = view.inner(f, i).and_then(|b| place.get_mut(b)) {
                *entry = i as u32;
            }
        }
    }
    Ok(place)
}

/// Ranks of half-edges, cycle by cycle: each follows its predecessor on the cycle, or its twin, except the starting half-edges.
pub(super) struct Ranks {
    /// The rank of each half-edge, or nil.
    pub(super) rank: Vec<u32>,
    count: u32,
    /// Half-edges at which cycles will be entered.
    ways: Vec<u32>,
    /// The number of list entries that may still be read: a boundary component is listed once.
    entries: usize,
}

impl Ranks {
    pub(super) fn new<V: View + ?Sized>(s: &Answers<'_, V>) -> Result<Self, LabelsError> {
        let mut ways = Vec::new();
        // Each half-edge is added at most by its twin or as a start.
        ways.try_reserve_exact(s.half_edges + s.boundaries).map_err(|_| LabelsError::OutOfMemory)?;
        Ok(Self { rank: nils(s.half_edges)?, count: 0, ways, entries: s.boundaries })
    }

    /// Adds a half-edge. Returns true if it had no rank.
    pub(super) fn add(&mut self, h: usize) -> bool {
        let is_free = self.rank.get(h) == Some(&NIL);
        if is_free {
            self.ways.push(h as u32);
        }
        is_free
    }

    /// Ranks everything reachable from the added half-edges, and passes each ranked half-edge to `ranked`.
    pub(super) fn spread<V: View + ?Sized>(&mut self, s: &Answers<'_, V>, mut ranked: impl FnMut(&mut Self, usize)) {
        while let Some(way) = self.ways.pop() {
            self.rank_cycle(s, way as usize, |ranks, h| {
                if let Some(twin) = s.twin(h) {
                    ranks.add(twin);
                }
                ranked(ranks, h);
            });
        }
    }

    /// Like [`spread`](Self::spread), and then ranks everything reachable from ranked half-edges. First enters cycles in
    /// numerical order, wherever a twin already has a rank: this reaches most half-edges, with close numbers in the caches.
    pub(super) fn spread_in_order<V: View + ?Sized>(
        &mut self,
        s: &Answers<'_, V>,
        mut ranked: impl FnMut(&mut Self, usize),
    ) {
        let free = |ranks: &Self, h: usize| ranks.rank.get(h) == Some(&NIL);
        let can_enter = |ranks: &Self, h: usize| {
            free(ranks, h) && s.twin(h).is_some_and(|twin| ranks.rank.get(twin).is_some_and(|rank| *rank != NIL))
        };
        for h in 0..self.rank.len() {
            while let Some(way) = self.ways.pop() {
                self.rank_cycle(s, way as usize, &mut ranked);
            }
            if can_enter(self, h) {
                self.rank_cycle(s, h, &mut ranked);
            }
        }
        for h in 0..self.rank.len() {
            if can_enter(self, h) {
                self.add(h);
            }
            self.spread(s, &mut ranked);
        }
    }

    fn rank_cycle<V: View + ?Sized>(
        &mut self,
        s: &Answers<'_, V>,
        from: usize,
        mut ranked: impl FnMut(&mut Self, usize),
    ) {
        let mut at = Some(from);
        while let Some(h) = at.filter(|h| self.rank.get(*h) == Some(&NIL)) {
            self.rank[h] = self.count;
            self.count += 1;
            ranked(self, h);
            at = s.next(h);
        }
    }

    /// Adds the starts of the inner boundary components of a face.
    fn add_inner<V: View + ?Sized>(&mut self, s: &Answers<'_, V>, f: usize) {
        let count = s.inner_count(f).min(self.entries);
        self.entries -= count;
        for b in (0..count).filter_map(|i| s.inner(f, i)) {
            if let Some(Start::HalfEdge(h)) = s.start(b) {
                self.add(h);
            }
        }
    }
}

/// Computes ranks: from the unbounded face to its components, and from the start of an outer cycle to the components in its face.
fn ranks<V: View + ?Sized>(s: &Answers<'_, V>) -> Result<Vec<u32>, LabelsError> {
    let mut ranks = Ranks::new(s)?;
    for f in (0..s.faces).filter(|f| s.is_face(*f) && s.outer(*f).is_none()) {
        ranks.add_inner(s, f);
    }
    ranks.spread_in_order(s, |ranks, h| {
        let Some(b) = s.boundary(h).filter(|b| s.start(*b) == Some(Start::HalfEdge(h))) else { return };
        if let (Some(BoundaryPlace::Outer), Some(f)) = (s.place(b), s.boundary_face(b)) {
            ranks.add_inner(s, f);
        }
    });
    Ok(ranks.rank)
}

/// Returns, for each cycle, whether it is the first one of its component.
fn outsides<V: View + ?Sized>(s: &Answers<'_, V>) -> Result<Vec<bool>, LabelsError> {
    let mut outside = column(s.boundaries, false).ok_or(LabelsError::OutOfMemory)?;
    let mut ranks = Ranks::new(s)?;
    for (b, outside) in outside.iter_mut().enumerate() {
        if let Some(Start::HalfEdge(h)) = s.start(b) {
            *outside = ranks.add(h);
            ranks.spread(s, |_, _| {});
        }
    }
    Ok(outside)
}
