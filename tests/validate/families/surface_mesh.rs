//! A mesh as in `CGAL::Surface_mesh` and in OpenMesh: half-edges `2e` and `2e + 1` are twins and store their *target*; border
//! half-edges have a next but no face. CGAL stores prev too, and at a vertex a half-edge that *arrives* at it; OpenMesh
//! stores no prev, and a half-edge that leaves.

use super::{Stored, each_change, holds, judged, mirrored, open_tetrahedron, other_side};
use crate::support::tables::TEXTBOOK;
use twinedge::validate::adapt::Targets;
use twinedge::validate::{Expectation, FaceRow, Link, Part, Parts, Rule, Table, VertexRow, View};
use twinedge::view_answers;

#[derive(Clone)]
struct Connectivity {
    target: Link,
    next: Link,
    prev: Link,
    face: Link,
}

#[derive(Clone)]
struct SurfaceMesh {
    /// As in OpenMesh, and not as in CGAL.
    open_mesh: bool,
    vertices: Vec<Link>,
    half_edges: Vec<Connectivity>,
    faces: Vec<Link>,
}

impl SurfaceMesh {
    fn view(&self) -> impl View {
        Targets::of(self, |h| self.half_edges[h].target).unwrap()
    }

    /// The half-edge of a vertex if it is to leave the vertex, or to arrive there.
    fn at(&self, v: usize, leaving: bool) -> Link {
        let stored = self.vertices[v];
        if leaving == self.open_mesh { stored } else { other_side(stored, self.half_edges.len()) }
    }
}

impl View for SurfaceMesh {
    view_answers! { |mesh|
        parts => {
            let parts = Parts::NONE.with(Part::Leaving).with(Part::Faces);
            if mesh.open_mesh { parts } else { parts.with(Part::Prev) }
        },
        vertex_slots => mesh.vertices.len(),
        half_edge_slots => mesh.half_edges.len(),
        face_slots => mesh.faces.len(),
        origin(_h) => None,
        twin(h) => Some(h ^ 1),
        next(h) => mesh.half_edges[h].next,
        prev(h) => mesh.half_edges[h].prev,
        face(h) => mesh.half_edges[h].face,
        leaving(v) => mesh.at(v, true),
        outer_half_edge(f) => mesh.faces[f],
    }
}

const EXPECTATION: Expectation = Expectation::surface().open();

fn sound(open_mesh: bool) -> SurfaceMesh {
    let table = open_tetrahedron();
    let half_edges = table.half_edges.iter().flatten().enumerate();
    let connectivity = |(h, row): (usize, &twinedge::validate::HalfEdgeRow)| Connectivity {
        target: table.half_edges[h ^ 1].unwrap().origin,
        next: row.next,
        prev: row.prev,
        face: row.face,
    };
    let leaving = table.vertices.iter().flatten().map(|row| row.leaving);
    SurfaceMesh {
        open_mesh,
        vertices: leaving.map(|h| if open_mesh { h } else { h.map(|h| h ^ 1) }).collect(),
        half_edges: half_edges.map(connectivity).collect(),
        faces: table.faces.iter().flatten().map(|row| row.outer_half_edge).collect(),
    }
}

fn links(mesh: &mut SurfaceMesh) -> Vec<Stored<'_>> {
    let [vertices, half_edges, faces] = [mesh.vertices.len(), mesh.half_edges.len(), mesh.faces.len()];
    let mut links: Vec<Stored<'_>> =
        mesh.vertices.iter_mut().chain(&mut mesh.faces).map(|link| (link, half_edges)).collect();
    for Connectivity { target, next, prev, face } in &mut mesh.half_edges {
        links.extend([(target, vertices), (next, half_edges), (face, faces)]);
        if !mesh.open_mesh {
            links.push((prev, half_edges));
        }
    }
    links
}

/// The mirror image. Its `next` is the prev of the mesh, or else the inverse of the mesh's `next`; if there is no inverse,
/// there is no table.
fn table(mesh: &SurfaceMesh) -> Table {
    let row = |(h, half_edge): (usize, &Connectivity)| {
        let inverse = || mesh.half_edges.iter().position(|other| other.next == Some(h));
        let prev = if mesh.open_mesh { inverse() } else { half_edge.prev };
        let mut row = mirrored(half_edge.target, [Some(h ^ 1), half_edge.next, prev]);
        row.face = half_edge.face;
        Some(row)
    };
    let face = |h: &Link| Some(FaceRow { outer_half_edge: *h, ..FaceRow::default() });
    // An arriving half-edge leaves the vertex in the mirror image.
    let vertex = |v: usize| Some(VertexRow { leaving: mesh.at(v, false), isolated: None });
    Table {
        parts: TEXTBOOK,
        vertices: (0..mesh.vertices.len()).map(vertex).collect(),
        half_edges: mesh.half_edges.iter().enumerate().map(row).collect(),
        faces: mesh.faces.iter().map(face).collect(),
        ..Table::default()
    }
}

#[test]
fn no_fault_of_such_a_mesh_is_hidden() {
    for (open_mesh, changes) in [(false, 566), (true, 398)] {
        let verdict = |mesh: &SurfaceMesh| judged(&mesh.view(), EXPECTATION);
        let found = each_change(&sound(open_mesh), links, verdict, |mesh| holds(&table(mesh), EXPECTATION));
        // Another half-edge of the same vertex (4 of degree 3) or face (3 triangles) is equally valid.
        assert_eq!((found.all, found.accepted), (changes, 4 * 2 + 3 * 2));
    }
}

/// L3 alone reports each wrong target, at its half-edge, and a swap of two `next` links together with `prev`.
#[test]
fn l3_compares_two_stored_facts() {
    let broken = |mesh: &SurfaceMesh| {
        let report = judged(&mesh.view(), EXPECTATION);
        let at = report.first().and_then(|violation| violation.records().into_iter().flatten().next());
        (report.broken_rules().next(), at.map(|record| record.index()))
    };
    let sound = sound(false);
    let n = sound.half_edges.len();
    for h in 0..n {
        for wrong in (0..4).map(Some) {
            let mut mesh = sound.clone();
            if std::mem::replace(&mut mesh.half_edges[h].target, wrong) != wrong {
                let (rule, at) = broken(&mesh);
                assert_eq!(rule, Some(Rule::L3));
                // Compared with the previous and the next one around the vertex.
                let before = mesh.half_edges[h ^ 1].prev;
                assert!(at == Some(h) || at == before, "{h}: {at:?}");
            }
        }
    }
    let mut swaps = 0;
    for (g, h) in (0..n).flat_map(|g| (0..g).map(move |h| (g, h))) {
        let mut mesh = sound.clone();
        if mesh.half_edges[g].target == mesh.half_edges[h].target {
            continue;
        }
        let (after_g, after_h) = (mesh.half_edges[g].next.unwrap(), mesh.half_edges[h].next.unwrap());
        (mesh.half_edges[g].next, mesh.half_edges[h].next) = (Some(after_h), Some(after_g));
        (mesh.half_edges[after_h].prev, mesh.half_edges[after_g].prev) = (Some(g), Some(h));
        assert_eq!(broken(&mesh), (Some(Rule::L3), Some(h)));
        swaps += 1;
    }
    // Of the pairs of 12 half-edges, 4 times 3 arrive at one vertex.
    assert_eq!(swaps, 66 - 12);
}
