//! The same structure with its records in other slots.

use twinedge::validate::{Start, Table};

/// The structure with record `i` of a kind in slot `slots[i]`; slots beyond the records are vacant. The kinds are vertices,
/// half-edges, boundary components and faces.
pub(crate) fn renumbered(table: &Table, slots: &[Vec<usize>; 4]) -> Table {
    let [v, h, b, f] = slots;
    let mut table = table.clone();
    for row in table.vertices.iter_mut().flatten() {
        row.leaving = row.leaving.map(|to| h[to]);
        row.isolated = row.isolated.map(|to| b[to]);
    }
    for row in table.half_edges.iter_mut().flatten() {
        row.origin = row.origin.map(|to| v[to]);
        row.boundary = row.boundary.map(|to| b[to]);
        row.face = row.face.map(|to| f[to]);
        for link in [&mut row.twin, &mut row.next, &mut row.prev] {
            *link = link.map(|to| h[to]);
        }
    }
    let start = |start: Start| match start {
        Start::HalfEdge(to) => Start::HalfEdge(h[to]),
        Start::Vertex(to) => Start::Vertex(v[to]),
    };
    for row in table.boundaries.iter_mut().flatten() {
        row.face = row.face.map(|to| f[to]);
        row.start = row.start.map(start);
    }
    for row in table.faces.iter_mut().flatten() {
        row.outer = row.outer.map(|to| b[to]);
        row.outer_half_edge = row.outer_half_edge.map(|to| h[to]);
        row.inner.iter_mut().for_each(|link| *link = link.map(|to| b[to]));
        row.inner_starts.iter_mut().for_each(|link| *link = link.map(start));
    }
    Table {
        parts: table.parts,
        vertices: placed(&table.vertices, v),
        half_edges: placed(&table.half_edges, h),
        boundaries: placed(&table.boundaries, b),
        faces: placed(&table.faces, f),
    }
}

fn placed<T: Clone>(rows: &[Option<T>], slots: &[usize]) -> Vec<Option<T>> {
    let mut placed = vec![None; slots.len()];
    for (row, slot) in rows.iter().zip(slots) {
        placed[*slot].clone_from(row);
    }
    placed
}
