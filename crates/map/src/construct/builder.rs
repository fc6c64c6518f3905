//! Gathering rings, lines and points, and building a map from all of them at once.

use super::arrange::{CombinatorialMap, Placement, arrange, points_by_vertex};
use super::cover::cover;
use super::cut::{self, CutSegments, Noding, usual_cuts};
use super::error::BuildError;
use super::gathered::GatheredFeatures;
use super::rings::Ring;
use crate::FeatureId;
use crate::feature::{Feature, Shape};
use crate::index::KeptIndex;
use crate::not_plane::NotPlane;
use crate::notes::Notes;
use crate::number_table::{NumberTable, hash};
use crate::planar_map::PlanarMap;
use crate::summary::{BuildSummary, IrregularityKind, Position};
use twinedge::dcel::RecordKind;
use twinedge_geometry::crossing::{Clash, clashes};
use twinedge_geometry::noding::NodingSummary;
use twinedge_geometry::{Point, threads};

/// The number of points of a chain that are looked up together.
const LOOKED_UP: usize = 64;

/// A step along a chain, to a vertex.
struct Step {
    to: u32,
    is_new: bool,
}

/// What the segments of a ring or a line tell about it, besides its darts.
#[derive(Default)]
struct Course {
    /// The position of the point where each segment starts.
    starts: Vec<u32>,
    /// True if two segments of the ring may start at one vertex.
    returns: bool,
}

/// Gathers rings, lines and points, and builds the map of them.
///
/// Vertices with equal coordinates are merged (−0 equals 0), as are repeated segments; segments without length are dropped.
/// [`BuildSummary`] counts these. Segments should meet only at shared endpoints. [`build_with`](Self::build_with) can cut others.
/// [`build`](Self::build) leaves them, and [`PlanarMap::not_plane`] reports where; queries and edits refuse such a map.
///
/// ```
/// use twinedge_map::{Builder, Shape};
///
/// let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [0.0, 0.0]];
/// let island = [[1.0, 1.0], [2.0, 1.0], [1.0, 2.0], [1.0, 1.0]];
/// let mut builder = Builder::new();
/// builder.shape(&Shape::polygon(square).hole(island))?;
/// let map = builder.build()?;
/// assert_eq!((map.dcel().vertex_count(), map.dcel().face_count()), (7, 3));
/// assert!(map.validate().is_valid());
/// # Ok::<(), twinedge_map::BuildError>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct Builder {
    pub(super) points: Vec<Point>,
    places: NumberTable,
    /// Distinct segments, by their ends in order of vertex numbers.
    pub(super) segments: Vec<[u32; 2]>,
    segment_numbers: NumberTable,
    /// The number of the last ring that visited each point. Numbers wrap around, so an equal number only suggests a second visit.
    last_rings: Vec<u32>,
    ring: u32,
    pub(super) features: GatheredFeatures,
    summary: BuildSummary,
    cuts: Option<usize>,
}

impl Builder {
    /// Creates an empty builder.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a feature. O(its points), expected.
    ///
    /// ```
    /// use twinedge_geometry::Point;
    /// use twinedge_map::{BuildError, Builder, Feature, Shape};
    ///
    /// let peak = |x: f64, y: f64| Feature {
    ///     name: Some("peak".into()),
    ///     shapes: vec![Shape::Point(Point::new(x, y))],
    ///     ..Feature::default()
    /// };
    /// let mut builder = Builder::new();
    /// let first = builder.feature(&peak(7.0, 46.0))?;
    /// assert!(matches!(builder.feature(&peak(f64::NAN, 46.0)), Err(BuildError::NotFinite { .. })));
    /// let second = builder.feature(&peak(8.0, 46.5))?;
    /// assert_eq!((first.index(), second.index()), (0, 1));
    /// # Ok::<(), BuildError>(())
    /// ```
    ///
    /// # Errors
    /// [`BuildError::NotFinite`] and [`BuildError::OutOfRange`], with the position. Nothing of the feature is added then.
    pub fn feature(&mut self, feature: &Feature) -> Result<FeatureId, BuildError> {
        let id = FeatureId::new(self.features.names.len() as u32);
        feature.check(id.index())?;
        // A builder that was returned has no tables.
        self.places.extend(self.points.len(), |number| hash_of_point(self.points[number as usize]));
        self.segment_numbers.extend(self.segments.len(), |number| hash_of_segment(self.segments[number as usize]));
        self.last_rings.resize(self.points.len(), self.ring);
        let [darts, parts] = [self.features.darts.len(), self.features.parts.len()];
        let taken = feature.shapes.iter().enumerate().try_for_each(|(shape, what)| {
            self.take(what, Position { feature: id.index(), shape, ..Position::default() })
        });
        if let Err(full) = taken {
            self.features.darts.truncate(darts);
            self.features.parts.truncate(parts);
            return Err(full);
        }
        self.features.names.push(feature.name.clone());
        self.summary.features += 1;
        Ok(id)
    }

    /// Adds a shape as an unnamed feature.
    ///
    /// # Errors
    /// As for [`Builder::feature`].
    pub fn shape(&mut self, shape: &Shape) -> Result<FeatureId, BuildError> {
        self.feature(&Feature { shapes: vec![shape.clone()], ..Feature::default() })
    }

    /// Adds a single segment as an unnamed feature.
    ///
    /// # Errors
    /// As for [`Builder::feature`].
    pub fn segment(&mut self, from: impl Into<Point>, to: impl Into<Point>) -> Result<FeatureId, BuildError> {
        self.shape(&Shape::Line(vec![from.into(), to.into()]))
    }

    /// Returns the counts and irregularities of the input so far.
    ///
    /// ```
    /// use twinedge_map::Builder;
    ///
    /// let mut builder = Builder::new();
    /// builder.segment([0.0, 0.0], [1.0, 0.0])?;
    /// builder.segment([1.0, 0.0], [0.0, 0.0])?;
    /// builder.segment([1.0, 0.0], [1.0, 0.0])?;
    /// let summary = builder.summary();
    /// assert_eq!((summary.segments, summary.duplicate_segments, summary.zero_length_segments), (3, 1, 1));
    /// # Ok::<(), twinedge_map::BuildError>(())
    /// ```
    #[must_use]
    pub const fn summary(&self) -> &BuildSummary {
        &self.summary
    }

    /// Limits the number of cuts by [`Noding::Snap`]: each segment is cut once at each vertex between its ends. The default is
    /// 2^20 plus 16 for each distinct segment. Most drawings need far fewer cuts, and memory grows with every cut. O(1).
    ///
    /// ```
    /// use twinedge_geometry::noding::Snap;
    /// use twinedge_map::{BuildError, Builder, Noding};
    ///
    /// let mut builder = Builder::new();
    /// builder.segment([0.0, 0.0], [2.0, 2.0])?;
    /// builder.segment([0.0, 2.0], [2.0, 0.0])?;
    /// // The crossing cuts both.
    /// builder.limit_cuts(1);
    /// let refused = builder.build_with(Noding::Snap(Snap::Auto));
    /// assert!(matches!(refused, Err(BuildError::TooManyCuts { allowed: 1 })));
    /// # Ok::<(), BuildError>(())
    /// ```
    pub const fn limit_cuts(&mut self, cuts: usize) {
        self.cuts = Some(cuts);
    }

    fn take(&mut self, shape: &Shape, at: Position) -> Result<(), BuildError> {
        match shape {
            Shape::Polygon(rings) => {
                for (ring, points) in rings.iter().enumerate() {
                    self.ring(points, Position { ring, ..at })?;
                }
                self.features.put_part(true);
            }
            Shape::Line(points) => {
                self.chain(points, at, &mut Course::default())?;
                self.features.put_part(false);
            }
            Shape::Point(p) => {
                self.vertex(*p, hash_of_point(*p), 0)?;
            }
        }
        Ok(())
    }

    /// Adds the segments of a ring, closes it, and checks it.
    fn ring(&mut self, ring: &[Point], at: Position) -> Result<(), BuildError> {
        let (Some(first), Some(last)) = (ring.first(), ring.last()) else {
            self.summary.degenerate_rings += 1;
            return Ok(());
        };
        let before = self.features.darts.len();
        self.ring = self.ring.wrapping_add(1);
        let mut course = Course { starts: Vec::with_capacity(ring.len()), returns: false };
        self.chain(ring, at, &mut course)?;
        if first != last {
            let end = Position { point: ring.len() - 1, ..at };
            self.summary.open_rings += 1;
            self.summary.list(self.summary.open_rings, IrregularityKind::OpenRing, end, *last);
            self.chain(&[*last, *first], end, &mut course)?;
        }
        let Course { starts, returns } = &course;
        let darts = &self.features.darts[before..];
        let shape =
            Ring { input: ring, starts, returns: *returns, points: &self.points, segments: &self.segments, darts }
                .shape();
        let summary = &mut self.summary;
        if darts.len() < 3 {
            summary.degenerate_rings += 1;
            summary.list(summary.degenerate_rings, IrregularityKind::DegenerateRing, at, *first);
        }
        if shape.counter_clockwise == Some(at.ring > 0) {
            summary.rings_wound_wrongly += 1;
            summary.list(summary.rings_wound_wrongly, IrregularityKind::WoundWrongly, at, *first);
        }
        let place = |point: u32| (Position { point: point as usize, ..at }, ring[point as usize]);
        if let Some((position, point)) = shape.touches.map(place) {
            summary.self_touching_rings += 1;
            summary.list(summary.self_touching_rings, IrregularityKind::SelfTouching, position, point);
        }
        for (position, point) in shape.spikes.into_iter().map(place) {
            summary.spikes += 1;
            summary.list(summary.spikes, IrregularityKind::Spike, position, point);
        }
        Ok(())
    }

    /// Adds the segments of a chain of points. A single point is an isolated vertex.
    fn chain(&mut self, points: &[Point], at: Position, course: &mut Course) -> Result<(), BuildError> {
        let Some((first, rest)) = points.split_first() else { return Ok(()) };
        let (mut from, mut last) = (self.vertex(*first, hash_of_point(*first), 0)?, 0);
        let mut steps = Vec::with_capacity(rest.len().min(LOOKED_UP));
        let mut hashes = [0; LOOKED_UP];
        for (points, place) in rest.chunks(LOOKED_UP).zip((at.point..).step_by(LOOKED_UP)) {
            let hashes = &mut hashes[..points.len()];
            self.walk(from, points, &mut steps, hashes)?;
            for (i, Step { to, is_new }) in steps.drain(..).enumerate() {
                if from == to {
                    self.summary.zero_length_segments += 1;
                    let position = Position { point: place + i + 1, ..at };
                    let count = self.summary.zero_length_segments;
                    self.summary.list(count, IrregularityKind::RepeatedPoint, position, points[i]);
                    continue;
                }
                let number = self.segment_between(ends(from, to), hashes[i], is_new, last)?;
                self.features.darts.push(number << 1 | u32::from(from > to));
                course.starts.push((place + i) as u32);
                course.returns |= core::mem::replace(&mut self.last_rings[from as usize], self.ring) == self.ring;
                last = number;
                from = to;
            }
            self.summary.segments += points.len();
        }
        Ok(())
    }

    /// Finds or adds the vertices of points, and appends the steps of a chain that comes from `from`, with the hashes of its
    /// segments. Tables are prefetched: waiting for memory at each lookup takes most of the time of large maps.
    fn walk(
        &mut self,
        from: u32,
        points: &[Point],
        steps: &mut Vec<Step>,
        hashes: &mut [u64],
    ) -> Result<(), BuildError> {
        for (hash, p) in hashes.iter_mut().zip(points) {
            *hash = hash_of_point(*p);
        }
        self.places.read_ahead(hashes);
        let mut beside = from;
        for (hash, p) in hashes.iter_mut().zip(points) {
            let before = self.points.len();
            let to = self.vertex(*p, *hash, beside)?;
            steps.push(Step { to, is_new: self.points.len() > before });
            *hash = hash_of_segment(ends(beside, to));
            beside = to;
        }
        self.segment_numbers.read_ahead(hashes);
        Ok(())
    }

    /// Finds or adds a segment. Its number is often next to the given one, since borders are followed from both sides.
    fn segment_between(&mut self, ends: [u32; 2], hash: u64, is_new: bool, beside: u32) -> Result<u32, BuildError> {
        let is = |number: u32| self.segments.get(number as usize) == Some(&ends);
        // No segment leads to a new point yet.
        let near = |number: u32| Some(number).filter(|number| !is_new && is(*number));
        let found = near(beside + 1).or_else(|| near(beside.wrapping_sub(1))).map_or_else(
            || {
                let room = self.segments.len() + 1;
                self.segment_numbers.reserve(room, |number| hash_of_segment(self.segments[number as usize]));
                self.segment_numbers.find(hash, is)
            },
            Ok,
        );
        self.summary.duplicate_segments += usize::from(found.is_ok());
        found.or_else(|free| {
            let number = self.segments.len() as u32;
            if number >= 1 << 30 {
                return Err(BuildError::Full(RecordKind::Edge));
            }
            self.segments.push(ends);
            self.segment_numbers.fill(free, hash);
            Ok(number)
        })
    }

    /// Finds or adds the vertex of a point with this hash. Its number is often next to the given one.
    fn vertex(&mut self, p: Point, hash: u64, beside: u32) -> Result<u32, BuildError> {
        let is = |number: u32| self.points.get(number as usize) == Some(&p);
        let near = |number: u32| Some(number).filter(|number| is(*number));
        if let Some(known) = near(beside + 1).or_else(|| near(beside.wrapping_sub(1))) {
            return Ok(known);
        }
        self.places.reserve(self.points.len() + 1, |number| hash_of_point(self.points[number as usize]));
        self.places.find(hash, is).or_else(|free| {
            let number = self.points.len() as u32;
            if number >= 1 << 30 {
                return Err(BuildError::Full(RecordKind::Vertex));
            }
            self.points.push(without_sign_of_zero(p));
            self.places.fill(free, hash);
            self.last_rings.push(self.ring.wrapping_sub(1));
            Ok(number)
        })
    }

    /// Builds the map from the segments as they are, [`Noding::None`]. O(n log n).
    ///
    /// # Errors
    /// [`BuildError::Full`].
    pub fn build(self) -> Result<PlanarMap, BuildError> {
        self.build_with(Noding::None)
    }

    /// Cuts the segments where they meet, as [`Noding`] says, and builds the map. [`PlanarMap::noding`] counts the cuts.
    ///
    /// O(n log n) without noding; see [`noding`](twinedge_geometry::noding#cost) for its cost. With the feature `rayon`, the work
    /// is divided among the threads of the current pool; the map is the same.
    ///
    /// ```
    /// use twinedge_geometry::noding::Snap;
    /// use twinedge_map::{BuildError, Builder, Noding};
    ///
    /// let cross = || {
    ///     let mut builder = Builder::new();
    ///     builder.segment([0.0, 0.0], [2.0, 2.0])?;
    ///     builder.segment([0.0, 2.0], [2.0, 0.0])?;
    ///     Ok::<_, BuildError>(builder)
    /// };
    /// let map = cross()?.build_with(Noding::Snap(Snap::Auto))?;
    /// assert_eq!((map.dcel().vertex_count(), map.dcel().edge_count()), (5, 4));
    /// assert_eq!(map.noding().map(|summary| summary.crossings), Some(1));
    /// assert!(matches!(cross()?.build_with(Noding::Exact), Err(BuildError::Crossing { count: 1, .. })));
    /// # Ok::<(), BuildError>(())
    /// ```
    ///
    /// # Errors
    /// [`BuildError::Full`]; with [`Noding::Exact`], [`BuildError::Crossing`]; with [`Noding::Snap`],
    /// [`BuildError::CellSize`], [`BuildError::OutOfReach`] and [`BuildError::TooManyCuts`].
    pub fn build_with(self, noding: Noding) -> Result<PlanarMap, BuildError> {
        let Self { points, places, segments, segment_numbers, last_rings, mut features, summary, cuts, .. } = self;
        drop((places, segment_numbers, last_rings));
        // A plane drawing needs no cuts.
        let plane = if noding == Noding::Exact { Some(Placement::new(&points, &segments)?) } else { None };
        let plane = plane.filter(|swept| swept.clash.is_none());
        let (points, segments, noded) = match noding {
            Noding::None => (points, segments, None),
            Noding::Exact if plane.is_some() => (points, segments, Some(NodingSummary::default())),
            Noding::Exact => {
                let CutSegments { points, segments, summary } = cut::exact(points, &segments, &mut features)?;
                (points, segments, Some(summary))
            }
            Noding::Snap(snap) => {
                let cuts = cuts.unwrap_or(usual_cuts(segments.len()));
                let CutSegments { points, segments, summary } =
                    cut::snapped(points, segments, &mut features, snap, cuts)?;
                (points, segments, Some(summary))
            }
        };
        let map = assembled(&points, &segments, &mut features, plane, |clash| match clash {
            Clash::Cross { a, b } if noding == Noding::Exact => {
                let [one, other] = [a, b].map(|segment| segments[segment as usize].map(|v| points[v as usize]));
                let count = clashes(&points, &segments, 0).map_or(1, |(_, count)| count);
                Err(BuildError::Crossing { one, other, count })
            }
            _ => Ok(()),
        })?;
        Ok(PlanarMap { summary, noding: noded, points: points_by_vertex(points), ..map })
    }

    /// Builds the map from the segments as they are. If it is not plane, also returns the builder, so the segments can be cut
    /// without being gathered again. A plane map copies nothing. O(n log n).
    ///
    /// ```
    /// use twinedge_map::{Builder, Noding};
    ///
    /// let mut builder = Builder::new();
    /// builder.segment([0.0, 0.0], [2.0, 2.0])?;
    /// builder.segment([0.0, 2.0], [2.0, 0.0])?;
    /// let (map, kept) = builder.build_keeping()?;
    /// assert!(!map.is_plane());
    /// let cut = kept.unwrap().build_with(Noding::Snap(Default::default()))?;
    /// assert_eq!(cut.dcel().vertex_count(), 5);
    /// # Ok::<(), twinedge_map::BuildError>(())
    /// ```
    ///
    /// # Errors
    /// [`BuildError::Full`].
    pub fn build_keeping(self) -> Result<(PlanarMap, Option<Self>), BuildError> {
        let Self { points, places, segments, segment_numbers, last_rings, mut features, summary, cuts, .. } = self;
        drop((places, segment_numbers, last_rings));
        let map = assembled(&points, &segments, &mut features, None, |_| Ok(()))?;
        if map.is_plane() {
            return Ok((PlanarMap { summary, points: points_by_vertex(points), ..map }, None));
        }
        let map = PlanarMap { summary: summary.clone(), points: points_by_vertex(points.clone()), ..map };
        features.names.clone_from(&map.names);
        let kept = Self { points, segments, features, summary, cuts, ..Self::default() };
        Ok((map, Some(kept)))
    }
}

/// Replaces −0 by 0.
fn without_sign_of_zero(p: Point) -> Point {
    Point::new(p.x + 0.0, p.y + 0.0)
}

fn ends(from: u32, to: u32) -> [u32; 2] {
    [from.min(to), from.max(to)]
}

/// Returns a hash of a point. −0 counts as 0.
fn hash_of_point(p: Point) -> u64 {
    let p = without_sign_of_zero(p);
    hash([p.x.to_bits(), p.y.to_bits()])
}

fn hash_of_segment([a, b]: [u32; 2]) -> u64 {
    hash([a.into(), b.into()])
}

/// Assembles the map of the segments, without its points. Moves the names out. `refuse` judges segments that cross or touch.
fn assembled(
    points: &[Point],
    segments: &[[u32; 2]],
    features: &mut GatheredFeatures,
    swept: Option<Placement>,
    refuse: impl FnOnce(Clash) -> Result<(), BuildError>,
) -> Result<PlanarMap, BuildError> {
    // The two are independent.
    let (swept, turned) = threads::join(
        || swept.map_or_else(|| Placement::new(points, segments), Ok),
        || CombinatorialMap::new(points, segments),
    );
    let swept = swept?;
    swept.clash.map_or(Ok(()), refuse)?;
    let dcel = arrange(points, segments, &swept, turned)?;
    let of_map = cover(&dcel, segments.len(), features);
    Ok(PlanarMap {
        points: Vec::new(),
        not_plane: swept.clash.map(|clash| NotPlane::at(clash, points, segments)),
        dcel,
        names: core::mem::take(&mut features.names),
        features: of_map,
        summary: BuildSummary::default(),
        noding: None,
        index: KeptIndex::default(),
        notes: Notes::default(),
    })
}
