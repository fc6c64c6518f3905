//! The validator of embeddings through a pointer, so that it is compiled once.

use twinedge::validate::{Collect, Expectation, Report};
use twinedge_map::Embedding;

pub(crate) fn validate_embedding(embedding: &dyn Embedding, expectation: &Expectation, collect: Collect) -> Report {
    twinedge_map::validate_embedding(embedding, expectation, collect)
}
