//! Importing an existing structure with coordinates.

use super::planar_map::PlanarMap;
use crate::{Embedding, validate_embedding};
use std::fmt;
use thiserror::Error;
use twinedge::dcel::{Dcel, ImportError, Keys, Outside};
use twinedge::validate::{Collect, Expectation, Report};
use twinedge_geometry::Point;

/// The error of [`PlanarMap::from_view`]: the structure was refused.
#[derive(Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum MapImportError {
    /// The structure breaks a rule from R1 to G5. The report names records by their indices in the view.
    #[error("the structure is not valid:\n{0}")]
    Invalid(Box<Report>),
    /// The structure is valid, but its topology is not a planar subdivision with this outside.
    #[error(transparent)]
    Topology(#[from] ImportError),
    /// The topology is planar, but the coordinates do not draw it with this outside. The report has indices of the refused map.
    #[error("with that outside, the coordinates do not draw the structure:\n{0}")]
    NotDrawn(Box<Report>),
}

/// Formats like `Display`, so that a failed `unwrap` or `main` prints readable lines.
impl fmt::Debug for MapImportError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl MapImportError {
    /// Returns the validator's report, if the validator refused.
    #[must_use]
    pub fn report(&self) -> Option<&Report> {
        match self {
            Self::Invalid(report) | Self::NotDrawn(report) => Some(report),
            Self::Topology(error) => error.report(),
        }
    }
}

impl PlanarMap {
    /// Builds the map that a structure with coordinates describes. Also returns the keys of its records.
    ///
    /// Validates the structure first, R1 … G5, and then the resulting map: the map keeps every rule, even if the view answers
    /// inconsistently. [`Dcel::from_view`] explains the expectation and the outside. The map has no features; add them with
    /// [`add_feature`](Self::add_feature) and [`set_features_of`](Self::set_features_of), using the keys. −0 becomes 0.
    ///
    /// O(n log n) time and O(n) memory for n slots of the view.
    ///
    /// ```
    /// use twinedge::dcel::Outside;
    /// use twinedge_geometry::Point;
    /// use twinedge_map::{Embedding, PlanarMap};
    /// use twinedge::validate::{Expectation, Link, Part, Parts, View};
    ///
    /// /// Two triangles that share an edge: half-edges `3f`, `3f + 1`, `3f + 2` around triangle `f`.
    /// ///
    /// ///     3 ─────── 2
    /// ///     │  1   ╱  │
    /// ///     │   ╱  0  │
    /// ///     0 ─────── 1
    /// struct Triangles;
    ///
    /// impl View for Triangles {
    ///     fn parts(&self) -> Parts { Parts::NONE.with(Part::Faces) }
    ///     fn vertex_slots(&self) -> usize { 4 }
    ///     fn half_edge_slots(&self) -> usize { 6 }
    ///     fn face_slots(&self) -> usize { 2 }
    ///     fn origin(&self, h: usize) -> Link { Some([0, 1, 2, 0, 2, 3][h]) }
    ///     fn twin(&self, h: usize) -> Link { [None, None, Some(3), Some(2), None, None][h] }
    ///     fn next(&self, h: usize) -> Link { Some(h - h % 3 + (h + 1) % 3) }
    ///     fn face(&self, h: usize) -> Link { Some(h / 3) }
    ///     fn outer_half_edge(&self, f: usize) -> Link { Some(3 * f) }
    /// }
    ///
    /// impl Embedding for Triangles {
    ///     fn point(&self, v: usize) -> Point {
    ///         [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]][v].into()
    ///     }
    /// }
    ///
    /// let mesh = Expectation::surface().open();
    /// let (map, keys) = PlanarMap::from_view(&Triangles, &mesh, Outside::Border)?;
    /// assert_eq!((map.dcel().edge_count(), map.dcel().face_count()), (5, 3));
    /// assert_eq!(map.position(keys.vertex(2).unwrap())?, Point::new(1.0, 1.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`MapImportError::Invalid`] if the structure breaks a rule; [`MapImportError::Topology`] for the errors of
    /// [`Dcel::from_view`]; [`MapImportError::NotDrawn`] if its coordinates do not draw the map, or change meanwhile.
    pub fn from_view<V: Embedding + ?Sized>(
        view: &V,
        expectation: &Expectation,
        outside: Outside,
    ) -> Result<(Self, Keys), MapImportError> {
        // A closed mesh has no unbounded face; its coordinates are validated once it has one.
        if !matches!(outside, Outside::Face(_)) {
            let report = validate_embedding(view, expectation, Collect::All);
            if !report.is_valid() {
                return Err(MapImportError::Invalid(Box::new(report)));
            }
        }
        let (dcel, keys) = Dcel::from_view(view, expectation, outside)?;
        let mut points = vec![Point::default(); dcel.vertices().last().map_or(0, |v| v.index() + 1)];
        for vertex in 0..view.vertex_slots() {
            let new = keys.vertex(vertex).and_then(|key| dcel.vertex(key).ok());
            if let Some(new) = new {
                // Adding zero turns −0 into 0.
                let Point { x, y } = view.point(vertex);
                points[new.index()] = Point::new(x + 0.0, y + 0.0);
            }
        }
        let map = Self { dcel, points, ..Self::default() };
        let report = map.validate();
        if report.is_valid() { Ok((map, keys)) } else { Err(MapImportError::NotDrawn(Box::new(report))) }
    }
}
