//! A table that counts what it is asked.

use std::cell::Cell;
use twinedge::validate::{BoundaryPlace, Link, Start, Table, View};

/// Answers as the table does, and counts some of the questions.
pub(crate) struct Watched<'a, C = fn(usize) -> Option<usize>> {
    pub(crate) table: &'a Table,
    pub(crate) twin: Cell<usize>,
    pub(crate) next: Cell<usize>,
    pub(crate) prev: Cell<usize>,
    pub(crate) inner_count: Cell<usize>,
    pub(crate) inner: Cell<usize>,
    /// What it claims as the length of a list instead, given how often it has been asked.
    pub(crate) claims: C,
}

impl<'a> Watched<'a> {
    /// One that tells the truth.
    pub(crate) fn new(table: &'a Table) -> Self {
        Self::claiming(table, |_| None)
    }
}

impl<'a, C: Fn(usize) -> Option<usize>> Watched<'a, C> {
    /// One that tells the truth but for the length of its lists.
    pub(crate) fn claiming(table: &'a Table, claims: C) -> Self {
        let [twin, next, prev, inner_count, inner] = [const { Cell::new(0) }; 5];
        Self { table, twin, next, prev, inner_count, inner, claims }
    }
}

fn count(questions: &Cell<usize>) -> usize {
    questions.set(questions.get() + 1);
    questions.get()
}

impl<C: Fn(usize) -> Option<usize>> View for Watched<'_, C> {
    fn vertex_slots(&self) -> usize {
        self.table.vertex_slots()
    }
    fn half_edge_slots(&self) -> usize {
        self.table.half_edge_slots()
    }
    fn boundary_slots(&self) -> usize {
        self.table.boundary_slots()
    }
    fn face_slots(&self) -> usize {
        self.table.face_slots()
    }
    fn is_vertex(&self, vertex: usize) -> bool {
        self.table.is_vertex(vertex)
    }
    fn is_half_edge(&self, half_edge: usize) -> bool {
        self.table.is_half_edge(half_edge)
    }
    fn is_boundary(&self, boundary: usize) -> bool {
        self.table.is_boundary(boundary)
    }
    fn is_face(&self, face: usize) -> bool {
        self.table.is_face(face)
    }
    fn origin(&self, half_edge: usize) -> Link {
        self.table.origin(half_edge)
    }
    fn twin(&self, half_edge: usize) -> Link {
        count(&self.twin);
        self.table.twin(half_edge)
    }
    fn next(&self, half_edge: usize) -> Link {
        count(&self.next);
        self.table.next(half_edge)
    }
    fn prev(&self, half_edge: usize) -> Link {
        count(&self.prev);
        self.table.prev(half_edge)
    }
    fn boundary(&self, half_edge: usize) -> Link {
        self.table.boundary(half_edge)
    }
    fn face(&self, half_edge: usize) -> Link {
        self.table.face(half_edge)
    }
    fn leaving(&self, vertex: usize) -> Link {
        self.table.leaving(vertex)
    }
    fn isolated(&self, vertex: usize) -> Link {
        self.table.isolated(vertex)
    }
    fn boundary_face(&self, boundary: usize) -> Link {
        self.table.boundary_face(boundary)
    }
    fn boundary_start(&self, boundary: usize) -> Option<Start> {
        self.table.boundary_start(boundary)
    }
    fn boundary_place(&self, boundary: usize) -> Option<BoundaryPlace> {
        self.table.boundary_place(boundary)
    }
    fn outer(&self, face: usize) -> Link {
        self.table.outer(face)
    }
    fn inner_count(&self, face: usize) -> usize {
        (self.claims)(count(&self.inner_count)).unwrap_or_else(|| self.table.inner_count(face))
    }
    /// Of a list that is longer than it is, the last entry comes over and over.
    fn inner(&self, face: usize, position: usize) -> Link {
        count(&self.inner);
        self.table.inner(face, position.min(self.table.inner_count(face).saturating_sub(1)))
    }
    fn outer_half_edge(&self, face: usize) -> Link {
        self.table.outer_half_edge(face)
    }
    fn inner_start(&self, face: usize, position: usize) -> Option<Start> {
        count(&self.inner);
        self.table.inner_start(face, position.min(self.table.inner_count(face).saturating_sub(1)))
    }
}
