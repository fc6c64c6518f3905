//! Records of boundary components in columns.

use super::cell::Cell;
use super::column::Column;
use super::error::ColumnsError;
use crate::validate::view::{Link, Start};

/// Records of boundary components (CGAL's CCBs) and the lists of the faces, as columns: one entry for each half-edge (`h` of them),
/// vertex (`v`), boundary component (`b`) or face (`f`).
///
/// [`Columns::with_boundaries`](super::Columns::with_boundaries) has an example.
#[derive(Debug)]
pub struct Boundaries<'a, T> {
    /// `h`: the boundary component of each half-edge.
    pub boundary: Column<'a, T>,
    /// `v`: the boundary component that each vertex is, if it is isolated; nil if not. `None`: no vertex is.
    pub isolated: Option<Column<'a, T>>,
    /// `b`: the face that each boundary component bounds.
    pub face: Column<'a, T>,
    /// `b`: a half-edge of each boundary component; nil if it is an isolated vertex.
    pub half_edge: Column<'a, T>,
    /// `b`: the isolated vertex that the boundary component is; read where it has no half-edge. `None`: none is a vertex.
    pub vertex: Option<Column<'a, T>>,
    /// `f`: the outer boundary component of each face; nil for the unbounded one.
    pub outer: Column<'a, T>,
    /// `f + 1`: face `i` lists the inner boundary components at the positions from `inner_first[i]` up to, but without,
    /// `inner_first[i + 1]` of `inner`. A list that would go on past the end of `inner` has nil there.
    pub inner_first: Column<'a, T>,
    /// The inner boundary components of all faces, one list after the other.
    pub inner: Column<'a, T>,
}

impl<T> Clone for Boundaries<'_, T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T> Copy for Boundaries<'_, T> {}

impl<T: Cell> Boundaries<'_, T> {
    /// Nothing, if every column has its length.
    pub(super) fn fit(&self, vertices: usize, half_edges: usize, faces: usize) -> Result<(), ColumnsError> {
        let boundaries = self.face.len();
        let optional = |column: Option<Column<'_, T>>, name, expected| match column {
            None => Ok(()),
            Some(column) => column.expect_len(name, expected),
        };
        self.boundary.expect_len("boundary", half_edges)?;
        optional(self.isolated, "isolated", vertices)?;
        self.half_edge.expect_len("boundary_half_edge", boundaries)?;
        optional(self.vertex, "boundary_vertex", boundaries)?;
        self.outer.expect_len("outer", faces)?;
        self.inner_first.expect_len("inner_first", faces.saturating_add(1))
    }

    pub(super) const fn slots(&self) -> usize {
        self.face.len()
    }

    pub(super) fn start(&self, boundary: usize) -> Option<Start> {
        match self.half_edge.link(boundary) {
            Some(half_edge) => Some(Start::HalfEdge(half_edge)),
            None => self.vertex?.link(boundary).map(Start::Vertex),
        }
    }

    pub(super) fn inner_count(&self, face: usize) -> usize {
        match (self.inner_first.link(face), self.inner_first.link(face.saturating_add(1))) {
            (Some(first), Some(end)) => end.saturating_sub(first),
            _ => 0,
        }
    }

    pub(super) fn inner(&self, face: usize, position: usize) -> Link {
        self.inner.link(self.inner_first.link(face)?.checked_add(position)?)
    }
}
