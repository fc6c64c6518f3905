//! The operators of each crate without findings keep every rule, in thousands of programs, so the adapters are not at
//! fault.

use twinedge_peers::crates::PEERS;
use twinedge_peers::program::{Operator, Program};
use twinedge_peers::run::Verdict;

const PROGRAMS: u64 = 2000;

/// Runs programs of only these operators, and asserts that calls are made without findings.
fn healthy(name: &str, only: &[&str]) {
    let entry = PEERS.iter().find(|entry| entry.name == name).unwrap();
    for name in only {
        assert!(entry.operators.iter().any(|operator| operator.name == *name), "there is no operator {name}");
    }
    let drawn = |operator: &Operator| Operator { weight: u32::from(only.contains(&operator.name)), ..*operator };
    let operators = entry.operators.iter().map(drawn).collect::<Vec<_>>();
    let (mut made, mut returned) = (std::collections::BTreeMap::<String, usize>::new(), 0);
    for number in 0..PROGRAMS {
        let program = Program::random(&operators, 7, number, 30);
        match (entry.run)(&program, &mut |operator| *made.entry(operator.to_owned()).or_default() += 1) {
            Verdict::Sound { done, .. } => returned += done,
            Verdict::Finding(finding) => panic!("{}: {finding:?}", program.to_text(entry.operators)),
        }
    }
    assert_eq!(made.len(), only.len(), "some operators were never tried: {made:?}");
    assert!(returned > 5 * PROGRAMS as usize, "only {returned} calls returned");
}

#[test]
fn dcel() {
    healthy("dcel", &["insert_mesh", "split_face_by_edge", "split_edge_by_vertex", "triangulate_face_around_point"]);
}

#[test]
fn dcel_removing_edges_between_polygons() {
    healthy("dcel", &["insert_mesh", "remove_inner_edge"]);
}

#[test]
fn halfedge() {
    healthy(
        "halfedge",
        &[
            "build_shape",
            "split_edge",
            "flip_edge",
            "extrude_face",
            "fill_hole",
            "add_vertex",
            "remove_isolated_vertices",
        ],
    );
}

#[test]
fn halfedge_adding_triangles() {
    healthy("halfedge", &["add_vertex", "add_triangle"]);
}

#[test]
fn plexus() {
    healthy("plexus", &["from_raw_buffers", "face_remove"]);
}

#[test]
fn tri_mesh() {
    healthy(
        "tri-mesh",
        &[
            "append_shape",
            "add_vertex",
            "split_edge",
            "split_face",
            "collapse_edge",
            "flip_orientation",
            "fix_orientation",
        ],
    );
}

#[test]
fn tri_mesh_flipping() {
    healthy("tri-mesh", &["append_shape", "split_edge", "split_face", "flip_edge", "remove_lonely_primitives"]);
}

#[test]
fn tri_mesh_adding_faces() {
    healthy("tri-mesh", &["add_vertex", "add_face", "split_edge", "split_face"]);
}

#[test]
fn spade() {
    healthy(
        "spade",
        &["insert", "insert_inexact", "remove", "add_constraint", "try_add_constraint", "remove_constraint_edge"],
    );
}
