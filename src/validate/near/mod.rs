//! Validation after a small change, in time proportional to the change.
//!
//! A [`Baseline`] stores the links of a valid structure. [`validate_near`] takes the structure's current state, and the
//! [`WriteSet`] of records changed since. It checks these and the records that they can break, and moves the baseline on.
//!
//! ```text
//!        before             after: h, n and p have changed
//!
//!    p ──► h ──►        p ──► n ──► h ──►       R1, L1 … L3 and labels: of h, n, p, and of what they were linked to
//!    ◄─────────         ◄──── · ◄──────         V2, B1: no walk around the whole cycle, see below
//! ```
//!
//! # What is checked
//!
//! | rules | how |
//! | --- | --- |
//! | R1 … F2 | completely: if they held before, and all changed records are named, they hold now |
//! | T1 and T3 | by their sum: V − E + F = 1 + the number of inner boundary components. Only for maps in the plane with boundary components and an unbounded face |
//! | T1 of each component, T2, T4, M1 … M8 | not checked |
//!
//! # No walks around whole cycles
//!
//! V2 and B1 say that all half-edges with one origin, or one boundary component, lie on one orbit of a permutation. A half-edge
//! with unchanged origin and successor lies on an orbit with a changed half-edge, or on an orbit without changes. So it is
//! enough that the changed half-edges lie on one orbit, and that one of them was there before if any earlier half-edges remain.
//! Walks in step from all changed half-edges establish this, and one of the walks may be left unfinished: an operator that
//! relabels the shorter of two cycles is checked in the time that it took.
//!
//! Coordinates are validated after a change by `near` of the crate `twinedge-map`, which reads the [changes] of the links.

mod baseline;
mod check;
mod column;
mod diff;
mod links;

pub mod changes {
    //! The links before and after a change, as stored in a [`Baseline`](super::Baseline), for checks beyond links.
    //!
    //! A structure with coordinates checks its links [near](super::Baseline::check) a change, reads the differences from [`Diff`], checks
    //! their consequences, and then [moves the baseline on](super::Baseline::commit).

    pub use super::column::{Column, Row, TIMES, Time};
    pub use super::diff::Diff;
    pub use super::links::{Face, HalfEdge, Label, Vertex, index};
}

pub use baseline::{Baseline, BaselineError, validate_near};
pub use diff::WriteSet;
