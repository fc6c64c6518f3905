//! The grid: conversion of coordinates to whole numbers of steps, and back.

use super::input::{Input, NodingError, Snap};
use super::pixel::{Pixel, Pixels, Steps};
use crate::point::Point;

/// Coordinates are at most 2^53 steps: all whole numbers up to there are doubles.
const REACH: i32 = 53;

/// With [`Snap::Auto`], a cell is 2^3 steps, so coordinates are at most 2^50 cells. Reading the input more finely than it is
/// rounded preserves the positions of crossings, and merges points that should be equal.
const SPARE: i32 = 3;
const _: () = assert!(Snap::AUTO_CELLS == 1 << (REACH - SPARE), "the documented number of cells");

/// The smallest positive double is 2^-1074.
const SMALLEST: i32 = -1074;

/// The greatest number of cells if their width is no power of two: rounding moves their centres by less than an eighth of a cell.
const MOST_DECIMAL: f64 = (1_u64 << 49) as f64;

/// The exact width of a cell: `numerator / denominator * 2^exponent`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cell {
    width: f64,
    numerator: i64,
    denominator: i64,
    exponent: i32,
    /// The power of ten that makes a decimal width a whole number; 1 if it has no decimal places.
    scale: f64,
}

impl Cell {
    /// Creates a cell whose width is the decimal number that this double stands for, if it has up to 22 decimal places and 15
    /// digits; otherwise the double itself. O(1).
    pub(super) fn of(width: f64) -> Self {
        /// Powers of ten up to this exponent are doubles.
        const PLACES: i32 = 22;
        let (mantissa, exponent) = decode(width);
        let twos = mantissa.trailing_zeros();
        let (numerator, exponent) = (mantissa >> twos, exponent + twos.cast_signed());
        let exact = Self { width, numerator, denominator: 1, exponent, scale: 1.0 };
        if numerator == 1 {
            return exact;
        }
        let (mut scale, mut denominator) = (1.0, 1);
        for places in 0..=PLACES {
            let whole = (width * scale).round();
            if whole.abs() < (1_u64 << 53) as f64 && (whole / scale).to_bits() == width.to_bits() {
                return Self { width, numerator: whole as i64, denominator, exponent: -places, scale };
            }
            scale *= 10.0;
            denominator *= 5;
        }
        exact
    }

    /// Creates a cell 2^exponent wide.
    fn binary(exponent: i32) -> Self {
        Self { width: power_of_two(exponent), numerator: 1, denominator: 1, exponent, scale: 1.0 }
    }

    const fn is_binary(&self) -> bool {
        self.numerator == 1 && self.denominator == 1
    }

    /// Returns the coordinate of a centre: the nearest double, if the decimal number has up to 15 digits.
    pub(super) fn coordinate(&self, cells: i64) -> f64 {
        let whole = cells.checked_mul(self.numerator).filter(|whole| whole.unsigned_abs() <= 1 << 53);
        match whole.filter(|_| self.scale > 1.0) {
            // The quotient of two doubles is rounded once.
            Some(whole) => whole as f64 / self.scale,
            None => cells as f64 * self.width,
        }
    }

    /// Returns the number of the cell nearest to a coordinate, rounding halves up.
    pub(super) fn nearest(&self, x: f64) -> i64 {
        ((self.half_steps(x, 0).0 + 1) >> 1) as i64
    }

    /// Returns a coordinate in half steps, 2^shift steps per cell, rounded down, and true if it is exact.
    fn half_steps(&self, x: f64, shift: u32) -> (i128, bool) {
        let (mantissa, exponent) = decode(x);
        let product = i128::from(mantissa) * i128::from(self.denominator);
        let up = exponent - self.exponent + shift.cast_signed() + 1;
        let by = up.unsigned_abs().min(127);
        let (shifted, is_exact) = if up < 0 {
            let shifted = product >> by;
            (shifted, shifted << by == product)
        } else {
            (product << by, true)
        };
        if self.numerator == 1 {
            return (shifted, is_exact);
        }
        let numerator = i128::from(self.numerator);
        (shifted.div_euclid(numerator), is_exact && shifted.rem_euclid(numerator) == 0)
    }
}

/// A grid of cells, and the finer grid on which the input is read.
#[derive(Clone, Copy, Debug)]
pub(super) struct Grid {
    cell: Cell,
    pub(super) pixels: Pixels,
}

impl Grid {
    /// Creates the grid for coordinates up to `largest` in magnitude, which occurs in `holder`.
    pub(super) fn new(snap: Snap, largest: f64, holder: Input) -> Result<Self, NodingError> {
        let above = exponent_above(largest);
        let cells = match snap {
            Snap::Auto => above
                .map_or([0; 2], |e| [e - REACH + SPARE, e - REACH].map(|cell| cell.max(SMALLEST)))
                .map(Cell::binary),
            Snap::Size(size) if size.is_finite() && size > 0.0 => [Cell::of(size); 2],
            Snap::Size(_) => return Err(NodingError::Size),
        };
        let grids = cells.into_iter().filter_map(|cell| Self::of_cells(cell, largest));
        let is_finite = |grid: &Self| grid.point(grid.pixels.at(grid.steps(Point::new(largest, 0.0)))).x.is_finite();
        grids.into_iter().find(is_finite).ok_or(NodingError::OutOfRange { at: holder })
    }

    /// Creates the grid with these cells for coordinates up to `largest`; `None` if they are out of reach.
    fn of_cells(cell: Cell, largest: f64) -> Option<Self> {
        let shift = if cell.is_binary() {
            let step = exponent_above(largest).map_or(cell.exponent, |e| (e - REACH).max(SMALLEST));
            u32::try_from(cell.exponent - step).ok()?
        } else {
            let cells = Some(largest / cell.width).filter(|cells| *cells <= MOST_DECIMAL)?;
            // The quotient may have been rounded down to a power of two, so one bit is spared.
            exponent_above(cells).map_or(0, |e| (REACH - 1 - e).unsigned_abs())
        };
        // From 2^55 steps on, every position is in pixel 0, so a larger pixel makes no difference.
        Some(Self { cell, pixels: Pixels { shift: shift.min(55) } })
    }

    pub(super) const fn cell(&self) -> f64 {
        self.cell.width
    }

    /// Returns the position nearest to a point, among positions in the same pixel. For a grid point, this is its pixel's centre.
    ///
    /// If a pixel is one step, halves are rounded up. Otherwise `-p` has the position opposite to `p`, so that segments with
    /// opposite ends still meet at the origin: halves become even positions, or next to a pixel's border lead away from it.
    pub(super) fn steps(&self, p: Point) -> Steps {
        let shift = self.pixels.shift;
        [p.x, p.y].map(|x| {
            if !self.cell.is_binary() {
                let nearest = self.cell.nearest(x);
                if self.cell.coordinate(nearest).total_cmp(&(x + 0.0)).is_eq() {
                    return nearest << shift;
                }
            }
            let (halves, is_exact) = self.cell.half_steps(x, shift);
            let (below, is_high) = ((halves >> 1) as i64, halves & 1 == 1);
            let up = below + i64::from(is_high);
            if shift == 0 || is_exact && !is_high {
                return up;
            }
            let nearest = if is_exact { below + (below & 1) } else { up };
            // The borders of pixels larger than a step are whole steps.
            if self.pixels.is_border(nearest) { 2 * below + 1 - nearest } else { nearest }
        })
    }

    pub(super) fn point(&self, pixel: Pixel) -> Point {
        let [x, y] = pixel.map(|c| self.cell.coordinate(c));
        Point { x, y }
    }
}

/// Decomposes finite `x` into `mantissa * 2^exponent`.
fn decode(x: f64) -> (i64, i32) {
    let bits = x.to_bits();
    let fraction = (bits & ((1 << 52) - 1)).cast_signed();
    let (magnitude, exponent) = match (bits >> 52) & 0x7ff {
        0 => (fraction, SMALLEST),
        e => (fraction | 1 << 52, e as i32 - 1075),
    };
    (if x < 0.0 { -magnitude } else { magnitude }, exponent)
}

/// Returns the least `e` with `x <= 2^e`, for finite `x`; `None` for zero.
fn exponent_above(x: f64) -> Option<i32> {
    let (mantissa, exponent) = decode(x.abs());
    (mantissa != 0).then(|| exponent + (64 - (mantissa - 1).leading_zeros().cast_signed()))
}

fn power_of_two(exponent: i32) -> f64 {
    if exponent < -1022 {
        f64::from_bits(1 << (exponent - SMALLEST).unsigned_abs())
    } else {
        f64::from_bits(u64::from((exponent + 1023).unsigned_abs()) << 52)
    }
}

#[cfg(test)]
mod tests;
