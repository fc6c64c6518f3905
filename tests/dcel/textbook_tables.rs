//! The textbooks' maps, drawn edge by edge with the operators: equal to the tables entered by hand, row by row, and so
//! isomorphic to them. `tests/support/textbook.rs` has the printed tables and drawings.

use crate::support::programs::{built, program};
use crate::support::tables::with_boundary_components;
use crate::support::textbook::{DANGLING, FIVE_FACES};
use twinedge::dcel::{Dcel, FaceKey, HalfEdgeKey, Side, Split, VertexKey};
use twinedge::validate::{Table, View};
use twinedge_trials::canonical::{Canonizer, isomorphic};

const LEFT: Split<'_> = Split { new_face: Side::Left, inner: &[] };
const RIGHT: Split<'_> = Split { new_face: Side::Right, inner: &[] };

/// A map being drawn: vertices v1, v2, … in the unbounded face, and half-edges e1,1, e1,2, e2,1, …
struct Embedding {
    map: Dcel,
    vertices: Vec<VertexKey>,
    half_edges: Vec<HalfEdgeKey>,
}

impl Embedding {
    fn new(vertices: usize) -> Self {
        let mut map = Dcel::new();
        let outside = map.unbounded_face().key();
        let vertices = (0..vertices).map(|_| map.add_isolated_vertex(outside).unwrap().vertex).collect();
        Self { map, vertices, half_edges: Vec::new() }
    }

    fn v(&self, number: usize) -> VertexKey {
        self.vertices[number - 1]
    }

    fn e(&self, edge: usize, side: usize) -> HalfEdgeKey {
        self.half_edges[2 * (edge - 1) + side - 1]
    }

    fn keep(&mut self, h: HalfEdgeKey) {
        self.half_edges.extend([h, self.map.half_edge(h).unwrap().twin().key()]);
    }

    /// An edge between two isolated vertices.
    fn begin(&mut self, from: usize, to: usize) {
        let connected = self.map.connect(self.v(from), self.v(to), LEFT).unwrap();
        self.keep(connected.half_edge);
    }

    /// An edge from the corner of a half-edge to an isolated vertex.
    fn reach(&mut self, (edge, side): (usize, usize), to: usize) {
        let connected = self.map.connect(self.e(edge, side), self.v(to), LEFT).unwrap();
        self.keep(connected.half_edge);
    }

    /// An edge between two corners, which closes a face.
    fn close(&mut self, from: (usize, usize), to: (usize, usize), split: Split<'_>) -> FaceKey {
        let connected = self.map.connect(self.e(from.0, from.1), self.e(to.0, to.1), split).unwrap();
        self.keep(connected.half_edge);
        connected.new_face().expect("a face is closed")
    }

    /// Checks that every row equals the table's, with the same names.
    fn assert_same(&self, faces: &[FaceKey], golden: &Table) {
        let vertex = |v| self.vertices.iter().position(|other| *other == v);
        let half_edge = |h| self.half_edges.iter().position(|other| *other == h);
        let face = |f| faces.iter().position(|other| *other == f);
        for (i, key) in self.half_edges.iter().enumerate() {
            let h = self.map.half_edge(*key).unwrap();
            let row = [
                vertex(h.origin().key()),
                half_edge(h.twin().key()),
                half_edge(h.next().key()),
                half_edge(h.prev().key()),
            ];
            assert_eq!(row, [golden.origin(i), golden.twin(i), golden.next(i), golden.prev(i)], "half-edge {i}");
            assert_eq!(face(h.face().key()), golden.face(i), "half-edge {i}");
        }
        for (i, key) in faces.iter().enumerate() {
            let f = self.map.face(*key).unwrap();
            assert_eq!(
                (f.outer().is_some(), f.inner_count()),
                (golden.outer_half_edge(i).is_some(), golden.inner_count(i))
            );
        }
        assert_eq!(self.map.half_edge_count(), golden.half_edges.len());
        assert_eq!((self.map.vertex_count(), self.map.face_count()), (golden.vertices.len(), golden.faces.len()));
    }
}

fn dangling() -> (Embedding, [FaceKey; 2]) {
    let mut drawing = Embedding::new(4);
    drawing.begin(1, 2); // e1
    // e2 and e3 start at v3, which e4 reaches; for the right numbers, e4 is drawn first and put last.
    let e4 = drawing.map.connect(drawing.e(1, 2), drawing.v(3), LEFT).unwrap().half_edge;
    let back = drawing.map.half_edge(e4).unwrap().twin().key();
    let e2 = drawing.map.connect(back, drawing.v(4), LEFT).unwrap().half_edge;
    drawing.keep(e2);
    // The triangle is closed on the side of e4 away from e2.
    let closing = drawing.map.connect(back, drawing.e(1, 1), RIGHT).unwrap();
    drawing.keep(closing.half_edge);
    drawing.half_edges.extend([back, e4]);
    let outside = drawing.map.unbounded_face().key();
    (drawing, [outside, closing.new_face().unwrap()])
}

fn five_faces() -> (Embedding, [FaceKey; 5]) {
    let mut drawing = Embedding::new(6);
    drawing.begin(3, 1); // e1
    drawing.reach((1, 2), 2); // e2
    let f1 = drawing.close((2, 2), (1, 1), LEFT); // e3
    drawing.reach((2, 2), 4); // e4
    let f2 = drawing.close((4, 2), (3, 2), LEFT); // e5
    drawing.reach((4, 2), 6); // e6
    let f3 = drawing.close((6, 2), (5, 2), LEFT); // e7
    drawing.reach((4, 2), 5); // e8
    let f4 = drawing.close((8, 2), (6, 2), LEFT); // e9
    let f5 = drawing.map.unbounded_face().key();
    (drawing, [f1, f2, f3, f4, f5])
}

#[test]
fn the_maps_are_built() {
    let ((first, first_faces), (second, second_faces)) = (dangling(), five_faces());
    for (drawing, faces, textbook) in [(first, &first_faces[..], DANGLING), (second, &second_faces, FIVE_FACES)] {
        assert!(drawing.map.validate().is_valid());
        drawing.assert_same(faces, &textbook.table());
        assert!(isomorphic(&drawing.map, &with_boundary_components(&textbook.table())));
        assert!(isomorphic(&drawing.map, &textbook.table()));
    }
}

#[test]
fn other_ways_lead_to_the_same_maps() {
    // A loop with two more vertices on it, and a leaf outside.
    let outside = built(&program(
        "add_isolated_vertex unbounded\nconnect i0 i0 left\nsplit_edge h0\nsplit_edge h0\nsplit_vertex h1 h1",
    ));
    assert!(isomorphic(&outside, &DANGLING.table()));
    // The leaf inside: the same map on the sphere, but a different one in the plane.
    let inside = built(&program(
        "add_isolated_vertex unbounded\nconnect i0 i0 left\nsplit_edge h0\nsplit_edge h0\nsplit_vertex h0 h0",
    ));
    assert!(!isomorphic(&inside, &DANGLING.table()));
    let mut canonizer = Canonizer::new();
    assert_eq!(canonizer.unrooted(&inside), canonizer.unrooted(&DANGLING.table()));
    // Turning an edge makes another map, and turning it back restores the map.
    let (mut drawing, _) = five_faces();
    drawing.map.flip_edge(drawing.e(5, 1), twinedge::dcel::Turn::Clockwise).unwrap();
    assert!(!isomorphic(&drawing.map, &FIVE_FACES.table()));
    drawing.map.flip_edge(drawing.e(5, 1), twinedge::dcel::Turn::CounterClockwise).unwrap();
    assert!(isomorphic(&drawing.map, &FIVE_FACES.table()));
}

#[test]
fn rootings_of_the_golden_maps() {
    let mut canonizer = Canonizer::new();
    for (table, expected) in [(DANGLING.table(), (1, 8)), (FIVE_FACES.table(), (2, 9))] {
        let unrooted = canonizer.unrooted(&table).unwrap();
        assert_eq!((unrooted.automorphisms, unrooted.rootings), expected);
    }
}
