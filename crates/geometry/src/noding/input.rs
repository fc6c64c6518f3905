//! The input of noding, the grid, and the errors.

use crate::point::Point;

/// The width of the cells of the grid.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub enum Snap {
    /// Chosen so that the largest coordinate (short of the ends of the range of doubles) is between 2^49 and 2^50 cells:
    /// coordinates keep some 15 decimal digits. For longitudes up to 180, a cell is 2^-42 degrees, or 25 nanometres.
    #[default]
    Auto,
    /// This width. If it has up to 22 decimal places, the decimal number counts instead of the double nearest to it: the points
    /// of a grid of 0.001 are the doubles nearest to whole thousandths, so coordinates with three decimal places are unchanged.
    /// Zero, negative, infinite and NaN are refused, and so is a cell so small that a coordinate would be more than 2^53 cells,
    /// or 2^49 cells whose width is no power of two.
    Size(f64),
}

impl Snap {
    /// With [`Snap::Auto`], the largest coordinate lies between half this number of cells and this number.
    pub const AUTO_CELLS: u64 = 1 << 50;
}

/// A part of the input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Input {
    /// The segment with this index.
    Segment(usize),
    /// The point with this index.
    Point(usize),
}

impl Input {
    /// Returns the faulty point, given the input of [`node`](super::node): for a segment, the end with the larger coordinate.
    /// Returns `None` if the input has no such part. O(1).
    #[must_use]
    pub fn point(self, segments: &[[Point; 2]], points: &[Point]) -> Option<Point> {
        match self {
            Self::Point(index) => points.get(index).copied(),
            Self::Segment(index) => {
                let [a, b] = *segments.get(index)?;
                let size = |p: Point| p.x.abs().max(p.y.abs());
                Some(if size(a) < size(b) { b } else { a })
            }
        }
    }
}

impl core::fmt::Display for Input {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Segment(index) => write!(f, "segment {index}"),
            Self::Point(index) => write!(f, "point {index}"),
        }
    }
}

/// The error of noding.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum NodingError {
    /// A coordinate is infinite or NaN.
    #[error("{at} has a coordinate that is not a finite number")]
    NotFinite {
        /// The first part of the input with such a coordinate.
        at: Input,
    },
    /// A coordinate is more than 2^53 cells, or 2^49 cells whose width is no power of two, or its grid point is not finite.
    #[error("{at} has a coordinate out of reach of the grid")]
    OutOfRange {
        /// The first part of the input with the coordinate of the largest magnitude.
        at: Input,
    },
    /// The size of a cell is not a positive finite number.
    #[error("the size of a cell is not a positive finite number")]
    Size,
    /// Segments meet each other, or pass close to vertices, more often than allowed.
    #[error("segments are cut more than {allowed} times")]
    TooManyCuts {
        /// The allowed number of cuts.
        allowed: usize,
    },
    /// There are more points than a `u32` can number.
    #[error("more points than 2^32 - 1")]
    TooMany,
}
