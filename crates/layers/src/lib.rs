//! Layers of features in the formats of geographic information systems, read and written without loss.
//!
//! ```text
//!   file ─► read ─► features: id, geometry, attributes, foreign members ─► Layer ─► write ─► file
//!                      └─► to_map ─► twinedge_map::Builder
//! ```
//!
//! | format | reads | writes | cannot hold |
//! | --- | --- | --- | --- |
//! | GeoJSON, one object | one feature at a time | yes | measures; types of dates and bytes |
//! | GeoJSON, newline-delimited | one feature at a time | yes | measures; types of dates and bytes; name, CRS and foreign members of the layer |
//! | `TopoJSON` | as a whole | no | |
//! | well-known text | line by line | yes | ids, attributes, features without geometry |
//! | well-known binary, including extended | line by line (hexadecimal digits), or bytes | lines of digits | ids, attributes, features without geometry |
//! | Shapefile | record by record | yes | ids, mixed geometries, names of more than 10 bytes, texts of more than 254, empty texts, lists |
//! | `FlatGeobuf` | feature by feature | yes | ids other than feature numbers, several types of values in a column |
//! | `GeoParquet` | row by row | yes | ids, names of layers, definitions of reference systems in well-known text |
//! | `GeoPackage` | row by row | yes | ids that are not integers, lists, names that differ by case |
//!
//! [`losses`] lists the parts of a layer that a format cannot hold. Numbers have 64 bits. A GeoJSON file without `crs` whose
//! coordinates can be longitudes and latitudes is in these, on WGS 84, as in RFC 7946.
//!
//! A zip archive or gzip data with one layer is read as that layer, with the feature `archive`.
//!
//! [`Indexed`] reads the features in a window of `FlatGeobuf` and `GeoParquet`, without the others.
//!
//! [`read`] detects the format by the content and the extension of the file. Files that are truncated or inconsistent, and counts
//! that exceed the data, are errors ([`ReadError`]).
//!
//! # Features
//!
//! | feature | adds | dependencies |
//! | --- | --- | --- |
//! | `geojson`, `shapefile`, `wkb`, `wkt` (default) | a reader and a writer each | none, codepage with `encoding_rs` and `oem_cp`, none, wkt |
//! | `topojson` (default) | a reader, and the audit of arcs | none |
//! | `flatgeobuf`, `geopackage`, `geoparquet` | a reader and a writer each | flatgeobuf, rusqlite, parquet with chrono |
//! | `archive` | layers in zip archives and in gzip data | zip, tempfile |
//! | `epsg` (default) | the definitions of the reference systems of the EPSG; without them only WGS 84 is known by its number | none |
//! | `serde` (default) | the audit of arcs is `Serialize` | none |
//! | `full` | all features | all |
#![cfg_attr(docsrs, feature(doc_cfg))]

#[cfg(feature = "archive")]
mod archive;
#[cfg(not(feature = "archive"))]
#[path = "without_archives.rs"]
mod archive;
pub mod clean;
mod closed;
mod crs;
mod each;
mod epsg;
mod error;
#[cfg_attr(not(any(feature = "flatgeobuf", feature = "geoparquet")), allow(dead_code, reason = "no file has boxes"))]
mod extent;
mod files;
#[cfg(feature = "flatgeobuf")]
mod flatgeobuf;
#[cfg(feature = "geojson")]
mod geojson;
#[cfg(feature = "geojson")]
mod geojson_cut;
#[cfg(feature = "geojson")]
mod geojson_edit;
#[cfg(feature = "geojson")]
mod geojson_feature;
#[cfg(feature = "geojson")]
mod geojson_file;
#[cfg(feature = "geojson")]
mod geojson_places;
#[cfg(feature = "geojson")]
mod geojson_scan;
#[cfg(feature = "geopackage")]
mod geopackage;
#[cfg(feature = "geoparquet")]
mod geoparquet;
mod indexed;
mod integers;
pub mod io;
#[cfg(any(feature = "geojson", feature = "topojson"))]
mod json;
mod loss;
mod losses;
mod model;
pub mod nesting;
mod overlay;
mod read;
#[cfg(feature = "shapefile")]
mod shapefile;
mod to_map;
#[cfg(feature = "topojson")]
pub mod topojson;
mod windows;
#[cfg(feature = "wkb")]
mod wkb;
#[cfg(feature = "wkt")]
mod wkt;
mod write;

pub use crate::io::Format;
pub use archive::{Unpacked, unpack};
#[cfg(feature = "archive")]
pub use archive::{UnpackedFiles, unpack_bytes, zip};
pub use crs::Crs;
pub use each::{Each, EachGeometry};
pub use error::{ArchiveError, Cause, Place, ReadError, WriteError};
pub use files::Files;
#[cfg(feature = "geojson")]
pub use geojson_edit::{Edit, edited, edits};
#[cfg(feature = "geojson")]
pub use geojson_file::{FileError, GeoJsonFile};
pub use indexed::{Amount, Indexed};
pub use integers::{IntegerColumn, write_integers, writes_integers};
pub use loss::Loss;
pub use losses::losses;
pub use model::{
    ColumnTaken, Dimensions, Feature, Field, FieldKind, Geometry, Header, Id, Layer, Line, Members, Position, Shape,
    Value,
};
pub use overlay::{Keep, OverlayError, overlay};
pub use read::{ReadOptions, format_of, read, read_layer, read_path};
pub use to_map::{read_for_map, to_map};
#[cfg(feature = "wkb")]
pub use wkb::{geometry_of_wkb, wkb_of_geometry};
pub use write::{files, refuse_losses, write, write_files, write_path};
