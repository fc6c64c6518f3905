//! `GeoParquet`: a Parquet file with a column of geometries in well-known binary, and files with Parquet's own geometry type.
//!
//! Rows are read and written in order, one row group at a time. The column of boxes (`covering`) follows from the geometries: it
//! is left out when a file is read, and rebuilt when one is written. With its statistics, a window is read without other row
//! groups.
//!
//! Sources: "`GeoParquet` Specification" 1.1.0 (<https://geoparquet.org>); "Parquet Logical Type Definitions", GEOMETRY,
//! GEOGRAPHY.

mod crs;
mod geometry_column;
mod ids;
mod index;
mod moment;
mod read;
mod value;
mod write;

pub(super) use crs::is_held;
pub(super) use ids::id_kind;
pub(super) use index::IndexedFile;
pub(super) use read::read;
pub(super) use write::{losses, write};

/// The key of the file metadata that describe the geometry columns.
const GEO: &str = "geo";

/// The names of the numbers of a box, in order.
const SIDES: [&str; 4] = ["xmin", "ymin", "xmax", "ymax"];
