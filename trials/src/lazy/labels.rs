//! Labels as a checker of certificates reads them, and their columns.

use super::work::{Claim, LazyError, LazyWork};
use std::fmt;
use twinedge::validate::Part;
use twinedge_certificate::{Column, Columns, Labels, Numbers};

/// The labels of a table, whose cells can be open.
#[derive(Clone, Copy)]
pub struct LazyLabels<'a>(&'a dyn LabelSource);

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

/// The columns with entries, each with its name and its numbers.
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

pub(super) struct Shape {
    pub(super) column: Column,
    pub(super) longest: usize,
    /// True if it can be shorter. An absent entry of links is nil, so shorter columns of links are no different ones.
    pub(super) is_any_length: bool,
    pub(super) entries: Entries,
}

/// The entries of a column: nil, or a number from 0 below a bound.
pub(super) enum Entries {
    Links(usize),
    /// Ranks or positions: those in the same order are equivalent.
    Ordered(usize),
}

/// Returns the columns of the labels of this work: for links that its tables do not store, and numbers that are always labels.
///
/// A link leads to each slot or to the one past the end, as in tables. As many ranks as half-edges, and nil, can be in any order.
///
/// # Errors
/// [`LazyError::NoCertificates`].
pub(super) fn shapes(work: &LazyWork) -> Result<Vec<Shape>, LazyError> {
    let claim = work.claim()?;
    let LazyWork { vertices, half_edges, boundaries, faces, .. } = *work;
    let has = |part| work.parts().has(part);
    let (by_record, has_faces) = (has(Part::BoundaryComponents), has(Part::Faces));
    let in_plane = matches!(claim, Claim::Plane);
    // The list of a face of a table has one entry per vertex; in labels each boundary component is listed once.
    let places = if by_record { vertices } else { boundaries };
    let mut shapes = Vec::new();
    let mut add = |is_label, is_any_length, column, longest, entries| {
        if is_label {
            shapes.push(Shape { column, longest, is_any_length, entries });
        }
    };
    let links = |slots| Entries::Links(slots + 1);
    let ordered = || Entries::Ordered(half_edges);
    add(true, true, Column::HalfEdgeRank, half_edges + 1, ordered());
    add(!has(Part::Prev), false, Column::HalfEdgePrev, half_edges, links(half_edges));
    add(!has(Part::Leaving), false, Column::VertexLeaving, vertices, links(half_edges));
    add(!in_plane, true, Column::HalfEdgeTurn, half_edges, ordered());
    add(!in_plane, true, Column::HalfEdgeStep, half_edges, ordered());
    add(!in_plane, true, Column::HalfEdgeComponent, half_edges, links(half_edges));
    // On surfaces, faces that half-edges name are their own boundary components.
    let has_cycles = !by_record && (in_plane || !has_faces);
    add(has_cycles, false, Column::HalfEdgeBoundary, half_edges, links(boundaries));
    add(has_cycles, true, Column::BoundaryFace, boundaries, links(faces));
    add(has_cycles, false, Column::BoundaryStart, boundaries, links(half_edges));
    add(has_cycles, false, Column::BoundaryVertex, boundaries, links(vertices));
    add(!has(Part::Places) && (by_record || in_plane), false, Column::BoundaryPlace, boundaries, links(places));
    let has_lists = !by_record && in_plane;
    add(has_lists, false, Column::VertexIsolated, vertices, links(boundaries));
    add(has_lists, !has_faces, Column::FaceOuter, faces, links(boundaries));
    // Ends are numbers of entries: one more than there are.
    add(has_lists, false, Column::FaceEnd, faces, links(boundaries + 1));
    add(has_lists, false, Column::FaceInner, boundaries, links(boundaries));
    Ok(shapes)
}
