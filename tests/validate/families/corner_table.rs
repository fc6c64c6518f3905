//! The corner table of Rossignac, *Edgebreaker* (1999): triangle `t` has the corners `3t`, `3t + 1` and `3t + 2`. A corner
//! stores its vertex and the opposite corner, in the triangle across the side that it faces.

use super::{Stored, each_change, judged};
use crate::support::tables::TETRAHEDRON;
use std::collections::BTreeSet;
use twinedge::validate::{Expectation, Link, Part, Parts, View};
use twinedge::view_answers;

#[derive(Clone)]
struct CornerTable {
    vertices: usize,
    vertex: Vec<Link>,
    opposite: Vec<Link>,
}

fn next(c: usize) -> usize {
    if c % 3 == 2 { c - 2 } else { c + 1 }
}

/// Half-edge `c` is the side that faces corner `c`: from the next corner to the one after that.
impl View for CornerTable {
    view_answers! { |table|
        parts => Parts::NONE.with(Part::Faces),
        vertex_slots => table.vertices,
        half_edge_slots => table.vertex.len(),
        face_slots => table.vertex.len() / 3,
        origin(c) => table.vertex[next(c)],
        twin(c) => table.opposite[c],
        next(c) => Some(next(c)),
        face(c) => Some(c / 3),
        outer_half_edge(t) => Some(3 * t),
    }
}

const EXPECTATION: Expectation = Expectation::surface().open();

/// Triangles, glued along shared sides.
fn glued(vertices: usize, triangles: &[[usize; 3]]) -> CornerTable {
    let vertex: Vec<usize> = triangles.concat();
    let side = |c: usize| (vertex[next(c)], vertex[next(next(c))]);
    let opposite = |c: usize| (0..vertex.len()).find(|d| (side(*d).1, side(*d).0) == side(c));
    CornerTable {
        vertices,
        opposite: (0..vertex.len()).map(opposite).collect(),
        vertex: vertex.iter().copied().map(Some).collect(),
    }
}

fn links(table: &mut CornerTable) -> Vec<Stored<'_>> {
    let (vertices, corners) = (table.vertices, table.vertex.len());
    let vertex = table.vertex.iter_mut().map(|link| (link, vertices));
    vertex.chain(table.opposite.iter_mut().map(|link| (link, corners))).collect()
}

/// In terms of the corner table: opposite corners see the same side, and the corners at a vertex form one fan.
fn is_sound(table: &CornerTable) -> bool {
    let corners = || 0..table.vertex.len();
    let at = |c: usize| table.vertex[c];
    let sides_match = corners().all(|c| {
        at(c).is_some_and(|v| v < table.vertices)
            && table.opposite[c].is_none_or(|d| {
                d < table.vertex.len()
                    && d != c
                    && table.opposite[d] == Some(c)
                    && (at(next(c)), at(next(next(c)))) == (at(next(next(d))), at(next(d)))
            })
    });
    sides_match
        && corners().all(|c| {
            let mut fan = BTreeSet::from([c]);
            let mut found = vec![c];
            while let Some(c) = found.pop() {
                // Across the two sides that meet in the corner.
                let left = table.opposite[next(c)].map(next);
                let right = table.opposite[next(next(c))].map(|d| next(next(d)));
                found.extend([left, right].into_iter().flatten().filter(|d| fan.insert(*d)));
            }
            corners().filter(|d| at(*d) == at(c)).all(|d| fan.contains(&d))
        })
}

#[test]
fn no_fault_of_a_corner_table_is_hidden() {
    // Vertex 5 is in no triangle.
    for (triangles, accepted) in [
        (&TETRAHEDRON[..], 0),
        // A corner whose two sides are on the border can move to vertex 5.
        (&[[0, 1, 2], [0, 2, 3], [0, 3, 4]][..], 2),
        (&[[0, 1, 2]][..], 3 * 3),
    ] {
        let table = glued(6, triangles);
        let found = each_change(&table, links, |table| judged(table, EXPECTATION), is_sound);
        assert_eq!(found.accepted, accepted);
    }
}
