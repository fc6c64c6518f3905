//! Boundaries of `OpenStreetMap`: relations whose members are ways, read from `.osm.pbf`, and what only such a file can have wrong.
//!
//! ```text
//!   file ─► relations ─► their ways ─► their nodes ─► rings ─► polygons ─► Layer
//!                └──────────────┴────────────┴──────────┴──► O1 … O5
//! ```
//!
//! Boundaries of one level are a coverage whose borders are shared: a way is a member of the relations on both of its sides. So a file says
//! itself where relations overlap: two of them have the same side of a way (O4). What the polygons then are to one another is for the rules
//! C1 … C7 of a coverage.
//!
//! The vocabulary is that of <https://wiki.openstreetmap.org/wiki/Relation:boundary> and <https://wiki.openstreetmap.org/wiki/Relation:multipolygon>;
//! the format, that of <https://wiki.openstreetmap.org/wiki/PBF_Format>.

mod boundaries;
mod elements;
mod filter;
mod finding;
mod rings;

pub use boundaries::{Boundaries, read};
pub use elements::OsmError;
pub use filter::{InvalidFilter, TagFilter};
