//! Every operator on every case that it has, by hand. What is reported made, kept and dropped is checked by `Tracked`
//! each time, and so is that the map stays valid; the tests say what the map is then.

use crate::support::tracked::Tracked;
use std::collections::BTreeSet;
use twinedge::dcel::{
    Connection, Corner, HalfEdge, HalfEdgeKey, OperatorError, RemovedEdge, Side, Split, Turn, Vertex, VertexKey,
};

const LEFT: Split<'_> = Split { new_face: Side::Left, inner: &[] };
const RIGHT: Split<'_> = Split { new_face: Side::Right, inner: &[] };

#[test]
fn isolated_vertices_come_and_go() {
    let mut t = Tracked::default();
    let outside = t.outside();
    let sides = t.polygon(outside, 3);
    let inside = t.face(sides[0]);
    let (a, b) = (t.add(inside), t.add(outside));
    assert_eq!(t.inner(inside), BTreeSet::from([a.boundary]));
    assert!(t.inner(outside).contains(&b.boundary));
    let removed = t.remove(a.vertex);
    assert_eq!((removed.face, removed.boundary), (inside, a.boundary));
    assert_eq!(t.inner(inside), BTreeSet::new());
    assert_eq!(t.counts(), [4, 3, 2, 2]);
    let corner = t.origin(sides[0]);
    assert_eq!(t.refuses(|map| map.remove_isolated_vertex(corner)), OperatorError::NotIsolated(corner));
}

#[test]
fn connect_two_isolated_vertices() {
    let mut t = Tracked::default();
    let outside = t.outside();
    let (a, b) = (t.add(outside), t.add(outside));
    let connected = t.connect(a.vertex, b.vertex, LEFT);
    let h = connected.half_edge;
    assert_eq!((t.origin(h), t.target(h)), (a.vertex, b.vertex));
    // Neither is longer: that of the second corner is kept.
    assert_eq!(connected.connection, Connection::Bridge { kept: b.boundary, dropped: a.boundary });
    assert_eq!(connected.new_face(), None);
    assert_eq!(t.cycle(h), [h, t.twin(h)]);
    assert_eq!(t.counts(), [2, 1, 1, 1]);
    assert!(!t.is_outer(h));
}

#[test]
fn connect_an_isolated_vertex_to_itself() {
    for (split, inside) in [(LEFT, 0), (RIGHT, 1)] {
        let mut t = Tracked::default();
        let outside = t.outside();
        let v = t.add(outside);
        let connected = t.connect(v.vertex, v.vertex, split);
        let sides = [connected.half_edge, t.twin(connected.half_edge)];
        assert_eq!((t.origin(sides[0]), t.target(sides[0])), (v.vertex, v.vertex));
        assert_eq!(sides.map(|h| t.cycle(h).len()), [1, 1]);
        assert_eq!(Some(t.face(sides[inside])), connected.new_face());
        assert_eq!(t.face(sides[1 - inside]), outside);
        assert_eq!(t.counts(), [1, 1, 2, 1]);
    }
}

#[test]
fn connect_a_corner_to_itself() {
    for (split, around) in [(RIGHT, false), (LEFT, true)] {
        let mut t = Tracked::default();
        let outside = t.outside();
        let sides = t.polygon(outside, 3);
        let h = t.twin(sides[0]);
        let before = t.cycle(h).len();
        let connected = t.connect(h, h, split);
        let n = connected.half_edge;
        // Its left side is the cycle that was there, its right side is empty.
        assert_eq!((t.cycle(n).len(), t.cycle(t.twin(n)).len()), (before + 1, 1));
        assert_eq!(t.next(n), h);
        assert_eq!(connected.new_face(), Some(t.face(if around { n } else { t.twin(n) })));
        // Around: the loop goes about the triangle, which is no longer seen from outside.
        assert_eq!(t.face(h) == outside, !around);
        assert_eq!(t.is_outer(h), around);
        assert_eq!(t.counts(), [3, 4, 3, 1]);
    }
}

#[test]
fn connect_across_a_face() {
    for split in [LEFT, RIGHT] {
        let mut t = Tracked::default();
        let outside = t.outside();
        let sides = t.polygon(outside, 5);
        let (inside, whole) = (t.face(sides[0]), t.boundary(sides[0]));
        let connected = t.connect(sides[0], sides[2], split);
        let (n, m) = (connected.half_edge, t.twin(connected.half_edge));
        assert_eq!(t.cycle(n), [n, sides[2], sides[3], sides[4]]);
        assert_eq!(t.cycle(m), [m, sides[0], sides[1]]);
        // The longer cycle keeps its record, whichever face is new.
        let Connection::Split { kept, face, .. } = connected.connection else { panic!("{connected:?}") };
        assert_eq!((kept, t.boundary(n)), (whole, whole));
        let (new, old) = if split.new_face == Side::Left { (n, m) } else { (m, n) };
        assert_eq!((t.face(new), t.face(old)), (face, inside));
        assert!(t.is_outer(new) && t.is_outer(old));
        assert_eq!(t.counts(), [5, 6, 3, 1]);
    }
}

#[test]
fn connect_twice_makes_parallel_edges() {
    let mut t = Tracked::default();
    let outside = t.outside();
    let first = t.edge(outside);
    let back = t.twin(first);
    let connected = t.connect(first, back, RIGHT);
    let n = connected.half_edge;
    assert_eq!((t.origin(n), t.target(n)), (t.origin(first), t.target(first)));
    assert_eq!([n, t.twin(n)].map(|h| t.cycle(h).len()), [2, 2]);
    assert_eq!(t.counts(), [2, 2, 2, 1]);
}

#[test]
fn connect_around_an_inner_cycle_from_both_sides() {
    // A path of three edges: an edge between its ends closes it to a square, of which either side may be the outside.
    for split in [LEFT, RIGHT] {
        let mut t = Tracked::default();
        let outside = t.outside();
        let a = t.edge(outside);
        let b = t.leaf(t.twin(a));
        let c = t.leaf(t.twin(b));
        let connected = t.connect(t.twin(c), a, split);
        let n = connected.half_edge;
        assert_eq!(t.cycle(n), [n, a, b, c]);
        assert_eq!(t.face(n) == outside, split.new_face == Side::Right);
        assert_eq!(t.is_outer(n), split.new_face == Side::Left);
        assert_eq!(t.is_outer(n), !t.is_outer(t.twin(n)));
        assert_eq!(t.counts(), [4, 4, 2, 1]);
    }
}

#[test]
fn connect_a_hole_to_what_is_around_it() {
    for (around, hole) in [(6, 3), (3, 6)] {
        let mut t = Tracked::default();
        let outside = t.outside();
        let outer = t.polygon(outside, around);
        let f = t.face(outer[0]);
        let inner = t.polygon(f, hole).into_iter().map(|h| t.twin(h)).collect::<Vec<_>>();
        let (outer_b, inner_b) = (t.boundary(outer[0]), t.boundary(inner[0]));
        assert_eq!(t.inner(f), BTreeSet::from([inner_b]));
        let connected = t.connect(outer[0], inner[0], LEFT);
        // The longer is kept, and bounds the face from outside, whatever it was.
        let (kept, dropped) = if around > hole { (outer_b, inner_b) } else { (inner_b, outer_b) };
        assert_eq!(connected.connection, Connection::Bridge { kept, dropped });
        assert_eq!(t.boundary(connected.half_edge), kept);
        assert!(t.is_outer(connected.half_edge) && t.inner(f).is_empty());
        assert_eq!(t.cycle(outer[0]).len(), around + hole + 2);
        assert_eq!(t.counts()[3], 1);
    }
}

#[test]
fn connect_two_holes() {
    for (first, second) in [(3, 5), (5, 3), (4, 4)] {
        let mut t = Tracked::default();
        let outside = t.outside();
        let a = t.polygon(outside, first)[0];
        let b = t.polygon(outside, second)[0];
        let (a, b) = (t.twin(a), t.twin(b));
        let (of_a, of_b) = (t.boundary(a), t.boundary(b));
        let connected = t.connect(a, b, LEFT);
        let (kept, dropped) = if first > second { (of_a, of_b) } else { (of_b, of_a) };
        assert_eq!(connected.connection, Connection::Bridge { kept, dropped });
        assert_eq!(t.inner(outside), BTreeSet::from([kept]));
        assert_eq!(t.cycle(a).len(), first + second + 2);
    }
}

#[test]
fn connect_to_an_isolated_vertex_from_either_end() {
    for reversed in [false, true] {
        let mut t = Tracked::default();
        let outside = t.outside();
        let sides = t.polygon(outside, 3);
        let v = t.add(t.face(sides[0]));
        let ends: [Corner; 2] = [sides[0].into(), v.vertex.into()];
        let [from, to] = if reversed { [ends[1], ends[0]] } else { ends };
        let connected = t.connect(from, to, LEFT);
        let kept = t.boundary(sides[0]);
        assert_eq!(connected.connection, Connection::Bridge { kept, dropped: v.boundary });
        assert_eq!(t.target(connected.half_edge) == v.vertex, !reversed);
        assert_eq!(t.cycle(sides[0]).len(), 5);
    }
}

#[test]
fn a_split_takes_along_the_holes_that_it_is_told_to() {
    for split_side in [Side::Left, Side::Right] {
        let mut t = Tracked::default();
        let outside = t.outside();
        let sides = t.polygon(outside, 4);
        let f = t.face(sides[0]);
        let v = t.add(f).boundary;
        let w = t.add(f).boundary;
        let hole = t.polygon(f, 3);
        let hole = t.boundary(t.twin(hole[0]));
        // Named twice, it goes once.
        let inner = [v, hole, v];
        let new = t.connect(sides[0], sides[2], Split { new_face: split_side, inner: &inner }).new_face().unwrap();
        assert_eq!(t.inner(new), BTreeSet::from([v, hole]));
        assert_eq!(t.inner(f), BTreeSet::from([w]));
    }
}

#[test]
fn a_split_refuses_what_cannot_go_along() {
    let mut t = Tracked::default();
    let outside = t.outside();
    let sides = t.polygon(outside, 4);
    let f = t.face(sides[0]);
    let hole = t.polygon(f, 3);
    let (around_hole, in_hole) = (t.twin(hole[0]), t.face(hole[0]));
    let elsewhere = t.add(in_hole).boundary;
    let mine = t.boundary(sides[0]);
    for inner in [mine, elsewhere, t.boundary(hole[0])] {
        let refused = t.refuses(|map| map.connect(sides[0], sides[2], Split { inner: &[inner], ..LEFT }));
        assert_eq!(refused, OperatorError::NotInner(inner));
    }
    // The hole's cycle is inner, the one around it outer.
    for inner in [mine, t.boundary(around_hole)] {
        let refused = t.refuses(|map| map.connect(around_hole, around_hole, Split { inner: &[inner], ..LEFT }));
        assert_eq!(refused, OperatorError::NotInner(inner));
    }
}

#[test]
fn corners_of_different_faces_are_refused() {
    let mut t = Tracked::default();
    let outside = t.outside();
    let sides = t.polygon(outside, 3);
    let inside = t.face(sides[0]);
    let out = t.twin(sides[0]);
    let refused = t.refuses(|map| map.connect(sides[0], out, LEFT));
    assert_eq!(refused, OperatorError::FacesDiffer(inside, outside));
    let v = t.add(outside).vertex;
    let refused = t.refuses(|map| map.connect(v, sides[0], LEFT));
    assert_eq!(refused, OperatorError::FacesDiffer(outside, inside));
    let busy = t.origin(out);
    assert_eq!(t.refuses(|map| map.connect(busy, v, LEFT)), OperatorError::NotIsolated(busy));
    assert_eq!(t.refuses(|map| map.connect(v, busy, LEFT)), OperatorError::NotIsolated(busy));
}

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
        // The face to the left is kept, and the record of the longer cycle.
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
    // A single edge falls into two isolated vertices; the part of the origin keeps the record on a tie.
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
    // Two polygons with an edge between: the longer part keeps the record.
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
    // The part that reaches the outside stays around the face, be it the shorter or the longer, the origin's or the
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
    // A ring of faces, and a bridge from it inwards to another ring; the cycle that is cut touches the outside nowhere.
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

#[test]
fn split_and_join_edges() {
    let mut t = Tracked::default();
    let outside = t.outside();
    let h = t.edge(outside);
    let ends = (t.origin(h), t.target(h));
    let n = t.split_edge(h).half_edge;
    assert_eq!(t.cycle(h), [h, n, t.twin(n), t.twin(h)]);
    t.join_edges(h);
    assert_eq!((t.cycle(h), (t.origin(h), t.target(h))), (vec![h, t.twin(h)], ends));
    // From the other end it is the other edge that stays.
    let n = t.split_edge(h).half_edge;
    let (back, other) = (t.twin(n), t.twin(h));
    let joined = t.join_edges(back);
    assert_eq!(joined.half_edge, other);
}

#[test]
fn split_and_join_a_loop() {
    let mut t = Tracked::default();
    let outside = t.outside();
    let h = t.polygon(outside, 1)[0];
    assert_eq!(t.refuses(|map| map.join_edges(h)), OperatorError::Loop(h));
    let n = t.split_edge(h).half_edge;
    assert_eq!(t.cycle(h), [h, n]);
    assert_eq!(t.cycle(t.twin(h)), [t.twin(h), t.twin(n)]);
    // Two edges between two vertices become a loop again, at either.
    let mut other = t.clone();
    t.join_edges(h);
    assert_eq!((t.cycle(h), t.cycle(t.twin(h))), (vec![h], vec![t.twin(h)]));
    other.join_edges(n);
    assert_eq!((other.cycle(n), other.counts()), (vec![n], [1, 1, 2, 1]));
}

#[test]
fn edges_are_joined_at_vertices_of_degree_two_only() {
    let mut t = Tracked::default();
    let outside = t.outside();
    let sides = t.polygon(outside, 3);
    let leaf = t.leaf(sides[0]);
    let into_leaf = leaf;
    let into_three = sides[2];
    for h in [into_leaf, into_three] {
        assert_eq!(t.refuses(|map| map.join_edges(h)), OperatorError::DegreeNotTwo(h));
    }
    t.join_edges(sides[0]);
    assert_eq!(t.counts(), [3, 3, 2, 1]);
}

#[test]
fn split_an_isolated_vertex() {
    let mut t = Tracked::default();
    let outside = t.outside();
    let v = t.add(outside);
    let split = t.split_vertex(v.vertex, v.vertex);
    let h = split.half_edge;
    assert_eq!((t.origin(h), t.target(h), t.boundary(h)), (v.vertex, split.vertex, v.boundary));
    let contracted = t.contract_edge(h);
    assert_eq!((contracted.kept, t.isolated(v.vertex)), (v.vertex, v.boundary));
}

#[test]
fn split_a_corner_makes_a_leaf_there() {
    let mut t = Tracked::default();
    let outside = t.outside();
    let sides = t.polygon(outside, 3);
    let v = t.origin(sides[0]);
    let split = t.split_vertex(sides[0], sides[0]);
    assert_eq!((t.origin(split.half_edge), t.target(split.half_edge)), (v, split.vertex));
    assert_eq!(t.cycle(sides[0]).len(), 5);
    assert_eq!(t.next(t.twin(split.half_edge)), sides[0]);
    let contracted = t.contract_edge(t.twin(split.half_edge));
    assert_eq!((contracted.kept, contracted.dropped), (v, split.vertex));
    assert_eq!(t.cycle(sides[0]), sides);
}

/// A vertex with so many leaves, counter-clockwise.
fn star(t: &mut Tracked, leaves: usize) -> (VertexKey, Vec<HalfEdgeKey>) {
    let outside = t.outside();
    let first = t.edge(outside);
    let mut rays = vec![first];
    while rays.len() < leaves {
        rays.push(t.leaf(rays[rays.len() - 1]));
    }
    let v = t.origin(first);
    let rotation: Vec<_> = t.map.vertex(v).unwrap().rotation().map(HalfEdge::key).collect();
    let start = rotation.iter().position(|h| *h == first).unwrap();
    assert_eq!([&rotation[start..], &rotation[..start]].concat(), rays);
    (v, rays)
}

#[test]
fn split_a_vertex_between_any_two_corners() {
    for from in 0..5 {
        for to in 0..5 {
            let mut t = Tracked::default();
            let (v, rays) = star(&mut t, 5);
            let split = t.split_vertex(rays[from], rays[to]);
            let n = split.half_edge;
            // Counter-clockwise from the first corner to the second: those go to the target.
            let moved: BTreeSet<_> = (1..=(to + 5 - from) % 5).map(|i| rays[(from + i) % 5]).collect();
            let at = |v| -> BTreeSet<_> { t.map.vertex(v).unwrap().rotation().map(HalfEdge::key).collect() };
            let expected: BTreeSet<_> = moved.iter().copied().chain([t.twin(n)]).collect();
            assert_eq!(at(t.target(n)), expected);
            assert_eq!(at(t.origin(n)).len(), 6 - moved.len());
            // The smaller rotation gets the new vertex.
            assert_eq!(t.target(n) == split.vertex, moved.len() <= 2);
            assert!([t.origin(n), t.target(n)].contains(&v));
            let contracted = t.contract_edge(n);
            assert_eq!(contracted.dropped, split.vertex);
            let again: Vec<_> = t.map.half_edge(rays[0]).unwrap().origin().rotation().map(HalfEdge::key).collect();
            assert_eq!(again.len(), 5);
        }
    }
}

#[test]
fn split_a_vertex_with_a_loop() {
    let mut t = Tracked::default();
    let outside = t.outside();
    let inside = t.polygon(outside, 1)[0];
    let out = t.twin(inside);
    // One end of the loop on each side: two parallel edges.
    let n = t.split_vertex(inside, out).half_edge;
    assert_eq!([n, t.twin(n)].map(|h| t.cycle(h).len()), [2, 2]);
    assert_eq!(t.counts(), [2, 2, 2, 1]);
    // And contracted, a loop again.
    let contracted = t.contract_edge(n);
    assert_eq!((t.origin(inside), t.target(inside)), (contracted.kept, contracted.kept));
    assert_eq!(t.refuses(|map| map.contract_edge(inside)), OperatorError::Loop(inside));
}

#[test]
fn a_vertex_is_split_between_corners_of_its_own() {
    let mut t = Tracked::default();
    let outside = t.outside();
    let sides = t.polygon(outside, 3);
    let (a, b) = (t.origin(sides[0]), t.origin(sides[1]));
    let refused = t.refuses(|map| map.split_vertex(sides[0], sides[1]));
    assert_eq!(refused, OperatorError::VerticesDiffer(a, b));
    let v = t.add(outside).vertex;
    assert_eq!(t.refuses(|map| map.split_vertex(v, sides[0])), OperatorError::VerticesDiffer(v, a));
    assert_eq!(t.refuses(|map| map.split_vertex(a, a)), OperatorError::NotIsolated(a));
}

#[test]
fn contract_an_edge_of_a_triangle() {
    let mut t = Tracked::default();
    let outside = t.outside();
    let sides = t.polygon(outside, 3);
    let v = t.origin(sides[0]);
    let contracted = t.contract_edge(sides[0]);
    // On a tie the origin stays.
    assert_eq!(contracted.kept, v);
    assert_eq!((t.cycle(sides[1]).len(), t.counts()), (2, [2, 2, 2, 1]));
    t.contract_edge(sides[1]);
    assert_eq!((t.cycle(sides[2]).len(), t.counts()), (1, [1, 1, 2, 1]));
}

#[test]
fn contract_keeps_the_vertex_with_more_edges() {
    let mut t = Tracked::default();
    let (v, rays) = star(&mut t, 4);
    for ray in [rays[0], t.twin(rays[1])] {
        assert_eq!(t.contract_edge(ray).kept, v);
    }
}

/// A square with a diagonal, from its first corner to its third.
fn square(t: &mut Tracked) -> (Vec<HalfEdgeKey>, HalfEdgeKey) {
    let outside = t.outside();
    let sides = t.polygon(outside, 4);
    let diagonal = t.connect(sides[0], sides[2], LEFT).half_edge;
    (sides, diagonal)
}

#[test]
fn flip_a_diagonal_either_way() {
    for (turn, ends) in [(Turn::CounterClockwise, (1, 3)), (Turn::Clockwise, (3, 1))] {
        let mut t = Tracked::default();
        let (sides, h) = square(&mut t);
        // From the first corner to the third.
        t.flip_edge(h, turn);
        assert_eq!((t.origin(h), t.target(h)), (t.origin(sides[ends.0]), t.origin(sides[ends.1])));
        t.flip_edge(h, turn.reversed());
        assert_eq!((t.origin(h), t.target(h)), (t.origin(sides[0]), t.origin(sides[2])));
        assert_eq!(t.cycle(h), [h, sides[2], sides[3]]);
    }
}

#[test]
fn flip_an_edge_to_the_face_around() {
    for turn in [Turn::CounterClockwise, Turn::Clockwise] {
        let mut t = Tracked::default();
        let outside = t.outside();
        let sides = t.polygon(outside, 4);
        t.flip_edge(sides[0], turn);
        assert_eq!(t.face(t.twin(sides[0])), outside);
        // It now joins the ends of the side opposite, and its own old ends are leaves.
        let ends = BTreeSet::from([t.origin(sides[0]), t.target(sides[0])]);
        assert_eq!(ends, BTreeSet::from([t.origin(sides[2]), t.target(sides[2])]));
        let mut degrees: Vec<_> = t.map.vertices().map(Vertex::degree).collect();
        degrees.sort_unstable();
        assert_eq!(degrees, [1, 1, 3, 3]);
    }
}

#[test]
fn flip_a_loop() {
    let mut t = Tracked::default();
    let outside = t.outside();
    // Alone, it stays what it is.
    let lone = t.polygon(outside, 1)[0];
    for turn in [Turn::CounterClockwise, Turn::Clockwise] {
        t.flip_edge(lone, turn);
        assert_eq!(t.cycle(lone), [lone]);
    }
    // At a corner of a triangle it slides from one to the next, inside or outside.
    for i in [0, 1] {
        for turn in [Turn::CounterClockwise, Turn::Clockwise] {
            let mut t = Tracked::default();
            let outside = t.outside();
            let side = t.polygon(outside, 3)[0];
            let corner = [side, t.twin(side)][i];
            let n = t.connect(corner, corner, RIGHT).half_edge;
            let mut seen = Vec::new();
            for h in [n, t.twin(n), n] {
                seen.push(t.origin(n));
                t.flip_edge(h, turn);
            }
            assert_eq!(t.origin(n), seen[0]);
            assert_eq!(BTreeSet::from_iter(seen).len(), 3);
        }
    }
}

#[test]
fn flip_one_of_two_parallel_edges() {
    let mut t = Tracked::default();
    let outside = t.outside();
    let sides = t.polygon(outside, 2);
    let ends = (t.origin(sides[0]), t.target(sides[0]));
    t.flip_edge(sides[0], Turn::Clockwise);
    assert_eq!((t.target(sides[0]), t.origin(sides[0])), ends);
    assert_eq!(t.counts(), [2, 2, 2, 1]);
}

#[test]
fn an_edge_that_separates_nothing_is_not_flipped() {
    let mut t = Tracked::default();
    let outside = t.outside();
    let h = t.edge(outside);
    assert_eq!(t.refuses(|map| map.flip_edge(h, Turn::Clockwise)), OperatorError::NotSeparating(h));
}

#[test]
fn move_holes_and_isolated_vertices() {
    let mut t = Tracked::default();
    let (sides, diagonal) = square(&mut t);
    let outside = t.outside();
    let (left, right) = (t.face(diagonal), t.face(t.twin(diagonal)));
    let hole = t.polygon(left, 3);
    let in_hole = t.face(hole[0]);
    let v = t.add(in_hole);
    let b = t.boundary(t.twin(hole[0]));
    for to in [right, outside, left, left] {
        let from = t.map.boundary(b).unwrap().face().key();
        assert_eq!(t.move_inner(b, to), from);
        assert!(t.inner(to).contains(&b));
        // What lies inside comes along.
        assert_eq!((t.face(hole[0]), t.map.boundary(v.boundary).unwrap().face().key()), (in_hole, in_hole));
    }
    assert_eq!(t.move_inner(v.boundary, right), in_hole);
    // The square itself, into its own parts or what lies in them.
    let whole = t.boundary(t.twin(sides[0]));
    for f in [left, right, in_hole] {
        assert_eq!(t.refuses(|map| map.move_inner(whole, f)), OperatorError::InsideItself(whole, f));
    }
    let outer = t.boundary(sides[0]);
    assert_eq!(t.refuses(|map| map.move_inner(outer, outside)), OperatorError::IsOuter(outer));
    // But beside it.
    let island = t.polygon(outside, 3);
    let on_island = t.face(island[0]);
    assert_eq!(t.move_inner(whole, on_island), outside);
    let island = t.boundary(t.twin(island[0]));
    assert_eq!(t.refuses(|map| map.move_inner(island, in_hole)), OperatorError::InsideItself(island, in_hole));
}
