//! Cleaning the features of a map to a coverage: each face goes to at most one feature.
//!
//! ```text
//!   ┌──────┬──┬─────┐        ┌─────────┬─────┐     overlaps go to one of those that claim them,
//!   │  a   │ab│  b  │        │    a    │  b  │     narrow or small gaps, and slivers, to the
//!   │      │  ├─┬───┤   ──►  │         ├─────┤     neighbour with the longest common border
//!   └──────┴──┴─┴───┘        └─────────┴─────┘
//!                 gap, c below
//! ```
//!
//! Faces change hands, but no edge moves: each border of a feature afterwards was a border of some feature before. Noding, which
//! moves points, happens when the map [is built](twinedge_map::Noding).
//!
//! The order of the steps:
//!
//! 1. Faces that several features claim go to one of them, as [`Winner`] says.
//! 2. Gaps (C2) that are small or narrow enough go to a neighbour, or to one of the [designated features](Options::gaps_to).
//! 3. Slivers (C4), the smallest first, go to a neighbour. A sliver without neighbours is dropped, unless it is the only part of
//!    its feature.
//! 4. Steps 2 and 3 repeat, with recomputed limits, until nothing changes. Each change joins two regions, so there are fewer
//!    changes than regions.
//!
//! So cleaning a map of the result changes nothing.

mod change;
mod heirs;
mod ownership;
mod resolve;
mod width;

pub use change::{Change, ChangeKind, Options, Winner};
pub use resolve::{Cleaned, clean, clean_with_fillers};
pub use width::{ChosenWidth, choose_gap_width};
