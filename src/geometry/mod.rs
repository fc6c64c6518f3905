//! Points, exact predicates, and the maps they draw.

mod point;

pub use point::Point;
