//! The adapters of `validate::adapt`.

mod borders;
mod hostile;
mod labels;
mod links;

use crate::support::tables::{half_edge, textbook_map, textbook_mesh, vertex};
use twinedge::delegate_view;
use twinedge::validate::{Expectation, HalfEdgeRow, Link, Part, Table, View};

const MESH: Expectation = Expectation::surface().without(Part::BoundaryComponents);
pub(super) const TEXTBOOK: Expectation = Expectation::plane().without(Part::BoundaryComponents);

/// A view whose origins are read as targets.
struct AsTargets<V>(V);

impl<V: View> View for AsTargets<V> {
    delegate_view!(|this| &this.0; except origin, target);
    fn origin(&self, _: usize) -> Link {
        None
    }
    fn target(&self, half_edge: usize) -> Link {
        self.0.origin(half_edge)
    }
}

/// The table seen from the other side: what was the origin is the target, and cycles run backwards.
fn mirrored(table: &Table) -> Table {
    let mut mirrored = table.clone();
    for row in mirrored.half_edges.iter_mut().flatten() {
        std::mem::swap(&mut row.next, &mut row.prev);
    }
    mirrored
}

/// A closed mesh, one with a border whose half-edges have no twins, and an edge with a loop at one end.
pub(super) fn maps() -> [(Table, Expectation); 3] {
    let closed = textbook_mesh(4, &[[0, 1, 2], [0, 3, 1], [1, 3, 2], [0, 2, 3]]);
    let mut open = with_bare_border(5, &[[0, 1, 2], [0, 2, 3], [0, 3, 4]]);
    let borders: Vec<usize> = (0..open.half_edges.len()).filter(|h| half_edge(&mut open, *h).face.is_none()).collect();
    for h in borders {
        open.half_edges[h] = None;
        half_edge(&mut open, h ^ 1).twin = None;
    }
    let tadpole = textbook_map(2, &[(0, 2), (1, 0), (1, 1), (1, 3)], &[(Some(0), &[]), (Some(3), &[])]);
    let surface = MESH.without(Part::Leaving);
    [(closed, surface), (open, surface.open()), (tadpole, surface)]
}

/// A mesh of these triangles. Its border half-edges have twin and origin, and neither face nor next.
fn with_bare_border(vertices: usize, triangles: &[[usize; 3]]) -> Table {
    let mut table = textbook_mesh(vertices, triangles);
    for h in 0..table.half_edges.len() {
        if table.face(h).is_none() {
            let origin = table.next(h ^ 1).and_then(|next| table.origin(next));
            *half_edge(&mut table, h) = HalfEdgeRow { origin, twin: Some(h ^ 1), ..HalfEdgeRow::default() };
        }
    }
    for h in 0..table.half_edges.len() {
        half_edge(&mut table, h).prev = (0..table.half_edges.len()).find(|prev| table.next(*prev) == Some(h));
    }
    for v in 0..vertices {
        vertex(&mut table, v).leaving = (0..table.half_edges.len()).find(|h| table.origin(*h) == Some(v));
    }
    table
}

/// Three triangles around vertex 0, side by side.
fn fan() -> Table {
    with_bare_border(5, &[[0, 1, 2], [0, 2, 3], [0, 3, 4]])
}
