//! Flipping edges.

use super::{RIGHT, square};
use crate::support::tracked::Tracked;
use std::collections::BTreeSet;
use twinedge::dcel::{OperatorError, Turn, Vertex};

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
        // It now joins the ends of the opposite side, and its old ends are leaves.
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
    // A lone loop does not change.
    let lone = t.polygon(outside, 1)[0];
    for turn in [Turn::CounterClockwise, Turn::Clockwise] {
        t.flip_edge(lone, turn);
        assert_eq!(t.cycle(lone), [lone]);
    }
    // At a corner of a triangle it slides to the next corner, inside or outside.
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
