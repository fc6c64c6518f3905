//! Reading GeoJSON ([RFC 7946](https://www.rfc-editor.org/rfc/rfc7946)), one feature at a time, and writing it.
//!
//! [`read`] takes a feature collection, a feature or a bare geometry, and hands over each feature as soon as its
//! closing brace is read. [`read_sequence`] takes any number of them, one after the other. Only the current feature is
//! kept, so a map of any size can be read as long as its largest feature fits: 32 bytes per position, up to three times that
//! while the lists grow, and 32 more for a position of three or four numbers.
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
//! - A feature's name is its property `name`, `NAME`, `Name`, `ADMIN`, `admin`, `title` or `id`, the first of these
//!   that is a string or a number.
//! - A geometry that is null or absent gives a feature without shapes. An empty line or polygon draws nothing; an empty
//!   ring is kept.
//! - Geometry collections are flattened. They may lie inside each other [`MAX_NESTED_COLLECTIONS`](super::MAX_NESTED_COLLECTIONS) deep.
//! - Numbers of a position beyond the first two are dropped and counted; so are properties other than the name, and empty
//!   lines and polygons ([`ReadSummary`](super::ReadSummary)).
//! - Members may come in any order. `bbox`, `crs` and foreign members of the outermost object are skipped, whatever
//!   they hold and however deep. A `crs` other than that of RFC 7946 is counted.
//! - Rings may be open or closed, and lines may have one position only: the builder of a map reports those.
//!
//! # What is done by the `geojson` crate
//!
//! It reads every feature and every geometry, and decides what the outermost object is and whether that has its
//! members. Only the array `"features"` does not reach it as a whole: this module walks through it and hands the crate
//! one element after the other. The crate's own streaming reader takes the first `[` of a file for that array, which is
//! wrong behind a `bbox`, and looks at nothing that follows the array. What the crate leaves open is checked here: that
//! positions have two numbers, and how deep collections lie.
//!
//! Two of its limits are limits here: a point or the first polygon of a multi-polygon must not be empty, and no file
//! can be read in a program that turns on the feature `arbitrary_precision` of `serde_json`.

mod crs;
mod input;
mod read;
mod write;

pub use crs::names_other_crs;
pub use read::{Documents, NAME_COLUMNS, Part, read, read_parts, read_sequence};
pub(in crate::io) use read::{read_sequence_with_properties, read_with_properties};
pub use write::write;
