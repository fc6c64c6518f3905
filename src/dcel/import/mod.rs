//! Imports existing structures.

mod faces;
mod from_view;
pub(super) mod gather;
mod rotations;
#[cfg(feature = "serde")]
mod saved;

pub use faces::FacesError;
pub use from_view::ImportError;
pub use from_view::Keys;
pub use from_view::Outside;
pub use rotations::{Placement, RotationsError};
