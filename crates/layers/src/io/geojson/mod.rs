//! Reading GeoJSON ([RFC 7946](https://www.rfc-editor.org/rfc/rfc7946)), one feature at a time, and writing it.
//!
//! [`read_parts`] takes feature collections, features and bare geometries, and passes on each feature as soon as its closing brace
//! is read. Only the current feature is kept, so a map of any size can be read as long as its largest feature fits.
//!
//! # What is taken, and how
//!
//! - Geometry collections may be nested [`MAX_NESTED_COLLECTIONS`](super::MAX_NESTED_COLLECTIONS) deep.
//! - Members may come in any order.
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
pub use read::{Documents, NAME_COLUMNS, Part, read_parts};
pub use write::write;
