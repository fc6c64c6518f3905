//! Validation after a small change, in time proportional to the change.
//!
//! A [`Baseline`] keeps the links of a structure that was found right. [`validate_near`] takes the structure as it is now,
//! and the [`WriteSet`] of what has changed since. It looks at those and at what they can break, and moves the baseline on.
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
//! | R1 … F2 | completely: if they held before, and all records that have changed are named, they hold now |
//! | T1 and T3 | by their sum: V − E + F = 1 + the number of inner boundary components. Only for maps in the plane with boundary components and an unbounded face |
//! | T1 of each component, T2, T4, M1 … M8 | not checked, but see [with coordinates](#with-coordinates) |
//!
//! # Why it need not walk around a cycle
//!
//! V2 and B1 say that all half-edges with one origin, or one boundary component, lie on one orbit of a permutation. A half-edge
//! of which neither the origin nor the following one has changed lies on an orbit with one that has, or on an orbit that has not
//! changed at all. So it is enough that those that have changed lie on one orbit, and that one of them was there before if
//! any of those before are left. They are found on one orbit by walks in step from all of them, of which one need not end:
//! an operator that relabels the shorter of two cycles is checked in the time that it took.
//!
//! # With coordinates
//!
//! With the feature `geometry`, `EmbeddingBaseline` and `validate_embedding_near` do the same for a plane map with coordinates,
//! faces with holes, boundary components and an unbounded face. All rules are checked completely: if they held before, and all records
//! that have changed are named, the verdict is that of a full validation.
//!
//! | rules | how |
//! | --- | --- |
//! | R1 … F2 | as above |
//! | G1 | the vertices that were written, and their edges |
//! | G2 | it follows: see [below](#sums-of-turns) |
//! | G3 | per boundary component, the number of turns that it makes: what has changed of a sum |
//! | G4 | each edge or isolated vertex that is drawn elsewhere, against all whose boxes meet its own, from an R-tree |
//! | G5 | what has changed of a winding number, and for what is new a ray downwards |
//! | T1 … T4 | they follow from these |
//! | M1 … M8 | not checked |
//!
//! The baseline has a copy of the coordinates and R-trees of its own. Whatever index the structure keeps has no part in this.
//!
//! # Sums of turns
//!
//! A walk around a face turns by 360° in all, to the left along an outer cycle, to the right along an inner one. The number of
//! times that its direction passes that of the x axis is 1 or −1, and a sum over corners: only those that have changed are counted,
//! before and after.
//!
//! A corner by which a walk turns by t is 180° − t wide. So the turns of all cycles are E, less the number of times that each rotation
//! goes around its vertex, which is one at least. G3 and the sum of T3 say that they are E less the number of vertices with edges. So
//! each rotation goes around once: G2.
//!
//! Where G2 and G4 hold, the cycles of a component are the walks around the faces of a plane drawing. So its genus is 0 (T3), and one
//! of its cycles turns clockwise; where G3 holds, that is the one inner boundary component (T1). Where G5 holds, a component that
//! lies in a face of another has its smallest point to the right of the other's, so none lies in itself (T2).
//!
//! # What lies where
//!
//! Let b be an inner boundary component of a face f, and m a point just to the left of one of its half-edges. If all is right, the
//! boundary of f goes around m once, or not at all if f is unbounded. Before the change this was so for each face and the points in
//! it, and for other points one less. A half-edge that is drawn as before has its point m where it was. So it is enough to add up
//! what has changed of the boundary of f, and to see how often that goes around m.
//!
//! ```text
//!    ┌─────────┬──────┐    A new edge splits f. What f has lost is the walk around the part to the right:
//!    │ f   ▫   │   ▫  │    it goes around the island there, which must be listed elsewhere now,
//!    │         │ new  │    and not around the other one, which is as it was.
//!    └─────────┴──────┘
//! ```
//!
//! What an edge drawn to and fro, or an edge split in two, contributes cancels out. Only the boundary components that start in the box
//! around what is left are looked at, and those whose records have changed, or of which half-edges have. A boundary component of which
//! nothing is drawn as before is located by a ray downwards from its smallest point.
//!
//! This proves G5 for all of them. Suppose that b is the wrong one with the lexicographically smallest lowest point. If it was located by a ray, the edge
//! below is on a wrong one as well, whose lowest point is smaller. Otherwise the boundary of f goes around m as often as it
//! should, though m lies elsewhere: so m lies in the outer cycle of f, and a component around m that lies in f is not listed there.
//! That one is wrong, and its lowest point is smaller.
//!
//! Where one change takes boundary components from a face to several others, and brings them together with those of another, what has
//! changed does not tell how often the boundary went around m before. The structure is validated in full then. No single operator does
//! this.

mod baseline;
mod check;
mod column;
mod diff;
#[cfg(feature = "geometry")]
mod embedded;
mod links;
mod orbits;
mod write_set;

pub use baseline::{Baseline, BaselineError, validate_near};
#[cfg(feature = "geometry")]
pub use embedded::{EmbeddingBaseline, validate_embedding_near};
pub use write_set::WriteSet;
