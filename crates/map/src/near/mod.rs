//! Validation of coordinates after a small change, in time proportional to the change.
//!
//! [`EmbeddingBaseline`] and [`validate_embedding_near`] do for a plane map with coordinates, faces with holes, boundary components and an
//! unbounded face what [`near`](twinedge::validate::near) does for links. All rules are checked completely: if they held before, and all records
//! that have changed are named, the verdict is that of a full validation.
//!
//! | rules | how |
//! | --- | --- |
//! | R1 … F2 | as `near` does |
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
mod chain;
mod disjoint;
mod drawing;
mod drawn;
mod inside;
mod tree;
mod turns;

pub use baseline::{EmbeddingBaseline, validate_embedding_near};
