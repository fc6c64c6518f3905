//! Mesh files: from a list of faces to half-edges, with a diagnosis.
//!
//! ```text
//!   file ── read ──► IndexedMesh ── HalfEdgeMesh::link ──► HalfEdgeMesh (a View) ── validate ──► Report
//!                                         │                                                        │
//!                                         └──► Findings: "edge 4–7 has three faces: 1, 2, 9"       │
//!                                                    └──────────────► audit ◄─────────────────────┘
//! ```
//!
//! `read` and its variants take OBJ, OFF, PLY and STL. [`HalfEdgeMesh::link`] joins the faces, in linear time, and finds the
//! parts that cannot be joined. [`audit`] does that, runs the validator on the joined parts, and counts. The validator also
//! checks properties beyond those of a surface: [`HalfEdgeMesh::expectation`] with `closed`, `genus` and so on.
//!
//! Throughout, faces and vertices are counted from 0, in the order of the file. OBJ files count vertices from 1:
//! [`Format::first_number`] and [`Finding::counted_from`] are for messages about these.
//!
//! ```
//! # #[cfg(feature = "off")] {
//! use twinedge::validate::Collect;
//! use twinedge_meshes::{Format, HalfEdgeMesh, audit, read_bytes};
//!
//! let tetrahedron = "OFF
//! 4 4 6
//! 0 0 0
//! 1 0 0
//! 0 1 0
//! 0 0 1
//! 3 0 2 1
//! 3 0 1 3
//! 3 1 2 3
//! 3 2 0 3
//! ";
//! let file = read_bytes(tetrahedron.as_bytes(), Some(Format::Off))?;
//! let audit = audit(&file.mesh, &HalfEdgeMesh::expectation().closed().triangles().genus(0), Collect::All);
//! assert!(audit.is_valid());
//! assert_eq!(audit.counts().edges, 6);
//! # }
//! # Ok::<(), twinedge_meshes::ReadError>(())
//! ```
//!
//! # Features
//!
//! | feature | adds | dependencies |
//! | --- | --- | --- |
//! | `obj`, `off`, `stl` (default) | a reader each | none |
//! | `ply` | the reader for PLY | ply-rs-bw |
//! | `serde` (default) | [`MeshAudit`] and its parts are `Serialize` | serde |
//! | `full` | all features | all |
#![cfg_attr(docsrs, feature(doc_cfg))]

mod audit;
mod counts;
mod finding;
mod half_edges;
mod indexed;
mod link;
#[cfg(any(feature = "obj", feature = "off", feature = "ply", feature = "stl"))]
mod read;
mod repeated;
#[cfg(feature = "serde")]
mod serialize;
mod space;
mod space_rule;

pub use audit::{MeshAudit, audit, audit_in_space};
pub use counts::MeshCounts;
pub use finding::{Finding, Findings, Kind};
pub use half_edges::HalfEdgeMesh;
pub use indexed::{IndexedMesh, IndexedMeshError};
#[cfg(any(feature = "obj", feature = "off", feature = "ply", feature = "stl"))]
pub use read::{Cause, Dropped, Format, MeshFile, Position, ReadError, read, read_bytes, read_path};
pub use space_rule::{SpaceOutcome, SpaceRule};
