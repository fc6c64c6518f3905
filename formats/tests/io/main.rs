//! Formats and drawings.
#![allow(clippy::incompatible_msrv, reason = "the tests need the Rust version of their own dependencies")]
#![allow(clippy::needless_pass_by_value, reason = "quickcheck hands its arguments over")]

mod export;
mod geojson;
mod geojson_properties;
mod import;
mod reading;
mod wkt;
