//! A subdivision with coordinates.

use super::arrange::Arranged;
use super::build::{BuildSummary, GatheredFeature};
use super::cover::Covered;
use super::crossing::Clash;
use super::noding;
use super::{Drawing, Point, validate_drawing};
use crate::dcel::{Dcel, FaceKey, HalfEdgeKey, StaleKey, VertexKey};
use crate::validate::{Collect, Expectation, Link, Place, Report, Start, View};

/// A feature of a map, such as a country: a number in order of input.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FeatureId(pub(super) u32);

impl FeatureId {
    /// The place in order of input, counted from 0.
    #[must_use]
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

/// A planar subdivision with coordinates: a [`Dcel`] whose edges are straight segments, and the features that cover its
/// faces.
///
/// Made by [`Builder`](super::Builder). The topology is read through [`PlanarMap::dcel`]; coordinates and features are had by
/// key.
#[derive(Clone, Debug)]
pub struct PlanarMap {
    dcel: Dcel,
    /// By index of vertex.
    points: Vec<Point>,
    names: Vec<Option<String>>,
    covered: Covered,
    summary: BuildSummary,
    noding: Option<noding::Summary>,
    clash: Option<Clash>,
}

impl PlanarMap {
    pub(super) fn from_parts(
        points: Vec<Point>,
        arranged: Arranged,
        features: Vec<GatheredFeature>,
        covered: Covered,
        summary: BuildSummary,
        noding: Option<noding::Summary>,
    ) -> Self {
        let Arranged { dcel, vertices, clash, .. } = arranged;
        let end = vertices.iter().max().map_or(0, |last| *last as usize + 1);
        let mut by_index = vec![Point::default(); end];
        for (vertex, point) in vertices.into_iter().zip(points) {
            by_index[vertex as usize] = point;
        }
        let names = features.into_iter().map(|feature| feature.name).collect();
        Self { dcel, points: by_index, names, covered, summary, noding, clash }
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

    /// The features that cover a face, in order. O(log n).
    ///
    /// # Errors
    /// [`StaleKey::Face`].
    pub fn features_of(&self, face: FaceKey) -> Result<impl Iterator<Item = FeatureId> + '_, StaleKey> {
        Ok(Self::pairs(&self.covered.faces, self.dcel.face(face)?.index()))
    }

    /// The features whose rings or lines run along an edge, in order. O(log n).
    ///
    /// # Errors
    /// [`StaleKey::HalfEdge`].
    pub fn features_along(&self, half_edge: HalfEdgeKey) -> Result<impl Iterator<Item = FeatureId> + '_, StaleKey> {
        let h = self.dcel.half_edge(half_edge)?;
        Ok(Self::pairs(&self.covered.edges, h.index().min(h.twin().index())))
    }

    fn pairs(pairs: &[(u32, u32)], index: usize) -> impl Iterator<Item = FeatureId> + '_ {
        let start = pairs.partition_point(|(i, _)| (*i as usize) < index);
        pairs[start..].iter().take_while(move |(i, _)| *i as usize == index).map(|(_, feature)| FeatureId(*feature))
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

    /// What became of the input of the builder.
    #[must_use]
    pub const fn summary(&self) -> &BuildSummary {
        &self.summary
    }

    /// What noding did to the segments; none, if the map was built of them as they are.
    #[must_use]
    pub const fn noding(&self) -> Option<&noding::Summary> {
        self.noding.as_ref()
    }

    /// Whether the segments from which the map was built meet at shared endpoints only.
    #[must_use]
    pub const fn is_plane(&self) -> bool {
        self.clash.is_none()
    }

    /// Checks every rule, R1 … T4 and G1 … G5. O(n log n) for a plane map.
    #[must_use]
    pub fn validate(&self) -> Report {
        validate_drawing(self, &Expectation::plane(), Collect::All)
    }
}

impl Drawing for PlanarMap {
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
        boundary_place(boundary) -> Option<Place>;
        outer(face) -> Link;
        inner_count(face) -> usize;
        inner(face, position) -> Link;
    }

    #[inline]
    fn boundary(&self, half_edge: usize) -> Link {
        View::boundary(&self.dcel, half_edge)
    }
}
