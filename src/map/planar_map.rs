//! A subdivision with coordinates.

use super::feature::FeatureId;
use super::feature_sets::FeatureSets;
use super::summary::BuildSummary;
use crate::dcel::{Dcel, FaceKey, HalfEdgeKey, StaleKey, VertexKey};
use crate::geometry::Point;
use crate::geometry::noding::NodingSummary;
use crate::validate::{BoundaryPlace, Collect, Expectation, Link, Report, Start, View};
use crate::validate::{Embedding, validate_embedding};

/// A planar subdivision with coordinates: a [`Dcel`] whose edges are straight segments, and the features that cover its
/// faces.
///
/// Made all at once by [`Builder`](super::Builder), or step by step from [`PlanarMap::new`] by [edits](super::edit). The
/// topology is read through [`PlanarMap::dcel`]; coordinates and features are had by key.
#[derive(Clone, Debug)]
pub struct PlanarMap {
    pub(super) dcel: Dcel,
    /// By index of vertex.
    pub(super) points: Vec<Point>,
    /// By number of feature.
    pub(super) names: Vec<Option<String>>,
    pub(super) features: FeatureSets,
    pub(super) summary: BuildSummary,
    pub(super) noding: Option<NodingSummary>,
    /// Whether edges meet at shared endpoints only.
    pub(super) plane: bool,
}

impl Default for PlanarMap {
    fn default() -> Self {
        Self {
            dcel: Dcel::default(),
            points: Vec::new(),
            names: Vec::new(),
            features: FeatureSets::default(),
            summary: BuildSummary::default(),
            noding: None,
            plane: true,
        }
    }
}

impl PlanarMap {
    /// The empty map: the unbounded face, and nothing in it. O(1).
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// The topology.
    #[must_use]
    pub const fn dcel(&self) -> &Dcel {
        &self.dcel
    }

    /// Where a vertex lies. O(1).
    ///
    /// # Errors
    /// [`StaleKey::Vertex`].
    pub fn position(&self, vertex: VertexKey) -> Result<Point, StaleKey> {
        Ok(self.point(self.dcel.vertex(vertex)?.index()))
    }

    /// The features that cover a face, in order. O(1).
    ///
    /// # Errors
    /// [`StaleKey::Face`].
    pub fn features_of(&self, face: FaceKey) -> Result<impl Iterator<Item = FeatureId> + '_, StaleKey> {
        let set = self.features.of_face(self.dcel.face(face)?.index());
        Ok(self.features.set(set).iter().copied())
    }

    /// The features whose rings or lines run along an edge, in order. O(1).
    ///
    /// # Errors
    /// [`StaleKey::HalfEdge`].
    pub fn features_along(&self, half_edge: HalfEdgeKey) -> Result<impl Iterator<Item = FeatureId> + '_, StaleKey> {
        let set = self.features.along(self.dcel.half_edge(half_edge)?.index());
        Ok(self.features.set(set).iter().copied())
    }

    /// All features, in order of input.
    pub fn features(&self) -> impl Iterator<Item = FeatureId> + '_ {
        (0..self.names.len() as u32).map(FeatureId)
    }

    /// The name of a feature, if it has one. O(1).
    #[must_use]
    pub fn name(&self, feature: FeatureId) -> Option<&str> {
        self.names.get(feature.index())?.as_deref()
    }

    /// What became of the input of the builder. Edits leave it as it was.
    #[must_use]
    pub const fn summary(&self) -> &BuildSummary {
        &self.summary
    }

    /// What noding did to the segments; none, if the map was built of them as they are.
    #[must_use]
    pub const fn noding(&self) -> Option<&NodingSummary> {
        self.noding.as_ref()
    }

    /// Whether the segments from which the map was built meet at shared endpoints only. Edits keep it so, and refuse a map
    /// where it is not so.
    #[must_use]
    pub const fn is_plane(&self) -> bool {
        self.plane
    }

    /// Checks every rule, R1 … T4 and G1 … G5. O(n log n) for a plane map.
    #[must_use]
    pub fn validate(&self) -> Report {
        validate_embedding(self, &Expectation::plane(), Collect::All)
    }
}

impl Embedding for PlanarMap {
    fn point(&self, vertex: usize) -> Point {
        self.points.get(vertex).copied().unwrap_or_default()
    }
}

macro_rules! delegate {
    ($($name:ident($($arg:ident),*) -> $out:ty;)*) => {$(
        #[inline]
        fn $name(&self, $($arg: usize),*) -> $out {
            self.dcel.$name($($arg),*)
        }
    )*};
}

/// Indices are those of the [`Dcel`].
impl View for PlanarMap {
    delegate! {
        vertex_slots() -> usize;
        half_edge_slots() -> usize;
        boundary_slots() -> usize;
        face_slots() -> usize;
        is_vertex(vertex) -> bool;
        is_half_edge(half_edge) -> bool;
        is_boundary(boundary) -> bool;
        is_face(face) -> bool;
        origin(half_edge) -> Link;
        twin(half_edge) -> Link;
        next(half_edge) -> Link;
        prev(half_edge) -> Link;
        leaving(vertex) -> Link;
        isolated(vertex) -> Link;
        boundary_face(boundary) -> Link;
        boundary_start(boundary) -> Option<Start>;
        boundary_place(boundary) -> Option<BoundaryPlace>;
        outer(face) -> Link;
        inner_count(face) -> usize;
        inner(face, position) -> Link;
    }

    #[inline]
    fn boundary(&self, half_edge: usize) -> Link {
        View::boundary(&self.dcel, half_edge)
    }
}
