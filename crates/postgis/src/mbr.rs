//! Boxes around faces.

use super::ewkb::{Geometry, Points};
use twinedge_geometry::Point;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Box2 {
    pub(super) low: Point,
    pub(super) high: Point,
}

impl Box2 {
    pub(super) const EMPTY: Self = Self {
        low: Point { x: f64::INFINITY, y: f64::INFINITY },
        high: Point { x: f64::NEG_INFINITY, y: f64::NEG_INFINITY },
    };

    pub(super) fn of(points: impl Iterator<Item = Point>) -> Self {
        points.fold(Self::EMPTY, |found, p| found.around(Self { low: p, high: p }))
    }

    pub(super) fn around(self, other: Self) -> Self {
        Self {
            low: Point::new(self.low.x.min(other.low.x), self.low.y.min(other.low.y)),
            high: Point::new(self.high.x.max(other.high.x), self.high.y.max(other.high.y)),
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Mbr {
    Null,
    /// No rectangle along the axes.
    NoBox,
    Is(Box2),
}

impl Mbr {
    pub(super) fn of(geometry: &Geometry<'_>) -> Self {
        match geometry {
            Geometry::Polygon(ring, 1) => Self::of_ring(*ring),
            _ => Self::NoBox,
        }
    }

    /// A rectangle has four corners, then the first again, and each side runs along an axis.
    fn of_ring(ring: Points<'_>) -> Self {
        let corners: Vec<Point> = ring.iter().take(6).collect();
        #[expect(clippy::float_cmp, reason = "a corner has the very coordinates of its neighbours")]
        let along_axis = |pair: &[Point]| pair[0].x == pair[1].x || pair[0].y == pair[1].y;
        let found = Box2::of(corners.iter().copied());
        let corner = |x, y| corners.contains(&Point::new(x, y));
        let Box2 { low, high } = found;
        let all = corner(low.x, low.y) && corner(low.x, high.y) && corner(high.x, low.y) && corner(high.x, high.y);
        if corners.len() == 5 && corners[0] == corners[4] && all && corners.windows(2).all(along_axis) {
            Self::Is(found)
        } else {
            Self::NoBox
        }
    }
}
