//! Points, exact predicates, and the maps they draw.

pub mod noding;
mod point;

pub use point::Point;
