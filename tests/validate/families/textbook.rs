//! The tables of de Berg, Cheong, van Kreveld and Overmars, *Computational Geometry* (2008), section 2.2.

use super::{Stored, each_change, holds, judged};
use crate::support::erased::validate_plane;
use crate::support::nested::PLANE;
use crate::support::tables::{TEXTBOOK, textbook_map};
use twinedge::validate::{FaceRow, HalfEdgeRow, Link, Part, Parts, Start, Table, VertexRow, View};
use twinedge::view_answers;

#[derive(Clone, Copy)]
struct HalfEdge {
    origin: Link,
    twin: Link,
    incident_face: Link,
    next: Link,
    prev: Link,
}

#[derive(Clone)]
struct Face {
    outer_component: Link,
    inner_components: Vec<Link>,
}

#[derive(Clone)]
struct Textbook {
    incident_edge: Vec<Link>,
    half_edges: Vec<HalfEdge>,
    faces: Vec<Face>,
}

impl View for Textbook {
    view_answers! { |map|
        parts => Parts::ALL.without(Part::BoundaryComponents),
        vertex_slots => map.incident_edge.len(),
        half_edge_slots => map.half_edges.len(),
        face_slots => map.faces.len(),
        origin(h) => map.half_edges[h].origin,
        twin(h) => map.half_edges[h].twin,
        next(h) => map.half_edges[h].next,
        prev(h) => map.half_edges[h].prev,
        face(h) => map.half_edges[h].incident_face,
        leaving(v) => map.incident_edge[v],
        outer_half_edge(f) => map.faces[f].outer_component,
        inner_count(f) => map.faces[f].inner_components.len(),
        inner_start(f, i) => map.faces[f].inner_components[i].map(Start::HalfEdge),
    }
}

/// A triangle with a triangular hole that contains a face.
fn sound() -> Textbook {
    let half_edges = [(0, 2), (1, 5), (1, 4), (2, 1), (2, 0), (0, 3), (3, 8), (4, 11), (4, 10), (5, 7), (5, 6), (3, 9)];
    let (outside, hole) = ([Start::HalfEdge(1)], [Start::HalfEdge(7)]);
    let table = textbook_map(6, &half_edges, &[(None, &outside), (Some(0), &hole), (Some(6), &[])]);
    Textbook {
        incident_edge: table.vertices.iter().flatten().map(|row| row.leaving).collect(),
        half_edges: table
            .half_edges
            .iter()
            .flatten()
            .map(|row| HalfEdge {
                origin: row.origin,
                twin: row.twin,
                incident_face: row.face,
                next: row.next,
                prev: row.prev,
            })
            .collect(),
        faces: table
            .faces
            .iter()
            .flatten()
            .map(|row| Face {
                outer_component: row.outer_half_edge,
                inner_components: if row.inner_starts == [Some(Start::HalfEdge(1))] {
                    vec![Some(1)]
                } else {
                    vec![Some(7); row.inner_starts.len()]
                },
            })
            .collect(),
    }
}

fn links(map: &mut Textbook) -> Vec<Stored<'_>> {
    let [vertices, half_edges, faces] = [map.incident_edge.len(), map.half_edges.len(), map.faces.len()];
    let mut links: Vec<Stored<'_>> = map.incident_edge.iter_mut().map(|link| (link, half_edges)).collect();
    for HalfEdge { origin, twin, incident_face, next, prev } in &mut map.half_edges {
        links.extend([(origin, vertices), (incident_face, faces)]);
        links.extend([twin, next, prev].map(|link| (link, half_edges)));
    }
    for face in &mut map.faces {
        links.push((&mut face.outer_component, half_edges));
        links.extend(face.inner_components.iter_mut().map(|link| (link, half_edges)));
    }
    links
}

fn table(map: &Textbook) -> Table {
    let row = |h: &HalfEdge| HalfEdgeRow {
        origin: h.origin,
        twin: h.twin,
        next: h.next,
        prev: h.prev,
        face: h.incident_face,
        ..HalfEdgeRow::default()
    };
    let face = |f: &Face| FaceRow {
        outer_half_edge: f.outer_component,
        inner_starts: f.inner_components.iter().map(|h| h.map(Start::HalfEdge)).collect(),
        ..FaceRow::default()
    };
    Table {
        parts: TEXTBOOK,
        vertices: map.incident_edge.iter().map(|h| Some(VertexRow { leaving: *h, isolated: None })).collect(),
        half_edges: map.half_edges.iter().map(|h| Some(row(h))).collect(),
        faces: map.faces.iter().map(|f| Some(face(f))).collect(),
        ..Table::default()
    }
}

#[test]
fn validating_textbook_tables() {
    assert!(validate_plane(&sound()).is_valid());
}

#[test]
fn no_fault_of_textbook_tables_is_hidden() {
    let found = each_change(&sound(), links, |map| judged(map, PLANE), |map| holds(&table(map), PLANE));
    // Another half-edge of the same vertex (6 vertices of degree 2) or of the same cycle (4 of length 3) is equally
    // valid.
    assert_eq!((found.all, found.accepted), (814, 6 + 4 * 2));
}
