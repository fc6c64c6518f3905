//! `dcel` 0.8.14, with its feature `stable-vec`.

use crate::{breaks, panics, still};
use dcel::{EdgeId, FaceId, HalfEdgeId, StableDcel, VertexId};
use twinedge_peers::crates::PEERS;
use twinedge_peers::crates::dcel::DcelView;
use twinedge_peers::judge::Judge;
use twinedge_peers::program::Program;
use twinedge_peers::run::Verdict;

type Dcel = StableDcel<u32>;

fn square() -> Dcel {
    let mut dcel = Dcel::new();
    dcel.insert_mesh([[0, 1, 2, 3]]);
    assert!(DcelView::new(&dcel).report().is_valid());
    dcel
}

/// Two squares with half-edges 2 and 3 as their common edge.
fn two_squares() -> Dcel {
    let mut dcel = Dcel::new();
    dcel.insert_mesh([[0, 1, 4, 3], [1, 2, 5, 4]]);
    assert!(DcelView::new(&dcel).report().is_valid());
    dcel
}

fn edge(dcel: &Dcel, h: usize) -> EdgeId {
    dcel.full_edge(HalfEdgeId::new(h))
}

fn is_live(dcel: &Dcel, h: HalfEdgeId) -> bool {
    dcel.half_edges().has_element_at(h.id())
}

/// "Insert a polygon": the outer sides are linked in the wrong direction. The target of a half-edge is "the same as the
/// source vertex of the next half-edge", but here it is not the source of its twin.
#[test]
fn insert_polygon_links_the_outer_sides_backwards() {
    let mut dcel = Dcel::new();
    dcel.insert_polygon([0, 1, 2]);
    breaks("D1", &DcelView::new(&dcel).report(), "L3");
    let h = HalfEdgeId::new(1);
    still("D1", dcel.target(h) != dcel.source(dcel.twin(h)));

    let mut dcel = square();
    let hole = dcel.insert_polygon_in_face(FaceId::new(1), [4, 5, 6]);
    let h = dcel.twin(dcel.face_representative(hole).unwrap());
    still("D1", dcel.target(h) != dcel.source(dcel.twin(h)));
}

/// "Remove an edge, merging the faces separated by it." This removes the unbounded face, which "is always the first element
/// of the face list" and whose "presence is an invariant of the structure".
#[test]
fn remove_edge_removes_the_unbounded_face() {
    let mut dcel = square();
    dcel.remove_edge(edge(&dcel, 0));
    breaks("D2", &DcelView::new(&dcel).report(), "F1");
    still("D2", !dcel.faces().has_element_at(dcel.unbounded_face().id()));
}

/// With another component, whose half-edges still name the removed face.
#[test]
fn remove_edge_leaves_other_components_in_a_face_that_is_gone() {
    let mut dcel = square();
    dcel.insert_mesh([[4, 5, 6, 7]]);
    dcel.remove_edge(edge(&dcel, 0));
    breaks("D2", &DcelView::new(&dcel).report(), "R1");
    still("D2", !dcel.faces().has_element_at(dcel.incident_face(HalfEdgeId::new(9)).id()));
}

/// "Remove a face along with its edges and vertices." Removing a face at the outside also removes the unbounded face.
#[test]
fn remove_face_removes_the_unbounded_face() {
    let mut dcel = two_squares();
    dcel.remove_face(FaceId::new(1));
    breaks("D3", &DcelView::new(&dcel).report(), "F1");
    still("D3", !dcel.faces().has_element_at(dcel.unbounded_face().id()));
}

#[test]
fn remove_face_panics_on_the_only_face() {
    let mut dcel = square();
    panics("D4", "dcel-0.8.14/src/merge.rs", "on a `None` value", || dcel.remove_face(FaceId::new(1)));
}

/// "Merge a contiguous set of faces into one": the sides of the merged face are linked in the order of their numbers.
#[test]
fn merge_faces_links_the_perimeter_in_the_order_of_ids() {
    let mut dcel = two_squares();
    dcel.merge_faces([FaceId::new(1), FaceId::new(2)]);
    breaks("D5", &DcelView::new(&dcel).report(), "L3");
    let h = HalfEdgeId::new(0);
    still("D5", dcel.target(h) != dcel.source(dcel.twin(h)));
}

/// "Remove a degree-2 vertex, merging its incident edges into one": the merged edge still starts at the vertex.
#[test]
fn smoothen_vertex_leaves_an_edge_at_the_vertex_that_is_gone() {
    let mut dcel = square();
    let v = VertexId::new(0);
    dcel.smoothen_vertex(v);
    breaks("D6", &DcelView::new(&dcel).report(), "R1");
    let of_removed = |h: &usize| dcel.source(HalfEdgeId::new(*h)) == v;
    still("D6", !dcel.vertices().has_element_at(0) && dcel.half_edges().indices().any(|h| of_removed(&h)));
}

/// "Remove a degree-2 vertex together with its incident edges, merging all of its incident faces into one".
#[test]
fn merge_faces_around_vertex_leaves_links_to_the_edges_that_are_gone() {
    let mut dcel = square();
    dcel.merge_faces_around_vertex(VertexId::new(0));
    breaks("D7", &DcelView::new(&dcel).report(), "R1");
    let prev = |h: usize| dcel.prev(HalfEdgeId::new(h));
    still("D7", dcel.half_edges().indices().any(|h| !is_live(&dcel, prev(h))));
}

/// "Insert an edge between two vertices, splitting a face in two": if they are already joined, `prev` and `next` disagree.
#[test]
fn insert_edge_beside_an_edge_breaks_next_and_prev() {
    let mut dcel = square();
    dcel.insert_edge(VertexId::new(0), VertexId::new(1));
    breaks("D8", &DcelView::new(&dcel).report(), "L2");
    let h = HalfEdgeId::new(8);
    still("D8", dcel.prev(dcel.next(h)) != h);
}

/// "Insert an edge chain between two vertices": also broken, although no edges would be parallel.
#[test]
fn insert_edge_chain_beside_an_edge_breaks_next_and_prev() {
    let mut dcel = square();
    dcel.insert_edge_chain(VertexId::new(0), VertexId::new(1), [4]);
    breaks("D8", &DcelView::new(&dcel).report(), "L2");
    let disagree = |h: HalfEdgeId| dcel.prev(dcel.next(h)) != h;
    still("D8", dcel.half_edges().indices().map(HalfEdgeId::new).any(disagree));
}

/// "Partition a face into triangles by connecting an existing vertex to all of the face's boundary vertices": the vertex is
/// also connected to itself, and not all edges are in its rotation.
#[test]
fn fan_triangulate_connects_the_apex_to_itself() {
    let mut dcel = square();
    let v = VertexId::new(0);
    let (edges, _) = dcel.fan_triangulate(FaceId::new(1), v);
    breaks("D9", &DcelView::new(&dcel).report(), "V2");
    still("D9", edges.iter().any(|edge| dcel.edge_endpoints(*edge) == (v, v)));
    let leaving = dcel.half_edges().indices().filter(|h| dcel.source(HalfEdgeId::new(*h)) == v).count();
    still("D9", dcel.vertex_half_spokes(v).count() < leaving);
}

/// "Split an edge by inserting a new vertex on it": fails if one end of the edge is a dead end.
#[test]
fn split_edge_by_vertex_breaks_an_edge_with_a_dead_end() {
    let mut dcel = square();
    dcel.split_face_by_edge(VertexId::new(1), VertexId::new(3), dcel.unbounded_face());
    dcel.remove_edge(edge(&dcel, 6));
    assert!(DcelView::new(&dcel).report().is_valid());
    dcel.split_edge_by_vertex(edge(&dcel, 0), 4);
    breaks("D10", &DcelView::new(&dcel).report(), "L2");
    let h = HalfEdgeId::new(10);
    still("D10", dcel.prev(dcel.next(h)) != h);
}

/// "Split a face by inserting an edge between two of its boundary vertices": fails if the boundary passes one of them
/// twice.
#[test]
fn split_face_by_edge_breaks_at_a_vertex_that_the_boundary_passes_twice() {
    let mut dcel = Dcel::new();
    dcel.insert_mesh([[0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6]]);
    dcel.split_face_by_edge(VertexId::new(7), VertexId::new(1), dcel.unbounded_face());
    dcel.remove_edge(edge(&dcel, 14));
    assert!(DcelView::new(&dcel).report().is_valid());
    let face = FaceId::new(3);
    let boundary = dcel.face_vertices(face).map(VertexId::id).collect::<Vec<_>>();
    assert_eq!(boundary.iter().filter(|v| **v == 7).count(), 2);
    dcel.split_face_by_edge(VertexId::new(5), VertexId::new(7), face);
    breaks("D11", &DcelView::new(&dcel).report(), "L2");
    let disagree = |h: HalfEdgeId| dcel.prev(dcel.next(h)) != h;
    still("D11", dcel.half_edges().indices().map(HalfEdgeId::new).any(disagree));
}

/// Outside the documentation, which requires a degree-2 vertex (the crate's own tests use degree 3): this call does not
/// return.
#[test]
fn merge_faces_around_a_vertex_of_higher_degree_does_not_return() {
    let entry = PEERS.iter().find(|entry| entry.name == "dcel").unwrap();
    let program = "insert_mesh 1 0; split_face_by_edge 1 4; merge_faces_around_inner_vertex 0; \
                   merge_faces_around_inner_vertex 1";
    let program = Program::parse(program, entry.operators).unwrap();
    let mut judge = Judge::new(*entry, env!("CARGO_BIN_EXE_twinedge-peers").into());
    let Verdict::Finding(finding) = judge.run(&program).unwrap() else { panic!("D12: {}", crate::MENDED) };
    still("D12", matches!(finding.what.as_str(), "does not return" | "ends the process"));
}
