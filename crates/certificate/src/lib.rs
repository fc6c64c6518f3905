//! Certificates: labels by which anyone can check that a structure is a planar subdivision.
//!
//! A [`Report`](twinedge::validate::Report) has to be believed: whoever trusts it trusts the walks, the sets and the counting of the validator. A certificate
//! need not be. It is one number for each half-edge, its *rank*, and [`check`] is a scan: it looks at each record once, with
//! the records that its links name, and compares two sums. It has no walk, no set and no order, and shares no code with the
//! rules. If every test passes, the structure keeps R1 … T4, whoever made the labels, and however.
//!
//! ```
//! use twinedge::validate::Table;
//! use twinedge_certificate::{Column, Labels, Test, check};
//!
//! // An edge between two vertices.
//! let mut edge: Table = "V 2 0 - 1 - H 2 0 1 1 1 0 1 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0".parse()?;
//! let labels = Labels::new(&edge)?;
//! assert_eq!(labels.column(Column::HalfEdgeRank), [0, 1]);
//! assert_eq!(check(&edge, &labels), Ok(()));
//!
//! edge.half_edges[1].as_mut().unwrap().next = Some(1);
//! let failures = check(&edge, &labels).unwrap_err();
//! assert_eq!(failures[0].test(), Test::NextOk);
//! assert_eq!(failures[0].to_string(), "next_ok: 2 of the half-edges, the first is 0");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The tests are those of `proofs/coq/CERTIFICATE.md`, which has the reason why they are enough. It is proved in Coq, for every
//! size: what passes keeps all rules (`labels_sound`), and whatever keeps all rules has labels with which it passes
//! (`labels_complete`). The proved checker, extracted from the proof, reads the same certificates from files, which the program
//! `twinedge certify` writes: a [`Certificate`] or [`SurfaceCertificate`] has these files as columns.
//!
//! # Parts that are not stored
//!
//! If a structure does not store a [`Part`](twinedge::validate::Part), the [`Labels`] have it: `prev`, the half-edge that a vertex keeps, places, boundary components,
//! faces. They mean no more than the tests say of them, as ranks do. Where half-edges name their face and faces half-edges, two
//! more tests, [`Test::FaceNameOk`] and [`Test::FaceStartsOk`], compare these names with the boundary components of the labels.
//!
//! A structure with faces must store [holes](twinedge::validate::Part::Holes) and the [unbounded face](twinedge::validate::Part::UnboundedFace): without them it does
//! not say how its components lie in the plane.
//!
//! # Surfaces
//!
//! [`Labels::of_surface`] and [`check_surface`] do the same for structures on closed surfaces, meshes above all, with the sum of the genera. Where the
//! genus is not 0, Euler's formula does not say that a vertex has one rotation and a face one cycle; positions do.
//! A [`SurfaceCertificate`] has the structure and its labels as columns, and may be open: cycles along the border are marked as holes.
//!
//! # Drawings
//!
//! A [`Drawing`] is the certificate of coordinates: a triangulation that has the edges of the structure among its own.
//! [`check_drawing`] finds out by tests of single triangles and edges that no two edges meet but at a common end, that rotations are in angular
//! order, and that faces are where they are said to be: G1, G2, G4 and G5. `twinedge_map::certificate` makes drawings.
//!
//! # Saved labels
//!
//! Labels can be kept beside a structure (with the feature `serde`), so that whoever reads both checks instead of validating.

#![no_std]
#![forbid(unsafe_code)]
#![allow(clippy::inline_always, reason = "a call for each half-edge costs more than what it asks")]

extern crate alloc;

mod answers;
mod check;
mod check_drawing;
mod closed;
mod columns;
mod drawing;
mod labels;
mod saved;
mod storage;
mod sums;
mod surface;
mod surface_counts;
mod surface_labels;
mod surface_saved;
mod test;

pub use check::{check, passes};
pub use check_drawing::check_drawing;
pub use columns::{Column, Labels, LabelsError, VACANT};
pub use drawing::Drawing;
pub use saved::Certificate;
pub use storage::{Columns, Numbers};
pub use surface::{check_surface, passes_surface};
pub use surface_counts::SurfaceCounts;
pub use surface_saved::SurfaceCertificate;
pub use test::{Failure, Test};

use alloc::vec::Vec;

/// Nil in a column.
const NIL: u32 = u32::MAX;

/// A column of so many entries, if there is memory for it.
fn column<T: Clone>(n: usize, value: T) -> Option<Vec<T>> {
    let mut column = Vec::new();
    column.try_reserve_exact(n).ok()?;
    column.resize(n, value);
    Some(column)
}
