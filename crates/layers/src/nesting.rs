//! Rings of positions, closed by their first: area, direction, and which ring lies in which.

use super::model::Position;
use std::cmp::Ordering;
use std::iter;
use twinedge_algorithm::area::ring_area;
use twinedge_geometry::Point;
use twinedge_geometry::predicates::{Orientation, on_segment, orientation};

fn point(position: &Position) -> Point {
    Point::new(position.x, position.y)
}

/// Returns the area, positive for counter-clockwise rings. O(n).
#[must_use]
pub fn area(ring: &[Position]) -> f64 {
    ring_area(ring.iter().map(point))
}

/// Returns the factor for coordinates up to this one, which is exact and keeps products of two from overflowing.
fn scale(greatest: f64) -> f64 {
    const LARGE: f64 = 1e150;
    const SHRINK: f64 = 1.0 / (1_u128 << 100) as f64;
    if greatest > LARGE { SHRINK.powi(6) } else { 1.0 }
}

/// Returns the direction in which a ring turns: `Greater` for counter-clockwise, `Equal` if it encloses nothing. The reversed
/// ring has the opposite direction in spite of rounding: both start along the same one of the two ways from the first point.
/// O(n).
#[must_use]
pub fn direction(ring: &[Position]) -> Ordering {
    let [first, rest @ ..] = ring else { return Ordering::Equal };
    let rest = match rest {
        [rest @ .., last] if point(last) == point(first) => rest,
        _ => rest,
    };
    let greatest = |number: fn(&Position) -> f64| ring.iter().map(number).fold(0.0, |most: f64, x| most.max(x.abs()));
    let (x, y) = (scale(greatest(|p| p.x)), scale(greatest(|p| p.y)));
    let scaled = |p: &Position| Point::new(p.x * x, p.y * y);
    let sign = |area: f64| area.partial_cmp(&0.0).unwrap_or(Ordering::Equal);
    let start = || iter::once(scaled(first));
    let coordinates = |p: &Position| (p.x, p.y);
    match rest.iter().map(coordinates).partial_cmp(rest.iter().rev().map(coordinates)) {
        Some(Ordering::Less) => sign(ring_area(start().chain(rest.iter().map(scaled)))),
        Some(Ordering::Greater) => sign(ring_area(start().chain(rest.iter().rev().map(scaled)))).reverse(),
        // There and back.
        _ => Ordering::Equal,
    }
}

/// The box around a ring.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    low: Point,
    high: Point,
}

impl Extent {
    /// Returns the box around a ring; one that contains nothing if the ring has no positions. O(n).
    #[must_use]
    pub fn of(ring: &[Position]) -> Self {
        let far = f64::INFINITY;
        let mut extent = Self { low: Point::new(far, far), high: Point::new(-far, -far) };
        for p in ring {
            extent.low = Point::new(extent.low.x.min(p.x), extent.low.y.min(p.y));
            extent.high = Point::new(extent.high.x.max(p.x), extent.high.y.max(p.y));
        }
        extent
    }

    /// Returns true if the other box lies in this one, or is the same.
    #[must_use]
    pub fn contains(&self, other: &Self) -> bool {
        self.low.x <= other.low.x
            && self.low.y <= other.low.y
            && self.high.x >= other.high.x
            && self.high.y >= other.high.y
    }
}

/// Returns true if the first point of a ring that is not on the other one is inside it, or if all are on it. O(n), for each
/// point that is on the other ring.
#[must_use]
pub fn lies_in(ring: &[Position], other: &[Position]) -> bool {
    ring.iter().find_map(|p| is_inside(point(p), other)).unwrap_or(true)
}

/// Returns true if a point lies inside a ring; `None` if it is on it.
fn is_inside(p: Point, ring: &[Position]) -> Option<bool> {
    let mut inside = false;
    for pair in ring.windows(2) {
        let [a, b] = [point(&pair[0]), point(&pair[1])];
        if on_segment(p, a, b) {
            return None;
        }
        let (low, high) = if a.y < b.y { (a, b) } else { (b, a) };
        inside ^= low.y <= p.y && p.y < high.y && orientation(low, high, p) == Orientation::CounterClockwise;
    }
    Some(inside)
}
