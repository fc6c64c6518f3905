//! Bringing in a structure that exists already.

mod error;
mod from_view;
mod gather;
mod keys;
mod outside;
#[cfg(feature = "serde")]
mod saved;

pub use error::ImportError;
pub use keys::Keys;
pub use outside::Outside;
