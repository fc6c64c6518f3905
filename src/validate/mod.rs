//! The validator: the rules, the trait that a structure implements, and the report.
//!
//! [`validate`] answers one question about any half-edge structure: *is it the topology of a planar subdivision* (or, on request, of a
//! map on surfaces), and if not, which record breaks which rule? It trusts no answer of the structure, not even its counters. On any
//! input (dangling, cyclic, contradictory, huge) it returns without panic, recursion or unbounded loop, in time and memory linear in
//! the number of slots, including vacant ones.
//!
//! ```
//! use twinedge::validate::{Collect, Expectation, Link, Parts, Rule, View, validate};
//!
//! /// A triangle. Half-edges 0, 2 and 4 run around its inside, their twins 1, 3 and 5 around its outside.
//! struct Triangle {
//!     next: [usize; 6],
//! }
//!
//! impl View for Triangle {
//!     // Neither `prev`, nor half-edges kept by vertices, nor faces.
//!     fn parts(&self) -> Parts { Parts::NONE }
//!     fn vertex_slots(&self) -> usize { 3 }
//!     fn half_edge_slots(&self) -> usize { 6 }
//!     fn origin(&self, h: usize) -> Link { Some([0, 1, 1, 2, 2, 0][h]) }
//!     fn twin(&self, h: usize) -> Link { Some(h ^ 1) }
//!     fn next(&self, h: usize) -> Link { Some(self.next[h]) }
//! }
//!
//! let right = Triangle { next: [2, 5, 4, 1, 0, 3] };
//! let report = validate(&right, &Expectation::plane(), Collect::All);
//! assert!(report.is_valid());
//! assert_eq!(report.figures().unwrap().cycles, 2);
//!
//! let wrong = Triangle { next: [4, 5, 4, 1, 0, 3] };
//! let report = validate(&wrong, &Expectation::plane(), Collect::All);
//! assert_eq!(report.first().unwrap().rule(), Rule::L2);
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
//!
//!  if asked for:      R1 ─► M1 used, M4 closed, M8 kept (and V1)
//!                     R1, L ─► M2 simple
//!                     R1, L2, B1, F1 ─► M3 sides
//!                     V2 ─► M5 connected, M6 borders (and B1), M7 genus (and T3)
//!
//!  with coordinates:  G1 finite ─► G2 angles ────┐
//!                              ─► G4 disjoint ─┬─┴► G5 inside
//!                                              └─► G3 winding
//! ```
//!
//! The documentation of each [`Rule`] has its statement, a picture and a pointer to its check. A rule makes sense only where the rules
//! to its left hold. Otherwise it is reported as *not checked*, with the reason; so is a rule about parts that the structure does not
//! store.
//!
//! For a structure that stores every part, and with [`Expectation::plane`], the rules are complete. R1, L and V make a combinatorial
//! map; B and F assign each of its cycles and each isolated vertex to exactly one face, exactly once; T1 and T2 make containment a
//! tree; T3 makes every component plane. From the tree one can draw the map, outermost component first, each inside a face already
//! drawn. So a structure that keeps R, L, V, B, F and T is the topology of some planar subdivision, and every planar subdivision keeps
//! them. G then says that the coordinates draw that topology: `validate_embedding` of the crate `twinedge-map` checks it.
//!
//! M1 … M8 are different: a valid structure may break them. They are claims about meshes (closed, of triangles, of this genus); each is
//! checked, and part of the report, only if the [`Expectation`] requests it.
//!
//! # Other representations
//!
//! An adapter wraps a structure that stores other links than a [`View`] answers (targets instead of origins, borders without `next`,
//! faces that store nothing). The table of [`adapt`] lists them. [`adapt::Index`] converts keys into the dense indices that a view
//! needs, and [`Report::named`] prints a report with the keys.
//!
//! Structures of other languages are often columns of integers already: `Columns` of the crate `twinedge-columns` reads them in place,
//! and its `Preset` has the expectations for known libraries.
//!
//! # After a change
//!
//! [`near`] validates a structure that was valid before, in the time of the change: after each operator of a test, or each edit of an
//! editor. `near` of the crate `twinedge-map` also validates coordinates.
//!
//! # Evidence
//!
//! A second implementation, [`mod@reference`], states each rule in sets and quantifiers. The crate `twinedge-trials` compares the two
//! on every small [`Table`], on every change of one cell of a larger one, and on a map in every supported representation.
//!
//! # Certificates
//!
//! The crate `twinedge-certificate` labels a structure so that a scan without walks, sets or order can decide that it is valid. The
//! specification of the scan is proved in Coq, and the scan in Rust runs alongside a checker extracted from the proof.
//!
//! # With serde
//!
//! With the feature `serde`, reports, violations, figures and tables can be written and read. A [`Report`] is written in the form
//! described by `docs/report.md`, in a format with named fields such as JSON. Reading it back fails if no validation could have
//! produced it. Only a validation can tell whether a report is true of a structure.

pub mod adapt;
mod catalogue;
mod expectation;
mod fast_path;
mod findings;
mod half_edges;
pub mod near;
pub mod reference;
mod report;
mod rule;
/// The checks of the rules, grouped as in the [catalogue](self::catalogue). R1 is in `live`. The crate `twinedge-map` checks G1 … G5.
mod rules {
    pub(super) mod faces;
    pub(super) mod links;
    pub(super) mod live;
    pub(super) mod mesh;
    pub(super) mod whole;
}

/// The structure to validate: the trait that it implements, and the parts that it stores.
mod structure {
    mod delegate;
    mod parts;
    mod view;

    pub use delegate::Only;
    pub use parts::{Part, Parts};
    pub use view::{BoundaryPlace, HalfEdgeColumns, Link, Start, View};
}

mod subject;
mod table;
mod validator;

pub use expectation::{Expectation, ParseExpectationError, Surface};
pub use findings::{Findings, Flow, Halt};
pub use report::{Bounds, Collect, Counts, Field, Figures, Named, Record, Report, RuleOutcome, Unchecked, Violation};
#[cfg(feature = "serde")]
pub use report::{Described, REPORT_SCHEMA};
pub use rule::Rule;
pub use structure::{BoundaryPlace, HalfEdgeColumns, Link, Only, Part, Parts, Start, View};
pub use table::{BoundaryRow, FaceRow, HalfEdgeRow, ParseTableError, Table, VertexRow};
pub use validator::{accepts, validate};
