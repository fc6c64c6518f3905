//! Mesh files: from a list of faces to half-edges, with a diagnosis.
//!
//! ```text
//!   file ── read ──► IndexedMesh ── HalfEdgeMesh::link ──► HalfEdgeMesh (a View) ── validate ──► Report
//!                                         │                                                        │
//!                                         └──► Findings: "edge 4–7 has three faces: 1, 2, 9"       │
//!                                                    └──────────────► audit ◄─────────────────────┘
//! ```
//!
//! [`read`] and its like take OBJ, OFF, PLY and STL. [`HalfEdgeMesh::link`] joins the faces, in linear time, and finds what
//! cannot be joined. [`audit`] does that, runs the validator on what was joined, counts, and compares the counts with a
//! [`MeshExpectation`].
//!
//! Faces and vertices are counted from 0, in the order of the file, in everything that this module says. (OBJ counts
//! vertices from 1 in its files.)

mod audit;
mod builder;
mod counts;
mod error;
mod expectation;
mod finding;
mod format;
mod half_edges;
mod indexed;
mod link;
#[cfg(feature = "obj")]
mod obj;
#[cfg(feature = "off")]
mod off;
#[cfg(feature = "ply")]
mod ply;
mod read;
mod repeated;
#[cfg(feature = "serde")]
mod serialize;
mod sets;
#[cfg(feature = "stl")]
mod stl;
mod text;

pub use audit::{MeshAudit, audit};
pub use counts::MeshCounts;
pub use error::{Cause, Position, ReadError};
pub use expectation::{MeshExpectation, Unmet};
pub use finding::{Finding, Findings, Kind};
pub use format::Format;
pub use half_edges::HalfEdgeMesh;
pub use indexed::{IndexedMesh, IndexedMeshError};
pub use read::{Dropped, MeshFile, read, read_bytes, read_path};
