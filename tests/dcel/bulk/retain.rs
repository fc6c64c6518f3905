//! Retaining: the result equals removing records one by one.

use crate::support::erased::validate_plane;
use crate::support::programs::{built, check};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::atomic::{AtomicUsize, Ordering};
use twinedge::dcel::{
    BoundaryKey, Dcel, FaceKey, HalfEdgeKey, OperatorError, RecordKind, RemovedEdge, Retained, Room, VertexKey,
};
use twinedge::program::choose::{Choose, Random};
use twinedge::program::{OpKind, Program, Runner};
use twinedge::validate::Table;
use twinedge_trials::canonical::isomorphic;

/// Decides, from some bytes, whether a record with this index stays.
fn stays(chosen: &[u8], index: usize) -> bool {
    chosen.get(index.checked_rem(chosen.len()).unwrap_or(0)).is_none_or(|byte| byte % 3 > 0)
}

/// Returns the groups of merged faces, as sets.
fn groups(faces: &[FaceKey], merged: impl IntoIterator<Item = (FaceKey, FaceKey)>) -> BTreeSet<BTreeSet<FaceKey>> {
    let mut group: BTreeMap<FaceKey, FaceKey> = faces.iter().map(|f| (*f, *f)).collect();
    for (dropped, kept) in merged {
        let (from, to) = (group[&dropped], group[&kept]);
        group.values_mut().filter(|f| **f == from).for_each(|f| *f = to);
    }
    let mut sets: BTreeMap<FaceKey, BTreeSet<FaceKey>> = BTreeMap::new();
    for (f, of) in group {
        sets.entry(of).or_default().insert(f);
    }
    sets.into_values().collect()
}

/// The numbers of dropped edges, vertices and faces, of new boundary components, and of runs without changes.
static SEEN: [AtomicUsize; 5] = [const { AtomicUsize::new(0) }; 5];

fn law(program: Program, of_vertices: Vec<u8>, of_edges: Vec<u8>, backwards: bool) {
    let old: Dcel = built(&program);
    let (mut map, mut other) = (old.clone(), old.clone());
    let retained = map.retain(|v| stays(&of_vertices, v.index()), |h| stays(&of_edges, h.index() / 2)).unwrap();
    assert!(validate_plane(&map).is_valid(), "{:?}", validate_plane(&map));

    // Only the conditions decide which records are dropped.
    let vertices: Vec<VertexKey> =
        old.vertices().filter(|v| !stays(&of_vertices, v.index())).map(|v| v.key()).collect();
    let edges: Vec<HalfEdgeKey> = old
        .edges()
        .filter(|h| {
            let ends = [h.origin(), h.target()];
            !ends.iter().all(|v| stays(&of_vertices, v.index())) || !stays(&of_edges, h.index() / 2)
        })
        .map(|h| h.key())
        .collect();
    assert_eq!((&retained.vertices, &retained.edges), (&vertices, &edges));
    for v in old.vertices() {
        assert_eq!(map.vertex(v.key()).is_err(), vertices.contains(&v.key()));
    }
    for h in old.edges() {
        assert_eq!(map.half_edge(h.key()).is_err(), edges.contains(&h.key()));
        if let Ok(here) = map.half_edge(h.key()) {
            assert_eq!([here.origin().key(), here.target().key()], [h.origin().key(), h.target().key()]);
        }
    }

    // Operators have the same result, in either order, and merge the same faces.
    let mut merged = vec![];
    let mut order = edges.clone();
    if backwards {
        order.reverse();
    }
    for h in order {
        if let RemovedEdge::Merged { kept_face, dropped_face, .. } = other.remove_edge(h).unwrap() {
            merged.push((dropped_face, kept_face));
        }
    }
    for v in &vertices {
        other.remove_isolated_vertex(*v).unwrap();
    }
    assert!(isomorphic(&map, &other));
    for h in other.half_edges() {
        assert_eq!(map.half_edge(h.key()).unwrap().next().key(), h.next().key());
    }
    let faces: Vec<FaceKey> = old.faces().map(|f| f.key()).collect();
    let said = retained.faces.iter().map(|merged| (merged.dropped, merged.kept));
    assert_eq!(groups(&faces, said), groups(&faces, merged));
    for merged in &retained.faces {
        assert!(map.face(merged.dropped).is_err() && map.face(merged.kept).is_ok());
    }
    assert_eq!(map.face_count() + retained.faces.len(), old.face_count());
    assert_eq!(map.unbounded_face().key(), old.unbounded_face().key());
    // The surviving face lay to the left of the half-edge with the smallest index.
    for f in map.faces().filter(|f| !f.is_unbounded()) {
        let first = f.outer().unwrap().half_edges().min_by_key(|h| h.index()).unwrap().key();
        assert_eq!(old.half_edge(first).unwrap().face().key(), f.key());
    }

    // Reported boundary components are made and dropped, and others stay with their starts.
    let all = |map: &Dcel| map.boundaries().map(|b| b.key()).collect::<BTreeSet<BoundaryKey>>();
    let (before, after) = (all(&old), all(&map));
    assert!(before.difference(&after).copied().eq(retained.dropped.iter().copied().collect::<BTreeSet<_>>()));
    assert!(after.difference(&before).copied().eq(retained.made.iter().copied().collect::<BTreeSet<_>>()));
    for b in map.boundaries().filter(|b| before.contains(&b.key())) {
        let was = old.boundary(b.key()).unwrap();
        let start = was.start().map(|h| map.half_edge(h.key()).unwrap().boundary().key());
        assert_eq!(start, b.start().map(|_| b.key()));
        assert_eq!(was.isolated_vertex().map(|v| v.key()), b.isolated_vertex().map(|v| v.key()));
    }
    // Of several components starting on one cycle, the one with the smallest index survives.
    for b in map.boundaries() {
        let mut starts = old.boundaries().filter_map(|was| Some((was.key(), was.start()?.key())));
        let first = starts.find(|(_, h)| map.half_edge(*h).is_ok_and(|h| h.boundary().key() == b.key()));
        assert!(first.is_none_or(|(first, _)| first == b.key()));
    }
    let unchanged = usize::from(retained == Retained::default());
    if unchanged == 1 {
        assert_eq!(Table::copy_of(&map), Table::copy_of(&old));
    }
    let Retained { vertices, edges, faces, made, .. } = retained;
    for (seen, count) in SEEN.iter().zip([edges.len(), vertices.len(), faces.len(), made.len(), unchanged]) {
        seen.fetch_add(count, Ordering::Relaxed);
    }
}

#[test]
fn what_is_left_is_what_the_operators_leave() {
    check(1500, 100, law as fn(Program, Vec<u8>, Vec<u8>, bool));
    assert!(SEEN.iter().all(|seen| seen.load(Ordering::Relaxed) > 10), "{SEEN:?}");
}

/// Loops and edges, separate and nested; removing the edges that join them leaves faces with several cycles that
/// contain others.
#[test]
fn of_several_cycles_the_outer_one_is_found_whatever_lies_inside_the_others() {
    let kinds = [OpKind::AddIsolatedVertex, OpKind::Connect, OpKind::SplitVertex, OpKind::SplitEdge];
    let programs = Program::generator().only(&kinds).weight(OpKind::Connect, 12).length(60..=120);
    let mut source = Random::seeded(28);
    let mut with_holes = 0;
    for _ in 0..300 {
        let program = programs.generate(&mut source);
        let [vertices, edges] = [5, 31].map(|count| (0..count).map(|_| source.choose(256) as u8).collect::<Vec<_>>());
        let map: Dcel = built(&program);
        with_holes += map.faces().filter(|f| !f.is_unbounded() && f.inner_count() > 1).count();
        law(program.clone(), vec![], edges.clone(), false);
        law(program, vertices, edges, true);
    }
    assert!(with_holes > 100, "{with_holes}");
}

/// Two edges in a row: without the first, there are an edge and an isolated vertex, with one boundary component more.
#[test]
fn what_does_not_fit_is_refused_and_changes_nothing() {
    let program = "twinedge program 1\n add_isolated_vertex unbounded\n split_vertex i0 i0\n split_edge h0".parse();
    let mut runner = Runner::new(Dcel::with_limits(Room { vertices: 3, edges: 2, boundaries: 1, faces: 1 }));
    runner.run(&program.unwrap());
    let mut map = runner.into_subject();
    assert_eq!((map.edge_count(), map.boundary_count()), (2, 1));
    let first = map.edges().next().unwrap().key();
    let before = Table::copy_of(&map);
    assert_eq!(map.retain(|_| true, |h| h.key() != first), Err(OperatorError::Full(RecordKind::Boundary)));
    assert_eq!(Table::copy_of(&map), before);
    // With its end it fits.
    let end = map.half_edge(first).unwrap();
    let end = if end.origin().degree() == 1 { end.origin().key() } else { end.target().key() };
    assert_eq!(map.retain(|v| v.key() != end, |_| true).unwrap().edges, [first]);
    assert!(validate_plane(&map).is_valid());
}
