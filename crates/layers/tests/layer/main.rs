//! Layers: reading, writing, refusals, and cleaning.
#![allow(clippy::needless_pass_by_value, reason = "quickcheck hands properties their input by value")]

mod archives;
mod arcs;
mod cleaning;
mod cleaning_gaps;
mod detection;
mod flatgeobuf;
mod geojson_cut;
mod geojson_edit;
mod geojson_file;
mod geoparquet;
mod hostile;
mod indexed;
mod losses;
mod neighbourhoods;
mod random;
mod round_trips;
mod shapefiles;
mod support;
mod topojson;
