//! Formats and drawings.
#![allow(clippy::needless_pass_by_value, reason = "quickcheck hands its arguments over")]

#[path = "../support/mod.rs"]
mod support;

mod export;
mod geojson;
mod geojson_properties;
mod import;
mod reading;
mod svg;
mod wkt;
