//! A table that counts questions.

use std::cell::Cell;
use twinedge::delegate_view;
use twinedge::validate::{Link, Start, Table, View};

/// Answers like the table, and counts some of the questions.
pub(crate) struct Watched<'a, C = fn(usize) -> Option<usize>> {
    pub(crate) table: &'a Table,
    pub(crate) twin: Cell<usize>,
    pub(crate) next: Cell<usize>,
    pub(crate) prev: Cell<usize>,
    pub(crate) inner_count: Cell<usize>,
    pub(crate) inner: Cell<usize>,
    /// The list length claimed instead of the true one, given the number of questions so far.
    pub(crate) claims: C,
}

impl<'a> Watched<'a> {
    /// Answers exactly like the table.
    pub(crate) fn new(table: &'a Table) -> Self {
        Self::claiming(table, |_| None)
    }
}

impl<'a, C: Fn(usize) -> Option<usize>> Watched<'a, C> {
    /// Answers like the table, except for list lengths.
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
    delegate_view!(|this| this.table; except twin, next, prev, inner_count, inner, inner_start);

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
    fn inner_count(&self, face: usize) -> usize {
        (self.claims)(count(&self.inner_count)).unwrap_or_else(|| self.table.inner_count(face))
    }
    /// Beyond the true end of a list, repeats the last entry.
    fn inner(&self, face: usize, position: usize) -> Link {
        count(&self.inner);
        self.table.inner(face, position.min(self.table.inner_count(face).saturating_sub(1)))
    }
    fn inner_start(&self, face: usize, position: usize) -> Option<Start> {
        count(&self.inner);
        self.table.inner_start(face, position.min(self.table.inner_count(face).saturating_sub(1)))
    }
}
