//! Axis-aligned boxes.

use super::point::Point;

/// A closed, axis-aligned box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// The lower left corner.
    pub low: Point,
    /// The upper right corner.
    pub high: Point,
}

impl Bounds {
    /// Creates the box of one point.
    #[must_use]
    pub const fn one(p: Point) -> Self {
        Self { low: p, high: p }
    }

    /// Returns the smallest box around both boxes.
    #[must_use]
    pub fn joined(self, other: Self) -> Self {
        Self {
            low: Point::new(self.low.x.min(other.low.x), self.low.y.min(other.low.y)),
            high: Point::new(self.high.x.max(other.high.x), self.high.y.max(other.high.y)),
        }
    }

    /// Returns the smallest box around points; `None` if there are none.
    pub fn around(points: impl IntoIterator<Item = Point>) -> Option<Self> {
        points.into_iter().map(Self::one).reduce(Self::joined)
    }

    /// Returns the box with each side moved outwards.
    #[must_use]
    pub fn grown(self, by: f64) -> Self {
        Self { low: Point::new(self.low.x - by, self.low.y - by), high: Point::new(self.high.x + by, self.high.y + by) }
    }

    /// Returns true if the boxes have a point in common.
    #[must_use]
    pub fn meets(&self, other: &Self) -> bool {
        self.low.x <= other.high.x
            && other.low.x <= self.high.x
            && self.low.y <= other.high.y
            && other.low.y <= self.high.y
    }
    /// Returns true if the whole box comes after a point in lexicographic order, false if it comes before; otherwise `None`.
    #[inline]
    #[must_use]
    pub fn after(&self, p: Point) -> Option<bool> {
        let (before, after) = (is_before(self.high, p), is_before(p, self.low));
        (before | after).then_some(after)
    }

    /// Returns true if the whole box lies to the left of the line through two points, the lower one first, and false if it lies
    /// to the right; `None` if neither is certain.
    ///
    /// Only the two corners furthest from the line matter. Each difference and product has a relative error of at most 2^-53, so
    /// a rounded value beyond this bound has the correct sign.
    #[inline]
    #[must_use]
    pub fn above(&self, [low, high]: [Point; 2]) -> Option<bool> {
        let (dx, dy) = (high.x - low.x, high.y - low.y);
        let side = |x: f64, y: f64| {
            let (left, right) = (dx * (y - low.y), dy * (x - low.x));
            (left - right, 1e-15 * (left.abs() + right.abs()))
        };
        let (nearest, furthest) = if dy > 0.0 { (self.high.x, self.low.x) } else { (self.low.x, self.high.x) };
        let (least, slack_of_least) = side(nearest, self.low.y);
        let (most, slack_of_most) = side(furthest, self.high.y);
        let (above, below) = (least > slack_of_least, most < -slack_of_most);
        (above | below).then_some(above)
    }
}

/// Returns true if a point comes before another in lexicographic order.
#[inline]
#[must_use]
#[expect(clippy::needless_bitwise_bool, reason = "without branches: to a search, which comes first looks random")]
#[expect(clippy::float_cmp, reason = "the order is exact")]
pub fn is_before(p: Point, q: Point) -> bool {
    (p.x < q.x) | ((p.x == q.x) & (p.y < q.y))
}

#[cfg(test)]
mod tests;
