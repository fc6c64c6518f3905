//! Edges at the lines of a grid, exactly: where an edge enters and leaves a tile, and the order of edges along a line.
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

use super::ends::Ends;
use super::side::Side;
use core::cmp::Ordering;
use twinedge_geometry::Point;
use twinedge_geometry::predicates::{Orientation, compare_lexicographic, orientation};

/// The lines around a tile; `None` where it extends to infinity.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounds {
    pub(super) left: Option<f64>,
    pub(super) right: Option<f64>,
    pub(super) bottom: Option<f64>,
    pub(super) top: Option<f64>,
}

/// The sides where an edge enters and leaves a tile, coming from its smaller end.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Crossings {
    pub(super) entry: Option<Side>,
    pub(super) exit: Option<Side>,
}

impl Bounds {
    pub(super) fn contains(&self, p: Point) -> bool {
        self.left.is_none_or(|x| x <= p.x)
            && self.right.is_none_or(|x| p.x < x)
            && self.bottom.is_none_or(|y| y <= p.y)
            && self.top.is_none_or(|y| p.y < y)
    }

    /// Returns true if the closed box between two corners meets the tile.
    pub(super) fn meets(&self, low: Point, high: Point) -> bool {
        self.left.is_none_or(|x| x <= high.x)
            && self.right.is_none_or(|x| low.x < x)
            && self.bottom.is_none_or(|y| y <= high.y)
            && self.top.is_none_or(|y| low.y < y)
    }

    /// Returns the bounds with each line moved outwards.
    pub(super) fn grown(&self, by: f64) -> Self {
        let moved = |line: Option<f64>, by: f64| line.map(|line| line + by);
        Self {
            left: moved(self.left, -by),
            right: moved(self.right, by),
            bottom: moved(self.bottom, -by),
            top: moved(self.top, by),
        }
    }

    pub(super) fn any_point(&self) -> Point {
        let within = |low: Option<f64>, high: Option<f64>| low.or(high.map(f64::next_down)).unwrap_or_default();
        Point::new(within(self.left, self.right), within(self.bottom, self.top))
    }

    /// Returns the sides at which an edge passes the border of the tile. O(1).
    pub(super) fn crossings(&self, [a, b]: Ends) -> Crossings {
        let (low, high) = if a.y < b.y { (a, b) } else { (b, a) };
        let upright = |x: Option<f64>| {
            x.filter(|x| {
                a.x < *x
                    && *x <= b.x
                    && self.bottom.is_none_or(|y| !is_left(a, b, Point::new(*x, y)))
                    && self.top.is_none_or(|y| is_left(a, b, Point::new(*x, y)))
            })
        };
        let level = |y: Option<f64>| {
            y.filter(|y| {
                low.y < *y
                    && *y <= high.y
                    && self.left.is_none_or(|x| is_left(low, high, Point::new(x, *y)))
                    && self.right.is_none_or(|x| !is_left(low, high, Point::new(x, *y)))
            })
        };
        let rises = a.y < b.y;
        let of_side = |side: Side, line: Option<f64>| line.map(|_| side);
        let [bottom, top] = [of_side(Side::Bottom, level(self.bottom)), of_side(Side::Top, level(self.top))];
        let (from_level, to_level) = if rises { (bottom, top) } else { (top, bottom) };
        Crossings {
            entry: of_side(Side::Left, upright(self.left)).or(from_level),
            exit: of_side(Side::Right, upright(self.right)).or(to_level),
        }
    }
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
        let upwards = |[a, b]: Ends| if a.y < b.y { [a, b] } else { [b, a] };
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
pub(super) fn is_left_of_ray([a, b]: Ends, x: f64, bottom: f64) -> bool {
    let (low, high) = if a.y < b.y { (a, b) } else { (b, a) };
    orientation(low, high, Point::new(x, bottom)) != Orientation::CounterClockwise
}

/// Returns true if the point straight below a vertex at `x`, on a non-vertical edge, lies below the tile.
pub(super) fn is_below([a, b]: Ends, x: f64, bottom: f64) -> bool {
    orientation(a, b, Point::new(x, bottom)) == Orientation::CounterClockwise
}
