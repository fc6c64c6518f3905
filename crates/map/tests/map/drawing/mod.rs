//! The rules of coordinates, G1 … G5.

mod bends;
mod embeddings;
mod near;
mod open_embeddings;
