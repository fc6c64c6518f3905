//! Labels are made: first the columns that the structure does not store, then the ranks.
//!
//! Nothing here has to be right for [`check`](super::check()) to be. For a structure that breaks rules the labels are of no use, but they
//! are made, in linear time: no slot is visited twice.

use super::answers::Answers;
use super::columns::{Column, Labels, LabelsError, MOST_SLOTS};
use crate::slots::{NIL, column};
use crate::validate::structure::{BoundaryPlace, Part, Start, View};
use alloc::vec::Vec;

impl Labels {
    /// Makes the labels of a structure.
    ///
    /// If it keeps all rules, [`check`](super::check()) passes with them; if not, it never does.
    ///
    /// Cost: O(n) for n slots and list entries, about as long as [`validate`](crate::validate::validate). The ranks take 4 bytes for each
    /// half-edge, and making them as much again.
    ///
    /// # Errors
    /// [`LabelsError`], if the structure does not say how its components lie in the plane, or is too large.
    ///
    /// ```
    /// use twinedge::validate::{Link, Parts, View};
    /// use twinedge::validate::certificate::{Column, Labels, check};
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
    /// # Ok::<(), twinedge::validate::certificate::LabelsError>(())
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

    /// The links of half-edges and vertices that the structure does not store.
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

    /// Adds a boundary component that starts there, in no face yet, and returns its number.
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

    /// A boundary component for each cycle of `next`.
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

    /// The boundary component that starts there: that of the half-edge, or a new one of an isolated vertex.
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

    /// The boundary components get the faces that name their starts.
    fn join_named_faces<V: View + ?Sized>(&mut self, view: &V) -> Result<(), LabelsError> {
        let mut outer = nils(view.face_slots())?;
        // A list that is longer than all that there is names something twice.
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

    /// The face lists the boundary component as its next inner one.
    fn list_inner(&mut self, f: usize, i: usize, b: usize) {
        self.column_mut(Column::FaceInner).push(b as u32);
        self.put(Column::BoundaryFace, b, f);
        self.put(Column::BoundaryPlace, b, i);
    }

    /// One cycle of each component, and all isolated vertices, are put into an unbounded face, number 0. All other cycles bound a face
    /// of their own.
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
        for v in (0..view.vertex_slots()).filter(|v| view.is_vertex(*v) && !has_half_edge[*v]) {
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

/// For each half-edge the one before.
fn prevs<V: View + ?Sized>(view: &V) -> Result<Vec<u32>, LabelsError> {
    let mut prev = nils(view.half_edge_slots())?;
    for h in (0..prev.len()).filter(|h| view.is_half_edge(*h)) {
        if let Some(entry) = view.next(h).and_then(|next| prev.get_mut(next)) {
            *entry = h as u32;
        }
    }
    Ok(prev)
}

/// For each vertex a half-edge that leaves it.
fn kept<V: View + ?Sized>(view: &V) -> Result<Vec<u32>, LabelsError> {
    let mut leaving = nils(view.vertex_slots())?;
    for h in (0..view.half_edge_slots()).filter(|h| view.is_half_edge(*h)) {
        if let Some(entry) = view.origin(h).and_then(|origin| leaving.get_mut(origin)) {
            *entry = h as u32;
        }
    }
    Ok(leaving)
}

/// For each boundary component its position in the list of its face.
fn places<V: View + ?Sized>(view: &V) -> Result<Vec<u32>, LabelsError> {
    let mut place = nils(view.boundary_slots())?;
    // The entries that may still be read: each boundary component is listed once.
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

/// The half-edges in an order in which each comes after a neighbour, but for those that it is begun with.
pub(super) struct Queue {
    /// For each half-edge its position; nil if it is not in the queue.
    pub(super) rank: Vec<u32>,
    half_edges: Vec<u32>,
    taken: usize,
    /// The number of list entries that may still be read: a boundary component is listed once.
    entries: usize,
}

impl Queue {
    pub(super) fn new<V: View + ?Sized>(s: &Answers<'_, V>) -> Result<Self, LabelsError> {
        let mut half_edges = Vec::new();
        half_edges.try_reserve_exact(s.half_edges).map_err(|_| LabelsError::OutOfMemory)?;
        Ok(Self { rank: nils(s.half_edges)?, half_edges, taken: 0, entries: s.boundaries })
    }

    /// Adds a half-edge, and says whether it never was in the queue.
    pub(super) fn add(&mut self, h: usize) -> bool {
        let Some(rank) = self.rank.get_mut(h).filter(|rank| **rank == NIL) else { return false };
        *rank = self.half_edges.len() as u32;
        self.half_edges.push(h as u32);
        true
    }

    /// The next half-edge, of which the neighbours are added.
    pub(super) fn take<V: View + ?Sized>(&mut self, s: &Answers<'_, V>) -> Option<usize> {
        let h = *self.half_edges.get(self.taken)? as usize;
        self.taken += 1;
        for neighbour in [s.next(h), s.prev(h), s.twin(h)].into_iter().flatten() {
            self.add(neighbour);
        }
        Some(h)
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

/// Ranks: from the unbounded face over the components in it, and, from the start of an outer cycle, to those in its face.
fn ranks<V: View + ?Sized>(s: &Answers<'_, V>) -> Result<Vec<u32>, LabelsError> {
    let mut queue = Queue::new(s)?;
    for f in (0..s.faces).filter(|f| s.is_face(*f) && s.outer(*f).is_none()) {
        queue.add_inner(s, f);
    }
    while let Some(h) = queue.take(s) {
        let Some(b) = s.boundary(h).filter(|b| s.start(*b) == Some(Start::HalfEdge(h))) else { continue };
        if let (Some(BoundaryPlace::Outer), Some(f)) = (s.place(b), s.boundary_face(b)) {
            queue.add_inner(s, f);
        }
    }
    Ok(queue.rank)
}

/// For each cycle: whether it is the first one of its component.
fn outsides<V: View + ?Sized>(s: &Answers<'_, V>) -> Result<Vec<bool>, LabelsError> {
    let mut outside = column(s.boundaries, false).ok_or(LabelsError::OutOfMemory)?;
    let mut queue = Queue::new(s)?;
    for (b, outside) in outside.iter_mut().enumerate() {
        if let Some(Start::HalfEdge(h)) = s.start(b) {
            *outside = queue.add(h);
            while queue.take(s).is_some() {}
        }
    }
    Ok(outside)
}
