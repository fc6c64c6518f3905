//! Imports existing structures.

mod error;
mod faces;
mod from_view;
pub(super) mod gather;
mod keys;
mod outside;
pub(super) mod pieces;
mod rotations;
#[cfg(feature = "serde")]
mod saved;

pub use error::ImportError;
pub use faces::FacesError;
pub use keys::Keys;
pub use outside::Outside;
pub use rotations::{Placement, RotationsError};
