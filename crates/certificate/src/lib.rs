//! Certificates: labels that let anyone check that a structure is a planar subdivision.
//!
//! Trusting a [`Report`](twinedge::validate::Report) means trusting the walks, sets and counts of the validator. A certificate
//! needs no such trust. It is one number for each half-edge, its *rank*, and [`check`] is a scan: it reads each record once, with
//! the records named by its links, and compares two sums. It has no walk, no set and no order, and shares no code with the rules.
//! If every test passes, the structure keeps R1 … T4, independent of how the labels were made.
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
//! `proofs/coq/CERTIFICATE.md` lists the tests and explains why they suffice. It is proved in Coq, for every size: a structure
//! that passes keeps all rules (`labels_sound`), and a structure that keeps all rules has labels with which it passes
//! (`labels_complete`). The proved checker, extracted from the proof, reads the same certificates from files, which the program
//! `twinedge certify` writes: a [`Certificate`] or [`SurfaceCertificate`] has these files as columns.
//!
//! # Parts that are not stored
//!
//! If a structure does not store a [`Part`](twinedge::validate::Part), the [`Labels`] contain it: `prev`, the half-edge kept by a
//! vertex, places, boundary components, faces. As with ranks, only the tests give them meaning. If half-edges and faces name each
//! other, two more tests, [`Test::FaceNameOk`] and [`Test::FaceStartsOk`], compare these with the labels' boundary components.
//!
//! A structure with faces must store [holes](twinedge::validate::Part::Holes) and the [unbounded
//! face](twinedge::validate::Part::UnboundedFace): otherwise it does not determine how its components lie in the plane.
//!
//! # Surfaces
//!
//! [`Labels::of_surface`] and [`check_surface`] do this for structures on closed surfaces, especially meshes, with the sum of the
//! genera. If the genus is not 0, Euler's formula does not imply that a vertex has one rotation and a face one cycle; positions
//! do. A [`SurfaceCertificate`] has the structure and labels as columns, and may be open: border cycles are marked as holes.
//!
//! # Drawings
//!
//! A [`Drawing`] is the certificate of coordinates: a triangulation that contains the edges of the structure. [`check_drawing`]
//! tests single triangles and edges to establish that two edges meet only at a common end, that rotations are in angular order,
//! and that faces are where they are said to be: G1, G2, G4 and G5. `twinedge_map::certificate` makes drawings.
//!
//! # Saved labels
//!
//! Labels can be saved with a structure (with the feature `serde`), so that readers of both check instead of validating.

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
mod fast;
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

const NIL: u32 = u32::MAX;

/// Allocates `n` copies of `value`; `None` if memory runs out.
fn column<T: Clone>(n: usize, value: T) -> Option<Vec<T>> {
    let mut column = Vec::new();
    column.try_reserve_exact(n).ok()?;
    column.resize(n, value);
    Some(column)
}
