//! The grid: coordinates as whole numbers of steps, and back.

use super::input::{Input, NodingError, Snap};
use super::pixel::{Pixel, Pixels, Steps};
use crate::geometry::point::Point;

/// Coordinates are at most 2^53 steps: any whole number up to there is a double.
const REACH: i32 = 53;

/// With [`Snap::Auto`], a cell is 2^3 steps, so coordinates are at most 2^50 cells. That the input is read more
/// finely than it is rounded keeps crossings where they were, and lets those that should be one point be one.
const SPARE: i32 = 3;
const _: () = assert!(Snap::AUTO_CELLS == 1 << (REACH - SPARE), "the documented number of cells");

/// The smallest positive double is 2^-1074.
const SMALLEST: i32 = -1074;

/// A grid of cells, and the finer one on which the input is read.
#[derive(Clone, Copy, Debug)]
pub(super) struct Grid {
    /// A cell is 2^cell wide.
    cell: i32,
    /// A step is 2^step wide.
    step: i32,
    pub(super) pixels: Pixels,
}

impl Grid {
    /// The grid for coordinates up to `largest` in magnitude, which `holder` has.
    pub(super) fn new(snap: Snap, largest: f64, holder: Input) -> Result<Self, NodingError> {
        let above = exponent_above(largest);
        let finest = above.map(|e| (e - REACH).max(SMALLEST));
        let cells = match snap {
            Snap::Auto => above.map_or([0; 2], |e| [e - REACH + SPARE, e - REACH].map(|cell| cell.max(SMALLEST))),
            Snap::Size(size) if size.is_finite() && size > 0.0 => [exponent_below(size); 2],
            Snap::Size(_) => return Err(NodingError::Size),
        };
        let grids = cells.map(|cell| Self::of_cells(cell, finest.unwrap_or(cell)));
        let reaches = |grid: &Self| {
            grid.cell >= grid.step && grid.point(grid.pixels.at(grid.steps(Point::new(largest, 0.0)))).x.is_finite()
        };
        grids.into_iter().find(reaches).ok_or(NodingError::OutOfRange { at: holder })
    }

    fn of_cells(cell: i32, step: i32) -> Self {
        // From 2^55 steps on, every position is in pixel 0, and a larger pixel makes no difference.
        Self { cell, step, pixels: Pixels { shift: cell.abs_diff(step).min(55) } }
    }

    /// The width of a cell.
    pub(super) fn cell(&self) -> f64 {
        power_of_two(self.cell)
    }

    /// The position of a point: the nearest one, of those in the same pixel.
    ///
    /// Where a pixel is a step, halves go up, as they do in pixels. Otherwise `-p` is at the position opposite to that of `p`, so that
    /// segments through the origin whose ends are opposite still meet there: halves go to even positions, and next to
    /// the border of a pixel away from it.
    pub(super) fn steps(&self, p: Point) -> Steps {
        [p.x, p.y].map(|x| {
            let (mantissa, exponent) = decode(x);
            let drop = self.step - exponent;
            if drop <= 0 {
                return mantissa << drop.unsigned_abs().min(63);
            }
            // A mantissa has 53 bits, so the rest of a longer way down makes no difference.
            let drop = drop.min(62);
            let half = 1 << (drop - 1);
            let up = (mantissa + half) >> drop;
            if self.pixels.shift == 0 {
                return up;
            }
            let (below, rest) = (mantissa >> drop, mantissa & ((1 << drop) - 1));
            let nearest = if rest == half { below + (below & 1) } else { up };
            // The borders of pixels that are many steps are whole steps.
            if rest != 0 && self.pixels.is_border(nearest) { 2 * below + 1 - nearest } else { nearest }
        })
    }

    /// The centre of a pixel.
    pub(super) fn point(&self, pixel: Pixel) -> Point {
        let [x, y] = pixel.map(|c| c as f64 * self.cell());
        Point { x, y }
    }
}

/// `x = mantissa * 2^exponent`, for finite `x`.
fn decode(x: f64) -> (i64, i32) {
    let bits = x.to_bits();
    let fraction = (bits & ((1 << 52) - 1)).cast_signed();
    let (magnitude, exponent) = match (bits >> 52) & 0x7ff {
        0 => (fraction, SMALLEST),
        e => (fraction | 1 << 52, e as i32 - 1075),
    };
    (if x < 0.0 { -magnitude } else { magnitude }, exponent)
}

/// The least `e` with `x <= 2^e`, for finite `x`; `None` for zero.
fn exponent_above(x: f64) -> Option<i32> {
    let (mantissa, exponent) = decode(x.abs());
    (mantissa != 0).then(|| exponent + (64 - (mantissa - 1).leading_zeros().cast_signed()))
}

/// The greatest `e` with `2^e <= x`, for positive finite `x`.
fn exponent_below(x: f64) -> i32 {
    let (mantissa, exponent) = decode(x);
    exponent + 63 - mantissa.leading_zeros().cast_signed()
}

/// 2^exponent, for the exponents that a double has.
fn power_of_two(exponent: i32) -> f64 {
    if exponent < -1022 {
        f64::from_bits(1 << (exponent - SMALLEST).unsigned_abs())
    } else {
        f64::from_bits(u64::from((exponent + 1023).unsigned_abs()) << 52)
    }
}

#[cfg(test)]
mod tests;
