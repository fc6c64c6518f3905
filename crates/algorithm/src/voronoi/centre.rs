//! The circumcentre of three points, computed with twice the precision of a double.
//!
//! If two of three points are close to each other, or all are nearly collinear, the determinant of the three nearly vanishes
//! compared with its products. Then the exact predicate guarantees only the sign, so centres are off by metres.

use twinedge_geometry::Point;

/// A number as the sum of a double and its rounding error.
#[derive(Clone, Copy)]
struct Long(f64, f64);

impl Long {
    fn new(high: f64, low: f64) -> Self {
        let sum = high + low;
        Self(sum, low - (sum - high))
    }

    /// Returns the exact difference of two numbers (D. Knuth).
    fn difference(a: f64, b: f64) -> Self {
        let high = a - b;
        let taken = a - high;
        Self(high, (a - (high + taken)) + (taken - b))
    }

    fn times(self, other: Self) -> Self {
        let high = self.0 * other.0;
        Self::new(high, self.0.mul_add(other.0, -high) + (self.0 * other.1 + self.1 * other.0))
    }

    fn minus(self, other: Self) -> Self {
        let Self(high, low) = Self::difference(self.0, other.0);
        Self::new(high, low + (self.1 - other.1))
    }

    fn plus(self, other: Self) -> Self {
        self.minus(Self(-other.0, -other.1))
    }
}

/// Returns the circumcentre of three points that turn counter-clockwise.
pub(super) fn centre([a, b, c]: [Point; 3]) -> Point {
    let from_a = |p: Point| [Long::difference(p.x, a.x), Long::difference(p.y, a.y)];
    let ([bx, by], [cx, cy]) = (from_a(b), from_a(c));
    let determinant = |[ax, ay]: [Long; 2], [bx, by]: [Long; 2]| ax.times(by).minus(ay.times(bx)).0;
    let square = |x: Long, y: Long| x.times(x).plus(y.times(y));
    let (bb, cc) = (square(bx, by), square(cx, cy));
    let doubled = 2.0 * determinant([bx, by], [cx, cy]);
    Point::new(a.x + determinant([bb, by], [cc, cy]) / doubled, a.y + determinant([bx, bb], [cx, cc]) / doubled)
}
