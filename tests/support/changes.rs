//! The records written by a change.

use twinedge::validate::Table;
use twinedge::validate::near::WriteSet;
use twinedge_trials::enumerate::Cell;

/// Adds the record that contains the cell.
pub(crate) fn note(written: &mut WriteSet, cell: Cell) {
    match cell {
        Cell::Origin(h) | Cell::Twin(h) | Cell::Next(h) | Cell::Prev(h) | Cell::Boundary(h) | Cell::Face(h) => {
            written.half_edges.push(h);
        }
        Cell::Leaving(v) | Cell::Isolated(v) => written.vertices.push(v),
        Cell::BoundaryFace(b) | Cell::BoundaryStart(b) | Cell::BoundaryPlace(b) => written.boundaries.push(b),
        Cell::Outer(f) | Cell::OuterHalfEdge(f) | Cell::InnerStart(f, _) => written.faces.push(f),
        Cell::Inner(f, i) => written.listed.push((f, i)),
    }
}

/// Returns all records that differ.
pub(crate) fn difference(before: &Table, after: &Table) -> WriteSet {
    fn rows<R: PartialEq>(before: &[Option<R>], after: &[Option<R>]) -> Vec<usize> {
        let row = |rows: &[Option<R>], i: usize| -> Option<usize> { rows.get(i)?.as_ref().map(|_| i) };
        let differ = |i: &usize| {
            row(before, *i).is_some() != row(after, *i).is_some()
                || row(before, *i).is_some() && before.get(*i) != after.get(*i)
        };
        (0..before.len().max(after.len())).filter(differ).collect()
    }
    let faces = rows(&before.faces, &after.faces);
    let list = |table: &Table, f: usize| match table.faces.get(f) {
        Some(Some(row)) => row.inner.clone(),
        _ => vec![],
    };
    let mut listed = vec![];
    for f in &faces {
        let (before, after) = (list(before, *f), list(after, *f));
        listed.extend((0..before.len().max(after.len())).filter(|i| before.get(*i) != after.get(*i)).map(|i| (*f, i)));
    }
    WriteSet {
        vertices: rows(&before.vertices, &after.vertices),
        half_edges: rows(&before.half_edges, &after.half_edges),
        boundaries: rows(&before.boundaries, &after.boundaries),
        faces,
        listed,
    }
}
