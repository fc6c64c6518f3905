//! A space-filling curve: points near each other on the curve are near each other in the plane.
//!
//! ```text
//!   ┌──┐  ┌──┐
//!   │  └──┘  │     A square is four squares, each run through by the same curve, turned so that the end of one is next to
//!   └─┐    ┌─┘     the start of the next.
//!   ──┘    └──
//! ```
//!
//! Source: D. Hilbert, "Ueber die stetige Abbildung einer Linie auf ein Flächenstück", Mathematische Annalen 38 (1891) 459-460.

use super::bounds::Bounds;
use super::point::Point;

/// The number of times that each side is halved.
const LEVELS: u32 = 16;

/// A Hilbert curve through a box.
pub struct Curve {
    low: Point,
    /// Cells per unit of length; 0 if the box has no extent.
    scale: [f64; 2],
}

impl Curve {
    /// Creates the curve through a box.
    #[must_use]
    pub fn through(Bounds { low, high }: Bounds) -> Self {
        let per = |width: f64| if width > 0.0 { f64::from((1_u32 << LEVELS) - 1) / width } else { 0.0 };
        Self { low, scale: [per(high.x - low.x), per(high.y - low.y)] }
    }

    /// Returns the position on the curve of the cell that contains a point of the box. O(1).
    #[must_use]
    pub fn place(&self, p: Point) -> u32 {
        #[expect(clippy::cast_sign_loss, reason = "the box begins at its lowest corner")]
        let [mut x, mut y] = [(p.x - self.low.x) * self.scale[0], (p.y - self.low.y) * self.scale[1]].map(|c| c as u32);
        let mut place = 0;
        for level in (0..LEVELS).rev() {
            let (right, upper) = (x >> level & 1, y >> level & 1);
            place = place << 2 | (3 * right) ^ upper;
            // The curve through the two lower squares is reflected in one diagonal or the other.
            if upper == 0 {
                if right == 1 {
                    (x, y) = (!x, !y);
                }
                (x, y) = (y, x);
            }
        }
        place
    }
}

#[cfg(test)]
mod tests;
