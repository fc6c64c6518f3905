//! `tri-mesh` 0.6.1.

use crate::{breaks, panics, still};
use three_d_asset::{Indices, Positions, TriMesh};
use tri_mesh::{HalfEdgeID, Mesh, VertexID, vec3};
use twinedge_peers::crates::tri_mesh::MeshView;

/// A mesh on points with no three collinear.
fn mesh(n: u32, faces: &[[u32; 3]]) -> Mesh {
    let points = (0..n).map(f64::from).map(|t| vec3(t, t * t, t * t * t)).collect();
    let mesh = Mesh::new(&TriMesh {
        positions: Positions::F64(points),
        indices: Indices::U32(faces.concat()),
        ..Default::default()
    });
    assert!(MeshView::new(&mesh).report().is_valid());
    mesh
}

fn leaving(mesh: &Mesh, v: VertexID) -> usize {
    let starts = |h: &HalfEdgeID| mesh.walker_from_halfedge(*h).into_twin().vertex_id() == Some(v);
    mesh.halfedge_iter().filter(starts).count()
}

/// Two triangles back to back form a closed mesh. "Returns an error if […] the flip will connect two vertices that are
/// already connected": here it connects a vertex with itself, and returns `Ok`. The next split breaks the twins.
#[test]
fn flip_edge_makes_a_loop() {
    let mut mesh = mesh(3, &[[0, 1, 2], [0, 2, 1]]);
    let h = mesh.halfedge_iter().next().unwrap();
    still("T1", mesh.flip_edge(h).is_ok());
    let (a, b) = mesh.edge_vertices(h);
    still("T1", a == b);
    let face = mesh.face_iter().next().unwrap();
    mesh.split_face(face, vec3(1.0, 0.0, 5.0));
    breaks("T1", &MeshView::new(&mesh).report(), "L1");
    let twin = |h: HalfEdgeID| mesh.walker_from_halfedge(h).twin_id();
    still("T1", mesh.halfedge_iter().any(|h| twin(h).and_then(twin) != Some(h)));
}

/// A face between two others at a vertex is removed. The documentation of `vertex_halfedge_iter` mentions vertices that are
/// "the only connection between two or more separate sets of faces"; `connecting_edge` then misses edges, and `add_face`
/// would add them again.
#[test]
fn remove_face_leaves_two_fans_at_a_vertex() {
    let mut mesh = mesh(5, &[[0, 1, 2], [0, 2, 3], [0, 3, 4]]);
    let v = mesh.vertex_iter().next().unwrap();
    let face = mesh.face_iter().nth(1).unwrap();
    mesh.remove_face(face);
    breaks("T2", &MeshView::new(&mesh).report(), "V2");
    still("T2", mesh.vertex_halfedge_iter(v).count() < leaving(&mesh, v));
    let neighbours = mesh.vertex_iter().filter(|other| mesh.connecting_edge(v, *other).is_some()).count();
    still("T2", neighbours == 2 && leaving(&mesh, v) == 4);
    // The crate's own check, for development only, refuses.
    still("T2", mesh.is_valid().is_err());
}

/// Outside the documentation, which warns that a collapse "might […] produce edges and vertices that are not connected":
/// the two triangles of a square are collapsed along a border edge and then along the next. `split_edge` panics.
#[test]
fn split_edge_panics_after_a_collapse_that_left_an_edge_without_face() {
    let mut mesh = mesh(4, &[[0, 1, 2], [2, 1, 3]]);
    let nth = |mesh: &Mesh, n: usize| mesh.halfedge_iter().nth(n).unwrap();
    let h = nth(&mesh, 1);
    mesh.collapse_edge(h);
    let h = nth(&mesh, 0);
    mesh.collapse_edge(h);
    let h = nth(&mesh, 0);
    panics("T3", "tri-mesh-0.6.1/src/mesh/edit.rs", "on a `None` value", || mesh.split_edge(h, vec3(0.0, 0.0, 1.0)));
}
