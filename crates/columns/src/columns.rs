//! A structure of columns of links.

use crate::boundaries::Boundaries;
use crate::cell::Cell;
use crate::column::Column;
use crate::error::ColumnsError;
use crate::form::Form;
use alloc::boxed::Box;
use twinedge::delegate_view;
use twinedge::validate::adapt::{FaceLabels, Targets};
use twinedge::validate::{Collect, Expectation, HalfEdgeColumns, Part, Parts, Report, View, validate};

/// A computation generic over views, for [`Columns::with_view`], which has an example.
pub trait OnView {
    /// The result.
    type Output;
    /// Computes the result.
    fn on<V: View>(self, view: V) -> Self::Output;
}

/// A half-edge structure with links in columns of integers, read in place.
///
/// [`Columns::validate`] judges it. It is also a [`View`] of its columns: if half-edges keep their target
/// ([`by_target`](Self::by_target)), that needs [`adapt::Targets`](twinedge::validate::adapt::Targets), and if faces keep
/// nothing, [`adapt::FaceLabels`](twinedge::validate::adapt::FaceLabels).
///
/// Constructors cost O(1), those with `live` in their name O(n), and memory is not allocated. A query checks one bound.
///
/// ```
/// use twinedge_columns::{Column, Columns};
/// use twinedge::validate::{Collect, Expectation};
/// // A triangle. Half-edges 0, 2 and 4 run around its inside.
/// let (origin, twin, next) = ([0_i32, 1, 1, 2, 2, 0], [1_i32, 0, 3, 2, 5, 4], [2_i32, 5, 4, 1, 0, 3]);
/// let columns = Columns::new(3, Column::new(&origin), Column::new(&twin), Column::new(&next))?;
/// assert!(columns.validate(Expectation::plane(), Collect::All).expect("memory").is_valid());
///
/// let error = Columns::new(3, Column::new(&origin), Column::new(&twin[1..]), Column::new(&next)).unwrap_err();
/// assert_eq!(error.to_string(), "the column `twin` has length 5, where 6 is expected");
/// # Ok::<(), twinedge_columns::ColumnsError>(())
/// ```
#[derive(Debug)]
pub struct Columns<'a, T> {
    form: Form<'a, Column<'a, T>, false>,
}

impl<T> Clone for Columns<'_, T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T> Copy for Columns<'_, T> {}

impl<'a, T: Cell> Columns<'a, T> {
    /// Returns a structure with this number of vertices, and with one half-edge for each entry of `next`.
    ///
    /// # Errors
    /// [`ColumnsError::Length`] if another column has a different length.
    pub fn new(
        vertices: usize,
        origin: Column<'a, T>,
        twin: Column<'a, T>,
        next: Column<'a, T>,
    ) -> Result<Self, ColumnsError> {
        let mut columns = Self::paired(vertices, origin, next)?;
        twin.expect_len("twin", columns.form.half_edges)?;
        columns.form.twin = Some(twin);
        Ok(columns)
    }

    /// Like [`new`](Self::new), with `h ^ 1` as the twin of half-edge `h`, as in `OpenMesh` and `Surface_mesh`.
    ///
    /// # Errors
    /// [`ColumnsError::Length`] if the lengths of `origin` and `next` differ.
    pub fn paired(vertices: usize, origin: Column<'a, T>, next: Column<'a, T>) -> Result<Self, ColumnsError> {
        let half_edges = next.len();
        origin.expect_len("origin", half_edges)?;
        let none = Column::new(&[]);
        let form = Form {
            vertices,
            half_edges,
            faces: 0,
            next,
            twin: None,
            origin,
            target: none,
            prev: none,
            face: none,
            leaving: none,
            outer_half_edge: none,
            lists: None,
            parts: Parts::NONE,
            live: [None; 4],
        };
        Ok(Self { form })
    }

    /// Takes the first column as targets instead of origins.
    #[must_use]
    pub const fn by_target(mut self) -> Self {
        self.form.target = self.form.origin;
        self.form.origin = Column::new(&[]);
        self
    }

    /// Adds `prev`.
    ///
    /// # Errors
    /// [`ColumnsError::Length`] if the length is not the number of half-edges.
    pub fn with_prev(mut self, prev: Column<'a, T>) -> Result<Self, ColumnsError> {
        prev.expect_len("prev", self.form.half_edges)?;
        self.form.prev = prev;
        self.form.parts = self.form.parts.with(Part::Prev);
        Ok(self)
    }

    /// Adds this number of faces, and the face of each half-edge.
    ///
    /// # Errors
    /// [`ColumnsError::Length`] if the length is not the number of half-edges.
    pub fn with_faces(mut self, faces: usize, face: Column<'a, T>) -> Result<Self, ColumnsError> {
        face.expect_len("face", self.form.half_edges)?;
        (self.form.face, self.form.faces) = (face, faces);
        self.form.parts = self.form.parts.with(Part::Faces);
        Ok(self)
    }

    /// Adds a half-edge that leaves each vertex.
    ///
    /// # Errors
    /// [`ColumnsError::Length`] if the length is not the number of vertices.
    pub fn with_leaving(mut self, leaving: Column<'a, T>) -> Result<Self, ColumnsError> {
        leaving.expect_len("leaving", self.form.vertices)?;
        self.form.leaving = leaving;
        self.form.parts = self.form.parts.with(Part::Leaving);
        Ok(self)
    }

    /// Adds a half-edge of each face.
    ///
    /// # Errors
    /// [`ColumnsError::Length`] if the length is not the number of [faces](Self::with_faces).
    pub fn with_outer_half_edge(mut self, outer_half_edge: Column<'a, T>) -> Result<Self, ColumnsError> {
        outer_half_edge.expect_len("outer_half_edge", self.form.faces)?;
        self.form.outer_half_edge = outer_half_edge;
        Ok(self)
    }

    /// Adds this number of faces, and records of boundary components: as in CGAL's `Arrangement_2`, half-edges name theirs and
    /// faces list theirs. The column `face` of half-edges is then not read.
    ///
    /// # Errors
    /// [`ColumnsError::Length`] if a column differs from the length in [`Boundaries`].
    ///
    /// ```
    /// use twinedge_columns::{Boundaries, Column, Columns};
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
    /// let figures = validate(&columns, &Expectation::plane(), Collect::All).into_result().unwrap();
    /// assert_eq!((figures.faces, figures.components, figures.isolated_vertices), (2, 2, 1));
    /// # Ok::<(), twinedge_columns::ColumnsError>(())
    /// ```
    pub fn with_boundaries(mut self, faces: usize, boundaries: Boundaries<'a, T>) -> Result<Self, ColumnsError> {
        boundaries.fit(self.form.vertices, self.form.half_edges, faces)?;
        (self.form.lists, self.form.faces) = (Some(boundaries.lists()), faces);
        self.form.parts = self.form.parts.with(Part::BoundaryComponents).with(Part::UnboundedFace);
        Ok(self)
    }

    /// Marks vertices as live or vacant: a slot is vacant at `false`.
    ///
    /// # Errors
    /// [`ColumnsError::Length`] if the length is not the number of vertices.
    pub fn with_live_vertices(self, live: &'a [bool]) -> Result<Self, ColumnsError> {
        let slots = self.form.vertices;
        self.with_live(0, "live_vertices", slots, live)
    }

    /// Marks half-edges.
    ///
    /// # Errors
    /// [`ColumnsError::Length`] if the length is not the number of half-edges.
    pub fn with_live_half_edges(self, live: &'a [bool]) -> Result<Self, ColumnsError> {
        let slots = self.form.half_edges;
        self.with_live(1, "live_half_edges", slots, live)
    }

    /// Marks boundary components, after [`with_boundaries`](Self::with_boundaries).
    ///
    /// # Errors
    /// [`ColumnsError::Length`] if the length is not the number of boundary components.
    pub fn with_live_boundaries(self, live: &'a [bool]) -> Result<Self, ColumnsError> {
        let slots = self.boundary_slots();
        self.with_live(2, "live_boundaries", slots, live)
    }

    /// Marks faces, after [`with_faces`](Self::with_faces) or [`with_boundaries`](Self::with_boundaries).
    ///
    /// # Errors
    /// [`ColumnsError::Length`] if the length is not the number of faces.
    pub fn with_live_faces(self, live: &'a [bool]) -> Result<Self, ColumnsError> {
        let slots = self.form.faces;
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
        // Without vacant slots, no column is kept.
        self.form.live[kind] = if live.iter().all(|live| *live) { None } else { Some(live) };
        Ok(self)
    }

    /// Returns the report of the structure. If half-edges keep targets, or faces keep nothing,
    /// [`adapt::Targets`](twinedge::validate::adapt::Targets) and [`adapt::FaceLabels`](twinedge::validate::adapt::FaceLabels)
    /// answer. `None` without enough memory for these, or for more than `u32::MAX - 1` records of one kind.
    ///
    /// It equals the report of [`validate`](validate()), and is faster: the columns are examined first, and read with fewer
    /// checks if they are whole slices, or go forward in memory, and all records are live. O(n).
    ///
    /// ```
    /// use twinedge_columns::{Column, Columns};
    /// use twinedge::validate::{Collect, Expectation};
    /// let (target, next) = ([1_i32, 0, 2, 1, 0, 2], [2_i32, 5, 4, 1, 0, 3]);
    /// let columns = Columns::paired(3, Column::new(&target), Column::new(&next))?.by_target();
    /// let report = columns.validate(Expectation::plane(), Collect::All).expect("memory");
    /// assert!(report.is_valid());
    /// # Ok::<(), twinedge_columns::ColumnsError>(())
    /// ```
    #[must_use]
    pub fn validate(&self, expectation: Expectation, collect: Collect) -> Option<Report> {
        struct Validate(Expectation, Collect);
        impl OnView for Validate {
            type Output = Report;
            fn on<V: View>(self, view: V) -> Report {
                validate(&view, &self.0, self.1)
            }
        }
        self.with_view(Validate(expectation, collect))
    }

    /// Computes something of the view that [`validate`](Self::validate) judges, for example by validating it in a custom wrapper.
    /// `None` in the same cases. O(n), plus the cost of the computation.
    ///
    /// ```
    /// use twinedge::delegate_view;
    /// use twinedge_columns::{Column, Columns, OnView};
    /// use twinedge::validate::{Collect, Expectation, Report, Rule, View, validate};
    ///
    /// /// The structure, without its half-edge 5.
    /// struct Cut<V>(V);
    /// impl<V: View> View for Cut<V> {
    ///     delegate_view!(|this| &this.0; except is_half_edge);
    ///     fn is_half_edge(&self, half_edge: usize) -> bool {
    ///         half_edge != 5 && self.0.is_half_edge(half_edge)
    ///     }
    /// }
    ///
    /// struct WithoutFive;
    /// impl OnView for WithoutFive {
    ///     type Output = Report;
    ///     fn on<V: View>(self, view: V) -> Report {
    ///         validate(&Cut(view), &Expectation::plane(), Collect::All)
    ///     }
    /// }
    ///
    /// let (origin, next) = ([0_i32, 1, 1, 2, 2, 0], [2_i32, 5, 4, 1, 0, 3]);
    /// let columns = Columns::paired(3, Column::new(&origin), Column::new(&next))?;
    /// let report = columns.with_view(WithoutFive).expect("memory");
    /// assert_eq!(report.broken_rules().next(), Some(Rule::R1));
    /// # Ok::<(), twinedge_columns::ColumnsError>(())
    /// ```
    pub fn with_view<D: OnView>(&self, on: D) -> Option<D::Output> {
        let parts = self.form.parts;
        let labels = parts.has(Part::Faces)
            && !parts.has(Part::BoundaryComponents)
            && self.form.outer_half_edge.is_empty()
            && self.form.faces > 0;
        let by_target = !self.form.target.is_empty();
        if !by_target && !labels {
            return Some(self.fastest(on));
        }
        let target = |h| self.form.target(h);
        // The usual forms. All others answer through one indirect call for each link, to compile few forms with adapters.
        let plain = self.form.map::<_, true>(|column| column.cells());
        let adapted: Box<dyn View + '_> = match (plain, by_target) {
            (Some(form), false) => return Some(on.on(FaceLabels::one_cycle(form)?)),
            (Some(form), true) if !labels => return Some(on.on(Targets::of(form, |h| form.target(h))?)),
            (_, false) => Box::new(FaceLabels::one_cycle(self.form)?),
            (_, true) if !labels => Box::new(Targets::of(self.form, target)?),
            (_, true) => Box::new(FaceLabels::one_cycle(Targets::of(self.form, target)?)?),
        };
        Some(on.on(adapted))
    }

    fn fastest<D: OnView>(&self, on: D) -> D::Output {
        if let Some(form) = self.form.map::<_, true>(|column| column.cells()) {
            return on.on(form);
        }
        if let Some(form) = self.form.map::<_, false>(|column| column.cells()) {
            return on.on(form);
        }
        match self.form.map::<_, true>(|column| column.forward()) {
            Some(form) => on.on(form),
            None => on.on(self.form),
        }
    }
}

impl<T: Cell> View for Columns<'_, T> {
    delegate_view!(|this| &this.form);

    fn half_edge_columns(&self) -> Option<HalfEdgeColumns<'_>> {
        self.form.half_edge_columns()
    }
}
