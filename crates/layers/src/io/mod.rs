//! Reading and writing maps.
//!
//! | module | format | reads | writes |
//! | --- | --- | --- | --- |
//! | `geojson` | GeoJSON (RFC 7946), and sequences of it (RFC 8142, newline-delimited) | yes | yes |
//! | `wkt` | well-known text, a geometry per line | yes | yes |
//!
//! These readers pass on all parts of a text, in the types of the crates that parse it; all return the same `ReadError`.
//! [`read_for_map`](crate::read_for_map) reads features for a [`Builder`](twinedge_map::Builder). Writers take
//! such features.

pub mod geojson;
#[cfg(feature = "wkt")]
pub mod wkt;

mod error;
mod foreign;
mod format;
mod json_head;
mod summary;
mod unread;
mod write;

pub use self::{
    error::{MAX_NESTED_COLLECTIONS, ReadCause, ReadError, TextPlace},
    foreign::ForeignFormat,
    format::Format,
    summary::ReadSummary,
    unread::unread_geometry,
    write::WriteError,
};
