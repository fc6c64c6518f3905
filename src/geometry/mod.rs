//! Points, exact predicates, and the maps they draw.

pub mod crossing;
mod point;
pub mod predicates;
mod status;
pub mod sweep;

pub use point::Point;
