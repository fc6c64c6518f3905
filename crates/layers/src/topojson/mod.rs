//! TopoJSON: arcs, and features that consist of them.
//!
//! As a layer, [`read`](super::read()) passes on features, their lines and rings assembled from the arcs. This module
//! audits the arcs themselves: [`read`] takes them as a half-edge structure, whose edges have bends, and [`audit`] judges it. A
//! file is read as a whole, since its arcs usually follow its objects.
//!
//! | id | rule |
//! | --- | --- |
//! | A0 size | every arc has two different positions, and every ring encloses something |
//! | A1 ends | every index refers to an arc, arcs join end to end, rings close |
//! | A2 sides | each side of an arc has one polygon of the object at most, and not the same one as the other side |
//! | A3 used | some object uses the arc |
//! | R1 … T4 | the polygons are faces of the subdivision by the arcs: no arc runs into a polygon, and polygons do not overlap |
//! | G1 … G5 | arcs meet at their ends only, outer rings and holes lie as the polygons state |
//!
//! Source: "The TopoJSON Format Specification", version 1.0.

mod audit;
mod document;
mod features;
mod finding;
mod rings;
mod topology;

pub use audit::audit;
pub(super) use features::read as read_features;
pub use rings::read;
pub use topology::ArcTopology;
pub use twinedge_diagnosis::{TopologyAudit, TopologyCounts};
