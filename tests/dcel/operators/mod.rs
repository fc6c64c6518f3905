//! Every operator in every case, by hand. `Tracked` checks the reported records and the validity of the map each time;
//! the tests check the resulting map.

mod connect;
mod flip;
mod remove;
mod split;

use crate::support::tracked::Tracked;
use std::collections::BTreeSet;
use twinedge::dcel::{HalfEdgeKey, OperatorError, Side, Split};

const LEFT: Split<'_> = Split { new_face: Side::Left, inner: &[] };
const RIGHT: Split<'_> = Split { new_face: Side::Right, inner: &[] };

/// A square with a diagonal, from its first corner to its third.
fn square(t: &mut Tracked) -> (Vec<HalfEdgeKey>, HalfEdgeKey) {
    let outside = t.outside();
    let sides = t.polygon(outside, 4);
    let diagonal = t.connect(sides[0], sides[2], LEFT).half_edge;
    (sides, diagonal)
}

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
        // The component inside moves along.
        assert_eq!((t.face(hole[0]), t.map.boundary(v.boundary).unwrap().face().key()), (in_hole, in_hole));
    }
    assert_eq!(t.move_inner(v.boundary, right), in_hole);
    // The square cannot move into its own parts, or into faces inside them.
    let whole = t.boundary(t.twin(sides[0]));
    for f in [left, right, in_hole] {
        assert_eq!(t.refuses(|map| map.move_inner(whole, f)), OperatorError::InsideItself(whole, f));
    }
    let outer = t.boundary(sides[0]);
    assert_eq!(t.refuses(|map| map.move_inner(outer, outside)), OperatorError::IsOuter(outer));
    // It can move to a face outside.
    let island = t.polygon(outside, 3);
    let on_island = t.face(island[0]);
    assert_eq!(t.move_inner(whole, on_island), outside);
    let island = t.boundary(t.twin(island[0]));
    assert_eq!(t.refuses(|map| map.move_inner(island, in_hole)), OperatorError::InsideItself(island, in_hole));
}
