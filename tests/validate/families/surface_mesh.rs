//! A mesh as in `CGAL::Surface_mesh`: half-edges `2e` and `2e + 1` are twins and store their *target*; border half-edges
//! have next and prev but no face; a vertex stores a half-edge that *arrives* at it.

use super::{Stored, each_change, holds, judged, mirrored, open_tetrahedron, other_side};
use crate::support::erased::validate;
use crate::support::tables::TEXTBOOK;
use twinedge::validate::adapt::Targets;
use twinedge::validate::{Collect, Expectation, FaceRow, Link, Part, Parts, Rule, Table, VertexRow, View};
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
    arriving: Vec<Link>,
    half_edges: Vec<Connectivity>,
    faces: Vec<Link>,
}

impl SurfaceMesh {
    fn view(&self) -> impl View {
        Targets::of(self, |h| self.half_edges[h].target).unwrap()
    }
}

impl View for SurfaceMesh {
    view_answers! { |mesh|
        parts => Parts::NONE.with(Part::Prev).with(Part::Leaving).with(Part::Faces),
        vertex_slots => mesh.arriving.len(),
        half_edge_slots => mesh.half_edges.len(),
        face_slots => mesh.faces.len(),
        origin(_h) => None,
        twin(h) => Some(h ^ 1),
        next(h) => mesh.half_edges[h].next,
        prev(h) => mesh.half_edges[h].prev,
        face(h) => mesh.half_edges[h].face,
        leaving(v) => other_side(mesh.arriving[v], mesh.half_edges.len()),
        outer_half_edge(f) => mesh.faces[f],
    }
}

const EXPECTATION: Expectation = Expectation::surface().open();

fn sound() -> SurfaceMesh {
    let table = open_tetrahedron();
    let origin = |h: usize| table.half_edges[h].unwrap().origin;
    let half_edges = table.half_edges.iter().flatten().enumerate();
    SurfaceMesh {
        arriving: table.vertices.iter().flatten().map(|row| row.leaving.map(|h| h ^ 1)).collect(),
        half_edges: half_edges
            .map(|(h, row)| Connectivity { target: origin(h ^ 1), next: row.next, prev: row.prev, face: row.face })
            .collect(),
        faces: table.faces.iter().flatten().map(|row| row.outer_half_edge).collect(),
    }
}

#[test]
fn validating_a_mesh_like_those_of_cgal() {
    let report = validate(&sound().view(), &EXPECTATION, Collect::All);
    assert_eq!(report.into_result().unwrap().cycles, 3);
}

fn links(mesh: &mut SurfaceMesh) -> Vec<Stored<'_>> {
    let [vertices, half_edges, faces] = [mesh.arriving.len(), mesh.half_edges.len(), mesh.faces.len()];
    let mut links: Vec<Stored<'_>> =
        mesh.arriving.iter_mut().chain(&mut mesh.faces).map(|link| (link, half_edges)).collect();
    for Connectivity { target, next, prev, face } in &mut mesh.half_edges {
        links.extend([(target, vertices), (next, half_edges), (prev, half_edges), (face, faces)]);
    }
    links
}

fn table(mesh: &SurfaceMesh) -> Table {
    let row = |(h, half_edge): (usize, &Connectivity)| {
        let mut row = mirrored(half_edge.target, [Some(h ^ 1), half_edge.next, half_edge.prev]);
        row.face = half_edge.face;
        Some(row)
    };
    let face = |h: &Link| Some(FaceRow { outer_half_edge: *h, ..FaceRow::default() });
    Table {
        parts: TEXTBOOK,
        // An arriving half-edge leaves the vertex in the mirror image.
        vertices: mesh.arriving.iter().map(|h| Some(VertexRow { leaving: *h, isolated: None })).collect(),
        half_edges: mesh.half_edges.iter().enumerate().map(row).collect(),
        faces: mesh.faces.iter().map(face).collect(),
        ..Table::default()
    }
}

#[test]
fn no_fault_of_such_a_mesh_is_hidden() {
    let verdict = |mesh: &SurfaceMesh| judged(&mesh.view(), EXPECTATION);
    let found = each_change(&sound(), links, verdict, |mesh| holds(&table(mesh), EXPECTATION));
    assert_eq!((found.all, found.accepted), (566, 4 * 2 + 3 * 2));
}

/// L3 alone reports each wrong target, at its half-edge, and a swap of two `next` links together with `prev`.
#[test]
fn l3_compares_two_stored_facts() {
    let broken = |mesh: &SurfaceMesh| {
        let report = judged(&mesh.view(), EXPECTATION);
        let at = report.first().and_then(|violation| violation.records().into_iter().flatten().next());
        (report.broken_rules().next(), at.map(|record| record.index()))
    };
    let n = sound().half_edges.len();
    for h in 0..n {
        for wrong in (0..4).map(Some) {
            let mut mesh = sound();
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
        let mut mesh = sound();
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
