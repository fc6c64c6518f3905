//! The validator: the rules, the trait that a structure implements to be judged, and the report.
//!
//! [`validate`] answers one question about any half-edge structure whatever: *is this the topology of a planar
//! subdivision* (or, if asked so, of a map on surfaces), and if not, which record breaks which rule? It trusts nothing
//! that the structure says, its own counters included. On any input (dangling, cyclic, contradictory, huge) it returns,
//! in time and memory linear in the number of records, without panic, recursion or unbounded loop.
//!
//! ```
//! use twinedge::validate::{Collect, Expectation, Link, Part, Rule, View, validate};
//!
//! /// One triangle, as three twins on each side, without faces.
//! struct Triangle {
//!     next: [usize; 6],
//! }
//!
//! impl View for Triangle {
//!     fn vertex_slots(&self) -> usize { 3 }
//!     fn half_edge_slots(&self) -> usize { 6 }
//!     fn origin(&self, h: usize) -> Link { Some([0, 1, 1, 2, 2, 0][h]) }
//!     fn twin(&self, h: usize) -> Link { Some(h ^ 1) }
//!     fn next(&self, h: usize) -> Link { Some(self.next[h]) }
//! }
//!
//! let expectation = Expectation::plane().without(Part::Faces).without(Part::Prev).without(Part::Leaving);
//! let right = Triangle { next: [2, 5, 4, 1, 0, 3] };
//! let report = validate(&right, &expectation, Collect::All);
//! assert!(report.is_valid());
//! assert_eq!(report.certificate().unwrap().cycles, 2);
//!
//! let wrong = Triangle { next: [4, 5, 4, 1, 0, 3] };
//! let report = validate(&wrong, &expectation, Collect::All);
//! assert_eq!(report.violations()[0].rule(), Rule::L2);
//! ```
//!
//! # The rules
//!
//! ```text
//!  R1 live ─► L1 twin ──────┐
//!             L2 next/prev ─┼─► V2 rotation ─┐
//!             L3 target ────┘   V1 leaving ──┼─► T3 Euler, T4 bounds
//!                               B1 cycle ────┤
//!                               B2 isolated ─┼─► T1 outside ─► T2 nesting
//!                               F1 outer ────┤
//!                               F2 listed ───┘
//! ```
//!
//! A rule to the right makes sense only where those to its left hold. If they do not, it is reported as *not checked*,
//! with the reason, and never passed over in silence; so is whatever the structure lacks.
//!
//! They are complete. R1, L and V make a combinatorial map; B and F give each of its cycles and each isolated vertex to
//! exactly one face, exactly once; T1 and T2 make containment a tree; T3 makes every component plane. From the tree one
//! can draw the map, outermost component first, each inside a face already drawn. So what keeps R, L, V, B, F and T is
//! the topology of some planar subdivision, and every planar subdivision keeps them.
//!
//! # Why believe it
//!
//! There is a second opinion: [`mod@reference`] says each rule once more in sets and quantifiers, and [`enumerate`]
//! makes every small [`Table`], and every change of one cell of a larger one, for the two to agree on.

mod boundaries;
mod components;
#[cfg(feature = "geometry")]
mod embedding;
pub mod enumerate;
mod expectation;
mod faces;
mod glance;
mod links;
mod live;
pub mod reference;
mod report;
mod rotations;
mod rule;
mod run;
mod table;
mod table_text;
mod topology;
mod view;
mod violation;

#[cfg(feature = "geometry")]
pub use embedding::{Embedding, places, validate_embedding};
pub use expectation::{Expectation, Part, Surface};
pub use report::{Bounds, Certificate, Collect, Counts, Report, RuleOutcome, Unchecked};
#[cfg(feature = "geometry")]
pub(crate) use report::{Findings, Flow, Halt};
pub use rule::Rule;
pub use run::validate;
pub use table::{BoundaryRow, FaceRow, HalfEdgeRow, Table, VertexRow};
pub use table_text::ParseTableError;
pub use view::{BoundaryPlace, Link, Start, View};
pub use violation::{Field, Record, Violation};
