//! The winged-edge structure of Baumgart (1975): an edge stores its two vertices, its two faces, and its four wings, the
//! edges before and after it around each face. Vertices and faces store one edge.

use super::{Stored, each_change, holds, judged};
use crate::support::tables::{TETRAHEDRON, TEXTBOOK, textbook_mesh};
use twinedge::validate::{Expectation, FaceRow, HalfEdgeRow, Link, Part, Parts, Table, VertexRow, View};
use twinedge::view_answers;

/// Side 0 runs from `vertices[0]` to `vertices[1]` along `faces[0]`, side 1 back along `faces[1]`.
#[derive(Clone)]
struct Edge {
    vertices: [Link; 2],
    faces: [Link; 2],
    after: [Link; 2],
    before: [Link; 2],
}

#[derive(Clone)]
struct WingedEdges {
    edges: Vec<Edge>,
    vertices: Vec<Link>,
    faces: Vec<Link>,
}

impl WingedEdges {
    /// The side of an edge that a link to the edge refers to. Without such a side the link dangles.
    fn side(&self, edge: Link, means: impl Fn(&Edge, usize) -> bool) -> Link {
        let edge = edge?;
        let found = self.edges.get(edge).and_then(|row| (0..2).find(|side| means(row, *side)));
        Some(found.map_or(usize::MAX, |side| 2 * edge + side))
    }
}

/// Half-edge `2e + s` is side `s` of edge `e`. A wing is the side of the other edge that starts, or ends, where this side
/// ends, or starts.
impl View for WingedEdges {
    view_answers! { |map|
        parts => Parts::NONE.with(Part::Prev).with(Part::Leaving).with(Part::Faces),
        vertex_slots => map.vertices.len(),
        half_edge_slots => 2 * map.edges.len(),
        face_slots => map.faces.len(),
        origin(h) => map.edges[h / 2].vertices[h % 2],
        twin(h) => Some(h ^ 1),
        next(h) => {
            let Edge { vertices, after, .. } = &map.edges[h / 2];
            map.side(after[h % 2], |edge, side| edge.vertices[side] == vertices[1 - h % 2])
        },
        prev(h) => {
            let Edge { vertices, before, .. } = &map.edges[h / 2];
            map.side(before[h % 2], |edge, side| edge.vertices[1 - side] == vertices[h % 2])
        },
        face(h) => map.edges[h / 2].faces[h % 2],
        leaving(v) => map.side(map.vertices[v], |edge, side| edge.vertices[side] == Some(v)),
        outer_half_edge(f) => map.side(map.faces[f], |edge, side| edge.faces[side] == Some(f)),
    }
}

const EXPECTATION: Expectation = Expectation::surface();

fn sound() -> WingedEdges {
    let table = textbook_mesh(4, &TETRAHEDRON);
    let half_edges: Vec<_> = table.half_edges.iter().flatten().collect();
    let edge = |link: Link| link.map(|h| h / 2);
    let both = |e: usize, link: fn(&HalfEdgeRow) -> Link| [2 * e, 2 * e + 1].map(|h| link(half_edges[h]));
    let row = |e: usize| Edge {
        vertices: both(e, |row| row.origin),
        faces: both(e, |row| row.face),
        after: both(e, |row| row.next).map(edge),
        before: both(e, |row| row.prev).map(edge),
    };
    WingedEdges {
        edges: (0..half_edges.len() / 2).map(row).collect(),
        vertices: table.vertices.iter().flatten().map(|row| edge(row.leaving)).collect(),
        faces: table.faces.iter().flatten().map(|row| edge(row.outer_half_edge)).collect(),
    }
}

fn links(map: &mut WingedEdges) -> Vec<Stored<'_>> {
    let [vertices, edges, faces] = [map.vertices.len(), map.edges.len(), map.faces.len()];
    let mut links: Vec<Stored<'_>> = vec![];
    for Edge { vertices: ends, faces: sides, after, before } in &mut map.edges {
        links.extend(ends.iter_mut().map(|link| (link, vertices)));
        links.extend(sides.iter_mut().map(|link| (link, faces)));
        links.extend(after.iter_mut().chain(before).map(|link| (link, edges)));
    }
    links.extend(map.vertices.iter_mut().chain(&mut map.faces).map(|link| (link, edges)));
    links
}

/// As tables, reading wings the other way: a wing is the side of the other edge that bounds the same face.
fn table(map: &WingedEdges) -> Table {
    let row = |(edge, side): (&Edge, usize)| {
        let same_face = |wing: Link| map.side(wing, |other, s| other.faces[s] == edge.faces[side]);
        HalfEdgeRow {
            origin: edge.vertices[side],
            face: edge.faces[side],
            next: same_face(edge.after[side]),
            prev: same_face(edge.before[side]),
            ..HalfEdgeRow::default()
        }
    };
    let rows = map.edges.iter().flat_map(|edge| [(edge, 0), (edge, 1)]).map(row).enumerate();
    Table {
        parts: TEXTBOOK,
        vertices: (0..map.vertices.len())
            .map(|v| Some(VertexRow { leaving: map.leaving(v), isolated: None }))
            .collect(),
        half_edges: rows.map(|(h, row)| Some(HalfEdgeRow { twin: Some(h ^ 1), ..row })).collect(),
        faces: (0..map.faces.len())
            .map(|f| Some(FaceRow { outer_half_edge: map.outer_half_edge(f), ..FaceRow::default() }))
            .collect(),
        ..Table::default()
    }
}

#[test]
fn no_fault_of_winged_edges_is_hidden() {
    let found = each_change(&sound(), links, |map| judged(map, EXPECTATION), |map| holds(&table(map), EXPECTATION));
    // Another edge of the same vertex (4 of degree 3) or face (4 triangles) is equally valid.
    assert_eq!((found.all, found.accepted), (6 * 4 * 6 + 6 * 4 * 8 + 8 * 8, 4 * 2 + 4 * 2));
}
