//! A mesh as in OpenMesh: half-edges `2e` and `2e + 1` are twins and store their *target*; border half-edges have a next
//! but no face; a vertex stores a leaving half-edge.

use super::{Stored, each_change, holds, judged, mirrored, open_tetrahedron, other_side};
use crate::support::erased::validate;
use crate::support::tables::TEXTBOOK;
use twinedge::validate::adapt::Targets;
use twinedge::validate::{Collect, Expectation, FaceRow, Link, Part, Parts, Table, VertexRow, View};
use twinedge::view_answers;

#[derive(Clone)]
struct HalfEdge {
    to_vertex: Link,
    next: Link,
    face: Link,
}

#[derive(Clone)]
struct OpenMesh {
    vertices: Vec<Link>,
    half_edges: Vec<HalfEdge>,
    faces: Vec<Link>,
}

impl OpenMesh {
    fn view(&self) -> impl View {
        Targets::of(self, |h| self.half_edges[h].to_vertex).unwrap()
    }
}

impl View for OpenMesh {
    view_answers! { |mesh|
        parts => Parts::NONE.with(Part::Faces).with(Part::Leaving),
        vertex_slots => mesh.vertices.len(),
        half_edge_slots => mesh.half_edges.len(),
        face_slots => mesh.faces.len(),
        origin(_h) => None,
        twin(h) => Some(h ^ 1),
        next(h) => mesh.half_edges[h].next,
        face(h) => mesh.half_edges[h].face,
        leaving(v) => mesh.vertices[v],
        outer_half_edge(f) => mesh.faces[f],
    }
}

const EXPECTATION: Expectation = Expectation::surface().open();

fn sound() -> OpenMesh {
    let table = open_tetrahedron();
    let origin = |h: usize| table.half_edges[h].unwrap().origin;
    let half_edges = table.half_edges.iter().flatten().enumerate();
    OpenMesh {
        vertices: table.vertices.iter().flatten().map(|row| row.leaving).collect(),
        half_edges: half_edges
            .map(|(h, row)| HalfEdge { to_vertex: origin(h ^ 1), next: row.next, face: row.face })
            .collect(),
        faces: table.faces.iter().flatten().map(|row| row.outer_half_edge).collect(),
    }
}

#[test]
fn validating_a_mesh_like_those_of_openmesh() {
    let report = validate(&sound().view(), &EXPECTATION, Collect::All);
    assert_eq!(report.into_result().unwrap().cycles, 3);
}

fn links(mesh: &mut OpenMesh) -> Vec<Stored<'_>> {
    let [vertices, half_edges, faces] = [mesh.vertices.len(), mesh.half_edges.len(), mesh.faces.len()];
    let mut links: Vec<Stored<'_>> =
        mesh.vertices.iter_mut().chain(&mut mesh.faces).map(|link| (link, half_edges)).collect();
    for HalfEdge { to_vertex, next, face } in &mut mesh.half_edges {
        links.extend([(to_vertex, vertices), (next, half_edges), (face, faces)]);
    }
    links
}

/// The mirror image. Its `next` is the inverse of the mesh's; if there is no inverse, there is no table.
fn table(mesh: &OpenMesh) -> Table {
    let n = mesh.half_edges.len();
    let prev = |h: usize| mesh.half_edges.iter().position(|other| other.next == Some(h));
    let row = |(h, half_edge): (usize, &HalfEdge)| {
        let mut row = mirrored(half_edge.to_vertex, [Some(h ^ 1), half_edge.next, prev(h)]);
        row.face = half_edge.face;
        Some(row)
    };
    // A leaving half-edge arrives in the mirror image.
    let leaving = |h: &Link| Some(VertexRow { leaving: other_side(*h, n), isolated: None });
    let face = |h: &Link| Some(FaceRow { outer_half_edge: *h, ..FaceRow::default() });
    Table {
        parts: TEXTBOOK,
        vertices: mesh.vertices.iter().map(leaving).collect(),
        half_edges: mesh.half_edges.iter().enumerate().map(row).collect(),
        faces: mesh.faces.iter().map(face).collect(),
        ..Table::default()
    }
}

#[test]
fn no_fault_of_such_a_mesh_is_hidden() {
    let verdict = |mesh: &OpenMesh| judged(&mesh.view(), EXPECTATION);
    let found = each_change(&sound(), links, verdict, |mesh| holds(&table(mesh), EXPECTATION));
    // Another half-edge of the same vertex (4 of degree 3) or face (3 triangles) is equally valid.
    assert_eq!((found.all, found.accepted), (398, 4 * 2 + 3 * 2));
}
