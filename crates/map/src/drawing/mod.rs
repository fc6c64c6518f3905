//! Structures whose vertices have coordinates, and the rules G1 … G5: do these coordinates draw that topology?

mod angles;
pub(crate) mod bends;
mod columns;
mod components;
mod disjoint;
mod embedding;
mod finite;
mod inside;
mod lists;
mod places;
mod reserved;
mod segments;
mod validator;
mod winding;

pub use embedding::Embedding;
pub use places::places;
pub use validator::validate_embedding;
