//! Errors of the builder.

use crate::summary::Position;
use core::fmt;
use thiserror::Error;
use twinedge::dcel::RecordKind;
use twinedge_geometry::Point;

/// The error of [`Builder`](crate::Builder): it refused a shape, or could not build a map.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum BuildError {
    /// A coordinate is NaN or infinite.
    #[error("{position}: the coordinates ({x}, {y}) are not finite")]
    NotFinite {
        /// The place in the input.
        position: Position,
        /// The first coordinate.
        x: f64,
        /// The second coordinate.
        y: f64,
    },
    /// A nonzero coordinate is too large or too close to zero for the predicates to be exact.
    #[error(
        "{position}: the coordinates ({x:?}, {y:?}) are out of range: magnitudes must be zero or from 2^-400 to 2^500"
    )]
    OutOfRange {
        /// The place in the input.
        position: Position,
        /// The first coordinate.
        x: f64,
        /// The second coordinate.
        y: f64,
    },
    /// There is no room for more records of this kind.
    #[error("there is no room for more {0}")]
    Full(RecordKind),
    /// Segments cross where the input has no point, although [`Noding::Exact`](crate::Noding::Exact) was requested.
    #[error("the segments {} and {} cross where the input has no point{}: snap to a grid to cut them there",
        Ends(one), Ends(other), FirstOf(*count))]
    Crossing {
        /// A segment that crosses another segment.
        one: [Point; 2],
        /// The other segment.
        other: [Point; 2],
        /// The number of crossing pairs.
        count: u64,
    },
    /// Segments meet more often than [`Builder::limit_cuts`](crate::Builder::limit_cuts) allows.
    #[error("segments are cut more than {allowed} times: allow more, or see whether they are the right ones")]
    TooManyCuts {
        /// The allowed number of cuts.
        allowed: usize,
    },
    /// The size of a cell is not a finite number of at least 2^-400 ([`Noding::Snap`](crate::Noding::Snap)).
    #[error("the size of a cell of the grid must be a finite number of at least 2^-400")]
    CellSize,
    /// A coordinate is more than 2^53 cells of the grid ([`Noding::Snap`](crate::Noding::Snap)).
    #[error("({x}, {y}) is out of reach of the grid: take larger cells")]
    OutOfReach {
        /// The first coordinate.
        x: f64,
        /// The second coordinate.
        y: f64,
    },
}

struct Ends<'a>(&'a [Point; 2]);

impl fmt::Display for Ends<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [a, b] = self.0;
        write!(f, "({}, {})-({}, {})", a.x, a.y, b.x, b.y)
    }
}

/// A note about further crossing pairs, if there are any.
struct FirstOf(u64);

impl fmt::Display for FirstOf {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            0 | 1 => Ok(()),
            count => write!(f, ", the first of {count} such pairs"),
        }
    }
}
