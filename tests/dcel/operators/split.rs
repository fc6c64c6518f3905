//! Splitting and joining edges, splitting vertices and contracting edges.

use crate::support::tracked::Tracked;
use std::collections::BTreeSet;
use twinedge::dcel::{HalfEdge, HalfEdgeKey, OperatorError, VertexKey};

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
    // From the other end, the other edge stays.
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
    // Two edges between two vertices become a loop again, at either vertex.
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

/// A vertex with `leaves` leaves, counter-clockwise.
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
            // The half-edges counter-clockwise from the first corner to the second move to the target.
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
    // Contracting restores the loop.
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
    // On a tie the origin survives.
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
