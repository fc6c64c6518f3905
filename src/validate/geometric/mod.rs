//! G1 … G5 in order, and the columns that they share.
//!
//! All decisions are exact (see [`predicates`](twinedge_geometry::predicates)). G4 and G5 take one sweep, O(n log n).

pub(super) mod bends;
pub(super) mod columns;
pub(super) mod components;
pub(super) mod lists;
mod reserved;
pub(super) mod segments;
pub(super) mod validator;
