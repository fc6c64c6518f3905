//! Topologies of PostGIS, audited as stored: a `View` over the columns of the database.
//!
//! ```text
//!   sql ──► psql ──► three binary COPY streams ── read ──► Topology (a View) ── audit ──► TopologyAudit
//! ```
//!
//! A topology of PostGIS is a doubly connected edge list. Edge `e` of the table `edge_data` is two half-edges: `+e` from
//! `start_node` to `end_node`, with `next_left_edge` as its next and `left_face` to its left, and `-e` back, with
//! `next_right_edge` and `right_face`. Nodes are vertices, face 0 is the unbounded face, and a node without edges names the face
//! that contains it. Edges are curves: lines with [bends](twinedge_map::Embedding::bends).
//!
//! [`sql`] prints the commands for `psql` to write nodes, faces and edges as they are, in one read-only transaction. [`read`]
//! takes that output, and [`audit`] lets the validator judge the stored links: rules R1 … T4 and G1 … G5, with the ids of the
//! database. Only such a database can break the further rules:
//!
//! | id | rule |
//! | --- | --- |
//! | P0 ids | ids exist and are unique, and edge ids are positive |
//! | P1 ends | every node is a point, every edge a line that starts at its start node and ends at its end node, all in one reference system |
//! | P2 containing | nodes with edges have no `containing_face`; those of the others are faces; if broken links prevent G5, the lines alone show that the nodes lie in these faces |
//! | P3 edges | every face but face 0 is named by an edge |
//! | P4 cached | `mbr` is the box around the edges of its face, and null for face 0; `abs_next_left_edge` and `abs_next_right_edge` are the values without sign |
//!
//! One broken link hides no fault elsewhere. If it prevents rules of the validator, G1 and G4 are checked for the lines alone,
//! which end at the nodes at their ends, and `mbr` for all faces with closed lines. [`audit`] counts the records for which a rule
//! was not checked. Repeated points within a line are legal, and are counted. The table `relation` and layers are not read.
//!
//! Sources: the documentation of PostGIS 3.3, chapter 9; ISO 13249-3 (SQL/MM), topology-geometry; for COPY and its binary format
//! the documentation of `PostgreSQL` 15.

mod advice;
mod audit;
mod containing;
mod copy;
mod error;
mod ewkb;
mod finding;
mod ids;
mod labels;
mod lines;
mod listed;
mod mbr;
mod mend;
mod message;
mod read;
mod rotation;
mod sql;
mod topology;

pub use audit::audit;
pub use error::{Cause, Place, ReadError, TableName};
pub use finding::{Finding, TopologyColumn};
pub use listed::Listed;
pub use read::{is_copy, read};
pub use sql::sql;
pub use topology::Topology;
pub use twinedge_diagnosis::{TopologyAudit, TopologyCounts};
