//! Every table: the cells of a [`Table`], and what each of them could be set to.
//!
//! Two walks are made of these. [`for_each_corruption`] sets one cell at a time to everything else that it could be:
//! what one broken pointer can do. [`for_each_assignment`] sets many cells to everything in all combinations: all
//! tables of a size, right or wrong.

use super::{BoundaryPlace, Expectation, Link, Part, Start, Table};
use alloc::vec::Vec;

/// One cell of a table: a field of the row with this index. Lists have a cell for each position.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[allow(missing_docs, reason = "the variants are named after the fields of the rows")]
pub enum Cell {
    Origin(usize),
    Twin(usize),
    Next(usize),
    Prev(usize),
    Boundary(usize),
    Face(usize),
    Leaving(usize),
    Isolated(usize),
    BoundaryFace(usize),
    BoundaryStart(usize),
    BoundaryPlace(usize),
    Outer(usize),
    Inner(usize, usize),
    OuterHalfEdge(usize),
    InnerStart(usize, usize),
}

/// What a cell holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Value {
    /// In most cells.
    Link(Link),
    /// In [`Cell::BoundaryStart`] and [`Cell::InnerStart`].
    Start(Option<Start>),
    /// In [`Cell::BoundaryPlace`].
    BoundaryPlace(Option<BoundaryPlace>),
}

/// The same, where it is stored.
enum Stored<'a> {
    Link(&'a mut Link),
    Start(&'a mut Option<Start>),
    BoundaryPlace(&'a mut Option<BoundaryPlace>),
}

impl Table {
    /// The cells that matter to a structure with these parts, row by row. O(n).
    #[must_use]
    pub fn cells(&self, expectation: &Expectation) -> Vec<Cell> {
        let has = |part| expectation.has(part);
        let by_record = has(Part::BoundaryComponents);
        let mut cells = Vec::new();
        let mut with = |wanted: bool, cell: Cell| cells.extend(wanted.then_some(cell));
        for h in live(&self.half_edges) {
            with(true, Cell::Origin(h));
            with(true, Cell::Twin(h));
            with(true, Cell::Next(h));
            with(has(Part::Prev), Cell::Prev(h));
            with(by_record, Cell::Boundary(h));
            with(has(Part::Faces) && !by_record, Cell::Face(h));
        }
        for v in live(&self.vertices) {
            with(has(Part::Leaving), Cell::Leaving(v));
            with(by_record && has(Part::Holes), Cell::Isolated(v));
        }
        for b in live(&self.boundaries).filter(|_| by_record) {
            with(true, Cell::BoundaryFace(b));
            with(true, Cell::BoundaryStart(b));
            with(has(Part::Places), Cell::BoundaryPlace(b));
        }
        for (f, row) in self.faces.iter().enumerate().filter(|_| has(Part::Faces)) {
            let Some(row) = row else { continue };
            with(by_record, Cell::Outer(f));
            with(!by_record, Cell::OuterHalfEdge(f));
            let listed = if by_record { row.inner.len() } else { row.inner_starts.len() };
            for i in (0..listed).filter(|_| has(Part::Holes)) {
                with(true, if by_record { Cell::Inner(f, i) } else { Cell::InnerStart(f, i) });
            }
        }
        cells
    }

    /// Everything that the cell could be set to: nil, the index of every slot of the kind that it leads to, the one
    /// past the end and the largest number there is. O(n).
    #[must_use]
    pub fn values(&self, cell: Cell) -> Vec<Value> {
        let indices = |slots: usize| (0..=slots).chain([usize::MAX]);
        let links = |slots| core::iter::once(None).chain(indices(slots).map(Some)).map(Value::Link).collect();
        match cell {
            Cell::Origin(_) => links(self.vertices.len()),
            Cell::Twin(_) | Cell::Next(_) | Cell::Prev(_) | Cell::Leaving(_) | Cell::OuterHalfEdge(_) => {
                links(self.half_edges.len())
            }
            Cell::Boundary(_) | Cell::Isolated(_) | Cell::Outer(_) | Cell::Inner(..) => links(self.boundaries.len()),
            Cell::Face(_) | Cell::BoundaryFace(_) => links(self.faces.len()),
            Cell::BoundaryStart(_) | Cell::InnerStart(..) => {
                let half_edges = indices(self.half_edges.len()).map(Start::HalfEdge);
                let vertices = indices(self.vertices.len()).map(Start::Vertex);
                let starts = half_edges.chain(vertices).map(Some);
                core::iter::once(None).chain(starts).map(Value::Start).collect()
            }
            Cell::BoundaryPlace(_) => {
                let longest = self.faces.iter().flatten().map(|row| row.inner.len()).max().unwrap_or(0);
                let places =
                    core::iter::once(BoundaryPlace::Outer).chain(indices(longest).map(BoundaryPlace::Inner)).map(Some);
                core::iter::once(None).chain(places).map(Value::BoundaryPlace).collect()
            }
        }
    }

    /// Sets a cell and returns what it held. `None`, and nothing changes, if there is no such cell or it cannot hold a
    /// value of this kind. O(1).
    pub fn set(&mut self, cell: Cell, value: Value) -> Option<Value> {
        match (self.stored(cell)?, value) {
            (Stored::Link(stored), Value::Link(link)) => Some(Value::Link(core::mem::replace(stored, link))),
            (Stored::Start(stored), Value::Start(start)) => Some(Value::Start(core::mem::replace(stored, start))),
            (Stored::BoundaryPlace(stored), Value::BoundaryPlace(place)) => {
                Some(Value::BoundaryPlace(core::mem::replace(stored, place)))
            }
            _ => None,
        }
    }

    fn stored(&mut self, cell: Cell) -> Option<Stored<'_>> {
        Some(match cell {
            Cell::Origin(h) => Stored::Link(&mut row(&mut self.half_edges, h)?.origin),
            Cell::Twin(h) => Stored::Link(&mut row(&mut self.half_edges, h)?.twin),
            Cell::Next(h) => Stored::Link(&mut row(&mut self.half_edges, h)?.next),
            Cell::Prev(h) => Stored::Link(&mut row(&mut self.half_edges, h)?.prev),
            Cell::Boundary(h) => Stored::Link(&mut row(&mut self.half_edges, h)?.boundary),
            Cell::Face(h) => Stored::Link(&mut row(&mut self.half_edges, h)?.face),
            Cell::Leaving(v) => Stored::Link(&mut row(&mut self.vertices, v)?.leaving),
            Cell::Isolated(v) => Stored::Link(&mut row(&mut self.vertices, v)?.isolated),
            Cell::BoundaryFace(b) => Stored::Link(&mut row(&mut self.boundaries, b)?.face),
            Cell::BoundaryStart(b) => Stored::Start(&mut row(&mut self.boundaries, b)?.start),
            Cell::BoundaryPlace(b) => Stored::BoundaryPlace(&mut row(&mut self.boundaries, b)?.place),
            Cell::Outer(f) => Stored::Link(&mut row(&mut self.faces, f)?.outer),
            Cell::Inner(f, i) => Stored::Link(row(&mut self.faces, f)?.inner.get_mut(i)?),
            Cell::OuterHalfEdge(f) => Stored::Link(&mut row(&mut self.faces, f)?.outer_half_edge),
            Cell::InnerStart(f, i) => Stored::Start(row(&mut self.faces, f)?.inner_starts.get_mut(i)?),
        })
    }
}

fn live<T>(rows: &[Option<T>]) -> impl Iterator<Item = usize> + '_ {
    rows.iter().enumerate().filter(|(_, row)| row.is_some()).map(|(i, _)| i)
}

fn row<T>(rows: &mut [Option<T>], i: usize) -> Option<&mut T> {
    rows.get_mut(i)?.as_mut()
}

/// Calls `visit` with the table as it is after each change of one cell to another of its [values](Table::values), and
/// with that cell and value. The table is the same again in the end. O(n) changes for each of the O(n) cells.
///
/// ```
/// use twinedge::validate::enumerate::for_each_corruption;
/// use twinedge::validate::{Collect, Expectation, Part, Table, VertexRow, validate};
/// // An isolated vertex in a structure without faces: a leaving half-edge is the only thing that it could get wrong.
/// let mut table = Table { vertices: vec![Some(VertexRow::default())], ..Table::default() };
/// let expectation = Expectation::plane().without(Part::Faces);
/// let mut caught = 0;
/// for_each_corruption(&mut table, &expectation, |corrupt, _, _| {
///     caught += usize::from(!validate(corrupt, &expectation, Collect::First).is_valid());
/// });
/// assert_eq!(caught, 2);
/// ```
pub fn for_each_corruption(table: &mut Table, expectation: &Expectation, mut visit: impl FnMut(&Table, Cell, Value)) {
    for cell in table.cells(expectation) {
        for value in table.values(cell) {
            let Some(before) = table.set(cell, value) else { continue };
            if value != before {
                visit(table, cell, value);
            }
            table.set(cell, before);
        }
    }
}

/// Calls `visit` with every table that results from setting each of these cells to each of its values, and returns how
/// many these were. The last cell changes fastest, and all keep their last values.
///
/// The number is the product of the numbers of values; between two visits O(1) cells change on average.
pub fn for_each_assignment(table: &mut Table, cells: &[(Cell, Vec<Value>)], mut visit: impl FnMut(&Table)) -> u64 {
    if cells.iter().any(|(_, values)| values.is_empty()) {
        return 0;
    }
    for (cell, values) in cells {
        table.set(*cell, values[0]);
    }
    let mut positions = alloc::vec![0; cells.len()];
    let mut count = 0;
    loop {
        visit(table);
        count += 1;
        // Like a mileage counter: the last position moves on, and where it is through, starts again and takes the one
        // before.
        let mut digits = positions.iter_mut().zip(cells).rev();
        let moved = digits.find_map(|(position, (cell, values))| {
            *position = (*position + 1) % values.len();
            table.set(*cell, values[*position]);
            (*position > 0).then_some(())
        });
        if moved.is_none() {
            return count;
        }
    }
}
