//! `GeoParquet`: a Parquet file with a column of geometries in well-known binary, and files with Parquet's own type of geometries.
//!
//! Rows are read and written in order, a row group at a time. The column of boxes (`covering`) follows from the geometries: it is left
//! out when a file is read, and made when one is written. By it and its statistics, a window is read without other row groups.
//!
//! Sources: "`GeoParquet` Specification" 1.1.0 (<https://geoparquet.org>); "Parquet Logical Type Definitions", GEOMETRY and GEOGRAPHY.

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

/// The key of the metadata of the file that describes its columns of geometries.
const GEO: &str = "geo";

/// The names of the numbers of a box, in their order.
const SIDES: [&str; 4] = ["xmin", "ymin", "xmax", "ymax"];
