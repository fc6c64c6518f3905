//! The side of a point or a segment on which all of a box lies.

use crate::geometry::Point;
use crate::geometry::bounds::Bounds;

impl Bounds {
    /// Returns true if all of it comes after a point in lexicographic order, false if all comes before; none if neither.
    #[inline]
    pub(super) fn after(&self, p: Point) -> Option<bool> {
        let (before, after) = (is_before(self.high, p), is_before(p, self.low));
        (before | after).then_some(after)
    }

    /// Returns true if all of it lies to the left of the line through two points, the lower one first, false if all lies to the
    /// right; none if neither is clear.
    ///
    /// Only the two corners furthest from the line count. Each difference and product is off by at most one part in 2^53,
    /// so a side of which the rounded value is so clear is the right one.
    #[inline]
    pub(super) fn above(&self, [low, high]: [Point; 2]) -> Option<bool> {
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
#[expect(clippy::needless_bitwise_bool, reason = "without branches: to a search, which comes first looks random")]
#[expect(clippy::float_cmp, reason = "the order is exact")]
pub(super) fn is_before(p: Point, q: Point) -> bool {
    (p.x < q.x) | ((p.x == q.x) & (p.y < q.y))
}

#[cfg(test)]
mod tests;
