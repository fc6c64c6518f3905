//! The validator of embeddings through a pointer, which is compiled once then.

use twinedge::validate::{Collect, Expectation, Report};
use twinedge_map::Embedding;

pub(crate) fn validate_embedding(embedding: &dyn Embedding, expectation: &Expectation, collect: Collect) -> Report {
    twinedge_map::validate_embedding(embedding, expectation, collect)
}
