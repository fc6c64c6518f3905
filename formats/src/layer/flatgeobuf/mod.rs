//! `FlatGeobuf`: a header, perhaps an index, and features one after the other.
//!
//! The crate `flatgeobuf` has the tables and their verifier. What lies around them is read and written here, since its reader
//! panics at values and ends beyond the data, and at nodes of an index of one entry, allocates what a length claims, and its writer sorts
//! features and has none without geometry.
//!
//! Source: the specification at <https://flatgeobuf.org>, version 3.

mod index;
mod packed;
mod properties;
mod read;
mod tree;
mod write;

use super::model::{Id, Layer};

pub(super) use index::IndexedFile;
pub(super) use read::read;
pub(super) use write::{losses, write};

/// Members of the header that are texts.
const TEXTS: [&str; 3] = ["title", "description", "metadata"];

/// Returns true if the ids are those that reading gives: the numbers of the features, counted from 0.
pub(super) fn holds_ids(layer: &Layer) -> bool {
    let mut all = layer.features.iter().zip(0_u64..);
    all.all(|(feature, row)| feature.id.as_ref().is_none_or(|id| *id == Id::Number(row.into())))
}
