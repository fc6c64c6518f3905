//! Records for boundary components, as in CGAL's arrangements: half-edges store their *target* and their boundary
//! component; a vertex stores a half-edge that *arrives* at it, or the record of an isolated vertex.

use super::{Stored, each_change, holds, judged, mirrored};
use crate::support::nested::{PLANE, nested};
use twinedge::validate::adapt::Targets;
use twinedge::validate::{BoundaryRow, FaceRow, Link, Part, Parts, Start, Table, VertexRow, View};
use twinedge::view_answers;

#[derive(Clone)]
struct HalfEdge {
    opposite: Link,
    target: Link,
    next: Link,
    prev: Link,
    ccb: Link,
}

#[derive(Clone)]
struct Arrangement {
    /// An arriving half-edge, and the boundary component of an isolated vertex.
    vertices: Vec<[Link; 2]>,
    half_edges: Vec<HalfEdge>,
    /// The face, and a half-edge or an isolated vertex.
    ccbs: Vec<(Link, Start)>,
    faces: Vec<(Link, Vec<Link>)>,
}

impl Arrangement {
    fn view(&self) -> impl View {
        Targets::of(self, |h| self.half_edges[h].target).unwrap()
    }
}

impl View for Arrangement {
    view_answers! { |map|
        parts => Parts::ALL.without(Part::Places),
        vertex_slots => map.vertices.len(),
        half_edge_slots => map.half_edges.len(),
        boundary_slots => map.ccbs.len(),
        face_slots => map.faces.len(),
        origin(_h) => None,
        twin(h) => map.half_edges[h].opposite,
        next(h) => map.half_edges[h].next,
        prev(h) => map.half_edges[h].prev,
        boundary(h) => map.half_edges[h].ccb,
        leaving(v) => {
            let arriving = map.vertices[v][0]?;
            map.half_edges.get(arriving).map_or(Some(arriving), |h| h.opposite)
        },
        isolated(v) => map.vertices[v][1],
        boundary_face(b) => map.ccbs[b].0,
        boundary_start(b) => Some(map.ccbs[b].1),
        outer(f) => map.faces[f].0,
        inner_count(f) => map.faces[f].1.len(),
        inner(f, i) => map.faces[f].1[i],
    }
}

/// A triangle with a triangular hole, and an isolated vertex between.
fn sound() -> Arrangement {
    let table = nested();
    let rows: Vec<_> = table.half_edges.iter().flatten().collect();
    let half_edge = |(h, row): (usize, &&twinedge::validate::HalfEdgeRow)| HalfEdge {
        opposite: row.twin,
        target: rows[h ^ 1].origin,
        next: row.next,
        prev: row.prev,
        ccb: row.boundary,
    };
    Arrangement {
        vertices: table.vertices.iter().flatten().map(|row| [row.leaving.map(|h| h ^ 1), row.isolated]).collect(),
        half_edges: rows.iter().enumerate().map(half_edge).collect(),
        ccbs: table.boundaries.iter().flatten().map(|row| (row.face, row.start.unwrap())).collect(),
        faces: table.faces.iter().flatten().map(|row| (row.outer, row.inner.clone())).collect(),
    }
}

fn links(map: &mut Arrangement) -> Vec<Stored<'_>> {
    let [vertices, half_edges] = [map.vertices.len(), map.half_edges.len()];
    let [ccbs, faces] = [map.ccbs.len(), map.faces.len()];
    let mut links: Vec<Stored<'_>> = vec![];
    for [arriving, isolated] in &mut map.vertices {
        links.extend([(arriving, half_edges), (isolated, ccbs)]);
    }
    for HalfEdge { opposite, target, next, prev, ccb } in &mut map.half_edges {
        links.extend([opposite, next, prev].map(|link| (link, half_edges)));
        links.extend([(target, vertices), (ccb, ccbs)]);
    }
    links.extend(map.ccbs.iter_mut().map(|(face, _)| (face, faces)));
    for (outer, inner) in &mut map.faces {
        links.push((outer, ccbs));
        links.extend(inner.iter_mut().map(|link| (link, ccbs)));
    }
    links
}

/// The mirror image.
fn table(map: &Arrangement) -> Table {
    let half_edge = |h: &HalfEdge| {
        let mut row = mirrored(h.target, [h.opposite, h.next, h.prev]);
        row.boundary = h.ccb;
        Some(row)
    };
    let vertex = |[leaving, isolated]: &[Link; 2]| Some(VertexRow { leaving: *leaving, isolated: *isolated });
    let boundary = |(face, start): &(Link, Start)| Some(BoundaryRow { face: *face, start: Some(*start), place: None });
    let face = |(outer, inner): &(Link, Vec<Link>)| {
        Some(FaceRow { outer: *outer, inner: inner.clone(), ..FaceRow::default() })
    };
    Table {
        parts: Parts::ALL.without(Part::Places),
        vertices: map.vertices.iter().map(vertex).collect(),
        half_edges: map.half_edges.iter().map(half_edge).collect(),
        boundaries: map.ccbs.iter().map(boundary).collect(),
        faces: map.faces.iter().map(face).collect(),
    }
}

#[test]
fn no_fault_of_an_arrangement_is_hidden() {
    let found = each_change(&sound(), links, |map| judged(&map.view(), PLANE), |map| holds(&table(map), PLANE));
    // Another half-edge arriving at the same vertex (6 of degree 2) is equally valid.
    assert_eq!((found.all, found.accepted), (910, 6));
}
