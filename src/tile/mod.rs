//! Maps in tiles: each tile of a grid is judged alone, and the summaries add up to the audit of the whole map.
pub use error::{FinishError, MergeError, TileError};
pub use fault::{Crossing, CrossingKind, SeamFault, SeamRule, Uneven};
pub use finish::Outcome;
pub use grid::{Grid, GridError, Side, Tile};
pub use summary::Summary;

mod claimed;
mod clip;
mod error;
mod fault;
mod findings;
mod finish;
mod grid;
mod large;
mod local;
mod merge;
mod pieces;
mod region;
#[cfg(feature = "serde")]
mod saved;
mod summary;
