//! Points, exact predicates, crossings, the sweep and noding: geometry that knows no half-edge.
//!
//! | module | purpose |
//! | --- | --- |
//! | [`predicates`] | exact answers about points, directions and segments |
//! | [`mod@sweep`] | one pass that tells whether segments meet only at shared endpoints, and which segment lies below a point |
//! | [`crossing`] | all pairs of segments that cross, touch or overlap |
//! | [`noding`] | snap rounding: any segments made to meet at shared endpoints only |

pub mod crossing;
pub mod noding;
pub mod predicates;
pub mod sweep;

pub(crate) mod bounds;
pub(crate) mod boxes;
pub(crate) mod curve;
mod events;
mod point;
mod status;
pub(crate) mod threads;
#[cfg(debug_assertions)]
#[doc(hidden)]
pub use threads::REVERSE_TIES;

pub use point::Point;
pub use predicates::{MAX_COORDINATE, MIN_COORDINATE};
