//! The default store: slotmap keys over columns of 32-bit slots.
//!
//! ```text
//!   keys                       columns
//!   edges          [e1][e2]…   origin   [· ·][· ·]…   two half-edges per edge, side by side:
//!                              next     [· ·][· ·]…   slot 2e and 2e + 1, so that twin(h) is h ^ 1
//!                              prev     [· ·][· ·]…   and L1 holds by construction
//!                              boundary [· ·][· ·]…
//!   vertices       [v1][v2]…   link     [·][·]…       a half-edge, or (high bit) a boundary component
//!   …
//! ```
//!
//! Bytes per record, all keys included: 36 per edge, 8 per vertex, 16 per boundary component, 12 per face, and 4 more for
//! each inner boundary component of a face that has several; 4 more for each record that was removed. A triangulated grid
//! needs 28.7 per half-edge.

mod columns;
mod inner;
#[cfg(feature = "near")]
mod journal;
mod records;
#[cfg(feature = "serde")]
mod restore;
mod store;

#[cfg(feature = "near")]
pub(crate) use journal::{Entry, Journal, Way};
pub(crate) use records::{InOrder, Numbered};
#[cfg(feature = "serde")]
pub(crate) use restore::{Generations, Live};
pub use store::SlotStore;
