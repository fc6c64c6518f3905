//! Lattice polygons: Pick's theorem, for every face of a map with integer coordinates.
//!
//! For a polygon whose vertices are lattice points, with I lattice points inside and B on its boundary, the area is
//!
//! ```text
//!   A = I + B / 2 − 1                ·  ┌──·──┐      A = 6, I = 2, B = 10: 2 + 5 − 1
//!                                       │  ·  │
//!   and with h holes                    ·  ·  ·
//!                                       │     │
//!   A = I + B / 2 − 1 + h               └──·──┘
//! ```
//!
//! with B over all boundaries. This holds for every bounded face of a plane map, if B is counted *along* the boundary: each
//! boundary cycle is walked, and every lattice point counts each time the walk visits it. So a point on an edge that dangles in
//! the face counts twice (its end once), and a vertex where holes touch counts once for each of its corners in the face. Holes
//! that touch are one boundary component, and one hole. An isolated vertex is a hole with an empty walk. The theorem follows from
//! Euler's formula for the face cut open along its boundary, in triangles of area 1/2.
//!
//! The three numbers are computed independently, in exact integers, so that the theorem checks all of them:
//!
//! - 2 A by the shoelace formula over the half-edges,
//! - B by greatest common divisors, one for each half-edge,
//! - I by rows: on each row, the lattice points strictly between an edge with the face to its right and the next one with the
//!   face to its left. The rows of one edge are summed in O(log) steps, as a sum of rounded-down quotients.
//!
//! Sources: G. Pick, "Geometrisches zur Zahlenlehre", Lotos 19 (1899) 311-319; B. Grünbaum and G. C. Shephard, "Pick's
//! theorem", American Mathematical Monthly 100 (1993) 150-161; for the sum: R. L. Graham, D. E. Knuth and O. Patashnik,
//! "Concrete Mathematics", 2nd edition, section 3.5.
//!
//! ```
//! use twinedge_algorithm::lattice;
//! use twinedge_map::PlanarMap;
//!
//! let mut map = PlanarMap::new();
//! let inside = map.insert_ring([[0.0, 0.0], [3.0, 0.0], [3.0, 3.0], [0.0, 3.0]])?.faces_split[0].1;
//! map.insert_ring([[1.0, 1.0], [2.0, 1.0], [2.0, 2.0]])?;
//! let count = lattice::of_face(&map, inside)?;
//! assert_eq!((count.area_doubled, count.interior, count.boundary, count.holes), (17, 1, 15, 1));
//! assert!(count.pick_holds());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use thiserror::Error;
use twinedge::dcel::{Face, FaceKey, HalfEdge, StaleKey, Vertex, VertexKey};
use twinedge_map::{Embedding, NotPlane, PlanarMap};

/// The error of [`of_face`] and [`of_map`].
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum LatticeError {
    /// A key is stale.
    #[error(transparent)]
    Stale(#[from] StaleKey),
    /// The unbounded face has no area.
    #[error("the unbounded face has no area")]
    Unbounded,
    /// The map is not plane, so the inside of a face is undefined.
    #[error(transparent)]
    NotPlane(#[from] NotPlane),
    /// The coordinates of a vertex are not both integers.
    #[error("the vertex at ({x}, {y}) is not a lattice point: both coordinates must be integers")]
    NotInteger {
        /// The vertex.
        vertex: VertexKey,
        /// The first coordinate.
        x: f64,
        /// The second coordinate.
        y: f64,
    },
    /// A coordinate of a vertex is larger than 2^53, where not every integer is a coordinate.
    #[error("the vertex at ({x}, {y}) is too far away: coordinates must be at most 2^53 in magnitude")]
    TooLarge {
        /// The vertex.
        vertex: VertexKey,
        /// The first coordinate.
        x: f64,
        /// The second coordinate.
        y: f64,
    },
}

/// The lattice points of a bounded face.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub struct LatticeCount {
    /// Twice the area, 2 A.
    pub area_doubled: i128,
    /// The number of lattice points strictly inside, I.
    pub interior: i128,
    /// The number of lattice points along the boundary, B: each counts every time a walk along the boundary cycles visits it.
    pub boundary: i128,
    /// The number of inner boundary components, h.
    pub holes: i128,
}

impl LatticeCount {
    /// Returns true if A = I + B / 2 − 1 + h. This holds for every face, and so checks the three numbers.
    #[must_use]
    pub const fn pick_holds(&self) -> bool {
        self.area_doubled == 2 * self.interior + self.boundary - 2 + 2 * self.holes
    }
}

/// The lattice points of all bounded faces of a map.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct LatticeMap {
    /// The bounded faces, in order of their indices.
    pub faces: Vec<(FaceKey, LatticeCount)>,
    /// The sums over all bounded faces.
    pub total: LatticeCount,
    /// Twice the area of all bounded faces, computed from the boundary of the unbounded face alone.
    pub covered_doubled: i128,
}

impl LatticeMap {
    /// Returns true if the theorem holds for every face and for the sums: Σ A = Σ I + Σ B / 2 − F + Σ h for F bounded faces; and
    /// the faces fill the complement of the unbounded face.
    #[must_use]
    pub fn pick_holds(&self) -> bool {
        let LatticeCount { area_doubled, interior, boundary, holes } = self.total;
        self.faces.iter().all(|(_, count)| count.pick_holds())
            && area_doubled == 2 * interior + boundary - 2 * self.faces.len() as i128 + 2 * holes
            && area_doubled == self.covered_doubled
    }
}

/// Counts the lattice points of a bounded face. O(n log C) for n half-edges and coordinates up to C.
///
/// # Errors
/// [`LatticeError`].
pub fn of_face(map: &PlanarMap, face: FaceKey) -> Result<LatticeCount, LatticeError> {
    let face = map.dcel().face(face)?;
    map.plane()?;
    if face.is_unbounded() {
        return Err(LatticeError::Unbounded);
    }
    count(map, face)
}

/// Counts the lattice points of all bounded faces. O(n log C) for n half-edges and coordinates up to C.
///
/// # Errors
/// [`LatticeError`], except [`LatticeError::Unbounded`] and [`LatticeError::Stale`].
///
/// ```
/// use twinedge_algorithm::lattice;
/// use twinedge_map::PlanarMap;
///
/// let mut map = PlanarMap::new();
/// map.insert_ring([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]])?;
/// map.insert_segment([0.0, 0.0], [4.0, 4.0])?;
/// let counts = lattice::of_map(&map)?;
/// // Two triangles: each has 3 points inside and 12 on its boundary.
/// assert_eq!((counts.total.area_doubled, counts.total.interior, counts.total.boundary), (32, 6, 24));
/// assert!(counts.pick_holds());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn of_map(map: &PlanarMap) -> Result<LatticeMap, LatticeError> {
    map.plane()?;
    let mut total = LatticeCount { area_doubled: 0, interior: 0, boundary: 0, holes: 0 };
    let mut faces = Vec::with_capacity(map.dcel().face_count());
    for face in map.dcel().faces().filter(|face| !face.is_unbounded()) {
        let found = count(map, face)?;
        total.area_doubled += found.area_doubled;
        total.interior += found.interior;
        total.boundary += found.boundary;
        total.holes += found.holes;
        faces.push((face.key(), found));
    }
    let outline = count(map, map.dcel().unbounded_face())?;
    Ok(LatticeMap { faces, total, covered_doubled: -outline.area_doubled })
}

/// A lattice point. Sums wrap: the totals fit, even if intermediate values do not.
type Whole = [i128; 2];

fn whole(map: &PlanarMap, vertex: Vertex<'_>) -> Result<Whole, LatticeError> {
    let (p, vertex) = (map.point(vertex.index()), vertex.key());
    let (x, y) = (p.x, p.y);
    if x.fract() != 0.0 || y.fract() != 0.0 {
        Err(LatticeError::NotInteger { vertex, x, y })
    } else if x.abs() > 2_f64.powi(53) || y.abs() > 2_f64.powi(53) {
        Err(LatticeError::TooLarge { vertex, x, y })
    } else {
        Ok([x as i128, y as i128])
    }
}

/// Counts a face. For the unbounded face, the area is minus the area of all others, and the number of points meaningless.
fn count(map: &PlanarMap, face: Face<'_>) -> Result<LatticeCount, LatticeError> {
    let mut count = LatticeCount { area_doubled: 0, interior: 0, boundary: 0, holes: face.inner_count() as i128 };
    for boundary in face.boundaries() {
        if let Some(vertex) = boundary.isolated_vertex() {
            whole(map, vertex)?;
            // The row slightly above passes over it.
            count.interior = count.interior.wrapping_sub(1);
        }
        for h in boundary.half_edges() {
            let [a, b] = [whole(map, h.origin())?, whole(map, h.target())?];
            let [dx, dy] = [b[0] - a[0], b[1] - a[1]];
            count.area_doubled = count.area_doubled.wrapping_add(a[0] * b[1] - b[0] * a[1]);
            count.boundary += gcd(dx.abs(), dy.abs());
            count.interior = count.interior.wrapping_add(row_points(a, b)).wrapping_add(corner_points(map, h)?);
        }
    }
    Ok(count)
}

/// Returns the contribution of a half-edge to the number of lattice points inside the face to its left.
///
/// Each row is examined slightly above its lattice points, where it passes through no vertex: from the row where an edge starts
/// to the one before the row where it ends. A point on the row is inside if it lies between an edge that runs downwards, with the
/// face to its right on the page, and an edge that runs upwards: beyond the intersection of the row and the first, and before the
/// intersection with the second. By this rule, points on a horizontal edge with the face above are inside; they are subtracted.
fn row_points(a: Whole, b: Whole) -> i128 {
    let [dx, dy] = [b[0] - a[0], b[1] - a[1]];
    if dy > 0 {
        // The largest integer below x + dx·i/dy is ⌈…⌉ − 1 = ⌊(dy·x + dx·i − 1) / dy⌋.
        floor_sum(dy, dy, dx, dy * a[0] - 1)
    } else if dy < 0 {
        // From the lower end, which is the target.
        -floor_sum(-dy, -dy, -dx, -dy * b[0])
    } else if dx > 0 {
        1 - dx
    } else {
        0
    }
}

/// Returns the correction of the rule for rows at a corner, between the half-edge and the one before it.
///
/// ```text
///     ╲  face  ╱          face
///      ╲      ╱       ────v────
///       ╲    ╱          ╱   ╲
///        ╲  ╱
///         v           the vertex counts as inside:
///   the row counts    one less
///   −1 points: one
///   more
/// ```
fn corner_points(map: &PlanarMap, h: HalfEdge<'_>) -> Result<i128, LatticeError> {
    let [before, v, after] = [h.prev().origin(), h.origin(), h.target()].map(|v| whole(map, v));
    let (before, v, after) = (before?, v?, after?);
    let [[ax, ay], [bx, by]] = [after, before].map(|p| [p[0] - v[0], p[1] - v[1]]);
    // The corner runs counter-clockwise from `after` to `before`.
    let turn = ax * by - ay * bx;
    Ok(match (ay > 0, by > 0) {
        (true, true) => i128::from(turn > 0),
        (true, false) | (false, true) => 0,
        (false, false) => {
            // Neither is above the row, so the corner contains everything above it or nothing. Opposites lie on the row.
            let below = turn > 0 || turn == 0 && ax < 0 && bx > 0;
            -i128::from(!below)
        }
    })
}

fn gcd(mut a: i128, mut b: i128) -> i128 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}

/// Returns the sum of ⌊(a·i + b) / m⌋ for i from 0 to n − 1, for m > 0. O(log m).
fn floor_sum(mut n: i128, mut m: i128, mut a: i128, mut b: i128) -> i128 {
    let mut sum: i128 = 0;
    loop {
        // The integer parts of slope and height form a triangle and a rectangle. The rest is a triangle under a line with a slope
        // and a height below one.
        sum = sum.wrapping_add((n * (n - 1) / 2).wrapping_mul(a.div_euclid(m))).wrapping_add(n * b.div_euclid(m));
        (a, b) = (a.rem_euclid(m), b.rem_euclid(m));
        let top = a * n + b;
        if top < m {
            return sum;
        }
        // Counts these points by columns instead of rows.
        (n, b) = (top / m, top % m);
        (m, a) = (a, m);
    }
}
