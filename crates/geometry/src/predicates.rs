//! Exact predicates of points, directions and segments.
//!
//! Every function here decides by the sign of a determinant, computed by Shewchuk's adaptive arithmetic (crate `robust`). The
//! result is exact for real numbers, as long as every coordinate is in the range of [`in_range`]. Beyond the range nothing
//! panics, but a result may be incorrect.
//!
//! # The range
//!
//! Adaptive arithmetic is exact until an intermediate result overflows or underflows. Let every coordinate be zero or of
//! magnitude from 2^-400 to 2^500. Then all of them are multiples of u = 2^-452 (a double has 53 bits), so are the differences
//! and the tails of the differences, and every product is a multiple of u² = 2^-904. Such a product is split into head and tail
//! without loss, because 2^-904 is far above 2^-1074, the smallest double. The finest error bound in use is about 2^-103 times
//! the sum of two products; a nonzero sum is at least 2^-904, so the bound is at least 2^-1007, still a normal number, and no
//! comparison with a bound is spoilt. Upwards, a difference is at most 2^501, a product 2^1002, the sum of a handful of them
//! under 2^1006, below 2^1024, the limit of doubles.
//!
//! The range leaves a margin: in millions of nearly collinear triples, the first errors came at about 2^-490 and 2^513.
//!
//! Source: J. R. Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric predicates",
//! Discrete & Computational Geometry 18 (1997) 305-363.

use core::cmp::Ordering;

use robust::Coord;

use super::point::Point;
use super::steps::count_step;

/// The largest magnitude of a coordinate for exact predicates: 2^500, about 3.27e150.
pub const MAX_COORDINATE: f64 = f64::from_bits((1023 + 500) << 52);

/// The smallest nonzero magnitude of a coordinate for exact predicates: 2^-400, about 3.87e-121.
///
/// This bounds the coordinates, not their differences: two coordinates may differ in the last bit only.
pub const MIN_COORDINATE: f64 = f64::from_bits((1023 - 400) << 52);

/// Returns true if the predicates are exact for this point: each coordinate is zero or of magnitude from [`MIN_COORDINATE`] to
/// [`MAX_COORDINATE`]. Returns false for NaN and the infinities. O(1).
#[must_use]
pub fn in_range(p: Point) -> bool {
    let fits = |c: f64| c == 0.0 || (MIN_COORDINATE..=MAX_COORDINATE).contains(&c.abs());
    fits(p.x) && fits(p.y)
}

/// The side of a directed line on which a point lies; see [`orientation`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Orientation {
    /// To the left: the three points turn counter-clockwise.
    CounterClockwise,
    /// On the line.
    Collinear,
    /// To the right: the three points turn clockwise.
    Clockwise,
}

/// Returns the side of the line from `a` to `b` on which the point `c` lies. O(1).
///
/// ```text
///          c   counter-clockwise
///         /
///   a----b-----  collinear
///         \
///          c   clockwise
/// ```
///
/// ```
/// use twinedge_geometry::Point;
/// use twinedge_geometry::predicates::{Orientation, orientation};
///
/// let (a, b) = (Point::new(12.0, 12.0), Point::new(24.0, 24.0));
/// assert_eq!(orientation(a, b, Point::new(0.5, 0.5)), Orientation::Collinear);
/// // One unit in the last place: rounded arithmetic would call this collinear.
/// assert_eq!(orientation(a, b, Point::new(0.5, 0.5 + f64::EPSILON / 2.0)), Orientation::CounterClockwise);
/// ```
#[inline]
#[must_use]
pub fn orientation(a: Point, b: Point, c: Point) -> Orientation {
    count_step();
    let coord = |p: Point| Coord { x: p.x, y: p.y };
    let det = robust::orient2d(coord(a), coord(b), coord(c));
    if det > 0.0 {
        Orientation::CounterClockwise
    } else if det < 0.0 {
        Orientation::Clockwise
    } else {
        Orientation::Collinear
    }
}

/// Returns true if a point lies on the circle through the corners of a triangle, or on the line if they are collinear. O(1).
///
/// The determinant has degree four, so it is exact only for coordinates of magnitude from 2⁻¹⁷⁰ to 2²⁴⁰.
#[must_use]
pub fn on_one_circle(triangle: [Point; 3], d: Point) -> bool {
    let coord = |p: Point| Coord { x: p.x, y: p.y };
    let [a, b, c] = triangle.map(coord);
    robust::incircle(a, b, c, coord(d)) == 0.0
}

/// Compares two points from left to right, and from the bottom up on a tie. O(1).
///
/// This is the order of a slightly leaning sweep line, which meets one point at a time. `Equal` if NaN would decide.
#[inline]
#[must_use]
pub fn compare_lexicographic(a: Point, b: Point) -> Ordering {
    a.partial_cmp(&b).unwrap_or(Ordering::Equal)
}

/// Compares the directions from `center` to `a` and to `b` by their angle, counter-clockwise from the positive x axis. O(1).
///
/// ```text
///           2nd
///      3rd   |   1st
///        \   |   /
///         center ------ 0th (first)
///        /   |   \
///      5th   |   7th (last)
///           6th
/// ```
///
/// Equal directions compare equal at any distance. `center` itself has no direction and comes first.
#[must_use]
pub fn compare_angle(center: Point, a: Point, b: Point) -> Ordering {
    let half = |p: Point| {
        if p == center {
            0
        } else if (p.y, p.x) > (center.y, center.x) {
            1
        } else {
            2
        }
    };
    // Within half a turn, "smaller angle" is "the turn to the other is to the left".
    half(a).cmp(&half(b)).then_with(|| match orientation(center, a, b) {
        Orientation::CounterClockwise => Ordering::Less,
        Orientation::Collinear => Ordering::Equal,
        Orientation::Clockwise => Ordering::Greater,
    })
}

/// Returns true if `p` lies on the closed segment from `a` to `b`. O(1).
#[must_use]
pub fn on_segment(p: Point, a: Point, b: Point) -> bool {
    boxes_meet(p, p, a, b) && orientation(a, b, p) == Orientation::Collinear
}

/// A kind of contact of two closed segments; see [`meeting`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Meeting {
    /// No contact.
    Disjoint,
    /// In one point, an endpoint of both.
    SharedEndpoint,
    /// In one point, interior to both.
    Cross,
    /// In one point, an endpoint of one and interior to the other. The value names the endpoint.
    Touch(Endpoint),
    /// In more than one point; they are collinear.
    Overlap,
}

/// One of the four endpoints given to [`meeting`], by the letter of its argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Endpoint {
    /// The first endpoint of the first segment.
    A,
    /// The second endpoint of the first segment.
    B,
    /// The first endpoint of the second segment.
    C,
    /// The second endpoint of the second segment.
    D,
}

/// Classifies the meeting of the closed segments `a b` and `c d`. O(1).
///
/// A segment of length zero is a point: it touches a segment whose interior contains it, and shares an endpoint with one that
/// ends there.
///
/// ```
/// use twinedge_geometry::Point;
/// use twinedge_geometry::predicates::{Endpoint, Meeting, meeting};
///
/// let p = |x: i32, y: i32| Point::new(f64::from(x), f64::from(y));
/// assert_eq!(meeting(p(0, 0), p(4, 4), p(0, 4), p(4, 0)), Meeting::Cross);
/// assert_eq!(meeting(p(0, 0), p(4, 4), p(2, 2), p(4, 0)), Meeting::Touch(Endpoint::C));
/// assert_eq!(meeting(p(0, 0), p(4, 4), p(3, 3), p(5, 5)), Meeting::Overlap);
/// assert_eq!(meeting(p(0, 0), p(4, 4), p(4, 4), p(5, 5)), Meeting::SharedEndpoint);
/// ```
#[inline]
#[must_use]
pub fn meeting(a: Point, b: Point, c: Point, d: Point) -> Meeting {
    use Orientation::Collinear;

    if !boxes_meet(a, b, c, d) {
        return Meeting::Disjoint;
    }
    let (at_c, at_d) = (orientation(a, b, c), orientation(a, b, d));
    if at_c == at_d {
        return if at_c == Collinear { meeting_on_a_line(a, b, c, d) } else { Meeting::Disjoint };
    }
    let (at_a, at_b) = (orientation(c, d, a), orientation(c, d, b));
    if at_a == at_b {
        // Not both collinear: otherwise all four points would be collinear, or `c` would equal `d` and `at_c` would equal `at_d`.
        return Meeting::Disjoint;
    }
    // Neither segment lies strictly on one side of the other, so they meet in exactly one point. If an endpoint lies on the line
    // of the other segment, it is that point.
    let of_first = match (at_a, at_b) {
        (Collinear, _) => Some(Endpoint::A),
        (_, Collinear) => Some(Endpoint::B),
        _ => None,
    };
    let of_second = match (at_c, at_d) {
        (Collinear, _) => Some(Endpoint::C),
        (_, Collinear) => Some(Endpoint::D),
        _ => None,
    };
    match (of_first, of_second) {
        (Some(_), Some(_)) => Meeting::SharedEndpoint,
        (Some(end), None) | (None, Some(end)) => Meeting::Touch(end),
        (None, None) => Meeting::Cross,
    }
}

/// Classifies the meeting of two collinear segments, or of a point with any segment.
#[cold]
fn meeting_on_a_line(a: Point, b: Point, c: Point, d: Point) -> Meeting {
    let at_point = |p: Point, end: Endpoint, q: Point, r: Point| {
        if p == q || p == r {
            Meeting::SharedEndpoint
        } else if on_segment(p, q, r) {
            Meeting::Touch(end)
        } else {
            Meeting::Disjoint
        }
    };
    if a == b {
        return at_point(a, Endpoint::A, c, d);
    }
    if c == d {
        return at_point(c, Endpoint::C, a, b);
    }
    let ascending = |p, q| {
        if compare_lexicographic(p, q).is_le() { (p, q) } else { (q, p) }
    };
    let ((first_low, first_high), (second_low, second_high)) = (ascending(a, b), ascending(c, d));
    let (_, low) = ascending(first_low, second_low);
    let (high, _) = ascending(first_high, second_high);
    match compare_lexicographic(low, high) {
        Ordering::Less => Meeting::Overlap,
        Ordering::Equal => Meeting::SharedEndpoint,
        Ordering::Greater => Meeting::Disjoint,
    }
}

/// Returns true if the closed bounding boxes of the segments `a b` and `c d` meet.
#[inline]
fn boxes_meet(a: Point, b: Point, c: Point, d: Point) -> bool {
    a.y.min(b.y) <= c.y.max(d.y)
        && c.y.min(d.y) <= a.y.max(b.y)
        && a.x.min(b.x) <= c.x.max(d.x)
        && c.x.min(d.x) <= a.x.max(b.x)
}
