//! Coordinates, after a small change. See [`near`](super) for what is checked, and why that is enough.

mod baseline;
mod chain;
mod disjoint;
mod drawing;
mod drawn;
mod inside;
mod tree;
mod turns;

pub use baseline::{EmbeddingBaseline, validate_embedding_near};
