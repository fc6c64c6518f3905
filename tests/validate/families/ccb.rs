//! Records for boundary components, as in the arrangements of CGAL: half-edges know their *target* and their boundary
//! component; a vertex keeps a half-edge that *arrives* at it, or the record of the isolated vertex that it is.

use super::{Stored, each_change, holds, judged, mirrored};
use crate::support::erased::validate;
use crate::support::nested::nested;
use twinedge::validate::adapt::Targets;
use twinedge::validate::{BoundaryRow, Collect, Expectation, FaceRow, Link, Part, Start, Table, VertexRow, View};

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
    /// A half-edge that arrives, and the boundary component of an isolated vertex.
    vertices: Vec<[Link; 2]>,
    half_edges: Vec<HalfEdge>,
    /// The face, and a half-edge or an isolated vertex.
    ccbs: Vec<(Link, Start)>,
    faces: Vec<(Link, Vec<Link>)>,
}

impl View for Arrangement {
    fn vertex_slots(&self) -> usize {
        self.vertices.len()
    }
    fn half_edge_slots(&self) -> usize {
        self.half_edges.len()
    }
    fn boundary_slots(&self) -> usize {
        self.ccbs.len()
    }
    fn face_slots(&self) -> usize {
        self.faces.len()
    }
    fn origin(&self, _: usize) -> Link {
        None
    }
    fn target(&self, h: usize) -> Link {
        self.half_edges[h].target
    }
    fn twin(&self, h: usize) -> Link {
        self.half_edges[h].opposite
    }
    fn next(&self, h: usize) -> Link {
        self.half_edges[h].next
    }
    fn prev(&self, h: usize) -> Link {
        self.half_edges[h].prev
    }
    fn boundary(&self, h: usize) -> Link {
        self.half_edges[h].ccb
    }
    fn leaving(&self, v: usize) -> Link {
        let arriving = self.vertices[v][0]?;
        self.half_edges.get(arriving).map_or(Some(arriving), |h| h.opposite)
    }
    fn isolated(&self, v: usize) -> Link {
        self.vertices[v][1]
    }
    fn boundary_face(&self, b: usize) -> Link {
        self.ccbs[b].0
    }
    fn boundary_start(&self, b: usize) -> Option<Start> {
        Some(self.ccbs[b].1)
    }
    fn outer(&self, f: usize) -> Link {
        self.faces[f].0
    }
    fn inner_count(&self, f: usize) -> usize {
        self.faces[f].1.len()
    }
    fn inner(&self, f: usize, i: usize) -> Link {
        self.faces[f].1[i]
    }
}

const EXPECTATION: Expectation = Expectation::plane().without(Part::Places);

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

#[test]
fn validating_an_arrangement() {
    let arrangement = sound();
    let report = validate(&Targets::of(&arrangement).unwrap(), &EXPECTATION, Collect::All);
    assert_eq!(report.into_result().unwrap().components, 3);
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
        vertices: map.vertices.iter().map(vertex).collect(),
        half_edges: map.half_edges.iter().map(half_edge).collect(),
        boundaries: map.ccbs.iter().map(boundary).collect(),
        faces: map.faces.iter().map(face).collect(),
    }
}

#[test]
fn no_fault_of_an_arrangement_is_hidden() {
    let verdict = |map: &Arrangement| judged(&Targets::of(map).unwrap(), EXPECTATION);
    let found = each_change(&sound(), links, verdict, |map| holds(&table(map), EXPECTATION));
    // Another half-edge that arrives at the same vertex (6 of degree 2) is as good.
    assert_eq!((found.all, found.accepted), (910, 6));
}
