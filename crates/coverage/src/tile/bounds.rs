//! Edges at the border of a tile, exactly: where an edge enters and leaves, and the order of edges along a side.
//!
//! The crossing of an edge and a line has coordinates that doubles cannot represent, so it is never computed. An edge is given by
//! its ends, known to the tiles on both sides, and all decisions are orientations of ends and corners of tiles.
//!
//! # No special cases
//!
//! The lines of a grid are treated as if moved a little: to the left by ε, and downwards by δ, much less than ε. There are
//! finitely many vertices, so for some such numbers no line meets a vertex, no edge runs along a line, and no edge meets a
//! corner. Hence tiles are half-open, an edge along a line belongs to the tile on its right or above it, and an edge through a
//! corner passes it on a definite side.

use super::ends::{Ends, upwards};
use super::side::Side;
use core::cmp::Ordering;
use twinedge_geometry::Point;
use twinedge_geometry::predicates::{Orientation, compare_lexicographic, orientation};

/// A line between tiles.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Line {
    /// True if the line is level, and `at` its y.
    pub(super) is_level: bool,
    pub(super) at: f64,
}

impl Line {
    /// Returns true if a point lies beyond the line, or on it.
    pub(super) fn is_passed(self, p: Point) -> bool {
        self.at <= if self.is_level { p.y } else { p.x }
    }
}

/// The corners of a tile, infinite where it extends to infinity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Bounds {
    pub(super) low: Point,
    pub(super) high: Point,
}

/// The sides where an edge enters and leaves a tile, coming from its smaller end.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Crossings {
    pub(super) entry: Option<Side>,
    pub(super) exit: Option<Side>,
}

impl Bounds {
    pub(super) const EVERYTHING: Self = Self {
        low: Point { x: f64::NEG_INFINITY, y: f64::NEG_INFINITY },
        high: Point { x: f64::INFINITY, y: f64::INFINITY },
    };

    pub(super) fn contains(&self, p: Point) -> bool {
        self.low.x <= p.x && p.x < self.high.x && self.low.y <= p.y && p.y < self.high.y
    }

    /// Returns the parts below and above a line.
    pub(super) fn divided(&self, line: Line) -> [Self; 2] {
        let mut parts = [*self; 2];
        if line.is_level {
            (parts[0].high.y, parts[1].low.y) = (line.at, line.at);
        } else {
            (parts[0].high.x, parts[1].low.x) = (line.at, line.at);
        }
        parts
    }

    /// Returns the bounds with each side moved outwards.
    pub(super) fn grown(&self, by: f64) -> Self {
        let Self { low, high } = self;
        Self { low: Point::new(low.x - by, low.y - by), high: Point::new(high.x + by, high.y + by) }
    }

    pub(super) fn any_point(&self) -> Point {
        let within = |low: f64, high: f64| match [low, high] {
            [low, _] if low.is_finite() => low,
            [_, high] if high.is_finite() => high.next_down(),
            _ => 0.0,
        };
        Point::new(within(self.low.x, self.high.x), within(self.low.y, self.high.y))
    }

    /// Returns true if an edge meets the closed box, exactly.
    pub(super) fn meets(&self, [a, b]: Ends) -> bool {
        let (bottom, top) = if a.y < b.y { (a.y, b.y) } else { (b.y, a.y) };
        if a.x > self.high.x || b.x < self.low.x || bottom > self.high.y || top < self.low.y {
            return false;
        }
        if self.contains(a) || self.contains(b) {
            return true;
        }
        // The part of the box within the box around the edge.
        let (low_x, high_x) = (self.low.x.max(a.x), self.high.x.min(b.x));
        let (low_y, high_y) = (self.low.y.max(bottom), self.high.y.min(top));
        let corners = if a.y < b.y {
            [Point::new(low_x, high_y), Point::new(high_x, low_y)]
        } else {
            [Point::new(low_x, low_y), Point::new(high_x, high_y)]
        };
        // Of an upright or level edge, both corners lie on it.
        let [one, other] = corners.map(|corner| orientation(a, b, corner));
        one != other || one == Orientation::Collinear
    }

    /// Returns the sides at which an edge passes the border of the tile. O(1).
    pub(super) fn crossings(&self, [a, b]: Ends) -> Crossings {
        let Self { low, high } = *self;
        let upright = |x: f64| passes_upright([a, b], x, [low.y, high.y]);
        let level = |y: f64| passes_level([a, b], y, [low.x, high.x]);
        let of_side = |side: Side, passes: bool| passes.then_some(side);
        let [bottom, top] = [of_side(Side::Bottom, level(low.y)), of_side(Side::Top, level(high.y))];
        let (from_level, to_level) = if a.y < b.y { (bottom, top) } else { (top, bottom) };
        Crossings {
            entry: of_side(Side::Left, upright(low.x)).or(from_level),
            exit: of_side(Side::Right, upright(high.x)).or(to_level),
        }
    }

    /// Returns true if a closed chain of points winds around the lower left corner an odd number of times.
    pub(super) fn has_corner_in(&self, around: &[Point]) -> bool {
        let Point { x, y } = self.low;
        let ahead = around.iter().cycle().skip(1);
        let passes = |(a, b): &(&Point, &Point)| passes_level([**a, **b], y, [f64::NEG_INFINITY, x]);
        around.iter().zip(ahead).filter(passes).count() % 2 == 1
    }
}

/// Returns true if an edge, of either direction, passes a level line between two places.
pub(super) fn passes_level(ends: Ends, y: f64, [from, to]: [f64; 2]) -> bool {
    let [low, high] = upwards(ends);
    low.y < y && y <= high.y && !is_left_of([low, high], from, y) && is_left_of([low, high], to, y)
}

/// Returns true if an edge passes an upright line between two places.
pub(super) fn passes_upright([a, b]: Ends, x: f64, [from, to]: [f64; 2]) -> bool {
    a.x < x && x <= b.x && !is_under([a, b], x, from) && is_under([a, b], x, to)
}

/// Returns true if an edge that passes the level line through a corner of tiles does so to the left of the corner.
pub(super) fn is_left_of(ends: Ends, x: f64, y: f64) -> bool {
    let [low, high] = upwards(ends);
    if x.is_infinite() { x > 0.0 } else { !is_left(low, high, Point::new(x, y)) }
}

/// Returns true if an edge that passes the upright line through a corner of tiles does so below the corner.
pub(super) fn is_under([a, b]: Ends, x: f64, y: f64) -> bool {
    if y.is_infinite() { y > 0.0 } else { is_left(a, b, Point::new(x, y)) }
}

/// Returns true if a corner, moved like the lines, lies to the left of the line from `p` to `q`.
fn is_left(p: Point, q: Point, corner: Point) -> bool {
    match orientation(p, q, corner) {
        Orientation::CounterClockwise => true,
        Orientation::Clockwise => false,
        Orientation::Collinear => (p.y, -p.x) < (q.y, -q.x),
    }
}

/// Compares the places where two edges of a plane drawing pass a line: from the bottom up, or from left to right. O(1).
pub(super) fn compare_along(side: Side, e: Ends, f: Ends) -> Ordering {
    // The order of two edges is constant along them, so it is decided at the later start; at equal starts, at an end.
    if side.is_upright() {
        let [[p, q], [r, s]] = [e, f];
        match compare_lexicographic(p, r) {
            Ordering::Less => above(orientation(p, q, r)),
            Ordering::Equal => above(orientation(p, q, s)),
            Ordering::Greater => above(orientation(r, s, p)).reverse(),
        }
    } else {
        let [[p, q], [r, s]] = [e, f].map(upwards);
        match (p.y, p.x).partial_cmp(&(r.y, r.x)).unwrap_or(Ordering::Equal) {
            Ordering::Less => above(orientation(p, q, r)).reverse(),
            Ordering::Equal => above(orientation(p, q, s)).reverse(),
            Ordering::Greater => above(orientation(r, s, p)),
        }
    }
}

/// Converts the side of a line on which a point lies to their order across the line, from right to left.
const fn above(side: Orientation) -> Ordering {
    match side {
        Orientation::CounterClockwise => Ordering::Less,
        Orientation::Collinear => Ordering::Equal,
        Orientation::Clockwise => Ordering::Greater,
    }
}

/// Returns true if an edge that passes the lower side of a tile does so to the left of a ray straight down from a vertex in the
/// tile, at `x`. The ray leans to the right by less than lines are moved.
pub(super) fn is_left_of_ray(ends: Ends, x: f64, bottom: f64) -> bool {
    let [low, high] = upwards(ends);
    orientation(low, high, Point::new(x, bottom)) != Orientation::CounterClockwise
}

/// Returns true if the point straight below a vertex at `x`, on a non-vertical edge, lies below the tile.
pub(super) fn is_below([a, b]: Ends, x: f64, bottom: f64) -> bool {
    bottom.is_finite() && orientation(a, b, Point::new(x, bottom)) == Orientation::CounterClockwise
}
