//! The error of triangulations.

use thiserror::Error;
use twinedge::dcel::StaleKey;
use twinedge_map::edit::EditError;

/// The error of triangulations and decompositions. The map is unchanged.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum ConvexError {
    /// A stale key, a map that is not plane, or no room for the diagonals.
    #[error(transparent)]
    Edit(#[from] EditError),
    /// The unbounded face has no triangulation.
    #[error("the unbounded face has no triangulation")]
    Unbounded,
    /// A coordinate is out of the range of exact triangulation: its magnitude must be zero or from 2^-142 to 2^201.
    #[error("the vertex at ({x:?}, {y:?}) is out of range: magnitudes must be zero or from 2^-142 to 2^201")]
    OutOfRange {
        /// The first coordinate.
        x: f64,
        /// The second coordinate.
        y: f64,
    },
}

impl From<StaleKey> for ConvexError {
    fn from(key: StaleKey) -> Self {
        Self::Edit(key.into())
    }
}
