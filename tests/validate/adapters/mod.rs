//! The adapters of `validate::adapt`.

mod borders;
mod hostile;
mod labels;
mod links;

use crate::support::tables::{TETRAHEDRON, half_edge, textbook_map, textbook_mesh, vertex, without_border};
use twinedge::delegate_view;
use twinedge::validate::adapt::Targets;
use twinedge::validate::{Expectation, HalfEdgeRow, Link, Part, Parts, Table, View};

const MESH: Expectation = Expectation::surface();

/// The view with its origins as targets.
fn as_targets<V: View>(view: &V) -> Option<Targets<impl View, impl Fn(usize) -> Link>> {
    struct NoOrigins<'a, V>(&'a V);
    impl<V: View> View for NoOrigins<'_, V> {
        delegate_view!(|this| this.0; except origin);
        fn origin(&self, h: usize) -> Link {
            unreachable!("the origin of half-edge {h} is not read")
        }
    }
    Targets::of(NoOrigins(view), |h| view.origin(h))
}

/// The table seen from the other side: origins become targets, and cycles run backwards.
fn mirrored(table: &Table) -> Table {
    let mut mirrored = table.clone();
    for row in mirrored.half_edges.iter_mut().flatten() {
        std::mem::swap(&mut row.next, &mut row.prev);
    }
    mirrored
}

/// A closed mesh, one with a border of half-edges without twins, and an edge with a loop at one end.
pub(super) fn maps() -> [(Table, Expectation); 3] {
    let closed = textbook_mesh(4, &TETRAHEDRON);
    let open = without_border(&fan());
    let tadpole = textbook_map(2, &[(0, 2), (1, 0), (1, 1), (1, 3)], &[(Some(0), &[]), (Some(3), &[])]);
    let kept = |table| Table { parts: Parts::NONE.with(Part::Prev).with(Part::Faces), ..table };
    [(kept(closed), MESH), (kept(open), MESH.open()), (kept(tadpole), MESH)]
}

/// A mesh of these triangles. Its border half-edges have twin and origin, but neither face nor next.
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
