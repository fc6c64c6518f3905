//! Points, exact predicates, and the maps they draw.

mod point;
mod shape;

pub use point::Point;
pub use shape::{Feature, Shape};
