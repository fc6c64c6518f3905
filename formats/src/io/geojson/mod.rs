//! Reading GeoJSON ([RFC 7946](https://www.rfc-editor.org/rfc/rfc7946)), one feature at a time, and writing it.
//!
//! [`read`] takes a feature collection, a feature or a bare geometry, and passes on each feature as soon as its closing brace is
//! read. [`read_sequence`] takes any number of successive objects. Only the current feature is kept, so a map of any size can be
//! read as long as its largest feature fits: 32 bytes per position, up to three times that while the lists grow, and 32 more for
//! a position of three or four numbers.
//!
//! ```
//! use twinedge_formats::io::{ReadError, geojson};
//!
//! let text = r#"{"type": "Feature", "properties": {"name": "Unit square"},
//!     "geometry": {"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]]]}}"#;
//! let mut names = Vec::new();
//! let summary = geojson::read(text.as_bytes(), |feature| {
//!     names.extend(feature.name);
//!     Ok::<_, ReadError>(())
//! })?;
//! assert_eq!(names, ["Unit square"]);
//! assert_eq!((summary.polygons, summary.positions), (1, 5));
//! # Ok::<_, ReadError>(())
//! ```
//!
//! # What is taken, and how
//!
//! - A feature's name is its property `name`, `NAME`, `Name`, `ADMIN`, `admin`, `title` or `id`: the first of these that is a
//!   string or a number.
//! - A null or absent geometry results in a feature without shapes. An empty line or polygon draws nothing; an empty ring is
//!   kept.
//! - Geometry collections are flattened. They may be nested [`MAX_NESTED_COLLECTIONS`](super::MAX_NESTED_COLLECTIONS) deep.
//! - Numbers of a position beyond the first two are dropped and counted; so are properties other than the name, and empty lines
//!   and polygons ([`ReadSummary`](super::ReadSummary)).
//! - Members may come in any order. `bbox`, `crs` and foreign members of the outermost object are skipped, with any content and
//!   depth. A `crs` other than that of RFC 7946 is counted.
//! - Rings may be open or closed, and lines may have only one position: the builder of a map reports such cases.
//!
//! # What is done by the `geojson` crate
//!
//! The crate `geojson` reads every feature and every geometry, and checks the outermost object and its members. Only the array
//! `"features"` does not reach it as a whole: this module iterates over it and passes on one element at a time. The crate's own
//! streaming reader mistakes the first `[` of a file for that array, which is incorrect after a `bbox`, and ignores everything
//! after the array. This module also checks that positions have two numbers, and the nesting of collections.
//!
//! Two limits of the crate apply here: a point or the first polygon of a multi-polygon must not be empty, and no file can be read
//! in a program that turns on the feature `arbitrary_precision` of `serde_json`.

mod crs;
mod input;
mod read;
mod write;

pub use crs::names_other_crs;
pub use read::{Documents, NAME_COLUMNS, Part, read, read_parts, read_sequence};
pub(in crate::io) use read::{read_sequence_with_properties, read_with_properties};
pub use write::write;
