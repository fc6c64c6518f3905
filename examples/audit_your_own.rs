//! Audit a half-edge structure of your own: one trait to implement, one function to call.
//!
//! The first part is a DCEL as one finds it in many projects, a vector for each of the textbook's three tables. The
//! second lets the validator look at it. Then a face is split, once right, and once with one assignment forgotten,
//! which nothing notices at the time: only a later walk around the face, from the new half-edge, would never come back
//! to it.
//!
//! ```text
//! cargo run --example audit_your_own
//! ```

use std::process::ExitCode;
use twinedge::validate::{Collect, Expectation, Part, Parts, Start, View, Violation, validate};
use twinedge::view_answers;

// ---- somebody's DCEL ---------------------------------------------------------------------------------------------

struct Vertex {
    leaving: usize,
}

#[derive(Clone, Copy)]
struct HalfEdge {
    origin: usize,
    twin: usize,
    next: usize,
    prev: usize,
    face: usize,
}

struct Face {
    half_edge: usize,
}

/// Half-edges 2i and 2i + 1 are twins. Face 0 is the unbounded one, and what is drawn is connected.
struct Dcel {
    vertices: Vec<Vertex>,
    half_edges: Vec<HalfEdge>,
    faces: Vec<Face>,
}

impl Dcel {
    /// A polygon with n corners: the half-edges 0, 2, 4, … run around its inside.
    fn polygon(n: usize) -> Self {
        let (after, before) = (|i| (i + 1) % n, |i| (i + n - 1) % n);
        let inside = |i| HalfEdge { origin: i, twin: 2 * i + 1, next: 2 * after(i), prev: 2 * before(i), face: 1 };
        let outside =
            |i| HalfEdge { origin: after(i), twin: 2 * i, next: 2 * before(i) + 1, prev: 2 * after(i) + 1, face: 0 };
        Self {
            vertices: (0..n).map(|i| Vertex { leaving: 2 * i }).collect(),
            half_edges: (0..n).flat_map(|i| [inside(i), outside(i)]).collect(),
            faces: vec![Face { half_edge: 1 }, Face { half_edge: 0 }],
        }
    }

    /// Splits the face of `a` and `b` by an edge from the origin of `a` to that of `b`.
    fn split_face(&mut self, a: usize, b: usize, forgetful: bool) {
        let (there, back, new) = (self.half_edges.len(), self.half_edges.len() + 1, self.faces.len());
        let (HalfEdge { origin, prev: before_a, face, .. }, before_b) = (self.half_edges[a], self.half_edges[b].prev);
        self.half_edges.push(HalfEdge { origin, twin: back, next: b, prev: before_a, face });
        let origin = self.half_edges[b].origin;
        self.half_edges.push(HalfEdge { origin, twin: there, next: a, prev: before_b, face: new });
        self.half_edges[a].prev = back;
        self.half_edges[b].prev = there;
        self.half_edges[before_b].next = back;
        if !forgetful {
            self.half_edges[before_a].next = there;
        }
        self.faces[face].half_edge = there;
        self.faces.push(Face { half_edge: back });
        let mut h = a;
        while h != back {
            self.half_edges[h].face = new;
            h = self.half_edges[h].next;
        }
    }
}

// ---- what the validator asks of it -------------------------------------------------------------------------------

impl View for Dcel {
    view_answers! { |map|
        // Faces keep half-edges here, and there are no records for boundary components.
        parts => Parts::ALL.without(Part::BoundaryComponents),
        vertex_slots => map.vertices.len(),
        half_edge_slots => map.half_edges.len(),
        face_slots => map.faces.len(),
        origin(half_edge) => Some(map.half_edges[half_edge].origin),
        twin(half_edge) => Some(map.half_edges[half_edge].twin),
        next(half_edge) => Some(map.half_edges[half_edge].next),
        prev(half_edge) => Some(map.half_edges[half_edge].prev),
        face(half_edge) => Some(map.half_edges[half_edge].face),
        leaving(vertex) => Some(map.vertices[vertex].leaving),
        outer_half_edge(face) => (face != 0).then(|| map.faces[face].half_edge),
        inner_count(face) => usize::from(face == 0),
        inner_start(face, _i) => Some(Start::HalfEdge(map.faces[face].half_edge)),
    }
}

// ---- the audit ---------------------------------------------------------------------------------------------------

fn main() -> ExitCode {
    let expectation = Expectation::plane();

    let mut right = Dcel::polygon(6);
    right.split_face(0, 6, false);
    let report = validate(&right, &expectation, Collect::All);
    println!("A hexagon split in two:\n\n{report}");
    let Some(figures) = report.figures() else {
        println!("This should have been accepted.");
        return ExitCode::FAILURE;
    };
    println!("{figures:#?}\n");

    let mut wrong = Dcel::polygon(6);
    wrong.split_face(0, 6, true);
    let report = validate(&wrong, &expectation, Collect::All);
    println!("The same, with the next of half-edge 10 forgotten:\n\n{report}");
    // It still leads to half-edge 0, which by now comes after the new half-edge 13.
    let bug = Violation::PrevOfNext { half_edge: 10, next: 0, found: 13 };
    if report.first() != Some(&bug) {
        println!("This should have been the first violation: {bug}");
        return ExitCode::FAILURE;
    }
    ExitCode::SUCCESS
}
