//! OGC `GeoPackage`: tables of `SQLite`, with geometries as well-known binary after a header.
//!
//! Source: "OGC `GeoPackage` Encoding Standard" (OGC 12-128r19), clauses 1 and 2.1.

mod read;
mod write;

pub(super) use read::read;
pub(super) use write::{holds_ids, write};

/// The beginning of the header of a geometry, and its version.
const MAGIC: [u8; 3] = *b"GP\0";

fn quoted(name: &str) -> String {
    format!("\"{}\"", name.replace('"', "\"\""))
}
