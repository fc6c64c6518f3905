//! The quad-edge structure of Guibas and Stolfi (1985): each edge has four quarters, `4e + r`, turned by `Rot`. A quarter
//! stores `Onext`, the next one counter-clockwise around its origin, which is a vertex for even `r` and a face for odd `r`.

use super::{Changes, Stored, each_change, judged};
use crate::support::tables::{TETRAHEDRON, textbook_mesh};
use std::collections::BTreeSet;
use twinedge::validate::adapt::FaceLabels;
use twinedge::validate::{Expectation, Link, Part, Parts, Table, View};
use twinedge::view_answers;

#[derive(Clone)]
struct QuadEdge {
    vertices: usize,
    faces: usize,
    onext: Vec<Link>,
    origin: Vec<Link>,
}

fn rot(q: usize, by: usize) -> usize {
    q - q % 4 + (q % 4 + by) % 4
}

/// The half-edge of a primal quarter; dual quarters have none.
fn half_edge(q: usize) -> usize {
    if q % 2 == 0 { q / 2 } else { usize::MAX }
}

/// Half-edge `2e` is the quarter `4e`, and `2e + 1` is `4e + 2`.
impl View for QuadEdge {
    view_answers! { |quads|
        parts => Parts::NONE.with(Part::Prev),
        vertex_slots => quads.vertices,
        half_edge_slots => quads.onext.len() / 2,
        face_slots => quads.faces,
        origin(h) => quads.origin[2 * h],
        twin(h) => Some(h ^ 1),
        next(h) => quads.onext[rot(2 * h, 3)].map(|q| half_edge(rot(q, 1))),
        prev(h) => quads.onext[2 * h].map(|q| half_edge(rot(q, 2))),
        face(h) => quads.origin[rot(2 * h, 3)],
    }
}

const EXPECTATION: Expectation = Expectation::surface();

fn of_mesh(table: &Table) -> QuadEdge {
    let rows: Vec<_> = table.half_edges.iter().flatten().collect();
    let quarter = |q: usize| {
        let h = q / 2;
        if q % 2 == 0 {
            return (rows[h].prev.map(|p| 2 * (p ^ 1)), rows[h].origin);
        }
        // To the right of a dual quarter lies the half-edge from which it is turned back, so its origin is the face of the
        // twin.
        let row = rows[h ^ 1];
        (row.next.map(|n| rot(2 * n, 3)), row.face)
    };
    let (onext, origin) = (0..2 * rows.len()).map(quarter).unzip();
    QuadEdge { vertices: table.vertices.len(), faces: table.faces.len(), onext, origin }
}

fn tetrahedron() -> QuadEdge {
    of_mesh(&textbook_mesh(4, &TETRAHEDRON))
}

fn links(quads: &mut QuadEdge) -> Vec<Stored<'_>> {
    let (vertices, faces, quarters) = (quads.vertices, quads.faces, quads.onext.len());
    let origins = quads.origin.iter_mut().enumerate().map(|(q, v)| (v, if q % 2 == 0 { vertices } else { faces }));
    quads.onext.iter_mut().map(|link| (link, quarters)).chain(origins).collect()
}

/// The axioms of the edge algebra of Guibas and Stolfi: `Onext` keeps primal and dual apart, and `e Rot Onext Rot Onext = e`.
/// Two quarters share their origin, a vertex or a face, if and only if they are in one orbit of `Onext`; each face is the
/// origin of one.
fn keeps_the_axioms(quads: &QuadEdge) -> bool {
    let quarters = || 0..quads.onext.len();
    let onext = |q: usize| quads.onext[q].filter(|to| *to < quads.onext.len() && (to + q) % 2 == 0);
    let turned = |q: usize| onext(rot(onext(rot(q, 1))?, 1));
    let orbit = |q: usize| {
        let mut orbit = BTreeSet::new();
        let mut at = Some(q);
        while let Some(q) = at.filter(|q| orbit.insert(*q)) {
            at = onext(q);
        }
        orbit
    };
    let same_origin = |q: usize| quarters().filter(move |p| (p + q) % 2 == 0 && quads.origin[*p] == quads.origin[q]);
    let slots = |q: usize| if q % 2 == 0 { quads.vertices } else { quads.faces };
    quarters().all(|q| turned(q) == Some(q))
        && quarters().all(|q| quads.origin[q].is_some_and(|at| at < slots(q)))
        && quarters().all(|q| same_origin(q).collect::<BTreeSet<_>>() == orbit(q))
        && (0..quads.faces).all(|f| quarters().any(|q| q % 2 == 1 && quads.origin[q] == Some(f)))
}

fn changes(quads: &QuadEdge) -> Changes {
    let verdict = |quads: &QuadEdge| judged(&FaceLabels::one_cycle(quads).unwrap(), EXPECTATION);
    each_change(quads, links, verdict, keeps_the_axioms)
}

#[test]
fn no_fault_of_a_quad_edge_structure_is_hidden() {
    // 24 links with 26 other values and 24 with 6.
    assert_eq!(changes(&tetrahedron()), Changes { all: 24 * 26 + 24 * 6, accepted: 0 });
}

/// Two vertices and an edge; a loop; two unused vertices. An origin alone in its orbit may be any free vertex. Faces cannot be
/// exchanged this way, as each needs its cycle.
#[test]
fn origins_of_single_quarters_may_change() {
    let edge = QuadEdge {
        vertices: 4,
        faces: 1,
        onext: [0, 3, 2, 1].map(Some).to_vec(),
        origin: [0, 0, 1, 0].map(Some).to_vec(),
    };
    assert_eq!(changes(&edge).accepted, 2 * 2);
    let on_a_loop = QuadEdge {
        vertices: 4,
        faces: 2,
        onext: [2, 1, 0, 3].map(Some).to_vec(),
        origin: [0, 0, 0, 1].map(Some).to_vec(),
    };
    assert_eq!(changes(&on_a_loop).accepted, 0);
}
