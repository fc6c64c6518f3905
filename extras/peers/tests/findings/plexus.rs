//! `plexus` 0.0.11, without features.

use crate::{breaks, panics, still};
use plexus::graph::{ArcKey, FaceKey, Selector};
use plexus::prelude::*;
use plexus::primitive::Triangle;
use twinedge_peers::crates::PEERS;
use twinedge_peers::crates::plexus::{Graph, report};
use twinedge_peers::judge::Judge;
use twinedge_peers::program::Program;
use twinedge_peers::run::Verdict;

fn graph(n: u32, faces: &[[usize; 3]]) -> Graph {
    let triangles = faces.iter().map(|[a, b, c]| Triangle::new(*a, *b, *c));
    let graph = Graph::from_raw_buffers(triangles, (0..n).map(f64::from)).unwrap();
    assert!(report(&graph).is_valid());
    graph
}

fn tetrahedron() -> Graph {
    graph(4, &[[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]])
}

fn arc(graph: &Graph, n: usize) -> ArcKey {
    graph.arcs().nth(n).unwrap().key()
}

fn face(graph: &Graph, n: usize) -> FaceKey {
    graph.faces().nth(n).unwrap().key()
}

/// Returns true if `previous_arc` of `next_arc` leads elsewhere for some arc.
fn next_and_previous_disagree(graph: &Graph) -> bool {
    graph.arcs().any(|arc| arc.next_arc().previous_arc().key() != arc.key())
}

/// "Splits an edge (and its arcs)": some vertex stores a removed arc, and reading it panics.
#[test]
fn split_with_leaves_a_vertex_with_an_arc_that_is_gone() {
    let mut graph = tetrahedron();
    let key = arc(&graph, 0);
    graph.arc_mut(key).unwrap().split_with(|| 0.5);
    let outgoing = || graph.vertices().map(|vertex| vertex.outgoing_arc().key()).collect::<Vec<_>>();
    panics("P1", "plexus-0.0.11/src/graph/mod.rs", "graph consistency violated", outgoing);
}

/// "Subdivides the face about a vertex", here a face at a border.
#[test]
fn poke_with_breaks_next_and_previous() {
    let mut graph = graph(4, &[[0, 1, 2], [2, 1, 3]]);
    let key = face(&graph, 0);
    graph.face_mut(key).unwrap().poke_with(|| 0.5);
    breaks("P2", &report(&graph), "L2");
    still("P2", next_and_previous_disagree(&graph));
}

/// `graph.vertex_mut(key).unwrap().remove()` is the example in the documentation.
#[test]
fn vertex_remove_is_not_implemented() {
    let mut graph = tetrahedron();
    let key = graph.vertices().next().unwrap().key();
    panics("P3", "src/graph/mutation/vertex.rs", "not implemented", || graph.vertex_mut(key).unwrap().remove());
}

/// Two neighbouring faces of a tetrahedron are merged, and then two of the three remaining ones.
#[test]
fn merge_panics_on_the_second_merge() {
    let mut graph = tetrahedron();
    let merge = |graph: &mut Graph| {
        let (from, to) = (face(graph, 0), face(graph, 1));
        graph.face_mut(from).unwrap().merge(Selector::ByKey(to)).map(|face| face.key())
    };
    merge(&mut graph).unwrap();
    assert!(report(&graph).is_valid());
    panics("P4", "plexus-0.0.11/src/graph/mod.rs", "TopologyMalformed", || merge(&mut graph));
}

/// "Connects faces with equal arity with faces inserted along their perimeters": two triangles with a common edge.
#[test]
fn bridge_does_not_return() {
    let entry = PEERS.iter().find(|entry| entry.name == "plexus").unwrap();
    let program = Program::parse("from_raw_buffers 3; face_bridge 1 2", entry.operators).unwrap();
    let mut judge = Judge::new(*entry, env!("CARGO_BIN_EXE_twinedge-peers").into());
    let Verdict::Finding(finding) = judge.run(&program).unwrap() else { panic!("P5: {}", crate::MENDED) };
    still("P5", matches!(finding.what.as_str(), "does not return" | "ends the process"));
}
