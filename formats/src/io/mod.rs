//! Reading and writing maps.
//!
//! | module | format | reads | writes |
//! | --- | --- | --- | --- |
//! | `geojson` | GeoJSON (RFC 7946), and sequences of it (RFC 8142, newline-delimited) | yes | yes |
//! | `wkt` | well-known text, a geometry per line | yes | yes |
//!
//! Readers pass [`Feature`](twinedge_map::Feature)s to a [`Builder`](twinedge_map::Builder). `read` takes any of the text
//! formats, by the extension of the file or by its content; all readers return the same `ReadError`, and count dropped parts in
//! the same `ReadSummary`. Writers take features; [`features`] and [`faces`] make features from a map. `twinedge-formats` draws
//! pictures.

mod export;
pub mod geojson;
#[cfg(feature = "wkt")]
pub mod wkt;

mod error;
mod foreign;
mod format;
mod json_head;
mod properties;
mod read;
mod summary;
mod unread;
mod write;

pub use self::{
    error::{FeatureLabel, MAX_NESTED_COLLECTIONS, ReadCause, ReadError, TextPlace},
    foreign::ForeignFormat,
    format::Format,
    properties::Properties,
    read::{read, read_with_properties},
    summary::ReadSummary,
    unread::unread_geometry,
    write::WriteError,
};
pub use export::{faces, features};
