//! The links before a change and after it, as a [`Baseline`](super::Baseline) knows them: for checks of more than links.
//!
//! A structure with coordinates checks its links [near](super::Baseline::check) a change, reads from [`Diff`] which of them differ, checks
//! what follows from that, and then [moves the baseline on](super::Baseline::commit).

pub use super::column::{Column, Row, TIMES, Time};
pub use super::diff::Diff;
pub use super::links::{Face, HalfEdge, Label, Vertex, index};
