//! Accessors of elements, compared with a drawing whose answers were entered by hand.

use crate::support::erased::validate_plane;
use std::fmt::Debug;
use twinedge::dcel::{
    Boundary, BoundaryKey, Dcel, Face, FaceKey, HalfEdge, HalfEdgeKey, Side, Split, Vertex, VertexKey,
};

/// ```text
///          ,--.
///        l( L  )l'            faces: O outside, T in the triangle, L in the loop
///          `. .'              half-edges: ab, bc, ca have T to their left, ba, cb, ac have O; l has L, l' has O
///            c                de and ed have T on both sides
///           / \               p and q are isolated
///          /   \      ∙q
///         / d─e \      O
///        /   ∙p  \
///       a─────────b
/// ```
struct Drawn {
    dcel: Dcel,
    vertices: [VertexKey; 7],
    half_edges: [HalfEdgeKey; 10],
    faces: [FaceKey; 3],
}

fn draw() -> Drawn {
    let mut dcel = Dcel::default();
    let outside = dcel.unbounded_face().key();
    // Removed records leave reused slots, or gaps.
    let gone = dcel.add_isolated_vertex(outside).unwrap().vertex;
    let a = dcel.add_isolated_vertex(outside).unwrap().vertex;
    dcel.remove_isolated_vertex(gone).unwrap();
    let left = Split { new_face: Side::Left, inner: &[] };
    let made = dcel.connect(a, a, left).unwrap();
    let (ab, triangle) = (made.half_edge, made.new_face().unwrap());
    let to_b = dcel.split_edge(ab).unwrap();
    let to_c = dcel.split_edge(to_b.half_edge).unwrap();
    let (bc, ca) = (to_b.half_edge, to_c.half_edge);
    let twin = |dcel: &Dcel, h| dcel.half_edge(h).unwrap().twin().key();
    let [ba, cb, ac] = [ab, bc, ca].map(|h| twin(&dcel, h));
    // A loop from a corner to itself has the rest of the cycle to its left.
    let made = dcel.connect(cb, cb, Split { new_face: Side::Right, inner: &[] }).unwrap();
    let (l2, inside) = (made.half_edge, made.new_face().unwrap());
    let l = twin(&dcel, l2);
    let d = dcel.add_isolated_vertex(triangle).unwrap().vertex;
    let to_e = dcel.split_vertex(d, d).unwrap();
    let (de, e) = (to_e.half_edge, to_e.vertex);
    let ed = twin(&dcel, de);
    let p = dcel.add_isolated_vertex(triangle).unwrap().vertex;
    let q = dcel.add_isolated_vertex(outside).unwrap().vertex;
    Drawn {
        dcel,
        vertices: [a, to_b.vertex, to_c.vertex, d, e, p, q],
        half_edges: [ab, bc, ca, ba, cb, ac, l, l2, de, ed],
        faces: [outside, triangle, inside],
    }
}

/// The items in their cyclic order, from the given one on.
#[track_caller]
fn from<T: Copy + PartialEq + Debug>(first: T, items: impl IntoIterator<Item = T>) -> Vec<T> {
    let mut items: Vec<T> = items.into_iter().collect();
    let at = items.iter().position(|item| *item == first).unwrap_or_else(|| panic!("{first:?} is not in {items:?}"));
    items.rotate_left(at);
    items
}

fn vertices(Drawn { dcel, vertices, half_edges, .. }: &Drawn) {
    let [a, b, c, d, e, p, q] = *vertices;
    let [ab, bc, ca, ba, cb, ac, l, l2, de, ed] = *half_edges;
    let expected: [(VertexKey, &[HalfEdgeKey], &[VertexKey]); 7] = [
        (a, &[ab, ac], &[b, c]),
        (b, &[bc, ba], &[c, a]),
        (c, &[ca, cb, l, l2], &[a, b, c, c]),
        (d, &[de], &[e]),
        (e, &[ed], &[d]),
        (p, &[], &[]),
        (q, &[], &[]),
    ];
    for (key, rotation, neighbours) in expected {
        let vertex = dcel.vertex(key).unwrap();
        assert_eq!(vertex.degree(), rotation.len());
        assert_eq!(vertex.leaving().is_some(), !rotation.is_empty());
        assert_eq!(vertex.isolated().is_some(), rotation.is_empty());
        assert_eq!(vertex.isolated().and_then(Boundary::isolated_vertex), vertex.isolated().map(|_| vertex));
        let Some(first) = rotation.first() else {
            assert_eq!((vertex.rotation().count(), vertex.neighbours().count()), (0, 0));
            continue;
        };
        assert_eq!(from(*first, vertex.rotation().map(HalfEdge::key)), rotation);
        let leaving = vertex.leaving().unwrap();
        let ends: Vec<_> = leaving.rotation().map(|h| h.target().key()).collect();
        assert_eq!(vertex.neighbours().map(Vertex::key).collect::<Vec<_>>(), ends);
        let mut around: Vec<_> = rotation.iter().copied().zip(neighbours.iter().copied()).collect();
        for _ in rotation {
            let h = dcel.half_edge(around[0].0).unwrap();
            assert_eq!(h.origin(), vertex);
            assert_eq!(h.rotation().map(|h| (h.key(), h.target().key())).collect::<Vec<_>>(), around);
            assert_eq!(h.counter_clockwise().key(), around[1 % around.len()].0);
            assert_eq!(h.counter_clockwise().clockwise(), h);
            // Clockwise from the last one on.
            let backwards: Vec<_> = h.rotation().rev().map(|h| (h.key(), h.target().key())).collect();
            assert_eq!(backwards, around.iter().rev().copied().collect::<Vec<_>>());
            around.rotate_left(1);
        }
    }
}

fn half_edges(Drawn { dcel, vertices, half_edges, faces }: &Drawn) {
    let [a, b, c, d, e, ..] = *vertices;
    let [ab, bc, ca, ba, cb, ac, l, l2, de, ed] = *half_edges;
    let [outside, triangle, inside] = *faces;
    // Half-edge, origin, target, twin, next, face, and whether it is on the outer boundary component of its face.
    let expected = [
        (ab, a, b, ba, bc, triangle, true),
        (bc, b, c, cb, ca, triangle, true),
        (ca, c, a, ac, ab, triangle, true),
        (ba, b, a, ab, ac, outside, false),
        (cb, c, b, bc, ba, outside, false),
        (ac, a, c, ca, l2, outside, false),
        (l, c, c, l2, l, inside, true),
        (l2, c, c, l, cb, outside, false),
        (de, d, e, ed, ed, triangle, false),
        (ed, e, d, de, de, triangle, false),
    ];
    for (key, origin, target, twin, next, face, outer) in expected {
        let h = dcel.half_edge(key).unwrap();
        let found = (h.key(), h.origin().key(), h.target().key(), h.twin().key(), h.next().key(), h.face().key());
        assert_eq!(found, (key, origin, target, twin, next, face));
        assert_eq!(h.next().prev(), h);
        assert_eq!(h.boundary().is_outer(), outer);
        assert_eq!(h.boundary().face(), h.face());
    }
    let of_edges: Vec<_> = dcel.edges().map(|h| (h.index(), h.twin().index())).collect();
    assert!(of_edges.is_sorted() && of_edges.iter().all(|(h, t)| h < t), "{of_edges:?}");
    let mut both: Vec<_> = dcel.edges().flat_map(|h| [h.key(), h.twin().key()]).collect();
    let mut all = half_edges.to_vec();
    both.sort_unstable();
    all.sort_unstable();
    assert_eq!(both, all);
}

/// A face, its outer boundary component, its list of inner ones, and the faces across its half-edges.
type Lists<'a> = (FaceKey, Option<BoundaryKey>, &'a [BoundaryKey], &'a [FaceKey]);

fn boundaries_and_faces(Drawn { dcel, vertices, half_edges, faces }: &Drawn) {
    let [.., p, q] = *vertices;
    let [ab, bc, ca, ba, cb, ac, l, l2, de, ed] = *half_edges;
    let [outside, triangle, inside] = *faces;
    let unbounded = dcel.unbounded_face();
    assert_eq!(unbounded.key(), outside);
    let boundary = |h: HalfEdgeKey| dcel.half_edge(h).unwrap().boundary().key();
    let isolated = |v: VertexKey| dcel.vertex(v).unwrap().isolated().unwrap().key();
    let cycles: [&[HalfEdgeKey]; 4] = [&[ab, bc, ca], &[cb, ba, ac, l2], &[l], &[de, ed]];
    for cycle in cycles {
        let found = dcel.boundary(boundary(cycle[0])).unwrap();
        assert_eq!(found.isolated_vertex(), None);
        assert_eq!(found.half_edges().next(), found.start());
        assert_eq!(from(cycle[0], found.half_edges().map(HalfEdge::key)), cycle);
        let backwards: Vec<_> = dcel.half_edge(cycle[0]).unwrap().boundary_cycle().rev().map(HalfEdge::key).collect();
        assert_eq!(backwards, cycle.iter().rev().copied().collect::<Vec<_>>());
    }
    for vertex in [p, q] {
        let found = dcel.boundary(isolated(vertex)).unwrap();
        assert_eq!((found.isolated_vertex().map(Vertex::key), found.start()), (Some(vertex), None));
        assert_eq!((found.half_edges().count(), found.is_outer()), (0, false));
    }
    let expected: [Lists<'_>; 3] = [
        (outside, None, &[boundary(cb), isolated(q)], &[triangle, triangle, triangle, inside]),
        (triangle, Some(boundary(ab)), &[boundary(de), isolated(p)], &[outside, outside, outside, triangle, triangle]),
        (inside, Some(boundary(l)), &[], &[outside]),
    ];
    for (key, outer, inner, neighbours) in expected {
        let face = dcel.face(key).unwrap();
        assert_eq!(face.is_unbounded(), key == outside);
        assert_eq!(face.outer().map(Boundary::key), outer);
        assert_eq!(face.outer_half_edge(), face.outer().and_then(Boundary::start));
        assert_eq!(face.inner().map(Boundary::key).collect::<Vec<_>>(), inner);
        assert_eq!(face.inner_count(), inner.len());
        let all: Vec<_> = outer.into_iter().chain(inner.iter().copied()).collect();
        assert_eq!(face.boundaries().map(Boundary::key).collect::<Vec<_>>(), all);
        assert!(face.boundaries().all(|boundary| boundary.face() == face));
        assert_eq!(face.half_edges().count(), neighbours.len());
        let mut across: Vec<_> = face.neighbours().map(Face::key).collect();
        assert_eq!(across, face.half_edges().map(|h| h.twin().face().key()).collect::<Vec<_>>());
        if face.is_unbounded() {
            across = from(inside, across);
            across.rotate_left(1);
        }
        assert_eq!(across, neighbours);
    }
}

fn counts_and_indices(Drawn { dcel, vertices, half_edges, faces }: &Drawn) {
    assert_eq!((dcel.vertex_count(), dcel.edge_count(), dcel.half_edge_count()), (7, 5, 10));
    assert_eq!((dcel.boundary_count(), dcel.face_count()), (6, 3));
    assert_eq!(dcel.vertices().count() + dcel.half_edges().count(), 17);
    assert_eq!(dcel.boundaries().count() + dcel.faces().count(), 9);
    assert!(vertices.iter().all(|key| dcel.vertices().any(|v| v.key() == *key)));
    assert!(half_edges.iter().all(|key| dcel.half_edges().any(|h| h.key() == *key)));
    assert!(faces.iter().all(|key| dcel.faces().any(|f| f.key() == *key)));
    assert!(dcel.vertices().all(|v| dcel.vertex_at(v.index()) == Some(v)));
    assert!(dcel.half_edges().all(|h| dcel.half_edge_at(h.index()) == Some(h)));
    assert!(dcel.boundaries().all(|b| dcel.boundary_at(b.index()) == Some(b)));
    assert!(dcel.faces().all(|f| dcel.face_at(f.index()) == Some(f)));
    assert!(dcel.vertices().all(|v| dcel.at(v.key()) == v && v.index() < dcel.vertex_slots()));
    assert!(dcel.half_edges().all(|h| dcel.at(h.key()) == h && h.index() < dcel.half_edge_slots()));
    assert!(dcel.boundaries().all(|b| dcel.at(b.key()) == b && b.index() < dcel.boundary_slots()));
    assert!(dcel.faces().all(|f| dcel.at(f.key()) == f && f.index() < dcel.face_slots()));
    assert_eq!(dcel.vertex_at(usize::MAX), None);
    assert_eq!(dcel.half_edge_at(usize::MAX), None);
    assert_eq!(dcel.boundary_at(usize::MAX), None);
    assert_eq!(dcel.face_at(usize::MAX), None);
    assert!(validate_plane(&dcel).is_valid());
}

fn of_one_structure(Drawn { dcel, vertices, .. }: &Drawn) {
    let copy = dcel.clone();
    assert!(copy == *dcel && Dcel::default() != copy);
    let (here, there) = (dcel.vertex(vertices[0]).unwrap(), copy.vertex(vertices[0]).unwrap());
    assert_eq!((here.key(), here.index()), (there.key(), there.index()));
    assert_ne!(here, there, "elements of two structures are not the same, whatever their keys");
    assert_ne!(here, dcel.vertex(vertices[1]).unwrap());
    assert_eq!(format!("{here:?}"), format!("{:?}", here.key()));
}

#[test]
fn elements_of_a_drawn_structure() {
    let drawn = draw();
    vertices(&drawn);
    half_edges(&drawn);
    boundaries_and_faces(&drawn);
    counts_and_indices(&drawn);
    of_one_structure(&drawn);
}
