//! Validation of coordinates after a small change, in time proportional to the change.
//!
//! [`EmbeddingBaseline`] and [`validate_embedding_near`] extend [`near`](twinedge::validate::near) from links to coordinates, for
//! plane maps with faces with holes, boundary components and an unbounded face. All rules are checked completely: if they held
//! before, and all changed records are named, the verdict equals the verdict of a full validation.
//!
//! | rules | method |
//! | --- | --- |
//! | R1 … F2 | as in `near` |
//! | G1 | the written vertices and their edges |
//! | G2 | follows: see [below](#sums-of-turns) |
//! | G3 | per boundary component, the change of its number of turns, a sum over corners |
//! | G4 | each redrawn edge or isolated vertex against all records whose boxes meet its box, from an R-tree |
//! | G5 | the change of a winding number; for new components, a ray downwards |
//! | T1 … T4 | follow from these |
//! | M1 … M8 | not checked |
//!
//! The baseline has its own copy of the coordinates and its own R-trees. It does not rely on any index of the structure.
//!
//! # Sums of turns
//!
//! A walk around a face turns by 360°: to the left along an outer cycle, to the right along an inner one. The number of times
//! that its direction passes the direction of the x axis is 1 or −1, and is a sum over corners. Only changed corners are counted.
//!
//! A corner at which a walk turns by t is 180° − t wide. So the turns of all cycles sum to E minus the rounds of each rotation
//! about its vertex, at least one. By G3 and the sum of T3 they equal E minus the vertices with edges. So each goes around once:
//! G2.
//!
//! If G2 and G4 hold, the cycles of a component are the walks around the faces of a plane drawing. So its genus is 0 (T3), and
//! one of its cycles turns clockwise; if G3 holds, this cycle is the one inner boundary component (T1). If G5 holds, a component
//! in a face of another one has its smallest point to the right of the other's, so none lies in itself (T2).
//!
//! # What lies where
//!
//! Let b be an inner boundary component of a face f, and m a point infinitely close to the left of one of its half-edges. In a
//! valid structure, the boundary of f goes around m once, or not at all if f is unbounded. Before the change this was so for each
//! face and its points, and for other points the number was one less. A half-edge whose drawing is unchanged has an unchanged m.
//! So it suffices to add up the changes of the boundary of f, and to count how often they go around m.
//!
//! ```text
//!    ┌─────────┬──────┐    A new edge splits f. What f has lost is the walk around the part to the right:
//!    │ f   ▫   │   ▫  │    it goes around the island there, which must be listed elsewhere now,
//!    │         │ new  │    and not around the other one, which is as it was.
//!    └─────────┴──────┘
//! ```
//!
//! An edge traversed in both directions, or an edge split in two, cancels out. The check covers boundary components that start in
//! the box around the remaining changes, and components whose records or half-edges have changed. A boundary component without
//! any unchanged half-edge is located by a ray downwards from its smallest point.
//!
//! This proves G5 for all components. Suppose b is the misplaced component with the lexicographically smallest lowest point. If b
//! was located by a ray, the edge below belongs to another misplaced component, with a smaller lowest point. Otherwise the
//! boundary of f goes around m the required number of times although m lies elsewhere. So m lies in the outer cycle of f, and f
//! does not list some component around m that lies in f. That component is misplaced, with a smaller lowest point.
//!
//! If one change moves boundary components from a face to several faces and combines them with components of another face, the
//! changes do not determine the old winding number around m. The structure is then fully validated. No single operator does this.

mod baseline;
mod chain;
mod disjoint;
mod drawing;
mod drawn;
mod inside;
mod tree;
mod turns;

pub use baseline::{EmbeddingBaseline, validate_embedding_near};
