//! The rules of coordinates, G1 … G5.

mod adversarial;
mod bends;
mod embeddings;
mod near;
mod open_embeddings;
mod reports;
