//! Coordinates, after a small change.

mod baseline;
mod chain;
mod disjoint;
mod drawing;
mod inside;
mod tree;
mod turns;

pub use baseline::{EmbeddingBaseline, validate_embedding_near};
