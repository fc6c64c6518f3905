//! The bodies of the fuzz targets, as plain functions of bytes, so that a test can replay a fuzzer's finding.
//!
//! Each returns if all is well, and otherwise panics.

mod certificates;
mod drawings;
mod edits;
mod histories;
mod layers;
mod maps;
mod postgis;
mod shapefiles;
mod tables;
mod topologies;

pub use certificates::certificates;
pub use drawings::{geojson, noding, segments};
pub use edits::edits;
pub use histories::history;
pub use layers::{flatgeobuf, layer};
pub use maps::{in_step, programs, stale_keys};
pub use postgis::postgis;
pub use shapefiles::shapefile;
pub use tables::{right_map, validator_total};
pub use topologies::topojson;
