//! Records of boundary components in columns.

use crate::cell::Cell;
use crate::column::{Column, Links};
use crate::error::ColumnsError;
use twinedge::validate::{Link, Start};

/// Records of boundary components (CGAL's CCBs) and the lists of the faces, as columns: one entry for each half-edge (`h` of
/// them), vertex (`v`), boundary component (`b`) or face (`f`).
///
/// [`Columns::with_boundaries`](crate::Columns::with_boundaries) has an example.
#[derive(Debug)]
pub struct Boundaries<'a, T> {
    /// `h`: the boundary component of each half-edge.
    pub boundary: Column<'a, T>,
    /// `v`: the boundary component of each isolated vertex; nil for the others. `None`: no vertex is isolated.
    pub isolated: Option<Column<'a, T>>,
    /// `b`: the face that each boundary component bounds.
    pub face: Column<'a, T>,
    /// `b`: a half-edge of each boundary component; nil for an isolated vertex.
    pub half_edge: Column<'a, T>,
    /// `b`: the isolated vertex of the boundary component; read if it has no half-edge. `None`: there are no isolated vertices.
    pub vertex: Option<Column<'a, T>>,
    /// `f`: the outer boundary component of each face; nil for the unbounded one.
    pub outer: Column<'a, T>,
    /// `f + 1`: face `i` lists the inner boundary components at the positions from `inner_first[i]` up to, but without,
    /// `inner_first[i + 1]` of `inner`. Positions past the end of `inner` are nil.
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

impl<'a, T: Cell> Boundaries<'a, T> {
    /// Returns an error for a column of the wrong length.
    pub(crate) fn fit(&self, vertices: usize, half_edges: usize, faces: usize) -> Result<(), ColumnsError> {
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

    pub(crate) fn lists(&self) -> Lists<Column<'a, T>> {
        let Self { boundary, isolated, face, half_edge, vertex, outer, inner_first, inner } = *self;
        let none = Column::new(&[]);
        let (isolated, vertex) = (isolated.unwrap_or(none), vertex.unwrap_or(none));
        Lists { boundary, isolated, face, half_edge, vertex, outer, inner_first, inner }
    }
}

/// [`Boundaries`] in columns of any kind.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lists<C> {
    pub(crate) boundary: C,
    /// This and `vertex` may be empty.
    pub(crate) isolated: C,
    pub(crate) face: C,
    half_edge: C,
    vertex: C,
    pub(crate) outer: C,
    inner_first: C,
    inner: C,
}

impl<C: Links> Lists<C> {
    /// Converts every column to another kind, if possible.
    pub(crate) fn map<D>(&self, to: impl Fn(C) -> Option<D>) -> Option<Lists<D>> {
        Some(Lists {
            boundary: to(self.boundary)?,
            isolated: to(self.isolated)?,
            face: to(self.face)?,
            half_edge: to(self.half_edge)?,
            vertex: to(self.vertex)?,
            outer: to(self.outer)?,
            inner_first: to(self.inner_first)?,
            inner: to(self.inner)?,
        })
    }

    pub(crate) fn slots(&self) -> usize {
        self.face.len()
    }

    pub(crate) fn start(&self, boundary: usize) -> Option<Start> {
        match self.half_edge.at(boundary) {
            Some(half_edge) => Some(Start::HalfEdge(half_edge)),
            None => self.vertex.at(boundary).map(Start::Vertex),
        }
    }

    pub(crate) fn inner_count(&self, face: usize) -> usize {
        match (self.inner_first.at(face), self.inner_first.at(face.saturating_add(1))) {
            (Some(first), Some(end)) => end.saturating_sub(first),
            _ => 0,
        }
    }

    pub(crate) fn inner(&self, face: usize, position: usize) -> Link {
        let position = self.inner_first.at(face)?.checked_add(position)?;
        // A list may continue past the end of `inner`.
        if position < self.inner.len() { self.inner.at(position) } else { None }
    }
}
