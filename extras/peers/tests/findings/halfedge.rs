//! `halfedge` 0.3.0.

use crate::{breaks, still};
use halfedge::{
    HalfEdgeId, MeshStorage, VertexId, add_triangle, build_mesh_from_vertices_and_faces, collapse_edge,
    detect_nonmanifold_vertices, remove_face, split_edge, split_face, validate_topology,
};
use twinedge_peers::crates::halfedge::report;

/// A mesh on points with no three collinear.
fn mesh(n: u32, faces: &[[u32; 3]]) -> MeshStorage {
    let points = (0..n).map(f64::from).map(|t| [t, t * t, t * t * t]).collect::<Vec<_>>();
    build_mesh_from_vertices_and_faces(&points, faces).unwrap()
}

fn tetrahedron() -> MeshStorage {
    let mesh = mesh(4, &[[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]]);
    assert!(report(&mesh).is_valid());
    mesh
}

/// Two triangles with a common edge.
fn square() -> MeshStorage {
    let mesh = mesh(4, &[[0, 1, 2], [2, 1, 3]]);
    assert!(report(&mesh).is_valid());
    mesh
}

/// The target of the twin: the origin of a half-edge.
fn origin(mesh: &MeshStorage, h: HalfEdgeId) -> Option<VertexId> {
    Some(mesh.get_halfedge(mesh.get_halfedge(h)?.twin?)?.vertex)
}

/// "Splits one triangle into three": the new edges are paired within each new triangle, not across them. The call
/// returns `Ok`, and the crate's own validator accepts.
#[test]
fn split_face_pairs_the_wrong_twins() {
    let mut mesh = tetrahedron();
    let face = mesh.face_ids().nth(2).unwrap();
    let center = split_face(&mut mesh, face).unwrap();
    breaks("H1", &report(&mesh), "L3");
    let jumps = |h: HalfEdgeId| {
        let record = mesh.get_halfedge(h).unwrap();
        origin(&mesh, record.next.unwrap()) != Some(record.vertex)
    };
    still("H1", mesh.halfedge_ids().any(jumps));
    // Three edges leave the new vertex, but a walk around it finds one.
    still("H1", halfedge::traversal::VertexRing::new(&mesh, center).count() == 1);
    still("H1", validate_topology(&mesh).is_empty());
}

/// The call removes the half-edges of the face, but vertices still store them.
#[test]
fn split_face_leaves_vertices_with_half_edges_that_are_gone() {
    let mut mesh = tetrahedron();
    let face = mesh.face_ids().next().unwrap();
    split_face(&mut mesh, face).unwrap();
    breaks("H2", &report(&mesh), "R1");
    let kept = |v: VertexId| mesh.get_vertex(v).unwrap().halfedge;
    still("H2", mesh.vertex_ids().any(|v| kept(v).is_some_and(|h| !mesh.contains_halfedge(h))));
}

/// On a mesh whose border was closed by the builder, the removed border half-edge stays in `next` and `prev` of its
/// neighbours. An error is returned, as documented for an invalid outcome, but the triangle could validly be added.
#[test]
fn add_triangle_leaves_links_to_the_border_that_is_gone() {
    let mut mesh = square();
    let v = mesh.vertex_ids().collect::<Vec<_>>();
    let result = add_triangle(&mut mesh, v[2], v[3], v[0]);
    breaks("H3", &report(&mesh), "R1");
    still("H3", mesh.halfedges().any(|h| [h.next, h.prev].into_iter().flatten().any(|h| !mesh.contains_halfedge(h))));
    still("H3", result.is_err());
}

/// "Half-edges of the border get no next and prev": but existing links stay.
#[test]
fn remove_face_leaves_links_to_the_border_that_is_gone() {
    let mut mesh = square();
    let face = mesh.face_ids().next().unwrap();
    remove_face(&mut mesh, face).unwrap();
    breaks("H4", &report(&mesh), "R1");
    still("H4", mesh.halfedges().any(|h| [h.next, h.prev].into_iter().flatten().any(|h| !mesh.contains_halfedge(h))));
}

/// Two opposite faces of four at a vertex are removed. "The outgoing half-edges of each vertex are a closed ring, or an
/// open chain": there are two chains, and the validator that promises to check this accepts.
#[test]
fn remove_face_leaves_two_fans_and_the_validator_accepts() {
    let octahedron = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
    let mut mesh = mesh(6, &octahedron);
    let faces = mesh.face_ids().collect::<Vec<_>>();
    let top = mesh.vertex_ids().nth(4).unwrap();
    remove_face(&mut mesh, faces[0]).unwrap();
    remove_face(&mut mesh, faces[2]).unwrap();
    breaks("H5", &report(&mesh), "V2");
    let leaving = mesh.halfedge_ids().filter(|h| origin(&mesh, *h) == Some(top)).count();
    still("H5", halfedge::traversal::VertexRing::new(&mesh, top).count() < leaving);
    still("H5", validate_topology(&mesh).is_empty());
}

/// Also for a list of two triangles that share only a vertex.
#[test]
fn the_validator_accepts_two_triangles_at_one_vertex() {
    let mesh = mesh(5, &[[2, 0, 1], [4, 3, 0]]);
    breaks("H6", &report(&mesh), "V2");
    still("H6", validate_topology(&mesh).is_empty());
    still("H6", detect_nonmanifold_vertices(&mesh).is_empty());
}

/// Edges of a tetrahedron, collapsed and split in turn; every call returns `Ok`.
#[test]
fn collapse_and_split_leave_links_to_half_edges_that_are_gone() {
    let mut mesh = tetrahedron();
    let nth = |mesh: &MeshStorage, n: usize| mesh.halfedge_ids().nth(n).unwrap();
    for _ in 0..2 {
        let h = nth(&mesh, 1);
        collapse_edge(&mut mesh, h).unwrap();
        assert!(report(&mesh).is_valid());
        let h = nth(&mesh, 0);
        split_edge(&mut mesh, h).unwrap();
    }
    breaks("H7", &report(&mesh), "R1");
    still("H7", mesh.halfedges().any(|h| [h.next, h.prev].into_iter().flatten().any(|h| !mesh.contains_halfedge(h))));
}
