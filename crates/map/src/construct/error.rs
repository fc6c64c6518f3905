//! Errors of the builder: a shape was refused, or no map could be built.

use crate::summary::Position;
use core::fmt;
use thiserror::Error;
use twinedge::dcel::RecordKind;
use twinedge_geometry::Point;

/// The error of [`Builder`](crate::Builder): a shape was refused, or no map could be built.
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
    /// A coordinate is too large, or too close to zero without being it, for the predicates to be exact.
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
    /// Segments cross where the input has no point, and [`Noding::Exact`](crate::Noding::Exact) was asked for.
    #[error("the segments {} and {} cross where the input has no point{}: snap to a grid to cut them there",
        Ends(one), Ends(other), FirstOf(*count))]
    Crossing {
        /// A segment that crosses another.
        one: [Point; 2],
        /// The other.
        other: [Point; 2],
        /// The number of pairs that cross.
        count: u64,
    },
    /// Segments meet more often than is allowed ([`Builder::limit_cuts`](crate::Builder::limit_cuts)).
    #[error("segments are cut more than {allowed} times: allow more, or see whether they are the right ones")]
    TooManyCuts {
        /// The number of cuts allowed.
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

/// A segment in a message.
struct Ends<'a>(&'a [Point; 2]);

impl fmt::Display for Ends<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [a, b] = self.0;
        write!(f, "({}, {})-({}, {})", a.x, a.y, b.x, b.y)
    }
}

/// That there are more such pairs, if there are.
struct FirstOf(u64);

impl fmt::Display for FirstOf {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            0 | 1 => Ok(()),
            count => write!(f, ", the first of {count} such pairs"),
        }
    }
}
