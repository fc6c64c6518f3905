//! The numbers of records in programs of edits: positions in order of creation.

use std::collections::BTreeSet;
use twinedge::dcel::{Face, FaceKey, HalfEdge, HalfEdgeKey, Vertex, VertexKey};
use twinedge::program::choose::Random;
use twinedge_map::program::*;
use twinedge_map::{FeatureId, PlanarMap};

/// The live keys in order of creation, and the removed keys, found by scanning everything after each edit.
struct Seen<K> {
    live: Vec<K>,
    retired: Vec<K>,
}

impl<K: Copy + Ord> Seen<K> {
    fn update(&mut self, now: Vec<K>) {
        let there: BTreeSet<K> = now.iter().copied().collect();
        let known: BTreeSet<K> = self.live.iter().copied().collect();
        self.retired.extend(self.live.iter().filter(|key| !there.contains(key)));
        self.live.retain(|key| there.contains(key));
        self.live.extend(now.into_iter().filter(|key| !known.contains(key)));
    }
}

fn vertex_of(runner: &EditRunner, pick: MapVertexPick) -> Option<VertexKey> {
    match runner.clone().step(&EditOp::InsertPoint { at: AtPick::Vertex(pick) }) {
        EditOutcome::Applied(edited) => Some(edited.vertices[0]),
        _ => None,
    }
}

fn half_edge_of(runner: &EditRunner, k: u32) -> HalfEdgeKey {
    match runner.clone().step(&EditOp::RemoveEdge { half_edge: MapHalfEdgePick::Live(k) }) {
        EditOutcome::Applied(edited) => edited.edges_dropped[0],
        other => panic!("{other:?}"),
    }
}

fn face_of(runner: &EditRunner, k: u32) -> Vec<FaceKey> {
    let mut covered = runner.clone();
    for op in [EditOp::AddFeature {}, EditOp::SetFeaturesOf { face: MapFacePick::Live(k), features: FeaturesPick(1) }] {
        covered.step(&op);
    }
    let map = covered.map();
    let is_covered = |f: &FaceKey| map.features_of(*f).unwrap().map(FeatureId::index).eq([0]);
    map.dcel().faces().map(Face::key).filter(is_covered).collect()
}

#[test]
fn numbers_are_positions_in_order_of_creation_however_much_comes_and_goes() {
    let mut source = Random::seeded(28);
    let kinds = [
        EditKind::InsertSegment,
        EditKind::InsertSegmentSnapped,
        EditKind::InsertRing,
        EditKind::RemoveEdge,
        EditKind::RemoveVertex,
    ];
    let programs = EditProgram::generator()
        .only(&kinds)
        .weight(EditKind::RemoveEdge, 8)
        .weight(EditKind::RemoveVertex, 6)
        .length(30..=30);
    let mut retired = 0;
    for _ in 0..30 {
        let mut runner = EditRunner::new(PlanarMap::new());
        let mut vertices = Seen { live: Vec::new(), retired: Vec::new() };
        let mut half_edges = Seen { live: Vec::new(), retired: Vec::new() };
        let mut faces = Seen { live: vec![runner.map().dcel().unbounded_face().key()], retired: Vec::new() };
        for op in &programs.generate(&mut source).0 {
            runner.step(op);
            let dcel = runner.map().dcel();
            vertices.update(dcel.vertices().map(Vertex::key).collect());
            half_edges.update(dcel.half_edges().map(HalfEdge::key).collect());
            faces.update(dcel.faces().map(Face::key).collect());
        }
        for (k, v) in (0..).zip(&vertices.live) {
            assert_eq!(vertex_of(&runner, MapVertexPick::Live(k)), Some(*v));
            assert_eq!(vertex_of(&runner, MapVertexPick::Live(k + vertices.live.len() as u32)), Some(*v));
        }
        for (k, h) in (0..).zip(&half_edges.live) {
            assert_eq!(half_edge_of(&runner, k), *h);
        }
        for (k, f) in (0..).zip(&faces.live) {
            assert_eq!(face_of(&runner, k), [*f]);
        }
        for (edit, prefix, after, count) in [
            ("remove_vertex", "v", "", vertices.live.len()),
            ("remove_vertex", "!v", "", vertices.retired.len()),
            ("remove_edge", "h", "", half_edges.live.len()),
            ("remove_edge", "!h", "", half_edges.retired.len()),
            ("set_features_of", "f", " none", faces.live.len()),
            ("set_features_of", "!f", " none", faces.retired.len()),
        ] {
            let op = |k: usize| -> EditOp { format!("{edit} {prefix}{k}{after}").parse().unwrap() };
            assert!(runner.check_numbers(&op(count.max(1) - 1)).is_ok());
            let past = runner.check_numbers(&op(count)).err().map(|past| (past.prefix, past.number, past.count));
            assert_eq!(past, (count > 0).then_some((prefix, count as u32, count)));
        }
        retired += vertices.retired.len().min(half_edges.retired.len()).min(faces.retired.len());
    }
    assert!(retired > 8, "{retired}");
}

#[test]
fn numbers_have_32_bits() {
    let at = |text: &str| text.parse::<EditOp>();
    assert_eq!(at("remove_vertex v65536"), Ok(EditOp::RemoveVertex { vertex: MapVertexPick::Live(65_536) }));
    assert_eq!(
        at("remove_edge !h4294967295"),
        Ok(EditOp::RemoveEdge { half_edge: MapHalfEdgePick::Retired(u32::MAX) })
    );
    assert!(at("remove_edge h4294967296").is_err());
}
