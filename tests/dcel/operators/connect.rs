//! Connecting two corners or isolated vertices.

use super::{LEFT, RIGHT};
use crate::support::tracked::Tracked;
use std::collections::BTreeSet;
use twinedge::dcel::{Connection, Corner, OperatorError, Side, Split};

#[test]
fn connect_two_isolated_vertices() {
    let mut t = Tracked::default();
    let outside = t.outside();
    let (a, b) = (t.add(outside), t.add(outside));
    let connected = t.connect(a.vertex, b.vertex, LEFT);
    let h = connected.half_edge;
    assert_eq!((t.origin(h), t.target(h)), (a.vertex, b.vertex));
    // Both are equally long, so the second corner's is kept.
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
        // On its left is the old cycle, and its right side is empty.
        assert_eq!((t.cycle(n).len(), t.cycle(t.twin(n)).len()), (before + 1, 1));
        assert_eq!(t.next(n), h);
        assert_eq!(connected.new_face(), Some(t.face(if around { n } else { t.twin(n) })));
        // The loop surrounds the triangle, which is no longer seen from outside.
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
    // A path of three edges: an edge between its ends closes it to a square, with either side as the outside.
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
        // The longer one is kept, and bounds the face from outside, whatever it was before.
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
        // Named twice, it moves once.
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
