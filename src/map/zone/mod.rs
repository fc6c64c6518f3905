//! The zone of a line: the faces, edges and vertices that it meets, in order.
//!
//! ```text
//!        ____________
//!       |      b     |           from a to d, the segment meets
//!   a---|------o-----|---c===d   face, edge, face, vertex, face, edge, face, vertex, along an edge, vertex
//!       |____________|
//! ```
//!
//! | | needs | time |
//! | --- | --- | --- |
//! | [`Locator::zone`](crate::map::Locator::zone), [`PlanarMap::zone`](crate::map::PlanarMap::zone) | an index | what an R-tree takes to find the edges, and O(k log k) to sort the k that are met |
//! | [`PlanarMap::zone_from`](crate::map::PlanarMap::zone_from) | nothing | the boundaries of the faces met |
//!
//! All are exact, also through vertices and along edges: no intersection is ever computed, and there is no tolerance.

mod follow;
mod indexed;
pub(in crate::map) mod line;
pub(in crate::map) mod query;
pub(in crate::map) mod selection;
mod walk;

pub use query::{QueryLine, ZoneElement};
