//! A structure whose columns are slices.

use super::cell::Cell;
use crate::validate::view::{Link, View};

/// [`Columns`](super::Columns) that are whole slices, of records that are all live: the same answers with fewer checks.
///
/// [`Columns::dense`](super::Columns::dense) makes it, and has an example.
#[derive(Debug)]
pub struct Dense<'a, T> {
    pub(super) vertices: usize,
    pub(super) faces: usize,
    pub(super) origin: &'a [T],
    pub(super) next: &'a [T],
    /// Empty where there is no such column: then every link is nil, but for twins, which are paired.
    pub(super) twin: &'a [T],
    pub(super) prev: &'a [T],
    pub(super) face: &'a [T],
    pub(super) leaving: &'a [T],
    pub(super) outer_half_edge: &'a [T],
}

impl<T> Clone for Dense<'_, T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T> Copy for Dense<'_, T> {}

#[inline]
fn at<T: Cell>(cells: &[T], position: usize) -> Link {
    cells.get(position)?.link()
}

impl<T: Cell> View for Dense<'_, T> {
    fn vertex_slots(&self) -> usize {
        self.vertices
    }
    fn half_edge_slots(&self) -> usize {
        self.next.len()
    }
    fn face_slots(&self) -> usize {
        self.faces
    }
    fn origin(&self, half_edge: usize) -> Link {
        at(self.origin, half_edge)
    }
    fn twin(&self, half_edge: usize) -> Link {
        if self.twin.is_empty() { Some(half_edge ^ 1) } else { at(self.twin, half_edge) }
    }
    fn next(&self, half_edge: usize) -> Link {
        at(self.next, half_edge)
    }
    fn prev(&self, half_edge: usize) -> Link {
        at(self.prev, half_edge)
    }
    fn face(&self, half_edge: usize) -> Link {
        at(self.face, half_edge)
    }
    fn leaving(&self, vertex: usize) -> Link {
        at(self.leaving, vertex)
    }
    fn outer_half_edge(&self, face: usize) -> Link {
        at(self.outer_half_edge, face)
    }
}
