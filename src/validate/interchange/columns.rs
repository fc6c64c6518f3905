//! A structure whose links are columns.

use super::boundaries::Boundaries;
use super::cell::Cell;
use super::column::Column;
use super::dense::Dense;
use super::error::ColumnsError;
use crate::validate::expectation::{Expectation, Part};
use crate::validate::view::{Link, Start, View};

/// A half-edge structure whose links are columns of integers, read where they lie.
///
/// Where half-edges keep their target, make it [`by_target`](Self::by_target) and wrap it in
/// [`adapt::Targets`](crate::validate::adapt::Targets); where faces keep nothing, wrap it in
/// [`adapt::FaceLabels`](crate::validate::adapt::FaceLabels).
///
/// Constructors cost O(1), those with `live` in their name O(n), and memory is not allocated. A link is read at each question, with
/// one check of a bound.
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
    boundaries: Option<Boundaries<'a, T>>,
    /// Which vertices, half-edges, boundary components and faces are live, where not all are.
    live: [Option<&'a [bool]>; 4],
}

impl<T> Clone for Columns<'_, T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T> Copy for Columns<'_, T> {}

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
        twin.expect_len("twin", columns.half_edges)?;
        columns.twin = Some(twin);
        Ok(columns)
    }

    /// The same, where the twin of half-edge `h` is `h ^ 1`, as in `OpenMesh` and `Surface_mesh`.
    ///
    /// # Errors
    /// [`ColumnsError::Length`] if `origin` has another length than `next`.
    pub fn paired(vertices: usize, origin: Column<'a, T>, next: Column<'a, T>) -> Result<Self, ColumnsError> {
        let half_edges = next.len();
        origin.expect_len("origin", half_edges)?;
        Ok(Self {
            vertices,
            half_edges,
            faces: 0,
            origin: Some(origin),
            target: None,
            twin: None,
            next,
            prev: None,
            face: None,
            leaving: None,
            outer_half_edge: None,
            boundaries: None,
            live: [None; 4],
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
        prev.expect_len("prev", self.half_edges)?;
        self.prev = Some(prev);
        Ok(self)
    }

    /// The same, with so many faces, and with the face of each half-edge.
    ///
    /// # Errors
    /// [`ColumnsError::Length`] if the column has another length than there are half-edges.
    pub fn with_faces(mut self, faces: usize, face: Column<'a, T>) -> Result<Self, ColumnsError> {
        face.expect_len("face", self.half_edges)?;
        self.face = Some(face);
        self.faces = faces;
        Ok(self)
    }

    /// The same, with a half-edge that each vertex keeps and that leaves it.
    ///
    /// # Errors
    /// [`ColumnsError::Length`] if the column has another length than there are vertices.
    pub fn with_leaving(mut self, leaving: Column<'a, T>) -> Result<Self, ColumnsError> {
        leaving.expect_len("leaving", self.vertices)?;
        self.leaving = Some(leaving);
        Ok(self)
    }

    /// The same, with a half-edge that each face keeps.
    ///
    /// # Errors
    /// [`ColumnsError::Length`] if the column has another length than there are [faces](Self::with_faces).
    pub fn with_outer_half_edge(mut self, outer_half_edge: Column<'a, T>) -> Result<Self, ColumnsError> {
        outer_half_edge.expect_len("outer_half_edge", self.faces)?;
        self.outer_half_edge = Some(outer_half_edge);
        Ok(self)
    }

    /// The same, with so many faces, and with records of boundary components: as in CGAL's `Arrangement_2`, half-edges name theirs
    /// and faces list theirs. The column `face` of half-edges is not read then.
    ///
    /// # Errors
    /// [`ColumnsError::Length`] if a column has another length than [`Boundaries`] says.
    ///
    /// ```
    /// use twinedge::validate::interchange::{Boundaries, Column, Columns};
    /// use twinedge::validate::{Collect, Expectation, validate};
    /// // A triangle in the plane, with an isolated vertex inside. Face 0 is unbounded.
    /// let (origin, next) = ([0_i32, 1, 1, 2, 2, 0], [2_i32, 5, 4, 1, 0, 3]);
    /// let boundaries = Boundaries {
    ///     boundary: Column::new(&[0_i32, 1, 0, 1, 0, 1]),
    ///     isolated: Some(Column::new(&[-1, -1, -1, 2])),
    ///     face: Column::new(&[1, 0, 1]),
    ///     half_edge: Column::new(&[0, 1, -1]),
    ///     vertex: Some(Column::new(&[-1, -1, 3])),
    ///     outer: Column::new(&[-1, 0]),
    ///     inner_first: Column::new(&[0, 1, 2]),
    ///     inner: Column::new(&[1, 2]),
    /// };
    /// let columns = Columns::paired(4, Column::new(&origin), Column::new(&next))?.with_boundaries(2, boundaries)?;
    /// let expectation = columns.expectation(Expectation::plane());
    /// let certificate = validate(&columns, &expectation, Collect::All).into_result().unwrap();
    /// assert_eq!((certificate.faces, certificate.components, certificate.isolated_vertices), (2, 2, 1));
    /// # Ok::<(), twinedge::validate::interchange::ColumnsError>(())
    /// ```
    pub fn with_boundaries(mut self, faces: usize, boundaries: Boundaries<'a, T>) -> Result<Self, ColumnsError> {
        boundaries.fit(self.vertices, self.half_edges, faces)?;
        self.boundaries = Some(boundaries);
        self.faces = faces;
        Ok(self)
    }

    /// The same, of which some vertices are not live: a slot is vacant where there is `false`.
    ///
    /// # Errors
    /// [`ColumnsError::Length`] if there are more or fewer than vertices.
    pub fn with_live_vertices(self, live: &'a [bool]) -> Result<Self, ColumnsError> {
        let slots = self.vertices;
        self.with_live(0, "live_vertices", slots, live)
    }

    /// The same for half-edges.
    ///
    /// # Errors
    /// [`ColumnsError::Length`] if there are more or fewer than half-edges.
    pub fn with_live_half_edges(self, live: &'a [bool]) -> Result<Self, ColumnsError> {
        let slots = self.half_edges;
        self.with_live(1, "live_half_edges", slots, live)
    }

    /// The same for boundary components, after [`with_boundaries`](Self::with_boundaries).
    ///
    /// # Errors
    /// [`ColumnsError::Length`] if there are more or fewer than boundary components.
    pub fn with_live_boundaries(self, live: &'a [bool]) -> Result<Self, ColumnsError> {
        let slots = self.boundary_slots();
        self.with_live(2, "live_boundaries", slots, live)
    }

    /// The same for faces, after [`with_faces`](Self::with_faces) or [`with_boundaries`](Self::with_boundaries).
    ///
    /// # Errors
    /// [`ColumnsError::Length`] if there are more or fewer than faces.
    pub fn with_live_faces(self, live: &'a [bool]) -> Result<Self, ColumnsError> {
        let slots = self.faces;
        self.with_live(3, "live_faces", slots, live)
    }

    fn with_live(
        mut self,
        kind: usize,
        column: &'static str,
        expected: usize,
        live: &'a [bool],
    ) -> Result<Self, ColumnsError> {
        if live.len() != expected {
            return Err(ColumnsError::Length { column, found: live.len(), expected });
        }
        // Where all are live there is nothing to ask.
        self.live[kind] = if live.iter().all(|live| *live) { None } else { Some(live) };
        Ok(self)
    }

    /// The same structure, in a form that is validated faster: if it has origins, every column is a whole slice, every record is live, and
    /// there are no records of boundary components. O(1).
    ///
    /// ```
    /// use twinedge::validate::interchange::{Column, Columns};
    /// use twinedge::validate::{Collect, Expectation, validate};
    /// let (origin, next) = ([0_i32, 1, 1, 2, 2, 0], [2_i32, 5, 4, 1, 0, 3]);
    /// let columns = Columns::paired(3, Column::new(&origin), Column::new(&next))?;
    /// let expectation = columns.expectation(Expectation::plane());
    /// let report = match columns.dense() {
    ///     Some(dense) => validate(&dense, &expectation, Collect::All),
    ///     None => validate(&columns, &expectation, Collect::All),
    /// };
    /// assert!(report.is_valid());
    /// # Ok::<(), twinedge::validate::interchange::ColumnsError>(())
    /// ```
    #[must_use]
    pub fn dense(&self) -> Option<Dense<'a, T>> {
        if self.boundaries.is_some() || self.live.iter().any(Option::is_some) {
            return None;
        }
        let optional = |column: Option<Column<'a, T>>| column.map_or(Some(&[][..]), |column| column.cells());
        Some(Dense {
            vertices: self.vertices,
            faces: self.faces,
            origin: self.origin?.cells()?,
            next: self.next.cells()?,
            twin: optional(self.twin)?,
            prev: optional(self.prev)?,
            face: optional(self.face)?,
            leaving: optional(self.leaving)?,
            outer_half_edge: optional(self.outer_half_edge)?,
        })
    }

    /// The expectation without the parts that the columns lack: places of boundary components always; records of boundary
    /// components, lists of holes, `prev`, `leaving` and faces where there are no such columns.
    #[must_use]
    pub const fn expectation(&self, mut expectation: Expectation) -> Expectation {
        expectation = expectation.without(Part::Places);
        if self.boundaries.is_none() {
            expectation = expectation.without(Part::BoundaryComponents).without(Part::Holes);
        }
        if self.prev.is_none() {
            expectation = expectation.without(Part::Prev);
        }
        if self.leaving.is_none() {
            expectation = expectation.without(Part::Leaving);
        }
        let labelled = self.face.is_some() || self.boundaries.is_some();
        if labelled { expectation } else { expectation.without(Part::Faces) }
    }
}

fn at<T: Cell>(column: Option<Column<'_, T>>, position: usize) -> Link {
    column?.link(position)
}

/// Whether the slot is live: all below `slots` are where there is no mask.
fn is_live(mask: Option<&[bool]>, slot: usize, slots: usize) -> bool {
    match mask {
        None => slot < slots,
        Some(live) => live.get(slot).is_some_and(|live| *live),
    }
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
    fn boundary_slots(&self) -> usize {
        self.boundaries.as_ref().map_or(0, |boundaries| boundaries.slots())
    }
    fn is_vertex(&self, vertex: usize) -> bool {
        is_live(self.live[0], vertex, self.vertices)
    }
    fn is_half_edge(&self, half_edge: usize) -> bool {
        is_live(self.live[1], half_edge, self.half_edges)
    }
    fn is_boundary(&self, boundary: usize) -> bool {
        is_live(self.live[2], boundary, self.boundary_slots())
    }
    fn is_face(&self, face: usize) -> bool {
        is_live(self.live[3], face, self.faces)
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

    fn boundary(&self, half_edge: usize) -> Link {
        self.boundaries.as_ref()?.boundary.link(half_edge)
    }
    fn isolated(&self, vertex: usize) -> Link {
        self.boundaries.as_ref()?.isolated?.link(vertex)
    }
    fn boundary_face(&self, boundary: usize) -> Link {
        self.boundaries.as_ref()?.face.link(boundary)
    }
    fn boundary_start(&self, boundary: usize) -> Option<Start> {
        self.boundaries.as_ref()?.start(boundary)
    }
    fn outer(&self, face: usize) -> Link {
        self.boundaries.as_ref()?.outer.link(face)
    }
    fn inner_count(&self, face: usize) -> usize {
        self.boundaries.as_ref().map_or(0, |boundaries| boundaries.inner_count(face))
    }
    fn inner(&self, face: usize, position: usize) -> Link {
        self.boundaries.as_ref()?.inner(face, position)
    }
}
