//! A mesh with keys, as in tri-mesh: half-edges store their *target*; border half-edges have neither next nor face; a vertex
//! stores a leaving half-edge.

use super::{Stored, each_change, holds, judged, open_tetrahedron};
use crate::support::erased::validate;
use std::collections::BTreeMap;
use twinedge::validate::adapt::{Borders, Index, Targets};
use twinedge::validate::{
    Collect, Expectation, FaceRow, HalfEdgeRow, Link, Part, Parts, Record, Table, VertexRow, View,
};
use twinedge::view_answers;

#[derive(Clone)]
struct HalfEdge {
    vertex: Option<usize>,
    twin: Option<usize>,
    next: Option<usize>,
    face: Option<usize>,
}

/// Records by key.
#[derive(Clone)]
struct KeyedMesh {
    vertices: BTreeMap<usize, Option<usize>>,
    half_edges: BTreeMap<usize, HalfEdge>,
    faces: BTreeMap<usize, Option<usize>>,
}

struct MeshView<'a> {
    mesh: &'a KeyedMesh,
    vertices: Index<usize>,
    half_edges: Index<usize>,
    faces: Index<usize>,
}

impl<'a> MeshView<'a> {
    fn of(mesh: &'a KeyedMesh) -> Self {
        let vertices = Index::of(mesh.vertices.keys().copied());
        let half_edges = Index::of(mesh.half_edges.keys().copied());
        Self { mesh, vertices, half_edges, faces: Index::of(mesh.faces.keys().copied()) }
    }

    fn view(&self) -> impl View {
        let target = |h| self.half_edges.follow(h, &self.vertices, |h| self.mesh.half_edges[h].vertex);
        Targets::of(Borders::of(self).unwrap(), target).unwrap()
    }
}

impl View for MeshView<'_> {
    view_answers! { |view|
        parts => Parts::NONE.with(Part::Faces).with(Part::Leaving),
        vertex_slots => view.vertices.len(),
        half_edge_slots => view.half_edges.len(),
        face_slots => view.faces.len(),
        origin(_h) => None,
        twin(h) => view.half_edges.follow(h, &view.half_edges, |h| view.mesh.half_edges[h].twin),
        next(h) => view.half_edges.follow(h, &view.half_edges, |h| view.mesh.half_edges[h].next),
        face(h) => view.half_edges.follow(h, &view.faces, |h| view.mesh.half_edges[h].face),
        leaving(v) => view.vertices.follow(v, &view.half_edges, |v| view.mesh.vertices[v]),
        outer_half_edge(f) => view.faces.follow(f, &view.half_edges, |f| view.mesh.faces[f]),
    }
}

const EXPECTATION: Expectation = Expectation::surface().open();

/// Keys of the records, far from their indices.
const VERTEX: usize = 100;
const HALF_EDGE: usize = 200;
const FACE: usize = 300;

/// Converts a table in which twins have neighbouring numbers into a mesh with keys.
fn keyed(table: &Table) -> KeyedMesh {
    let rows: Vec<_> = table.half_edges.iter().flatten().collect();
    let keys = |kind: usize, link: Link| link.map(|i| kind + i);
    let half_edge = |h: usize| HalfEdge {
        vertex: keys(VERTEX, rows[h ^ 1].origin),
        twin: Some(HALF_EDGE + (h ^ 1)),
        next: keys(HALF_EDGE, rows[h].next.filter(|_| rows[h].face.is_some())),
        face: keys(FACE, rows[h].face),
    };
    let vertices = table.vertices.iter().flatten().map(|row| keys(HALF_EDGE, row.leaving));
    let faces = table.faces.iter().flatten().map(|row| keys(HALF_EDGE, row.outer_half_edge));
    KeyedMesh {
        vertices: vertices.enumerate().map(|(v, h)| (VERTEX + v, h)).collect(),
        half_edges: (0..rows.len()).map(|h| (HALF_EDGE + h, half_edge(h))).collect(),
        faces: faces.enumerate().map(|(f, h)| (FACE + f, h)).collect(),
    }
}

#[test]
fn validating_a_mesh_with_keys() {
    let mut mesh = keyed(&open_tetrahedron());
    let report = |mesh: &KeyedMesh| {
        let view = MeshView::of(mesh);
        let report = validate(&view.view(), &EXPECTATION, Collect::All);
        let names = |record| match record {
            Record::Vertex(v) => format!("#{}", view.vertices.name(v)),
            Record::HalfEdge(h) => format!("#{}", view.half_edges.name(h)),
            record => format!("#{}", view.faces.name(record.index())),
        };
        (report.figures().map(|found| found.cycles), report.named(names).to_string())
    };
    assert_eq!(report(&mesh).0, Some(3));
    mesh.half_edges.get_mut(&HALF_EDGE).unwrap().vertex = Some(VERTEX + 3);
    let (figures, text) = report(&mesh);
    assert_eq!(figures, None);
    let expected = "L3: half-edge #200 ends at vertex #103, but its next #202 starts at vertex #101: the cycle jumps";
    assert!(text.contains(expected), "{text}");
}

/// Converts link values into keys: the harness uses numbers below the number of records.
fn shifted(mesh: &KeyedMesh) -> KeyedMesh {
    let key = |kind: usize, link: Link| link.map(|i| if i < usize::MAX { kind + i } else { i });
    let half_edge = |h: &HalfEdge| HalfEdge {
        vertex: key(VERTEX, h.vertex),
        twin: key(HALF_EDGE, h.twin),
        next: key(HALF_EDGE, h.next),
        face: key(FACE, h.face),
    };
    KeyedMesh {
        vertices: mesh.vertices.iter().map(|(v, h)| (VERTEX + v, key(HALF_EDGE, *h))).collect(),
        half_edges: mesh.half_edges.iter().map(|(h, row)| (HALF_EDGE + h, half_edge(row))).collect(),
        faces: mesh.faces.iter().map(|(f, h)| (FACE + f, key(HALF_EDGE, *h))).collect(),
    }
}

/// Converts keys back.
fn unshifted(mesh: &KeyedMesh) -> KeyedMesh {
    let index = |kind: usize, link: Link| link.map(|key| key - kind);
    let half_edge = |h: &HalfEdge| HalfEdge {
        vertex: index(VERTEX, h.vertex),
        twin: index(HALF_EDGE, h.twin),
        next: index(HALF_EDGE, h.next),
        face: index(FACE, h.face),
    };
    KeyedMesh {
        vertices: mesh.vertices.iter().map(|(v, h)| (v - VERTEX, index(HALF_EDGE, *h))).collect(),
        half_edges: mesh.half_edges.iter().map(|(h, row)| (h - HALF_EDGE, half_edge(row))).collect(),
        faces: mesh.faces.iter().map(|(f, h)| (f - FACE, index(HALF_EDGE, *h))).collect(),
    }
}

fn links(mesh: &mut KeyedMesh) -> Vec<Stored<'_>> {
    let [vertices, half_edges, faces] = [mesh.vertices.len(), mesh.half_edges.len(), mesh.faces.len()];
    let kept = mesh.vertices.values_mut().chain(mesh.faces.values_mut());
    let mut links: Vec<Stored<'_>> = kept.map(|link| (link, half_edges)).collect();
    for HalfEdge { vertex, twin, next, face } in mesh.half_edges.values_mut() {
        links.extend([(vertex, vertices), (twin, half_edges), (next, half_edges), (face, faces)]);
    }
    links
}

/// Border half-edges are judged by their own sentences, the others as a table in which their twins are nil. The origin of a
/// half-edge is the target of the previous one, found by its next.
fn is_sound(mesh: &KeyedMesh) -> bool {
    let get = |h: Link| h.and_then(|h| mesh.half_edges.get(&h));
    let is_border = |h: &HalfEdge| h.next.is_none() && h.face.is_none();
    let before = |h: usize| mesh.half_edges.values().find(|other| other.next == Some(h));
    let origin = |h: usize| before(h).and_then(|before| before.vertex);
    let borders_are_right = mesh.half_edges.iter().filter(|(_, row)| is_border(row)).all(|(b, row)| {
        let twin = get(row.twin);
        twin.is_some_and(|twin| !is_border(twin) && twin.twin == Some(*b))
            && row.vertex == origin(row.twin.unwrap())
            && mesh.half_edges.values().all(|other| other.next != Some(*b))
    });
    let row = |(h, row): (&usize, &HalfEdge)| {
        let has_twin = !get(row.twin).is_some_and(is_border);
        (!is_border(row)).then_some(HalfEdgeRow {
            origin: origin(*h),
            twin: if has_twin { row.twin.or(Some(usize::MAX)) } else { None },
            next: row.next,
            face: row.face,
            ..HalfEdgeRow::default()
        })
    };
    // A border half-edge leaves a vertex if its twin ends there.
    let ends_at = |v: usize, h: Link| {
        let ends = |h: &HalfEdge| get(h.twin).is_some_and(|twin| twin.vertex == Some(v));
        get(h).is_some_and(ends)
    };
    let has_half_edges = |v: usize| mesh.half_edges.values().any(|row| row.vertex == Some(v));
    let leaving_is_right =
        mesh.vertices.iter().all(|(v, h)| if h.is_some() || has_half_edges(*v) { ends_at(*v, *h) } else { true });
    // The target of a half-edge is the origin of its twin, which the table does not contain at the border.
    let targets_are_right = mesh.half_edges.iter().all(|(h, row)| {
        is_border(row) || get(row.twin).is_none_or(|twin| is_border(twin) || origin(*h) == twin.vertex)
    });
    let faces_are_named =
        mesh.half_edges.values().all(|row| is_border(row) || row.next.is_some() && row.face.is_some());
    let table = Table {
        parts: Parts::NONE.with(Part::Faces),
        vertices: mesh.vertices.values().map(|_| Some(VertexRow::default())).collect(),
        half_edges: mesh.half_edges.iter().map(row).collect(),
        faces: mesh.faces.values().map(|h| Some(FaceRow { outer_half_edge: *h, ..FaceRow::default() })).collect(),
        ..Table::default()
    };
    borders_are_right && leaving_is_right && targets_are_right && faces_are_named && holds(&table, EXPECTATION)
}

#[test]
fn no_fault_of_a_mesh_with_keys_is_hidden() {
    let verdict = |mesh: &KeyedMesh| judged(&MeshView::of(&shifted(mesh)).view(), EXPECTATION);
    let found = each_change(&unshifted(&keyed(&open_tetrahedron())), links, verdict, is_sound);
    // Another half-edge of the same vertex (4 of degree 3) or face (3 triangles) is equally valid.
    assert_eq!((found.all, found.accepted), (566, 4 * 2 + 3 * 2));
}
