//! Areas, by the shoelace formula.
//!
//! The sum runs over triangles that share the first point of the ring, so it is as accurate for a small ring far from the origin
//! as near it. The sum is compensated, so it is as accurate for a long ring as for a short one. Only the rounding of each
//! triangle remains: at worst a few units in the last place of the squared diameter of the ring.
//!
//! Areas may be infinite for coordinates near [`MAX_COORDINATE`](twinedge_geometry::MAX_COORDINATE).
//!
//! Source for the compensation: A. Neumaier, "Rundungsfehleranalyse einiger Verfahren zur Summation endlicher Summen",
//! ZAMM 54 (1974) 39-51.

use super::claims::faces_of;
use twinedge::dcel::{Boundary, FaceKey, HalfEdge, StaleKey};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::compare_lexicographic;
use twinedge_map::{Embedding, FeatureId, PlanarMap};

/// A compensated sum: rounding errors are also summed.
#[derive(Clone, Copy, Debug, Default)]
pub struct Sum {
    total: f64,
    lost: f64,
}

impl Sum {
    /// Adds a term. O(1).
    pub fn add(&mut self, term: f64) {
        let total = self.total + term;
        let (large, small) = if self.total.abs() >= term.abs() { (self.total, term) } else { (term, self.total) };
        self.lost += (large - total) + small;
        self.total = total;
    }

    /// Returns the sum. O(1).
    #[must_use]
    pub fn value(self) -> f64 {
        // Beyond the largest number, the sum of the errors is NaN.
        if self.total.is_finite() { self.total + self.lost } else { self.total }
    }
}

impl FromIterator<f64> for Sum {
    fn from_iter<I: IntoIterator<Item = f64>>(terms: I) -> Self {
        let mut sum = Self::default();
        terms.into_iter().for_each(|term| sum.add(term));
        sum
    }
}

/// Returns the area that a ring encloses: positive if it turns counter-clockwise, negative if clockwise. O(points).
///
/// The last point may repeat the first.
///
/// ```
/// use twinedge_algorithm::area::ring_area;
/// use twinedge_geometry::Point;
///
/// // A unit square, a thousand million units away: the plain formula would say 0.
/// let far = |x: f64, y: f64| Point::new(1e9 + x, 1e9 + y);
/// assert_eq!(ring_area([far(0.0, 0.0), far(1.0, 0.0), far(1.0, 1.0), far(0.0, 1.0)]), 1.0);
/// ```
#[must_use]
pub fn ring_area(ring: impl IntoIterator<Item = Point>) -> f64 {
    let mut points = ring.into_iter();
    let Some(o) = points.next() else { return 0.0 };
    let mut last = o;
    let twice: Sum = points
        .map(|p| {
            let a = core::mem::replace(&mut last, p);
            (a.x - o.x) * (p.y - o.y) - (p.x - o.x) * (a.y - o.y)
        })
        .collect();
    twice.value() / 2.0
}

/// Returns the area inside a cycle, or 0 for an isolated vertex. The ring begins at the least vertex, so that the rounding does not depend on the
/// order of records.
pub(super) fn boundary(map: &PlanarMap, boundary: Boundary<'_>) -> f64 {
    let point = |h: HalfEdge<'_>| map.point(h.origin().index());
    let first = boundary.half_edges().min_by(|a, b| compare_lexicographic(point(*a), point(*b)));
    first.map_or(0.0, |first| ring_area(first.boundary_cycle().map(point)))
}

/// Returns the area of a face, without its holes; infinite for the unbounded face. O(its half-edges).
///
/// # Errors
/// [`StaleKey::Face`].
///
/// ```
/// use twinedge_algorithm::area::face_area;
/// use twinedge_map::{Builder, Shape};
///
/// let square = |low: f64, high: f64| [[low, low], [high, low], [high, high], [low, high]];
/// let mut builder = Builder::new();
/// builder.shape(&Shape::polygon(square(0.0, 3.0)).hole(square(1.0, 2.0)))?;
/// let map = builder.build()?;
/// let areas: Vec<f64> = map.dcel().faces().map(|f| face_area(&map, f.key()).unwrap()).collect();
/// assert_eq!(areas, [f64::INFINITY, 8.0, 1.0]);
/// # Ok::<(), twinedge_map::BuildError>(())
/// ```
pub fn face_area(map: &PlanarMap, key: FaceKey) -> Result<f64, StaleKey> {
    let face = map.dcel().face(key)?;
    if face.is_unbounded() {
        return Ok(f64::INFINITY);
    }
    let sum: Sum = face.boundaries().map(|b| boundary(map, b)).collect();
    Ok(sum.value())
}

/// Returns the area of all faces that a feature covers. O(faces of the map · log + half-edges of those covered).
///
/// ```
/// use twinedge_algorithm::area::feature_area;
/// use twinedge_map::{Builder, Feature, Shape};
///
/// let square = |x: f64| [[x, 0.0], [x + 1.0, 0.0], [x + 1.0, 1.0], [x, 1.0]];
/// let mut builder = Builder::new();
/// let shapes = [0.0, 1.0, 5.0].map(|x| Shape::polygon(square(x))).to_vec();
/// let estate = builder.feature(&Feature { shapes, ..Feature::default() })?;
/// assert_eq!(feature_area(&builder.build()?, estate), 3.0);
/// # Ok::<(), twinedge_map::BuildError>(())
/// ```
#[must_use]
pub fn feature_area(map: &PlanarMap, feature: FeatureId) -> f64 {
    let sum: Sum = faces_of(map, feature).into_iter().filter_map(|f| face_area(map, f).ok()).collect();
    sum.value()
}
