//! The census: each map once, none missing, and every operator tried with every argument.

use std::collections::{BTreeMap, BTreeSet, HashSet};
use twinedge::dcel::Dcel;
use twinedge::program::{Op, Refusal, Runner, StepOutcome, every_op, try_every_op};
use twinedge_trials::canonical::{self, Canonizer};
use twinedge_trials::census::{Census, Scope};

#[test]
fn connected_maps_are_as_many_as_published() {
    let mut canonizer = Canonizer::new();
    let mut plane = [0; 5];
    let mut rootings: BTreeMap<_, (usize, usize)> = BTreeMap::new();
    let mut last = 0;
    for found in Census::new(Scope::Connected { edges: 4 }) {
        let map = found.runner.subject();
        assert!(map.validate().is_valid());
        let edges = map.edge_count();
        assert!(last <= edges, "those with fewer edges come first");
        last = edges;
        plane[edges] += 1;
        let unrooted = canonizer.unrooted(map).unwrap();
        rootings.insert(unrooted.code, (edges, unrooted.rootings));
        // The program makes the map from nothing.
        let mut again = Runner::new(Dcel::new());
        again.run(&found.program);
        assert!(canonical::isomorphic(again.subject(), map));
    }
    // OEIS A103937: one face is distinguished. A006384: nothing is. A000168: one half-edge is.
    assert_eq!(plane, [1, 2, 6, 26, 150]);
    let (mut sensed, mut rooted) = ([0; 5], [0; 5]);
    for (edges, count) in rootings.into_values() {
        sensed[edges] += 1;
        rooted[edges] += count;
    }
    assert_eq!((sensed, rooted), ([1, 2, 4, 14, 57], [1, 2, 9, 54, 378]));
}

#[test]
fn subdivisions_of_one_edge_are_those_counted_by_hand() {
    let mut counts = BTreeMap::new();
    let mut codes = BTreeSet::new();
    for found in Census::new(Scope::Subdivisions { edges: 1, vertices: 3 }) {
        let map = found.runner.subject();
        assert!(map.validate().is_valid());
        assert!(codes.insert(canonical::code(map).unwrap()), "a map came twice");
        *counts.entry((map.edge_count(), map.vertex_count())).or_insert(0) += 1;
    }
    // A loop; an edge, or a loop with a vertex inside or outside; an edge with one vertex, or a loop with two.
    let by_hand = [((0, 0), 1), ((0, 1), 1), ((0, 2), 1), ((0, 3), 1), ((1, 1), 1), ((1, 2), 3), ((1, 3), 4)];
    assert_eq!(counts, BTreeMap::from(by_hand));
}

#[test]
fn a_scope_too_small_for_its_smallest_map_is_not_empty() {
    assert_eq!(Census::new(Scope::Connected { edges: 0 }).count(), 1);
    assert_eq!(Census::new(Scope::Subdivisions { edges: 0, vertices: 0 }).count(), 1);
    assert_eq!(Census::new(Scope::Subdivisions { edges: 5, vertices: 0 }).count(), 1);
}

/// A loop with a vertex on each side, and removed records.
fn loop_with_vertices() -> Runner<Dcel> {
    let text = "twinedge program 1
        add_isolated_vertex unbounded
        split_vertex i0 i0
        contract_edge h0
        connect i0 i0 right
        remove_edge h0
        connect i0 i0 left
        add_isolated_vertex h0
        add_isolated_vertex h1";
    let mut runner = Runner::new(Dcel::new());
    let outcomes = runner.run(&text.parse().unwrap());
    assert_eq!(outcomes, [StepOutcome::Applied; 8]);
    runner
}

#[test]
fn every_operator_comes_with_every_argument_once() {
    let map = loop_with_vertices();
    let ops = every_op(&map);
    assert_eq!(ops.iter().collect::<HashSet<_>>().len(), ops.len());
    let count = |is: fn(&Op) -> bool| ops.iter().filter(|op| is(op)).count();
    // Two faces and a removed one; two vertices, a non-isolated and a removed one; two half-edges and a removed one; four
    // boundary components and three invalid handles.
    assert_eq!(count(|op| matches!(op, Op::AddIsolatedVertex { .. })), 3);
    assert_eq!(count(|op| matches!(op, Op::RemoveIsolatedVertex { .. })), 4);
    assert_eq!(count(|op| matches!(op, Op::MoveInner { .. })), 3 * (4 + 3));
    for is in [
        |op: &Op| matches!(op, Op::RemoveEdge { .. }),
        |op: &Op| matches!(op, Op::SplitEdge { .. }),
        |op: &Op| matches!(op, Op::JoinEdges { .. }),
        |op: &Op| matches!(op, Op::ContractEdge { .. }),
    ] {
        assert_eq!(count(is), 3);
    }
    assert_eq!(count(|op| matches!(op, Op::FlipEdge { .. })), 2 * 3);
    // Four corners; four with three invalid ones, in both orders.
    assert_eq!(count(|op| matches!(op, Op::SplitVertex { .. })), 4 * 4 + 2 * 4 * 3);
    // Twelve pairs of different boundary components, on two sides; four corners with themselves, on two sides, with or
    // without the other boundary component of the face, and with components that may not go: itself, two elsewhere, three
    // invalid ones.
    assert_eq!(count(|op| matches!(op, Op::Connect { .. })), 12 * 2 + 4 * (2 * 2 + 6) + 2 * 4 * 3);

    let mut refusals = BTreeSet::new();
    let code = canonical::code(map.subject());
    try_every_op(&map, |op, outcome, result| {
        assert!(result.subject().validate().is_valid(), "{op}");
        match outcome {
            StepOutcome::Applied => {}
            StepOutcome::Refused(refusal) => {
                refusals.insert(refusal);
                assert_eq!(canonical::code(result.subject()), code, "{op}");
            }
            StepOutcome::Skipped => panic!("{op} has nothing to choose from"),
        }
    });
    // No vertex has degree 2, and the only edge separates two faces.
    let all = [
        Refusal::Stale,
        Refusal::NotIsolated,
        Refusal::FacesDiffer,
        Refusal::VerticesDiffer,
        Refusal::NotInner,
        Refusal::IsOuter,
        Refusal::Loop,
        Refusal::InsideItself,
    ];
    assert_eq!(refusals, BTreeSet::from(all));
}
