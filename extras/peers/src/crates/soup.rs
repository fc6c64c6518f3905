//! `halfedge` 0.3.0, builder and validator: lists of triangles, not all of them surfaces.
//!
//! The only error that the builder documents is an index out of range, and the crate assumes manifolds. The audit tests
//! the crate's validator of the outcome: a finding is a mesh that it accepts although the rules refuse it.

use super::halfedge::report;
use crate::peer::{self, Applied};
use crate::program::Operator;
use halfedge::MeshStorage;
use twinedge::validate::Report;

/// Random lists of triangles on six vertices.
pub struct Peer {
    faces: Vec<[u32; 3]>,
}

/// Distinct, no three collinear, and no four coplanar.
const POSITIONS: [[f64; 3]; 6] =
    [[0.0, 0.0, 0.0], [1.0, 1.0, 1.0], [2.0, 4.0, 8.0], [3.0, 9.0, 27.0], [4.0, 16.0, 64.0], [5.0, 25.0, 125.0]];

impl Peer {
    fn mesh(&self) -> MeshStorage {
        halfedge::build_mesh_from_vertices_and_faces(&POSITIONS, &self.faces).expect("all indices are in range")
    }
}

impl peer::Peer for Peer {
    const OPERATORS: &'static [Operator] = &[Operator::on_records("face", 3, 1)];

    fn new() -> Self {
        Self { faces: Vec::new() }
    }

    fn apply(&mut self, _: &str, arguments: &[u32]) -> Applied {
        let [a, b, c] = [arguments[0] % 6, arguments[1] % 6, arguments[2] % 6];
        if a == b || b == c || c == a {
            return Applied::Skipped;
        }
        self.faces.push([a, b, c]);
        Applied::Done
    }

    fn report(&self) -> Report {
        report(&self.mesh())
    }

    fn own_check(&self) -> Option<bool> {
        Some(halfedge::validate_topology(&self.mesh()).is_empty())
    }
}
