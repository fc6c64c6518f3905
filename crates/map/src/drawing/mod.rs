//! Structures whose vertices have coordinates, and the rules G1 … G5: do these coordinates draw that topology?

pub(crate) mod bends;
mod columns;
mod components;
mod embedding;
mod lists;
mod places;
mod reserved;
mod rules;
mod segments;
mod validator;

pub use embedding::Embedding;
pub use places::places;
pub use validator::validate_embedding;
