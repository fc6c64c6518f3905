#![doc = include_str!("../README.md")]

pub mod predicates;

mod claims;
mod clash;
mod coverage;
mod drawing;
mod finding;
mod measure;
mod mismatch;
mod near_miss;
mod nest;
mod noding;
mod place;
mod subdivision;
mod vector;

pub use claims::{Cover, Inside};
pub use clash::{Clash, clashes};
pub use coverage::{Coverage, check};
pub use drawing::{Arc, Drawing, DrawingError, Undrawn};
pub use finding::{Finding, MissingVertex};
pub use measure::{RADIUS, distance};
pub use mismatch::mismatches;
pub use noding::Unresolved;
pub use place::{Place, PlaceError};
pub use subdivision::{Subdivision, SubdivisionError};
