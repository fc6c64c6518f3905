//! Labels as a checker of certificates reads them, and the columns that they have.

use super::work::{Claim, LazyError, LazyWork};
use std::fmt;
use twinedge::validate::Part;
use twinedge::validate::certificate::{Column, Columns, Labels, Numbers};

/// The labels of a table, whose cells can be open.
#[derive(Clone, Copy)]
pub struct LazyLabels<'a>(&'a dyn LabelSource);

/// Labels, wherever they are.
pub(super) trait LabelSource {
    fn count(&self, column: Column) -> usize;
    fn at(&self, column: Column, entry: usize) -> Option<u32>;
}

impl<'a> LazyLabels<'a> {
    pub(super) fn new(labels: &'a dyn LabelSource) -> Self {
        Self(labels)
    }
}

impl LabelSource for Labels {
    fn count(&self, column: Column) -> usize {
        self.column(column).len()
    }

    fn at(&self, column: Column, entry: usize) -> Option<u32> {
        self.column(column).get(entry).copied()
    }
}

/// A column of [`LazyLabels`].
#[derive(Clone, Copy)]
pub struct LazyColumn<'a> {
    labels: LazyLabels<'a>,
    column: Column,
}

impl Columns for LazyLabels<'_> {
    type Numbers<'a>
        = LazyColumn<'a>
    where
        Self: 'a;

    fn column(&self, column: Column) -> LazyColumn<'_> {
        LazyColumn { labels: *self, column }
    }
}

impl Numbers for LazyColumn<'_> {
    fn count(self) -> usize {
        self.labels.0.count(self.column)
    }

    fn at(self, entry: usize) -> Option<u32> {
        self.labels.0.at(self.column, entry)
    }
}

/// The columns that have entries, each with its name and its numbers.
impl fmt::Display for LazyLabels<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for column in Column::ALL.into_iter().filter(|column| self.0.count(*column) > 0) {
            write!(f, " {}", column.name())?;
            for number in (0..self.0.count(column)).filter_map(|entry| self.0.at(column, entry)) {
                if number == u32::MAX { f.write_str(" -")? } else { write!(f, " {number}")? }
            }
        }
        Ok(())
    }
}

impl fmt::Debug for LazyLabels<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("LazyLabels").finish_non_exhaustive()
    }
}

impl fmt::Debug for LazyColumn<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("LazyColumn").field(&self.column).finish()
    }
}

/// A column of open labels. Each entry is nil, or a number less than `numbers`.
pub(super) struct Shape {
    pub(super) column: Column,
    pub(super) longest: usize,
    pub(super) numbers: usize,
    /// True if it can be shorter. Of links, an entry that is not there is nil, so that shorter columns are no others.
    pub(super) any_length: bool,
}

/// The columns of the labels of this work: those of the links that its tables do not store, and those of the numbers that are always labels.
///
/// A link leads to each slot or to the one past the end, as in tables. Ranks and positions are compared with each other only, and there are as many numbers as
/// half-edges, besides nil: any others are in the order of some of these.
///
/// # Errors
/// [`LazyError::NoCertificates`].
pub(super) fn shapes(work: &LazyWork) -> Result<Vec<Shape>, LazyError> {
    let claim = work.claim()?;
    let LazyWork { vertices, half_edges, boundaries, faces, .. } = *work;
    let has = |part| work.parts().has(part);
    let (by_record, has_faces) = (has(Part::BoundaryComponents), has(Part::Faces));
    let in_plane = matches!(claim, Claim::Plane);
    // The entries of all lists are boundary components, each of which is listed once; the list of a face of a table has as many as there are vertices.
    let places = if by_record { vertices } else { boundaries };
    let mut shapes =
        vec![Shape { column: Column::HalfEdgeRank, longest: half_edges + 1, numbers: half_edges, any_length: true }];
    let mut add = |missing: bool, any_length, column, longest, numbers| {
        if missing {
            shapes.push(Shape { column, longest, numbers, any_length });
        }
    };
    add(!has(Part::Prev), false, Column::HalfEdgePrev, half_edges, half_edges + 1);
    add(!has(Part::Leaving), false, Column::VertexLeaving, vertices, half_edges + 1);
    add(!in_plane, true, Column::HalfEdgeTurn, half_edges, half_edges);
    add(!in_plane, true, Column::HalfEdgeStep, half_edges, half_edges);
    add(!in_plane, true, Column::HalfEdgeComponent, half_edges, half_edges + 1);
    // On surfaces, faces that half-edges name are their own boundary components.
    let has_cycles = !by_record && (in_plane || !has_faces);
    add(has_cycles, false, Column::HalfEdgeBoundary, half_edges, boundaries + 1);
    add(has_cycles, true, Column::BoundaryFace, boundaries, faces + 1);
    add(has_cycles, false, Column::BoundaryStart, boundaries, half_edges + 1);
    add(has_cycles, false, Column::BoundaryVertex, boundaries, vertices + 1);
    add(!has(Part::Places) && (by_record || in_plane), false, Column::BoundaryPlace, boundaries, places + 1);
    add(!by_record && in_plane, false, Column::VertexIsolated, vertices, boundaries + 1);
    add(!by_record && in_plane, !has_faces, Column::FaceOuter, faces, boundaries + 1);
    add(!by_record && in_plane, false, Column::FaceEnd, faces, boundaries + 2);
    add(!by_record && in_plane, false, Column::FaceInner, boundaries, boundaries + 1);
    Ok(shapes)
}
