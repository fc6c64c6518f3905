//! A structure whose links are columns.

use super::cell::Cell;
use super::column::Column;
use super::error::ColumnsError;
use crate::validate::expectation::{Expectation, Part};
use crate::validate::view::{Link, View};

/// A half-edge structure whose links are columns of integers, read where they lie.
///
/// Where half-edges keep their target, make it [`by_target`](Self::by_target) and wrap it in
/// [`adapt::Targets`](crate::validate::adapt::Targets); where faces keep nothing, wrap it in
/// [`adapt::FaceLabels`](crate::validate::adapt::FaceLabels).
///
/// Constructors cost O(1), and memory is not allocated. A link is read at each question, with one check of a bound.
///
/// ```
/// use twinedge::validate::interchange::{Column, Columns};
/// use twinedge::validate::{Collect, Expectation, validate};
/// // A triangle. Half-edges 0, 2 and 4 run around its inside.
/// let (origin, twin, next) = ([0_i32, 1, 1, 2, 2, 0], [1_i32, 0, 3, 2, 5, 4], [2_i32, 5, 4, 1, 0, 3]);
/// let columns = Columns::new(3, Column::new(&origin), Column::new(&twin), Column::new(&next))?;
/// let expectation = columns.expectation(Expectation::plane());
/// assert!(validate(&columns, &expectation, Collect::All).is_valid());
///
/// let error = Columns::new(3, Column::new(&origin), Column::new(&twin[1..]), Column::new(&next)).unwrap_err();
/// assert_eq!(error.to_string(), "the column `twin` has length 5, where 6 is expected");
/// # Ok::<(), twinedge::validate::interchange::ColumnsError>(())
/// ```
#[derive(Debug)]
pub struct Columns<'a, T> {
    vertices: usize,
    half_edges: usize,
    faces: usize,
    origin: Option<Column<'a, T>>,
    target: Option<Column<'a, T>>,
    twin: Option<Column<'a, T>>,
    next: Column<'a, T>,
    prev: Option<Column<'a, T>>,
    face: Option<Column<'a, T>>,
    leaving: Option<Column<'a, T>>,
    outer_half_edge: Option<Column<'a, T>>,
}

impl<T> Clone for Columns<'_, T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T> Copy for Columns<'_, T> {}

/// The column, if it has the length that is expected.
const fn of_length<'a, T: Cell>(
    name: &'static str,
    column: Column<'a, T>,
    expected: usize,
) -> Result<Option<Column<'a, T>>, ColumnsError> {
    if column.len() == expected {
        Ok(Some(column))
    } else {
        Err(ColumnsError::Length { column: name, found: column.len(), expected })
    }
}

impl<'a, T: Cell> Columns<'a, T> {
    /// A structure of so many vertices, and of as many half-edges as `next` is long.
    ///
    /// # Errors
    /// [`ColumnsError::Length`] if another column has another length.
    pub fn new(
        vertices: usize,
        origin: Column<'a, T>,
        twin: Column<'a, T>,
        next: Column<'a, T>,
    ) -> Result<Self, ColumnsError> {
        let mut columns = Self::paired(vertices, origin, next)?;
        columns.twin = of_length("twin", twin, columns.half_edges)?;
        Ok(columns)
    }

    /// The same, where the twin of half-edge `h` is `h ^ 1`, as in `OpenMesh` and `Surface_mesh`.
    ///
    /// # Errors
    /// [`ColumnsError::Length`] if `origin` has another length than `next`.
    pub fn paired(vertices: usize, origin: Column<'a, T>, next: Column<'a, T>) -> Result<Self, ColumnsError> {
        let half_edges = next.len();
        Ok(Self {
            vertices,
            half_edges,
            faces: 0,
            origin: of_length("origin", origin, half_edges)?,
            target: None,
            twin: None,
            next,
            prev: None,
            face: None,
            leaving: None,
            outer_half_edge: None,
        })
    }

    /// The same structure, the first column of which held targets.
    #[must_use]
    pub const fn by_target(mut self) -> Self {
        self.target = self.origin;
        self.origin = None;
        self
    }

    /// The same, with `prev`.
    ///
    /// # Errors
    /// [`ColumnsError::Length`] if the column has another length than there are half-edges.
    pub fn with_prev(mut self, prev: Column<'a, T>) -> Result<Self, ColumnsError> {
        self.prev = of_length("prev", prev, self.half_edges)?;
        Ok(self)
    }

    /// The same, with so many faces, and with the face of each half-edge.
    ///
    /// # Errors
    /// [`ColumnsError::Length`] if the column has another length than there are half-edges.
    pub fn with_faces(mut self, faces: usize, face: Column<'a, T>) -> Result<Self, ColumnsError> {
        self.face = of_length("face", face, self.half_edges)?;
        self.faces = faces;
        Ok(self)
    }

    /// The same, with a half-edge that each vertex keeps and that leaves it.
    ///
    /// # Errors
    /// [`ColumnsError::Length`] if the column has another length than there are vertices.
    pub fn with_leaving(mut self, leaving: Column<'a, T>) -> Result<Self, ColumnsError> {
        self.leaving = of_length("leaving", leaving, self.vertices)?;
        Ok(self)
    }

    /// The same, with a half-edge that each face keeps.
    ///
    /// # Errors
    /// [`ColumnsError::Length`] if the column has another length than there are [faces](Self::with_faces).
    pub fn with_outer_half_edge(mut self, outer_half_edge: Column<'a, T>) -> Result<Self, ColumnsError> {
        self.outer_half_edge = of_length("outer_half_edge", outer_half_edge, self.faces)?;
        Ok(self)
    }

    /// The expectation without the parts that the columns lack: records of boundary components and lists of holes always, `prev`,
    /// `leaving` and faces where there is no such column.
    #[must_use]
    pub const fn expectation(&self, mut expectation: Expectation) -> Expectation {
        expectation = expectation.without(Part::BoundaryComponents).without(Part::Holes);
        if self.prev.is_none() {
            expectation = expectation.without(Part::Prev);
        }
        if self.leaving.is_none() {
            expectation = expectation.without(Part::Leaving);
        }
        if self.face.is_none() { expectation.without(Part::Faces) } else { expectation }
    }
}

fn at<T: Cell>(column: Option<Column<'_, T>>, position: usize) -> Link {
    column?.link(position)
}

impl<T: Cell> View for Columns<'_, T> {
    fn vertex_slots(&self) -> usize {
        self.vertices
    }
    fn half_edge_slots(&self) -> usize {
        self.half_edges
    }
    fn face_slots(&self) -> usize {
        self.faces
    }
    fn origin(&self, half_edge: usize) -> Link {
        at(self.origin, half_edge)
    }
    fn target(&self, half_edge: usize) -> Link {
        at(self.target, half_edge)
    }
    fn twin(&self, half_edge: usize) -> Link {
        match self.twin {
            Some(twin) => twin.link(half_edge),
            None => Some(half_edge ^ 1),
        }
    }
    fn next(&self, half_edge: usize) -> Link {
        self.next.link(half_edge)
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
