//! The links before and after a change, as stored in a [`Baseline`](super::Baseline), for checks beyond links.
//!
//! A structure with coordinates checks its links [near](super::Baseline::check) a change, reads the differences from [`Diff`], checks
//! their consequences, and then [moves the baseline on](super::Baseline::commit).

pub use super::column::{Column, Row, TIMES, Time};
pub use super::diff::Diff;
pub use super::links::{Face, HalfEdge, Label, Vertex, index};
