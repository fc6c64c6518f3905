//! The zone of a line: the faces, edges and vertices along it, in order.
//!
//! ```text
//!        ____________
//!       |      b     |           from a to d, the segment meets
//!   a---|------o-----|---c===d   face, edge, face, vertex, face, edge, face, vertex, along an edge, vertex
//!       |____________|
//! ```
//!
//! [`PlanarMap::zone`](crate::PlanarMap::zone) finds the edges in the R-tree of an index, and sorts the k edges on the line in
//! O(k log k). It is exact, even through vertices and along edges: no intersection is ever computed, and there is no tolerance.

mod follow;
mod indexed;
pub(crate) mod line;
pub(crate) mod query;
pub(crate) mod selection;

pub use query::{QueryLine, ZoneElement};
