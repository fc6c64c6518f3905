//! Enumerated tables: the cells of a [`Table`], and the possible values of each.
//!
//! [`for_each_corruption`] sets one cell at a time to each of its other values, which covers every effect of one wrong link.
//! [`for_each_assignment`] sets many cells to all combinations of values: all tables of a size, valid or not.

use twinedge::validate::{BoundaryPlace, HalfEdgeRow, Link, Part, Parts, Start, Table, VertexRow};

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

/// The value of a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Value {
    /// In most cells.
    Link(Link),
    /// In [`Cell::BoundaryStart`] and [`Cell::InnerStart`].
    Start(Option<Start>),
    /// In [`Cell::BoundaryPlace`].
    BoundaryPlace(Option<BoundaryPlace>),
}

enum Stored<'a> {
    Link(&'a mut Link),
    Start(&'a mut Option<Start>),
    BoundaryPlace(&'a mut Option<BoundaryPlace>),
}

/// The cells of a [`Table`].
pub trait TableCells {
    /// Returns the relevant cells of a structure with these parts, row by row. O(n).
    #[must_use]
    fn cells(&self, parts: Parts) -> Vec<Cell>;

    /// Returns every possible value of the cell: nil, every slot of the target kind, the one past the end, `usize::MAX`. O(n).
    #[must_use]
    fn values(&self, cell: Cell) -> Vec<Value>;

    /// Sets a cell and returns its old value. `None`, without any change, for an absent cell or a value of another kind. O(1).
    fn set(&mut self, cell: Cell, value: Value) -> Option<Value>;

    /// Derives the origin of each half-edge from the links, as the origin of the next of its twin, and adds a vertex for each
    /// rotation. The new vertices keep no half-edge. O(n²).
    ///
    /// ```
    /// use twinedge::validate::Table;
    /// use twinedge_trials::enumerate::TableCells;
    /// // Two half-edges, each the twin and the next of the other: an edge.
    /// let mut table: Table = "V 0 H 2 - 1 1 - - - 0 0 - - B 0 F 0".parse()?;
    /// table.derive_origins();
    /// assert_eq!(table.to_string(), "V 2 - - - - H 2 0 1 1 - - 1 0 0 - - B 0 F 0");
    /// # Ok::<(), twinedge::validate::ParseTableError>(())
    /// ```
    fn derive_origins(&mut self);
}

impl TableCells for Table {
    fn cells(&self, parts: Parts) -> Vec<Cell> {
        let has = |part| parts.has(part);
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

    fn values(&self, cell: Cell) -> Vec<Value> {
        let indices = |slots: usize| (0..=slots).chain([usize::MAX]);
        let links = |slots| std::iter::once(None).chain(indices(slots).map(Some)).map(Value::Link).collect();
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
                std::iter::once(None).chain(starts).map(Value::Start).collect()
            }
            Cell::BoundaryPlace(_) => {
                let longest = self.faces.iter().flatten().map(|row| row.inner.len()).max().unwrap_or(0);
                let places =
                    std::iter::once(BoundaryPlace::Outer).chain(indices(longest).map(BoundaryPlace::Inner)).map(Some);
                std::iter::once(None).chain(places).map(Value::BoundaryPlace).collect()
            }
        }
    }

    fn set(&mut self, cell: Cell, value: Value) -> Option<Value> {
        match (stored(self, cell)?, value) {
            (Stored::Link(stored), Value::Link(link)) => Some(Value::Link(std::mem::replace(stored, link))),
            (Stored::Start(stored), Value::Start(start)) => Some(Value::Start(std::mem::replace(stored, start))),
            (Stored::BoundaryPlace(stored), Value::BoundaryPlace(place)) => {
                Some(Value::BoundaryPlace(std::mem::replace(stored, place)))
            }
            _ => None,
        }
    }

    fn derive_origins(&mut self) {
        let half_edges = self.half_edges.len();
        let next_of_twin = |table: &Self, h: usize| {
            let link = |link: fn(&HalfEdgeRow) -> Link, h: usize| link(table.half_edges.get(h)?.as_ref()?);
            link(|row| row.twin, h).and_then(|t| link(|row| row.next, t)).filter(|h| *h < half_edges)
        };
        let mut least: Vec<usize> = (0..half_edges).collect();
        for _ in 0..half_edges {
            for h in 0..half_edges {
                if let Some(around) = next_of_twin(self, h) {
                    let first = least[h].min(least[around]);
                    (least[h], least[around]) = (first, first);
                }
            }
        }
        let mut vertices: Vec<usize> = live(&self.half_edges).map(|h| least[h]).collect();
        vertices.sort_unstable();
        vertices.dedup();
        for (h, first) in least.iter().enumerate() {
            if let Some(row) = row(&mut self.half_edges, h) {
                row.origin = vertices.binary_search(first).ok();
            }
        }
        self.vertices.clear();
        self.vertices.resize(vertices.len(), Some(VertexRow::default()));
    }
}

fn stored(table: &mut Table, cell: Cell) -> Option<Stored<'_>> {
    Some(match cell {
        Cell::Origin(h) => Stored::Link(&mut row(&mut table.half_edges, h)?.origin),
        Cell::Twin(h) => Stored::Link(&mut row(&mut table.half_edges, h)?.twin),
        Cell::Next(h) => Stored::Link(&mut row(&mut table.half_edges, h)?.next),
        Cell::Prev(h) => Stored::Link(&mut row(&mut table.half_edges, h)?.prev),
        Cell::Boundary(h) => Stored::Link(&mut row(&mut table.half_edges, h)?.boundary),
        Cell::Face(h) => Stored::Link(&mut row(&mut table.half_edges, h)?.face),
        Cell::Leaving(v) => Stored::Link(&mut row(&mut table.vertices, v)?.leaving),
        Cell::Isolated(v) => Stored::Link(&mut row(&mut table.vertices, v)?.isolated),
        Cell::BoundaryFace(b) => Stored::Link(&mut row(&mut table.boundaries, b)?.face),
        Cell::BoundaryStart(b) => Stored::Start(&mut row(&mut table.boundaries, b)?.start),
        Cell::BoundaryPlace(b) => Stored::BoundaryPlace(&mut row(&mut table.boundaries, b)?.place),
        Cell::Outer(f) => Stored::Link(&mut row(&mut table.faces, f)?.outer),
        Cell::Inner(f, i) => Stored::Link(row(&mut table.faces, f)?.inner.get_mut(i)?),
        Cell::OuterHalfEdge(f) => Stored::Link(&mut row(&mut table.faces, f)?.outer_half_edge),
        Cell::InnerStart(f, i) => Stored::Start(row(&mut table.faces, f)?.inner_starts.get_mut(i)?),
    })
}

/// Returns every way to pair off this many half-edges as twins: for each way the twin of each half-edge. Empty for an odd number.
///
/// There are (n − 1)!! = 1 · 3 · 5 · … · (n − 1) of them.
///
/// ```
/// use twinedge_trials::enumerate::pairings;
/// assert_eq!(pairings(4), [[1, 0, 3, 2], [2, 3, 0, 1], [3, 2, 1, 0]]);
/// ```
#[must_use]
pub fn pairings(half_edges: usize) -> Vec<Vec<usize>> {
    if half_edges & 1 == 1 {
        return Vec::new();
    }
    let mut all = vec![vec![usize::MAX; half_edges]];
    for _ in 0..half_edges / 2 {
        let with_one_pair_more = |twins: &Vec<usize>| {
            let alone: Vec<usize> = (0..half_edges).filter(|h| twins[*h] == usize::MAX).collect();
            let first = alone[0];
            let paired = |other: &usize| {
                let mut twins = twins.clone();
                (twins[first], twins[*other]) = (*other, first);
                twins
            };
            alone.iter().skip(1).map(paired).collect::<Vec<_>>()
        };
        all = all.iter().flat_map(with_one_pair_more).collect();
    }
    all
}

fn live<T>(rows: &[Option<T>]) -> impl Iterator<Item = usize> + '_ {
    rows.iter().enumerate().filter(|(_, row)| row.is_some()).map(|(i, _)| i)
}

fn row<T>(rows: &mut [Option<T>], i: usize) -> Option<&mut T> {
    rows.get_mut(i)?.as_mut()
}

/// Calls `visit` with the table after each change of one cell to another of its [values](TableCells::values), and with that cell
/// and value. Cells of parts that are not stored are left alone. At the end the table is unchanged. O(n) changes for each of the
/// O(n) cells.
///
/// ```
/// use twinedge_trials::enumerate::for_each_corruption;
/// use twinedge::validate::{Collect, Expectation, Part, Parts, Table, VertexRow, validate};
/// // An isolated vertex in a structure without faces: its leaving half-edge is the only cell.
/// let parts = Parts::ALL.without(Part::Faces);
/// let mut table = Table { parts, vertices: vec![Some(VertexRow::default())], ..Table::default() };
/// let mut caught = 0;
/// for_each_corruption(&mut table, parts, |corrupt, _, _| {
///     caught += usize::from(!validate(corrupt, &Expectation::plane(), Collect::First).is_valid());
/// });
/// assert_eq!(caught, 2);
/// ```
pub fn for_each_corruption(table: &mut Table, parts: Parts, mut visit: impl FnMut(&Table, Cell, Value)) {
    for cell in table.cells(parts) {
        for value in table.values(cell) {
            let Some(before) = table.set(cell, value) else { continue };
            if value != before {
                visit(table, cell, value);
            }
            table.set(cell, before);
        }
    }
}

/// Calls `visit` with every table that results from setting each of these cells to each of its values, and returns the number of
/// tables. The last cell changes fastest, and all keep their last values.
///
/// The number is the product of the numbers of values; between two visits O(1) cells change on average.
pub fn for_each_assignment(table: &mut Table, cells: &[(Cell, Vec<Value>)], mut visit: impl FnMut(&Table)) -> u64 {
    if cells.iter().any(|(_, values)| values.is_empty()) {
        return 0;
    }
    for (cell, values) in cells {
        table.set(*cell, values[0]);
    }
    let mut positions = vec![0; cells.len()];
    let mut count = 0;
    loop {
        visit(table);
        count += 1;
        // Like an odometer: the last position advances; if it wraps around, the one before it also advances.
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
