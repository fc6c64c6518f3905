//! Boundaries of `OpenStreetMap`: relations whose members are ways, read from `.osm.pbf`, and the faults of only such files.
//!
//! ```text
//!   file ─► relations ─► their ways ─► their nodes ─► rings ─► polygons ─► Layer
//!                └──────────────┴────────────┴──────────┴──► O1 … O5
//! ```
//!
//! Boundaries of one level are a coverage with shared borders: a way is a member of the relations on both of its sides. So the
//! file itself shows where relations overlap: two of them have the same side of a way (O4). The rules C1 … C7 judge the polygons.
//!
//! The vocabulary follows <https://wiki.openstreetmap.org/wiki/Relation:boundary> and
//! <https://wiki.openstreetmap.org/wiki/Relation:multipolygon>, and the format <https://wiki.openstreetmap.org/wiki/PBF_Format>.

mod boundaries;
#[cfg_attr(not(feature = "pbf"), allow(dead_code, reason = "no file is read"))]
mod elements;
mod filter;
mod finding;
#[cfg(feature = "pbf")]
mod pbf;
mod rings;

pub use boundaries::{Boundaries, read};
pub use elements::OsmError;
pub use filter::{InvalidFilter, TagFilter};
