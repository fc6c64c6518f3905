//! Lengths and areas on a sphere of the earth's size, in metres. They are measured in doubles, not decided exactly.

use crate::place::Place;
use crate::predicates::side;
use crate::subdivision::Subdivision;
use crate::vector::{Vector, cross, dot, length, minus};
use core::f64::consts::{PI, TAU};
use twinedge_geometry::predicates::Orientation;

/// The radius of the sphere in metres: the mean radius R₁ of the earth (International Union of Geodesy and Geophysics, 1980; (2a + b)/3 of WGS 84). A
/// length on the ellipsoid differs by up to 0.6 %, and an area by up to 0.7 %.
pub const RADIUS: f64 = 6_371_008.771_4;

/// The area of the unit sphere.
pub(crate) const WHOLE: f64 = 4.0 * PI;

/// Returns the length of the arc between two places, in metres. O(1).
///
/// ```
/// use twinedge_sphere::{Place, RADIUS, distance};
///
/// let quarter = distance(Place::new(12.0, 0.0)?, Place::NORTH);
/// assert!((quarter - RADIUS * std::f64::consts::FRAC_PI_2).abs() < 1e-6);
/// # Ok::<(), twinedge_sphere::PlaceError>(())
/// ```
#[must_use]
pub fn distance(a: Place, b: Place) -> f64 {
    let [a, b] = [a, b].map(Place::unit);
    // Subtract first: arcs are short.
    RADIUS * libm::atan2(length(cross(a, minus(b, a))), dot(a, b))
}

/// A vector at half the angle of a triangle's signed area on the unit sphere; the area is positive if the triangle is counter-clockwise.
fn triangle(a: Vector, [b, c]: [Vector; 2]) -> [f64; 2] {
    let det = dot(a, cross(minus(b, a), minus(c, a)));
    [1.0 + dot(a, b) + dot(b, c) + dot(c, a), det]
}

/// Returns the area to the left of a ring on the unit sphere, up to multiples of 4π.
pub(crate) fn signed_area(ring: &[Place]) -> f64 {
    let units: Vec<Vector> = ring.iter().map(|place| place.unit()).collect();
    let Some(first) = units.first() else { return 0.0 };
    let arcs = || units.iter().zip(units.iter().cycle().skip(1)).map(|(a, b)| [*a, *b]);
    // A triangle with opposite corners has no well-defined area.
    let apex = if units.iter().all(|unit| dot(*first, *unit) > 0.0) {
        *first
    } else {
        let least = |apex: &Vector| {
            let sizes = arcs().map(|arc| triangle(*apex, arc)).map(|[x, y]| libm::hypot(x, y));
            sizes.fold(f64::INFINITY, f64::min)
        };
        let corners = CORNERS.into_iter().map(|corner| corner.map(|coordinate| coordinate / length(corner)));
        corners.max_by(|a, b| least(a).total_cmp(&least(b))).unwrap_or(*first)
    };
    let area = |arc: [Vector; 2]| {
        let [x, y] = triangle(apex, arc);
        2.0 * libm::atan2(y, x)
    };
    arcs().map(area).sum()
}

/// Directions in all parts of the sphere, chosen so that no input lies there.
const CORNERS: [Vector; 8] = [
    [0.61, 0.53, 0.59],
    [-0.57, 0.63, 0.53],
    [0.53, -0.59, 0.61],
    [-0.61, -0.57, 0.55],
    [0.59, 0.55, -0.59],
    [-0.55, 0.61, -0.57],
    [0.57, -0.61, -0.55],
    [-0.59, -0.53, -0.61],
];

/// Returns the area to the left of a cycle, as a precise part and a number of whole spheres, so that small areas lose no digits.
fn left_of(map: &Subdivision, cycle: &[u32]) -> (f64, f64) {
    let ring: Vec<Place> = cycle.iter().map(|dart| map.place(map.origin(*dart))).collect();
    let area = signed_area(&ring);
    // By the angles, which distinguish an empty area from the whole sphere.
    let angles: f64 = (0..cycle.len())
        .map(|i| {
            let before = cycle[(i + cycle.len() - 1) % cycle.len()];
            angle(map, before, cycle[i])
        })
        .sum();
    let rough = angles - (cycle.len() as f64 - 2.0) * PI;
    (area, ((rough - area) / WHOLE).round())
}

/// Returns the angle to the left, from 0 to 2π, where a cycle continues from one dart to the next.
fn angle(map: &Subdivision, dart: u32, next: u32) -> f64 {
    if dart ^ 1 == next {
        return TAU;
    }
    let [back, at, out] = [map.origin(dart), map.origin(next), map.origin(next ^ 1)].map(|vertex| map.place(vertex));
    let [b, v, o] = [back, at, out].map(Place::unit);
    let (b, o) = (minus(b, v), minus(o, v));
    let turn = libm::atan2(dot(v, cross(o, b)), dot(b, o) - dot(b, v) * dot(o, v));
    // The side is exact; rounding could mistake no turn for half a turn.
    match side(at, out, back) {
        Orientation::CounterClockwise => turn.abs(),
        Orientation::Collinear => PI,
        Orientation::Clockwise => TAU - turn.abs(),
    }
}

/// Returns the area of each face on the unit sphere. O(n) for n half-edges.
pub(crate) fn areas(map: &Subdivision) -> Vec<f64> {
    let mut sums = vec![(0.0, 0.0, 0.0); map.face_count()];
    for cycle in map.cycles() {
        let (area, spheres) = left_of(map, &cycle);
        let (sum, whole, count) = &mut sums[map.face(cycle[0]) as usize];
        *sum += area;
        *whole += spheres;
        *count += 1.0;
    }
    // Subtract the areas beyond the cycles from the whole sphere.
    sums.into_iter().map(|(sum, whole, count)| sum + WHOLE * (whole - (count - 1.0))).collect()
}
