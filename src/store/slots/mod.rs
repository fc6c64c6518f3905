//! The default store: slotmap keys over columns of 32-bit slots.
//!
//! ```text
//!   keys                       columns
//!   edge slotmap   [e1][e2]…   origin   [· ·][· ·]…   two half-edges per edge, side by side:
//!                              next     [· ·][· ·]…   slot 2e and 2e + 1, so that twin(h) is h ^ 1
//!                              prev     [· ·][· ·]…   and L1 holds by construction
//!                              boundary [· ·][· ·]…
//!   vertex slotmap [v1][v2]…   link     [·][·]…       a half-edge, or (high bit) a boundary component
//!   …
//! ```
//!
//! Bytes per record, all keys included: 44 per edge, 16 per vertex, 24 per boundary component, 24 per face, and 4 more for
//! each inner boundary component. A triangulated grid needs about 40 per half-edge.

mod columns;
mod records;
#[cfg(feature = "serde")]
mod restore;
mod store;

pub(crate) use records::Slots;
#[cfg(feature = "serde")]
pub(crate) use restore::{Generations, Live};
pub use store::SlotStore;
