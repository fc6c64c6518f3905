//! Reading and writing maps.
//!
//! | module | what | reads | writes |
//! | --- | --- | --- | --- |
//! | `geojson` | GeoJSON (RFC 7946), and sequences of it (RFC 8142, newline-delimited) | yes | yes |
//! | `wkt` | well-known text, a geometry per line | yes | yes |
//! | `geo_types` | the types of the crate geo-types | yes | yes |
//!
//! Readers hand over [`Feature`](crate::map::Feature)s for a [`Builder`](crate::map::Builder) to take. `read` takes any of the
//! text formats, by the extension of the file or by its content; all readers return the same `ReadError`, and count
//! what they dropped in the same `ReadSummary`. Writers take features, and [`features`] and [`faces`] make features of a
//! map. Pictures are drawn by `svg` of the package `twinedge-formats`.

mod export;
#[cfg(feature = "geo-types")]
pub mod geo_types;
#[cfg(feature = "geojson")]
pub mod geojson;
#[cfg(feature = "wkt")]
pub mod wkt;

#[cfg(any(feature = "geojson", feature = "wkt"))]
mod error;
#[cfg(any(feature = "geojson", feature = "wkt"))]
mod foreign;
#[cfg(any(feature = "geojson", feature = "wkt"))]
mod format;
#[cfg(any(feature = "geojson", feature = "wkt"))]
mod json_head;
#[cfg(any(feature = "geojson", feature = "wkt"))]
mod properties;
#[cfg(any(feature = "geojson", feature = "wkt"))]
mod read;
#[cfg(any(feature = "geojson", feature = "wkt"))]
mod summary;
#[cfg(any(feature = "geojson", feature = "wkt"))]
mod unread;
#[cfg(any(feature = "geojson", feature = "wkt"))]
mod write;

pub use export::{faces, features};

#[cfg(any(feature = "geojson", feature = "wkt"))]
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
