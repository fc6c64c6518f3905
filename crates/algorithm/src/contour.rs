//! The outline of a set of faces, as polygons with holes.
//!
//! Edges between two faces of the set vanish; so do lines and isolated vertices inside it. The remaining half-edges have a face
//! of the set on their left and another face on their right. From the end of such a half-edge the outline continues along the
//! same wedge of the set. So where parts of the set meet like black fields of a chessboard, it stays with its own part:
//!
//! ```text
//!   ┌───────┐               ┌───────────┐
//!   │   A   │               │     A     │     ┌───── A ─────┐
//!   │     ▲ │               │   ┌───┐   │     │   ┌───┬───┐ │
//!   └─────┼─●───────┐       │   │   │   │     │   │ B │   │ │
//!           │ ▼     │       └───┴─●─┴───┘     │   ├───●───┤ │
//!           │   A   │             hole        │   │   │ B │ │
//!           └───────┘                         │   └───┴───┘ │
//!    two polygons, which    one polygon, whose     two holes, which
//!    touch at a vertex      hole touches it        touch at a vertex
//! ```
//!
//! The polygons are valid by the rules of the OGC: every ring is simple (an outline that visits a vertex twice is cut there into
//! rings), rings of a polygon meet only at single vertices, and its interior is connected. Parts of the set that meet only at
//! vertices are separate polygons; a hole that touches the outer ring, or another hole, remains a hole.
//!
//! Cutting needs no geometry: parts are found across inner edges, and each has one counter-clockwise ring; others are holes.
//!
//! Source for the rules: "Simple feature access, part 1: common architecture" (OGC 06-103r4), section 6.1.11.

use super::area::{Sum, ring_area};
use super::claims::{faces_by_feature, faces_of};
use rustc_hash::{FxHashMap, FxHashSet};
use thiserror::Error;
use twinedge::dcel::{Face, FaceKey, HalfEdge, StaleKey};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::{Orientation, compare_lexicographic, orientation};
use twinedge_map::{Embedding, Feature, FeatureId, PlanarMap, Shape};

/// A polygon with holes. Every ring is closed: its last point repeats the first, its lexicographically smallest.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Polygon {
    /// The outer ring, counter-clockwise.
    pub outer: Vec<Point>,
    /// The holes, each clockwise.
    pub holes: Vec<Vec<Point>>,
}

impl Polygon {
    /// Returns all rings, the outer one first.
    pub fn rings(&self) -> impl Iterator<Item = &[Point]> {
        core::iter::once(&self.outer).chain(&self.holes).map(Vec::as_slice)
    }

    /// Returns the enclosed area, without the holes. O(points).
    #[must_use]
    pub fn area(&self) -> f64 {
        let sum: Sum = self.rings().map(|ring| ring_area(ring.iter().copied())).collect();
        sum.value()
    }
}

impl From<Polygon> for Shape {
    fn from(polygon: Polygon) -> Self {
        let mut rings = polygon.holes;
        rings.insert(0, polygon.outer);
        Self::Polygon(rings)
    }
}

/// The outline of a set of faces: polygons that touch each other at most at vertices.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Contour {
    /// One polygon for each part of the set, in order of its smallest face index.
    pub polygons: Vec<Polygon>,
}

impl Contour {
    /// Returns the enclosed area. O(points).
    #[must_use]
    pub fn area(&self) -> f64 {
        let sum: Sum = self.polygons.iter().map(Polygon::area).collect();
        sum.value()
    }
}

impl From<Contour> for Feature {
    fn from(contour: Contour) -> Self {
        Self { shapes: contour.polygons.into_iter().map(Shape::from).collect(), ..Self::default() }
    }
}

/// The error of contours.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Error)]
#[non_exhaustive]
pub enum ContourError {
    /// A key is stale.
    #[error(transparent)]
    Stale(#[from] StaleKey),
    /// The unbounded face is in the set; no ring encloses it.
    #[error("the unbounded face has no contour")]
    Unbounded,
    /// The map is not plane, and the rings around the part with this face do not enclose it.
    #[error("the map is not plane, and no ring encloses {0:?}")]
    NotPlane(FaceKey),
}

/// Returns the contour of a set of faces. Expected O(half-edges of the faces); sorts unordered or repeated faces first.
///
/// On a map that is not plane, the rings follow the links and may cross.
///
/// # Errors
/// [`ContourError`].
///
/// ```
/// use twinedge_algorithm::contour::of_faces;
/// use twinedge::dcel::Face;
/// use twinedge_map::{Builder, Shape};
///
/// // Two squares side by side: the edge between them vanishes.
/// let square = |x: f64| [[x, 0.0], [x + 1.0, 0.0], [x + 1.0, 1.0], [x, 1.0]];
/// let mut builder = Builder::new();
/// builder.shape(&Shape::polygon(square(0.0)))?;
/// builder.shape(&Shape::polygon(square(1.0)))?;
/// let map = builder.build()?;
/// let contour = of_faces(&map, map.dcel().faces().filter(|f| !f.is_unbounded()).map(Face::key))?;
/// assert_eq!(contour.polygons.len(), 1);
/// assert_eq!(contour.polygons[0].outer.len(), 7);
/// assert_eq!(contour.area(), 2.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn of_faces(map: &PlanarMap, faces: impl IntoIterator<Item = FaceKey>) -> Result<Contour, ContourError> {
    let mut found = Vec::new();
    for key in faces {
        let face = map.dcel().face(key)?;
        if face.is_unbounded() {
            return Err(ContourError::Unbounded);
        }
        found.push(face);
    }
    found.sort_by_key(|f| f.index());
    found.dedup();
    let parts = Parts::new(&found);

    let mut shells: Vec<Option<Vec<Point>>> = vec![None; parts.count];
    let mut holes = vec![Vec::new(); parts.count];
    let mut visited = FxHashSet::default();
    for start in found.iter().flat_map(|f| f.half_edges()) {
        if !parts.bounded_by(start) || visited.contains(&start.index()) {
            continue;
        }
        let part = parts.of[&start.face().index()];
        for ring in rings(&parts, start, &mut visited) {
            let points = closed(map, &ring);
            if !turns_left(&points) {
                holes[part].push(points);
            } else if shells[part].replace(points).is_some() {
                return Err(ContourError::NotPlane(start.face().key()));
            }
        }
    }
    let mut polygons = Vec::with_capacity(parts.count);
    for ((outer, holes), first) in shells.into_iter().zip(holes).zip(&parts.first) {
        let outer = outer.ok_or(ContourError::NotPlane(*first))?;
        polygons.push(Polygon { outer, holes });
    }
    Ok(Contour { polygons })
}

/// Returns the contour of all faces that a feature covers. O(faces of the map · log + half-edges of those covered), expected.
///
/// ```
/// use twinedge_algorithm::contour::of_feature;
/// use twinedge_map::{Builder, Feature, Shape};
///
/// let square = |x: f64| [[x, 0.0], [x + 1.0, 0.0], [x + 1.0, 1.0], [x, 1.0]];
/// let mut builder = Builder::new();
/// let shapes = [0.0, 1.0, 5.0].map(|x| Shape::polygon(square(x))).to_vec();
/// let estate = builder.feature(&Feature { shapes, ..Feature::default() })?;
/// let contour = of_feature(&builder.build()?, estate)?;
/// let sizes: Vec<f64> = contour.polygons.iter().map(|polygon| polygon.area()).collect();
/// assert_eq!(sizes, [2.0, 1.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`ContourError`], if the map is not plane or the feature covers the unbounded face.
pub fn of_feature(map: &PlanarMap, feature: FeatureId) -> Result<Contour, ContourError> {
    of_faces(map, faces_of(map, feature))
}

/// Returns the contours of all features, by [`FeatureId::index`]. O(faces · log + half-edges of the faces of each), expected.
///
/// ```
/// use twinedge_algorithm::contour::of_features;
/// use twinedge_map::{Builder, Shape};
///
/// let square = |x: f64| [[x, 0.0], [x + 1.0, 0.0], [x + 1.0, 1.0], [x, 1.0]];
/// let mut builder = Builder::new();
/// builder.shape(&Shape::polygon(square(0.0)))?;
/// builder.segment([0.0, 0.0], [1.0, 1.0])?;
/// let contours = of_features(&builder.build()?)?;
/// // The segment cuts the square in two faces, which together are the square. It covers nothing itself.
/// assert_eq!(contours[0].polygons[0].outer.len(), 5);
/// assert!(contours[1].polygons.is_empty());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`ContourError`], if the map is not plane or a feature covers the unbounded face.
pub fn of_features(map: &PlanarMap) -> Result<Vec<Contour>, ContourError> {
    faces_by_feature(map).into_iter().map(|faces| of_faces(map, faces)).collect()
}

/// Returns the contour of one face, a single polygon. O(its half-edges), expected.
///
/// ```
/// use twinedge_algorithm::contour::{ContourError, of_face};
/// use twinedge_map::PlanarMap;
///
/// let mut map = PlanarMap::new();
/// let (outside, inside) = map.insert_ring([[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]])?.faces_split[0];
/// map.insert_ring([[1.0, 1.0], [2.0, 1.0], [1.0, 2.0]])?;
/// let polygon = of_face(&map, inside)?;
/// assert_eq!((polygon.outer.len(), polygon.holes.len(), polygon.area()), (4, 1, 7.5));
/// assert_eq!(of_face(&map, outside), Err(ContourError::Unbounded));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`ContourError`].
pub fn of_face(map: &PlanarMap, face: FaceKey) -> Result<Polygon, ContourError> {
    of_faces(map, [face])?.polygons.pop().ok_or(ContourError::NotPlane(face))
}

/// The connected parts of a set of faces, across the edges between them.
struct Parts {
    of: FxHashMap<usize, usize>,
    first: Vec<FaceKey>,
    count: usize,
}

impl Parts {
    fn new(faces: &[Face<'_>]) -> Self {
        const NONE: usize = usize::MAX;
        let mut of: FxHashMap<usize, usize> = faces.iter().map(|f| (f.index(), NONE)).collect();
        let mut first = Vec::new();
        let mut stack = Vec::new();
        for start in faces {
            stack.push(*start);
            let before = first.len();
            while let Some(face) = stack.pop() {
                match of.get_mut(&face.index()) {
                    Some(part) if *part == NONE => *part = before,
                    _ => continue,
                }
                if first.len() == before {
                    first.push(face.key());
                }
                stack.extend(face.neighbours());
            }
        }
        Self { of, count: first.len(), first }
    }

    fn contains(&self, face: Face<'_>) -> bool {
        self.of.contains_key(&face.index())
    }

    /// Returns true if a half-edge of a face of the set is on the contour.
    fn bounded_by(&self, h: HalfEdge<'_>) -> bool {
        !self.contains(h.twin().face())
    }

    /// Returns the next half-edge on the contour: the next one clockwise around its target, across the faces of the set.
    fn after<'a>(&self, h: HalfEdge<'a>) -> HalfEdge<'a> {
        let mut next = h.next();
        // The walk reaches an edge to a face outside the set before it returns to the twin of `h`.
        while !self.bounded_by(next) {
            next = next.twin().next();
        }
        next
    }
}

/// Returns the rings of the closed outline with `start`, cut wherever it visits a vertex again.
fn rings<'a>(parts: &Parts, start: HalfEdge<'a>, visited: &mut FxHashSet<usize>) -> Vec<Vec<HalfEdge<'a>>> {
    let mut rings = Vec::new();
    let mut chain = Vec::new();
    // The index in the chain where each of its vertices is the origin.
    let mut places = FxHashMap::default();
    let mut h = start;
    // Each half-edge of the contour has one successor and one predecessor, so the walk returns to its start.
    while visited.insert(h.index()) {
        places.insert(h.origin().index(), chain.len());
        chain.push(h);
        if let Some(place) = places.get(&h.target().index()) {
            let ring = chain.split_off(*place);
            for gone in &ring {
                places.remove(&gone.origin().index());
            }
            rings.push(ring);
        }
        h = parts.after(h);
    }
    rings
}

/// Returns the points of a ring, starting and ending with the lexicographically smallest.
fn closed(map: &PlanarMap, ring: &[HalfEdge<'_>]) -> Vec<Point> {
    let mut points: Vec<Point> = ring.iter().map(|h| map.point(h.origin().index())).collect();
    let low = (0..points.len()).min_by(|i, j| compare_lexicographic(points[*i], points[*j])).unwrap_or(0);
    points.rotate_left(low);
    points.extend(points.first().copied());
    points
}

/// Returns true if a simple closed ring that starts at its smallest point turns counter-clockwise. No point lies to the left of
/// the smallest one, so the turn there decides.
fn turns_left(points: &[Point]) -> bool {
    match points {
        [low, next, .., last, _] => orientation(*last, *low, *next) == Orientation::CounterClockwise,
        _ => false,
    }
}
