//! A table whose cells are open: each gets its value when it is first read.

use super::work::{LazyWork, TooManyTables};
use std::cell::{Cell, RefCell};
use twinedge::validate::{BoundaryPlace, Link, Part, Parts, Start, Table, View};

/// A table of a size, of which the cells that were read have values.
///
/// The first read of a cell gives it its first value. [`runs`](Self::runs) then gives the last cell its next value, and opens it again after
/// the last one. So runs of a reader go through all tables, and one run stands for all tables that agree with it in the cells that it has read.
pub(super) struct OpenTable {
    parts: Parts,
    vertices: Records,
    half_edges: Records,
    boundaries: Records,
    faces: Records,
    /// The number of the value of each cell, or [`OPEN`].
    values: Vec<Cell<u8>>,
    domains: Vec<Domain>,
    choices: RefCell<Vec<Choice>>,
    /// The number of tables that agree with the choices.
    agreeing: Cell<u128>,
}

const OPEN: u8 = u8::MAX;

/// The records of one kind: the number of cells before them, and the number of cells of each.
#[derive(Clone, Copy)]
struct Records {
    count: usize,
    before: usize,
    width: usize,
}

/// The numbers of the cells of a record. The first one says whether it is vacant.
mod cell {
    pub(super) const VACANT: usize = 0;
    pub(super) const ORIGIN: usize = 1;
    pub(super) const TWIN: usize = 2;
    pub(super) const NEXT: usize = 3;
    pub(super) const PREV: usize = 4;
    /// The boundary component or face of a half-edge.
    pub(super) const NAME: usize = 5;
    pub(super) const LEAVING: usize = 1;
    pub(super) const ISOLATED: usize = 2;
    pub(super) const FACE: usize = 1;
    pub(super) const START: usize = 2;
    pub(super) const PLACE: usize = 3;
    pub(super) const OUTER: usize = 1;
    pub(super) const LENGTH: usize = 2;
    /// The first entry of the list of a face.
    pub(super) const INNER: usize = 3;
}

/// The values of a cell, by numbers from 0. For each, in how many ways the cells of the same record that depend on it can be set.
#[derive(Clone)]
struct Domain {
    ways: Vec<u128>,
    all: u128,
}

/// A cell that has a value, and the number of tables that agreed before.
#[derive(Clone, Copy)]
struct Choice {
    cell: usize,
    agreeing: u128,
}

/// The first choices of a run, each with its cell: a branch of the tree of all runs.
pub(super) type Branch = Vec<(usize, u8)>;

impl Domain {
    fn of(ways: Vec<u128>) -> Option<Self> {
        let all = ways.iter().try_fold(0_u128, |all, ways| all.checked_add(*ways))?;
        (ways.len() < usize::from(OPEN)).then_some(Self { ways, all })
    }

    /// That of a cell on which none depends; a single value for a cell that does not matter.
    fn plain(values: usize, matters: bool) -> Option<Self> {
        Self::of(vec![1; if matters { values } else { 1 }])
    }
}

/// The number of values of a link to slots: nil, each slot, and the one past the end.
const fn links(slots: usize) -> usize {
    slots + 2
}

impl OpenTable {
    /// The table of this work, with all cells open.
    ///
    /// # Errors
    /// [`TooManyTables`] if there are more tables than can be counted.
    pub(super) fn new(work: &LazyWork) -> Result<Self, TooManyTables> {
        Self::with_cells(work).ok_or(TooManyTables)
    }

    fn with_cells(work: &LazyWork) -> Option<Self> {
        let parts = work.expectation.looks_at(work.parts);
        let has = |part| parts.has(part);
        let (by_record, has_holes) = (has(Part::BoundaryComponents), has(Part::Holes));
        let plain = Domain::plain;
        let starts = 1 + (work.half_edges + 1) + (work.vertices + 1);
        // Each component of a right table has one inner boundary component, so no list is longer.
        let longest = if has_holes { work.vertices } else { 0 };
        let entries = if by_record { links(work.boundaries) } else { starts };
        let lengths =
            (0..=longest as u32).map(|length| (entries as u128).checked_pow(length)).collect::<Option<_>>()?;

        let vertex = vec![
            plain(links(work.half_edges), has(Part::Leaving))?,
            plain(links(work.boundaries), by_record && has_holes)?,
        ];
        let names = links(if by_record { work.boundaries } else { work.faces });
        let half_edge = vec![
            plain(links(work.vertices), true)?,
            plain(links(work.half_edges), true)?,
            plain(links(work.half_edges), true)?,
            plain(links(work.half_edges), has(Part::Prev))?,
            plain(names, has(Part::Faces))?,
        ];
        let boundary = vec![
            plain(links(work.faces), true)?,
            plain(starts, true)?,
            // Nil, the outer one, and each position up to the one past the end.
            plain(2 + longest + 1, has(Part::Places))?,
        ];
        let outer = links(if by_record { work.boundaries } else { work.half_edges });
        let mut face = vec![plain(outer, true)?, Domain::of(lengths)?];
        let with_list = face.iter().try_fold(1, |ways: u128, domain| ways.checked_mul(domain.all))?;
        face.resize(face.len() + longest, plain(entries, true)?);

        let mut table = Self {
            parts,
            vertices: Records { count: 0, before: 0, width: 0 },
            half_edges: Records { count: 0, before: 0, width: 0 },
            boundaries: Records { count: 0, before: 0, width: 0 },
            faces: Records { count: 0, before: 0, width: 0 },
            values: Vec::new(),
            domains: Vec::new(),
            choices: RefCell::default(),
            agreeing: Cell::new(1),
        };
        let ways = |cells: &[Domain]| cells.iter().try_fold(1, |ways: u128, cell| ways.checked_mul(cell.all));
        table.vertices = table.add(work.vertices, ways(&vertex)?, &vertex, work.vacant)?;
        table.half_edges = table.add(work.half_edges, ways(&half_edge)?, &half_edge, work.vacant)?;
        let boundaries = if by_record { work.boundaries } else { 0 };
        table.boundaries = table.add(boundaries, ways(&boundary)?, &boundary, work.vacant)?;
        let faces = if has(Part::Faces) { work.faces } else { 0 };
        table.faces = table.add(faces, with_list, &face, work.vacant)?;
        Some(table)
    }

    /// Adds records with these cells, which can be set in so many ways.
    fn add(&mut self, count: usize, ways: u128, cells: &[Domain], vacant: bool) -> Option<Records> {
        let live = Domain::of(if vacant { vec![ways, 1] } else { vec![ways] })?;
        let records = Records { count, before: self.values.len(), width: 1 + cells.len() };
        for _ in 0..count {
            self.agreeing.set(self.agreeing.get().checked_mul(live.all)?);
            self.domains.push(live.clone());
            self.domains.extend_from_slice(cells);
        }
        self.values.resize(self.domains.len(), Cell::new(OPEN));
        Some(records)
    }

    /// The number of tables that agree with all that was read.
    pub(super) fn agreeing(&self) -> u128 {
        self.agreeing.get()
    }

    /// Calls `run`, which reads the table, until every table was in one run, or `run` returns false. What had been read before stays.
    pub(super) fn runs(&self, mut run: impl FnMut(&Self) -> bool) {
        let before = self.choices.borrow().len();
        while run(self) && self.advance(before) {}
        self.retract(before);
    }

    /// The branches of the runs of a reader: their first choices, up to so many.
    pub(super) fn branches(&self, depth: usize, mut read: impl FnMut(&Self)) -> Vec<Branch> {
        let mut branches = Vec::new();
        self.runs(|table| {
            read(table);
            table.retract(depth);
            let choices = table.choices.borrow();
            branches.push(choices.iter().map(|choice| (choice.cell, table.values[choice.cell].get())).collect());
            true
        });
        branches
    }

    /// Makes the choices of a branch.
    pub(super) fn enter(&self, branch: &[(usize, u8)]) {
        for (cell, value) in branch {
            self.choose(*cell, *value);
        }
    }

    /// Opens the cells that were read after the first so many.
    pub(super) fn retract(&self, depth: usize) {
        let mut choices = self.choices.borrow_mut();
        while choices.len() > depth {
            if let Some(choice) = choices.pop() {
                self.values[choice.cell].set(OPEN);
                self.agreeing.set(choice.agreeing);
            }
        }
    }

    /// The table, with the first value in each cell that is open.
    pub(super) fn to_table(&self) -> Option<Table> {
        let depth = self.choices.borrow().len();
        let table = Table::copy_of(self);
        self.retract(depth);
        table
    }

    /// Gives the last cell that has another value that value; false if none has, of those after the first so many.
    fn advance(&self, depth: usize) -> bool {
        loop {
            let choices = self.choices.borrow();
            let Some(choice) = choices.get(depth..).and_then(<[Choice]>::last).copied() else { return false };
            let length = choices.len();
            drop(choices);
            let next = self.values[choice.cell].get() + 1;
            self.retract(length - 1);
            if usize::from(next) < self.domains[choice.cell].ways.len() {
                self.choose(choice.cell, next);
                return true;
            }
        }
    }

    fn choose(&self, cell: usize, value: u8) {
        let Domain { ways, all } = &self.domains[cell];
        let agreeing = self.agreeing.get();
        self.choices.borrow_mut().push(Choice { cell, agreeing });
        self.agreeing.set(agreeing / all * ways[usize::from(value)]);
        self.values[cell].set(value);
    }

    fn value(&self, cell: usize) -> u8 {
        if self.values[cell].get() == OPEN {
            self.choose(cell, 0);
        }
        self.values[cell].get()
    }

    /// True if the record is there. It is read first, as the other cells depend on it.
    fn is_live(&self, records: Records, record: usize) -> bool {
        record < records.count && self.value(records.before + record * records.width + cell::VACANT) == 0
    }

    /// The value of a cell of a record; nil if that is vacant.
    fn field(&self, records: Records, record: usize, field: usize) -> usize {
        if self.is_live(records, record) {
            self.value(records.before + record * records.width + field).into()
        } else {
            0
        }
    }

    fn link(&self, records: Records, record: usize, field: usize) -> Link {
        self.field(records, record, field).checked_sub(1)
    }

    /// Nil, half-edges up to the one past the end, vertices up to the one past the end.
    fn start(&self, records: Records, record: usize, field: usize) -> Option<Start> {
        let number = self.link(records, record, field)?;
        let vertex = number.checked_sub(self.half_edges.count + 1);
        Some(vertex.map_or(Start::HalfEdge(number), Start::Vertex))
    }

    fn place(&self, boundary: usize) -> Option<BoundaryPlace> {
        let number = self.link(self.boundaries, boundary, cell::PLACE)?;
        Some(number.checked_sub(1).map_or(BoundaryPlace::Outer, BoundaryPlace::Inner))
    }

    /// The cell of an entry, if the list is that long.
    fn entry(&self, face: usize, position: usize) -> Option<usize> {
        (position < self.inner_count(face)).then_some(cell::INNER + position)
    }

    /// The link, where it is one of boundary components with records, or of faces without them.
    fn only(&self, by_record: bool, link: impl FnOnce() -> Link) -> Link {
        if by_record == self.parts.has(Part::BoundaryComponents) { link() } else { None }
    }
}

impl View for OpenTable {
    twinedge::view_answers! { |this|
        parts => this.parts,
        vertex_slots => this.vertices.count,
        half_edge_slots => this.half_edges.count,
        boundary_slots => this.boundaries.count,
        face_slots => this.faces.count,
        is_vertex(v) => this.is_live(this.vertices, v),
        is_half_edge(h) => this.is_live(this.half_edges, h),
        is_boundary(b) => this.is_live(this.boundaries, b),
        is_face(f) => this.is_live(this.faces, f),
        origin(h) => this.link(this.half_edges, h, cell::ORIGIN),
        twin(h) => this.link(this.half_edges, h, cell::TWIN),
        next(h) => this.link(this.half_edges, h, cell::NEXT),
        prev(h) => this.link(this.half_edges, h, cell::PREV),
        boundary(h) => this.only(true, || this.link(this.half_edges, h, cell::NAME)),
        face(h) => this.only(false, || this.link(this.half_edges, h, cell::NAME)),
        leaving(v) => this.link(this.vertices, v, cell::LEAVING),
        isolated(v) => this.link(this.vertices, v, cell::ISOLATED),
        boundary_face(b) => this.link(this.boundaries, b, cell::FACE),
        boundary_start(b) => this.start(this.boundaries, b, cell::START),
        boundary_place(b) => this.place(b),
        outer(f) => this.only(true, || this.link(this.faces, f, cell::OUTER)),
        inner_count(f) => this.field(this.faces, f, cell::LENGTH),
        inner(f, i) => this.only(true, || this.link(this.faces, f, this.entry(f, i)?)),
        outer_half_edge(f) => this.only(false, || this.link(this.faces, f, cell::OUTER)),
        inner_start(f, i) => {
            if this.parts.has(Part::BoundaryComponents) { None } else { this.entry(f, i).and_then(|entry| this.start(this.faces, f, entry)) }
        },
    }
}
