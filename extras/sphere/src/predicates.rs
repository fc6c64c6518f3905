//! Exact predicates of places and arcs on the sphere.
//!
//! An arc is the shorter part of the great circle through its two ends, which are neither the same place nor antipodes. Every function here decides
//! by signs of determinants of three vectors, which [`robust::orient3d`] computes exactly: coordinates are zero or of magnitude from 2^-100 to 2^61,
//! so all are multiples of 2^-152, and no product of three overflows or underflows. Answers cannot contradict each other, because they are all true
//! of the same vectors.
//!
//! The determinant of three places on one great circle is 0, so their order is determined with a coordinate axis that does not lie on the circle.
//!
//! Source of the conditions: J. R. Shewchuk (see [`twinedge_geometry::predicates`]); the axis corresponds to the usual trick for order on a line,
//! seen from a point off it.

use crate::place::Place;
use core::cmp::Ordering;
use robust::{Coord, Coord3D};
use twinedge_geometry::predicates::{Endpoint, Meeting, Orientation};

const AXES: [[f64; 3]; 3] = [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

/// The sign of the determinant of three vectors.
fn sign(a: [f64; 3], b: [f64; 3], c: [f64; 3]) -> Ordering {
    let coord = |[x, y, z]: [f64; 3]| Coord3D { x, y, z };
    let det = robust::orient3d(coord(a), coord(b), coord(c), coord([0.0; 3]));
    det.partial_cmp(&0.0).unwrap_or(Ordering::Equal)
}

fn turn(a: Place, b: Place, c: [f64; 3]) -> Ordering {
    sign(a.vector(), b.vector(), c)
}

/// Returns the side of the great circle from `a` to `b` on which the place `c` lies: counter-clockwise is to the left, seen from outside, and
/// collinear is on the circle. If `a` and `b` are the same place or antipodes, every `c` is collinear. O(1).
///
/// ```
/// use twinedge_geometry::predicates::Orientation;
/// use twinedge_sphere::{Place, predicates::side};
///
/// let at = |longitude, latitude| Place::new(longitude, latitude);
/// // The shortest way from 0 to 90 degrees along the parallel of 45 bulges to the north, to 54.7 degrees.
/// let (a, b) = (at(0.0, 45.0)?, at(90.0, 45.0)?);
/// assert_eq!(side(a, b, at(45.0, 54.0)?), Orientation::Clockwise);
/// assert_eq!(side(a, b, at(45.0, 55.0)?), Orientation::CounterClockwise);
/// // Meridians are great circles, exactly.
/// assert_eq!(side(at(0.1, 0.1)?, at(0.1, 0.3)?, at(0.1, 77.7)?), Orientation::Collinear);
/// # Ok::<(), twinedge_sphere::PlaceError>(())
/// ```
#[must_use]
pub fn side(a: Place, b: Place, c: Place) -> Orientation {
    match turn(a, b, c.vector()) {
        Ordering::Greater => Orientation::CounterClockwise,
        Ordering::Equal => Orientation::Collinear,
        Ordering::Less => Orientation::Clockwise,
    }
}

/// Returns a coordinate axis off the great circle through two places, and its side; `None` if there is no such circle.
fn axis_beside(a: Place, b: Place) -> Option<([f64; 3], Ordering)> {
    AXES.into_iter().map(|axis| (axis, turn(a, b, axis))).find(|(_, side)| side.is_ne())
}

/// Returns true if `p` lies on the closed arc from `a` to `b`. O(1).
#[must_use]
pub fn on_arc(p: Place, a: Place, b: Place) -> bool {
    p == a || p == b || turn(a, b, p.vector()).is_eq() && is_between(p, a, b)
}

/// Returns true if `p`, on the great circle through `a` and `b`, lies inside the arc between them.
fn is_between(p: Place, a: Place, b: Place) -> bool {
    axis_beside(a, b).is_some_and(|(axis, side)| turn(a, p, axis) == side && turn(p, b, axis) == side)
}

/// Classifies the meeting of the closed arcs `a b` and `c d`, with the terms of the plane. O(1).
///
/// ```
/// use twinedge_geometry::predicates::{Endpoint, Meeting};
/// use twinedge_sphere::{Place, predicates::meeting};
///
/// let at = |longitude, latitude| Place::new(longitude, latitude);
/// // The 49th parallel drawn by its ends alone, and a border that ends half a degree to the north of it.
/// let (a, b) = (at(-123.0, 49.0)?, at(-95.0, 49.0)?);
/// assert_eq!(meeting(a, b, at(-109.0, 49.5)?, at(-109.0, 55.0)?), Meeting::Cross);
/// assert_eq!(meeting(a, b, b, at(-95.0, 55.0)?), Meeting::SharedEndpoint);
/// // A vertex on a meridian.
/// let (c, d) = (at(-102.05, 41.0)?, at(-102.05, 37.0)?);
/// assert_eq!(meeting(c, d, at(-109.0, 39.13)?, at(-102.05, 39.13)?), Meeting::Touch(Endpoint::D));
/// # Ok::<(), twinedge_sphere::PlaceError>(())
/// ```
#[must_use]
pub fn meeting(a: Place, b: Place, c: Place, d: Place) -> Meeting {
    let (at_c, at_d) = (turn(a, b, c.vector()), turn(a, b, d.vector()));
    if at_c == at_d {
        return if at_c.is_eq() { meeting_on_a_circle(a, b, c, d) } else { Meeting::Disjoint };
    }
    let (at_a, at_b) = (turn(c, d, a.vector()), turn(c, d, b.vector()));
    if at_a == at_b {
        return Meeting::Disjoint;
    }
    // Two different circles meet in two antipodes; an arc contains at most one of them.
    let ends = [
        (at_a, Endpoint::A, a, [c, d]),
        (at_b, Endpoint::B, b, [c, d]),
        (at_c, Endpoint::C, c, [a, b]),
        (at_d, Endpoint::D, d, [a, b]),
    ];
    let mut is_on_circle = false;
    for (side, end, p, [q, r]) in ends {
        if side.is_ne() {
            continue;
        }
        is_on_circle = true;
        if p == q || p == r {
            return Meeting::SharedEndpoint;
        }
        if is_between(p, q, r) {
            return Meeting::Touch(end);
        }
    }
    // Each arc passes through the other's circle, on the same side of the sphere if they turn the same way.
    if !is_on_circle && at_a == at_d { Meeting::Cross } else { Meeting::Disjoint }
}

/// [`meeting`] of arcs of one great circle.
#[cold]
fn meeting_on_a_circle(a: Place, b: Place, c: Place, d: Place) -> Meeting {
    if (a, b) == (c, d) || (a, b) == (d, c) {
        return Meeting::Overlap;
    }
    let inside = [(a, c, d), (b, c, d), (c, a, b), (d, a, b)].into_iter().any(|(p, q, r)| is_between(p, q, r));
    if inside {
        Meeting::Overlap
    } else if a == c || a == d || b == c || b == d {
        Meeting::SharedEndpoint
    } else {
        Meeting::Disjoint
    }
}

/// Compares the directions from `center` to `a` and to `b`, counter-clockwise as seen from outside, starting at the north, or at a pole at the
/// meridian of longitude 0. Equal means the same direction at any distance. Neither may be `center` or its antipode, which come before all. O(1).
#[must_use]
pub fn compare_around(center: Place, a: Place, b: Place) -> Ordering {
    let part = |p: Place| part_of_turn(center, p);
    part(a).cmp(&part(b)).then_with(|| turn(center, a, b.vector()).reverse())
}

/// Returns the part of a turn around `center` with the direction to `p`: 1 for the first direction, 2 up to half a turn from there, 3 at half a turn,
/// 4 beyond.
fn part_of_turn(center: Place, p: Place) -> u8 {
    let first = if center.is_pole() { AXES[1] } else { AXES[0] };
    match sign(center.vector(), first, p.vector()) {
        Ordering::Greater => 2,
        Ordering::Less => 4,
        Ordering::Equal => match axis_beside(center, p) {
            None => 0,
            Some((axis, side)) if sign(center.vector(), first, axis) == side => 1,
            Some(_) => 3,
        },
    }
}

/// Compares longitudes: greater if the meridian of `b` lies to the east of the meridian of `a` by less than half a turn; equal on one meridian or on
/// opposite ones. Neither place may be a pole.
pub(crate) fn eastward(a: Place, b: Place) -> Ordering {
    let coord = |p: Place| Coord { x: p.vector()[0], y: p.vector()[1] };
    let det = robust::orient2d(coord(a), coord(b), Coord { x: 0.0, y: 0.0 });
    det.partial_cmp(&0.0).unwrap_or(Ordering::Equal)
}

/// Returns true if two places lie on the same meridian, from pole to pole.
pub(crate) fn on_one_meridian(a: Place, b: Place) -> bool {
    a.vector()[..2] == b.vector()[..2]
}
