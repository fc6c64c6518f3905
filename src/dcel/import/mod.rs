//! Bringing in a structure that exists already.

mod error;
mod from_view;
mod gather;
mod keys;
mod outside;

pub use error::ImportError;
pub use keys::Keys;
pub use outside::Outside;
