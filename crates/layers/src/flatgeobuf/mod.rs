//! `FlatGeobuf`: a header, an optional index, and successive features.
//!
//! The crate `flatgeobuf` provides the tables and their verifier. The framing is read and written here: the crate's reader panics
//! at values and ends beyond the data and at index nodes with one entry, and allocates the claimed length; its writer sorts
//! features and needs geometries.
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

/// Text members of the header.
const TEXTS: [&str; 3] = ["title", "description", "metadata"];

/// Returns true if the ids equal those assigned by reading: the numbers of the features, counted from 0.
pub(super) fn holds_ids(layer: &Layer) -> bool {
    let mut all = layer.features.iter().zip(0_u64..);
    all.all(|(feature, row)| feature.id.as_ref().is_none_or(|id| *id == Id::Number(row.into())))
}
