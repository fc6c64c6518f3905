//! Errors of tiles.

use super::grid::Tile;
use thiserror::Error;
use twinedge_map::BuildError;

/// The error of [`Summary::new`](super::Summary::new), and of finding [`Cuts`](super::Cuts).
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum TileError {
    /// The grid does not have the tile.
    #[error("the grid has no tile {0}")]
    NoSuchTile(Tile),
    /// Two features have the same number, or a tile was given the piece of a feature twice.
    #[error("two features have the number {0}, or one was given twice")]
    SameNumber(u32),
    /// A piece was divided for another grid.
    #[error("a piece was made for another grid")]
    OtherGrid,
    /// The cuts belong to another round or another map.
    #[error("cuts were found in another round, or are those of another map")]
    OtherCuts,
    /// A feature or an edge was refused.
    #[error("{0}")]
    Build(#[from] BuildError),
}

/// The error of [`Summary::merge`](super::Summary::merge) and [`Portion::merge`](super::Portion::merge).
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum MergeError {
    /// The tiles are not of one map, one grid or the same limits.
    #[error("these are not tiles of one map: {what} is {one} for the first and {other} for the second")]
    Different {
        /// The fact of the source, the grid or the limit that differs.
        what: String,
        /// The value for the first tiles; `none` if there is none.
        one: String,
        /// The value for the second tiles.
        other: String,
    },
    /// Both summaries contain a tile.
    #[error("both summaries have tile {0}")]
    Twice(Tile),
}

/// The error of [`Summary::finish`](super::Summary::finish).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum FinishError {
    /// Tiles are missing.
    #[error("{} missing, the first of them {first}", Missing(*count))]
    Missing {
        /// The first missing tile.
        first: Tile,
        /// The number of missing tiles.
        count: u64,
    },
}

/// The error of [`audit`](super::audit).
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum AuditError<E> {
    /// The pieces of a tile could not be obtained.
    #[error("{0}")]
    Pieces(E),
    /// A tile could not be audited.
    #[error(transparent)]
    Tile(#[from] TileError),
    /// Summaries could not be merged.
    #[error(transparent)]
    Merge(#[from] MergeError),
    /// Tiles are missing.
    #[error(transparent)]
    Finish(#[from] FinishError),
}

struct Missing(u64);

impl core::fmt::Display for Missing {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        if self.0 == 1 { f.write_str("1 tile is") } else { write!(f, "{} tiles are", self.0) }
    }
}
