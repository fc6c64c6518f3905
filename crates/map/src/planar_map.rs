//! A subdivision with coordinates.

use super::feature_sets::FeatureSets;
use super::index::{KeptIndex, RecordIndex};
use super::not_plane::NotPlane;
use super::notes::Notes;
use super::summary::BuildSummary;
use crate::{Embedding, FeatureId, validate_embedding};
use std::fmt;
use std::ops::Index;
use twinedge::dcel::{Dcel, FaceKey, HalfEdgeKey, StaleKey, VertexKey};
use twinedge::delegate_view;
use twinedge::validate::{Collect, Expectation, HalfEdgeColumns, Report, View};
use twinedge_geometry::Point;
use twinedge_geometry::noding::NodingSummary;

/// A planar subdivision with coordinates: a [`Dcel`] whose edges are straight segments, and the features that cover its faces.
///
/// [`Builder`](super::Builder) makes one at once, [edits](super::edit) change one step by step from [`PlanarMap::new`], and
/// [`PlanarMap::from_view`] converts an existing structure. [`PlanarMap::dcel`] returns the topology; coordinates and features
/// are read by key.
///
/// ```text
///   ┌──────────┐ ┌──────┐    dcel      vertices, half-edges, faces and what lies in what
///   │ a   ┌──┐ │ │  b   │    position  by vertex
///   │     │  │ │ │   ┌──┼─┐  features  a: one polygon with a hole; b and c overlap
///   │     └──┘ │ │   │bc│c│  features_of(bc) = b, c
///   └──────────┘ └───┼──┘ │
///                    └────┘
/// ```
///
/// ```
/// use twinedge_map::{Builder, Feature, Shape};
///
/// let field = Feature {
///     name: Some("field".into()),
///     shapes: vec![
///         Shape::polygon([[0.0, 0.0], [6.0, 0.0], [6.0, 6.0], [0.0, 6.0]])
///             .hole([[2.0, 2.0], [2.0, 4.0], [4.0, 4.0], [4.0, 2.0]]),
///     ],
///     ..Feature::default()
/// };
/// let mut builder = Builder::new();
/// let field = builder.feature(&field)?;
/// let map = builder.build()?;
///
/// let covered = map.dcel().faces().find(|f| map.features_of(f.key()).unwrap().any(|g| g == field)).unwrap();
/// assert_eq!(map.name(field), Some("field"));
/// // Its boundary: the outer ring, and the ring of the hole.
/// let lengths: Vec<usize> = covered.boundaries().map(|b| b.half_edges().count()).collect();
/// assert_eq!(lengths, [4, 4]);
/// let first = covered.outer().unwrap().half_edges().next().unwrap();
/// assert!(map.position(first.origin().key())?.x <= 6.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Default)]
pub struct PlanarMap {
    pub(super) dcel: Dcel,
    pub(super) points: Vec<Point>,
    pub(super) names: Vec<Option<String>>,
    pub(super) features: FeatureSets,
    pub(super) summary: BuildSummary,
    pub(super) noding: Option<NodingSummary>,
    /// A place where edges meet without a vertex, if there is one.
    pub(super) not_plane: Option<NotPlane>,
    pub(super) index: KeptIndex,
    pub(super) notes: Notes,
}

/// Prints the numbers of records and features, and `plane`.
impl fmt::Debug for PlanarMap {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("PlanarMap")
            .field("vertices", &self.dcel.vertex_count())
            .field("edges", &self.dcel.edge_count())
            .field("faces", &self.dcel.face_count())
            .field("features", &self.names.len())
            .field("plane", &self.is_plane())
            .finish_non_exhaustive()
    }
}

/// Maps are equal if their structures have the same keys and links, their vertices have the same points, and their faces and
/// edges have the same features with the same names. The builder's findings are ignored. O(n), plus the features.
///
/// ```
/// use twinedge_map::PlanarMap;
///
/// let mut map = PlanarMap::new();
/// map.insert_ring([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])?;
/// let before = map.clone();
/// let made = map.insert_point([0.25, 0.25])?;
/// assert_ne!(map, before);
/// map.remove_vertex(made.vertices[0])?;
/// assert_eq!(map, before);
/// # Ok::<(), twinedge_map::edit::EditError>(())
/// ```
impl PartialEq for PlanarMap {
    fn eq(&self, other: &Self) -> bool {
        let points = |map: &Self| map.dcel.vertices().map(|v| map.point(v.index())).collect::<Vec<_>>();
        let is_covered_alike =
            |f: usize| self.features.set(self.features.of_face(f)).eq(other.features.set(other.features.of_face(f)));
        let is_followed_alike =
            |h: usize| self.features.set(self.features.along(h)).eq(other.features.set(other.features.along(h)));
        self.is_plane() == other.is_plane()
            && self.names == other.names
            && self.features.removed == other.features.removed
            && self.dcel == other.dcel
            && points(self) == points(other)
            && self.dcel.faces().all(|f| is_covered_alike(f.index()))
            && self.dcel.edges().all(|h| is_followed_alike(h.index()))
    }
}

/// Returns the coordinates of a vertex, like [`position`](PlanarMap::position).
///
/// # Panics
/// Panics if the key is stale.
///
/// ```
/// use twinedge_geometry::Point;
/// use twinedge_map::PlanarMap;
///
/// let mut map = PlanarMap::new();
/// let vertex = map.insert_point([2.0, 3.0])?.vertices[0];
/// assert_eq!(map[vertex], Point::new(2.0, 3.0));
/// # Ok::<(), twinedge_map::edit::EditError>(())
/// ```
impl Index<VertexKey> for PlanarMap {
    type Output = Point;

    #[track_caller]
    fn index(&self, vertex: VertexKey) -> &Point {
        &self.points[self.dcel.at(vertex).index()]
    }
}

impl PlanarMap {
    /// Creates an empty map, which has only the unbounded face. O(1).
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Returns the topology. O(1).
    ///
    /// ```
    /// use twinedge_map::PlanarMap;
    ///
    /// let mut map = PlanarMap::new();
    /// map.insert_ring([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])?;
    /// assert_eq!((map.dcel().vertex_count(), map.dcel().edge_count(), map.dcel().face_count()), (3, 3, 2));
    /// # Ok::<(), twinedge_map::edit::EditError>(())
    /// ```
    #[must_use]
    pub const fn dcel(&self) -> &Dcel {
        &self.dcel
    }

    /// Returns the coordinates of a vertex. O(1).
    ///
    /// ```
    /// use twinedge_geometry::Point;
    /// use twinedge_map::PlanarMap;
    ///
    /// let mut map = PlanarMap::new();
    /// let vertex = map.insert_point([2.0, 3.0])?.vertices[0];
    /// assert_eq!(map.position(vertex)?, Point::new(2.0, 3.0));
    /// map.remove_vertex(vertex)?;
    /// assert!(map.position(vertex).is_err());
    /// # Ok::<(), twinedge_map::edit::EditError>(())
    /// ```
    ///
    /// # Errors
    /// [`StaleKey::Vertex`].
    pub fn position(&self, vertex: VertexKey) -> Result<Point, StaleKey> {
        Ok(self.point(self.dcel.vertex(vertex)?.index()))
    }

    /// Returns the features that cover a face, in order. O(log features) for the first, O(1) on average for each other.
    ///
    /// ```
    /// use twinedge_map::{Builder, Shape};
    ///
    /// let square = |x: f64| [[x, 0.0], [x + 2.0, 0.0], [x + 2.0, 2.0], [x, 2.0]];
    /// let mut builder = Builder::new();
    /// let left = builder.shape(&Shape::polygon(square(0.0)))?;
    /// let right = builder.shape(&Shape::polygon(square(2.0)))?;
    /// let map = builder.build()?;
    /// let covers: Vec<Vec<_>> = map.dcel().faces().map(|f| map.features_of(f.key()).unwrap().collect()).collect();
    /// assert_eq!(covers, [vec![], vec![left], vec![right]]);
    /// # Ok::<(), twinedge_map::BuildError>(())
    /// ```
    ///
    /// # Errors
    /// [`StaleKey::Face`].
    pub fn features_of(&self, face: FaceKey) -> Result<impl Iterator<Item = FeatureId> + '_, StaleKey> {
        let set = self.features.of_face(self.dcel.face(face)?.index());
        Ok(self.features.set(set))
    }

    /// Returns the features whose rings or lines run along an edge, in order. O(log features) for the first, O(1) for others.
    ///
    /// ```
    /// use twinedge_map::Builder;
    ///
    /// let mut builder = Builder::new();
    /// let road = builder.segment([0.0, 0.0], [1.0, 0.0])?;
    /// let border = builder.segment([1.0, 0.0], [0.0, 0.0])?;
    /// let map = builder.build()?;
    /// let edge = map.dcel().edges().next().unwrap();
    /// assert!(map.features_along(edge.key())?.eq([road, border]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`StaleKey::HalfEdge`].
    pub fn features_along(&self, half_edge: HalfEdgeKey) -> Result<impl Iterator<Item = FeatureId> + '_, StaleKey> {
        let set = self.features.along(self.dcel.half_edge(half_edge)?.index());
        Ok(self.features.set(set))
    }

    /// Returns the feature with this number, counted from 0 in order of input, or `None` beyond the last. O(1).
    ///
    /// ```
    /// use twinedge_map::Builder;
    ///
    /// let mut builder = Builder::new();
    /// let road = builder.segment([0.0, 0.0], [1.0, 0.0])?;
    /// let map = builder.build()?;
    /// assert_eq!(map.feature(0), Some(road));
    /// assert_eq!(map.feature(1), None);
    /// # Ok::<(), twinedge_map::BuildError>(())
    /// ```
    #[must_use]
    pub fn feature(&self, index: usize) -> Option<FeatureId> {
        (index < self.names.len()).then_some(FeatureId::new(index as u32))
    }

    /// Returns all features, in order of input. A [removed](Self::remove_feature) feature keeps its number and is included.
    pub fn features(&self) -> impl Iterator<Item = FeatureId> + '_ {
        (0..self.names.len() as u32).map(FeatureId::new)
    }

    /// Returns the name of a feature, if it has one. O(1).
    #[must_use]
    pub fn name(&self, feature: FeatureId) -> Option<&str> {
        self.names.get(feature.index())?.as_deref()
    }

    /// Returns the counts and irregularities that the builder found in its input. Edits do not change them.
    #[must_use]
    pub const fn summary(&self) -> &BuildSummary {
        &self.summary
    }

    /// Returns the changes that noding made to the segments, or `None` if the map was built without noding.
    #[must_use]
    pub const fn noding(&self) -> Option<&NodingSummary> {
        self.noding.as_ref()
    }

    /// Returns true if edges meet only at shared endpoints. O(1).
    ///
    /// The builder determines this, and edits refuse a map that is not plane. Its links are valid, its locations undefined.
    ///
    /// ```
    /// use twinedge_map::{Builder, Noding};
    /// use twinedge::validate::Rule;
    ///
    /// let mut builder = Builder::new();
    /// builder.segment([0.0, 0.0], [2.0, 2.0])?;
    /// builder.segment([0.0, 2.0], [2.0, 0.0])?;
    /// let map = builder.build_with(Noding::None)?;
    /// assert!(!map.is_plane());
    /// assert_eq!(map.validate().first().unwrap().rule(), Rule::G4);
    /// # Ok::<(), twinedge_map::BuildError>(())
    /// ```
    #[must_use]
    pub const fn is_plane(&self) -> bool {
        self.not_plane.is_none()
    }

    /// Returns where the map is not [plane](Self::is_plane), if it is not. O(1).
    ///
    /// ```
    /// use twinedge_map::Builder;
    ///
    /// let mut builder = Builder::new();
    /// builder.segment([0.0, 0.0], [2.0, 2.0])?;
    /// builder.segment([0.0, 2.0], [2.0, 0.0])?;
    /// let map = builder.build()?;
    /// let why = map.locate([0.0, 0.0].into()).unwrap_err().to_string();
    /// assert!(why.starts_with("the map is not plane: edges meet where no vertex is, as at (1, 1); `Builder::build_with("));
    /// assert_eq!(map.not_plane().unwrap().to_string(), why);
    /// # Ok::<(), twinedge_map::BuildError>(())
    /// ```
    #[must_use]
    pub const fn not_plane(&self) -> Option<NotPlane> {
        self.not_plane
    }

    /// Returns an error if the map is not plane. O(1).
    ///
    /// # Errors
    /// [`NotPlane`], with the place.
    pub fn plane(&self) -> Result<(), NotPlane> {
        self.not_plane.map_or(Ok(()), Err)
    }

    /// Checks every rule, R1 … T4 and G1 … G5. O(n log n) for a plane map; otherwise plus the number of pairs of edges whose
    /// boxes meet.
    ///
    /// Useful in tests, and for maps of crossing segments ([`is_plane`](Self::is_plane)): edits break no rule.
    ///
    /// ```
    /// use twinedge_map::PlanarMap;
    ///
    /// let mut map = PlanarMap::new();
    /// map.insert_ring([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])?;
    /// let report = map.validate();
    /// assert!(report.is_valid());
    /// assert_eq!((report.counts().vertices, report.counts().edges), (3, 3));
    /// # Ok::<(), twinedge_map::edit::EditError>(())
    /// ```
    #[must_use]
    pub fn validate(&self) -> Report {
        validate_embedding(self, &Expectation::plane(), Collect::All)
    }
}

impl PlanarMap {
    /// Makes a map from a structure and the coordinates of its vertices, by index. Checks only that each vertex has coordinates;
    /// [`validate`](Self::validate) checks that they draw the structure. [`from_view`](Self::from_view) checks everything. O(1).
    #[must_use]
    pub fn assembled(dcel: Dcel, points: Vec<Point>) -> Option<Self> {
        (points.len() >= dcel.vertex_slots()).then(|| Self { dcel, points, ..Self::default() })
    }
}

impl PlanarMap {
    /// Returns the index of the edges and isolated vertices, building it in O(n log n) if necessary.
    pub(super) fn index(&self) -> &RecordIndex {
        self.index.get(&self.dcel, &self.points)
    }
}

impl Embedding for PlanarMap {
    fn point(&self, vertex: usize) -> Point {
        self.points.get(vertex).copied().unwrap_or_default()
    }
}

/// Indices are the indices of the [`Dcel`].
impl View for PlanarMap {
    delegate_view!(|this| &this.dcel);

    fn half_edge_columns(&self) -> Option<HalfEdgeColumns<'_>> {
        self.dcel.half_edge_columns()
    }
}
