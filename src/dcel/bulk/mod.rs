//! Changes to a whole structure at once, in linear time.

mod compact;
mod nest;
mod retain;

pub use compact::Renamed;
pub use retain::{MergedFace, Retained};
