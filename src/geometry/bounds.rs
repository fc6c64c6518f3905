//! Boxes with sides along the axes.

use super::point::Point;

/// A box with sides along the axes, which belong to it.
#[derive(Clone, Copy)]
pub(crate) struct Bounds {
    pub(crate) low: Point,
    pub(crate) high: Point,
}

impl Bounds {
    /// The box of one point.
    pub(crate) const fn one(p: Point) -> Self {
        Self { low: p, high: p }
    }

    /// The smallest box around two.
    pub(crate) fn joined(self, other: Self) -> Self {
        Self {
            low: Point::new(self.low.x.min(other.low.x), self.low.y.min(other.low.y)),
            high: Point::new(self.high.x.max(other.high.x), self.high.y.max(other.high.y)),
        }
    }

    /// The smallest box around points; none if there are none.
    #[cfg(feature = "map")]
    pub(crate) fn around(points: impl IntoIterator<Item = Point>) -> Option<Self> {
        points.into_iter().map(Self::one).reduce(Self::joined)
    }

    /// The box with each side moved outwards.
    pub(crate) fn grown(self, by: f64) -> Self {
        Self { low: Point::new(self.low.x - by, self.low.y - by), high: Point::new(self.high.x + by, self.high.y + by) }
    }

    /// Returns true if they have a point in common.
    pub(crate) fn meets(&self, other: &Self) -> bool {
        self.low.x <= other.high.x
            && other.low.x <= self.high.x
            && self.low.y <= other.high.y
            && other.low.y <= self.high.y
    }
}
