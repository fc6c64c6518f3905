//! Removing edges.

use super::LEFT;
use crate::support::tracked::Tracked;
use std::collections::BTreeSet;
use twinedge::dcel::RemovedEdge;

#[test]
fn remove_the_edge_between_two_faces_side_by_side() {
    for from_right in [false, true] {
        let mut t = Tracked::default();
        let outside = t.outside();
        let sides = t.polygon(outside, 5);
        let n = t.connect(sides[0], sides[2], LEFT).half_edge;
        let h = if from_right { t.twin(n) } else { n };
        let (left, right) = (t.face(h), t.face(t.twin(h)));
        let (v, w) = (t.add(left).boundary, t.add(right).boundary);
        let longer = t.boundary(n);
        let removed = t.remove_edge(h);
        // The left face survives, with the record of the longer cycle.
        let RemovedEdge::Merged { kept_face, kept, .. } = removed else { panic!("{removed:?}") };
        assert_eq!((kept_face, kept), (left, longer));
        assert_eq!(t.inner(left), BTreeSet::from([v, w]));
        assert_eq!(t.cycle(sides[0]), sides);
        assert_eq!(t.counts(), [7, 5, 2, 3]);
    }
}

#[test]
fn remove_an_edge_to_the_face_around() {
    for from_outside in [false, true] {
        let mut t = Tracked::default();
        let outside = t.outside();
        let sides = t.polygon(outside, 4);
        let inside = t.face(sides[0]);
        let v = t.add(inside).boundary;
        let h = if from_outside { t.twin(sides[0]) } else { sides[0] };
        let removed = t.remove_edge(h);
        let RemovedEdge::Merged { kept_face, dropped_face, kept, .. } = removed else { panic!("{removed:?}") };
        assert_eq!((kept_face, dropped_face), (outside, inside));
        assert_eq!(t.inner(outside), BTreeSet::from([kept, v]));
        assert!(!t.is_outer(sides[1]));
        assert_eq!(t.cycle(sides[1]).len(), 6);
    }
}

#[test]
fn remove_a_loop() {
    // Alone, with a leaf inside, with a leaf outside.
    for leaf_side in [None, Some(0), Some(1)] {
        let mut t = Tracked::default();
        let outside = t.outside();
        let side = t.polygon(outside, 1)[0];
        let v = t.origin(side);
        let leaf = leaf_side.map(|i| t.leaf([side, t.twin(side)][i]));
        let removed = t.remove_edge(side);
        let RemovedEdge::Merged { kept, .. } = removed else { panic!("{removed:?}") };
        match leaf {
            None => assert_eq!(t.isolated(v), kept),
            Some(leaf) => assert_eq!((t.boundary(leaf), t.cycle(leaf).len()), (kept, 2)),
        }
        assert_eq!(t.inner(outside), BTreeSet::from([kept]));
    }
}

#[test]
fn remove_a_bridge_from_an_inner_cycle() {
    let mut t = Tracked::default();
    let outside = t.outside();
    // A single edge falls into two isolated vertices; on a tie the origin's part keeps the record.
    let h = t.edge(outside);
    let (a, b, whole) = (t.origin(h), t.target(h), t.boundary(h));
    let removed = t.remove_edge(h);
    assert_eq!(removed, RemovedEdge::Parted { kept: whole, made: t.isolated(b) });
    assert_eq!(t.isolated(a), whole);
    // A leaf.
    let sides = t.polygon(outside, 3);
    let leaf = t.leaf(t.twin(sides[0]));
    let (end, whole) = (t.target(leaf), t.boundary(leaf));
    let removed = t.remove_edge(leaf);
    assert_eq!(removed, RemovedEdge::Parted { kept: whole, made: t.isolated(end) });
    // Two polygons joined by an edge: the longer part keeps the record.
    let more = t.polygon(outside, 5);
    let bridge = t.connect(t.twin(sides[0]), t.twin(more[0]), LEFT).half_edge;
    let whole = t.boundary(bridge);
    let removed = t.remove_edge(bridge);
    assert_eq!(removed, RemovedEdge::Parted { kept: whole, made: t.boundary(t.twin(sides[0])) });
    assert_eq!(t.boundary(t.twin(more[0])), whole);
    assert!(!t.is_outer(t.twin(sides[0])) && !t.is_outer(t.twin(more[0])));
    assert_eq!(t.inner(outside).len(), 5);
}

#[test]
fn remove_a_bridge_from_an_outer_cycle() {
    // The part that reaches the outside stays around the face, whether it is shorter or longer, the origin's or the
    // target's.
    for (around, within) in [(3, 8), (8, 3), (1, 1), (4, 1), (1, 4)] {
        for reversed in [false, true] {
            let mut t = Tracked::default();
            let outside = t.outside();
            let outer = t.polygon(outside, around);
            let f = t.face(outer[0]);
            let inner = t.polygon(f, within);
            let hole = t.twin(inner[0]);
            let bridge = t.connect(outer[0], hole, LEFT).half_edge;
            let h = if reversed { t.twin(bridge) } else { bridge };
            let whole = t.boundary(h);
            let removed = t.remove_edge(h);
            let RemovedEdge::Parted { kept, .. } = removed else { panic!("{removed:?}") };
            assert_eq!(kept, whole);
            assert!(t.is_outer(outer[0]) && !t.is_outer(hole), "{around}, {within}");
            assert_eq!(t.inner(f), BTreeSet::from([t.boundary(hole)]));
            assert_eq!((t.face(outer[0]), t.face(hole)), (f, f));
            assert_eq!(t.cycle(outer[0]), outer);
            assert_eq!(t.counts(), [around + within, around + within, 3, 2]);
        }
    }
}

#[test]
fn remove_a_bridge_where_the_outside_is_far() {
    // A ring of faces, and a bridge from it inwards to another ring; the cut cycle touches the outside nowhere.
    for (corners, reversed) in [(3, false), (3, true), (9, false), (9, true)] {
        let mut t = Tracked::default();
        let outside = t.outside();
        let outer = t.polygon(outside, 6);
        let f = t.face(outer[0]);
        let ring = t.polygon(f, 4);
        let around_ring = t.twin(ring[0]);
        t.connect(outer[0], around_ring, LEFT);
        let opposite = t.twin(ring[2]);
        t.connect(outer[3], opposite, LEFT);
        let g = t.face(ring[0]);
        let island = t.polygon(g, corners);
        let hole = t.twin(island[0]);
        let bridge = t.connect(ring[0], hole, LEFT).half_edge;
        let h = if reversed { t.twin(bridge) } else { bridge };
        t.remove_edge(h);
        assert!(t.is_outer(ring[0]) && !t.is_outer(hole));
        assert_eq!(t.inner(g), BTreeSet::from([t.boundary(hole)]));
    }
}

#[test]
fn remove_a_leaf_inside_a_face() {
    for reversed in [false, true] {
        let mut t = Tracked::default();
        let outside = t.outside();
        let sides = t.polygon(outside, 3);
        let leaf = t.leaf(sides[1]);
        let end = t.target(leaf);
        let h = if reversed { t.twin(leaf) } else { leaf };
        t.remove_edge(h);
        assert_eq!(t.inner(t.face(sides[0])), BTreeSet::from([t.isolated(end)]));
        assert!(t.is_outer(sides[0]));
    }
}
