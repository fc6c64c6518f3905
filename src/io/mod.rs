//! Reading and writing maps.
//!
//! | module | what | reads | writes |
//! | --- | --- | --- | --- |
//! | `geojson` | GeoJSON (RFC 7946) | yes | yes |
//! | `wkt` | well-known text, a geometry per line | yes | yes |
//! | `geo_types` | the types of the crate geo-types | yes | yes |
//! | [`svg`] | a picture | | yes |
//! | [`tables`] | the three tables of the textbooks | yes | yes |
//!
//! Readers hand over [`Feature`](crate::map::Feature)s for a [`Builder`](crate::map::Builder) to take; writers take
//! features, and [`features`] and [`faces`] make features of a map.

mod export;
#[cfg(feature = "geo-types")]
pub mod geo_types;
#[cfg(feature = "geojson")]
pub mod geojson;
#[cfg(any(feature = "geojson", feature = "wkt"))]
mod summary;
pub mod svg;
pub mod tables;
#[cfg(feature = "wkt")]
pub mod wkt;
#[cfg(any(feature = "geojson", feature = "wkt"))]
mod write;

pub use export::{faces, features};
#[cfg(any(feature = "geojson", feature = "wkt"))]
pub use summary::ReadSummary;
#[cfg(any(feature = "geojson", feature = "wkt"))]
pub use write::WriteError;

/// How many geometry collections a reader accepts around one geometry. RFC 7946 advises against nesting them at all;
/// the bound keeps the stack small.
#[cfg(any(feature = "geojson", feature = "wkt"))]
pub const MAX_NESTED_COLLECTIONS: usize = 32;
