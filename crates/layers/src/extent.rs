//! Bounding boxes stored in files.

use super::error::Cause;
use super::model::Geometry;
use twinedge_geometry::Point;

/// A stored box around one geometry, or around many. The location of its contents is unknown if the corners are not in order:
/// boxes of nothing and boxes across the antimeridian are written so.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Extent {
    pub(super) low: Point,
    pub(super) high: Point,
}

impl Extent {
    /// The box of nothing.
    pub(super) const NOTHING: Self = Self {
        low: Point { x: f64::INFINITY, y: f64::INFINITY },
        high: Point { x: f64::NEG_INFINITY, y: f64::NEG_INFINITY },
    };

    pub(super) const fn new([x0, y0, x1, y1]: [f64; 4]) -> Self {
        Self { low: Point { x: x0, y: y0 }, high: Point { x: x1, y: y1 } }
    }

    pub(super) fn is_known(&self) -> bool {
        self.low.x <= self.high.x && self.low.y <= self.high.y
    }

    pub(super) fn may_meet(&self, window: &Self) -> bool {
        let is_apart = self.high.x < window.low.x
            || window.high.x < self.low.x
            || self.high.y < window.low.y
            || window.high.y < self.low.y;
        !(self.is_known() && is_apart)
    }

    fn holds(&self, x: f64, y: f64) -> bool {
        self.low.x <= x && x <= self.high.x && self.low.y <= y && y <= self.high.y
    }

    pub(super) fn check(&self, inner: &Self) -> Result<(), Cause> {
        let is_inside = self.holds(inner.low.x, inner.low.y) && self.holds(inner.high.x, inner.high.y);
        if self.is_known() && inner.is_known() && !is_inside { Err(Cause::OutOfBox) } else { Ok(()) }
    }

    pub(super) fn check_geometry(&self, geometry: &Geometry) -> Result<(), Cause> {
        let mut is_inside = true;
        geometry.shape.visit(&mut |p| is_inside &= self.holds(p.x, p.y));
        if self.is_known() && !is_inside { Err(Cause::OutOfBox) } else { Ok(()) }
    }

    /// Returns this box if it states a location, or else the one around it.
    pub(super) fn or(self, around: Self) -> Self {
        if self.is_known() { self } else { around }
    }

    /// Returns the box around both; if one is unknown, the other.
    pub(super) fn with(self, other: Self) -> Self {
        match (self.is_known(), other.is_known()) {
            (_, false) => self,
            (false, true) => other,
            (true, true) => Self::new([
                self.low.x.min(other.low.x),
                self.low.y.min(other.low.y),
                self.high.x.max(other.high.x),
                self.high.y.max(other.high.y),
            ]),
        }
    }
}
