//! A table with open cells: each gets its value when it is first read.

use super::labels::{Entries, LabelSource, Order, Shape};
use super::work::{LazyError, LazyWork, MOST_SLOTS};
use std::cell::{Cell, RefCell};
use twinedge::validate::{BoundaryPlace, Link, Part, Parts, Start, View};
use twinedge_certificate::Column;

/// A table of a size, in which the cells that were read have values.
///
/// The first read of a cell gives it its first value. [`runs`](Self::runs) then advances the last cell to its next value, and
/// opens it again after the last one. The runs thus go through all tables, and one covers all tables that agree in the cells
/// read.
pub(super) struct OpenTable {
    parts: Parts,
    vertices: Records,
    half_edges: Records,
    boundaries: Records,
    faces: Records,
    labels: [Option<Labels>; Column::ALL.len()],
    /// The index of the value of each cell, or [`OPEN`].
    values: Vec<Cell<u8>>,
    /// The number in each cell that has a place in an order, if it has a value.
    numbers: Vec<Cell<u32>>,
    domains: Vec<Domain>,
    choices: RefCell<Vec<Choice>>,
    /// For each of the leading statements that hold, the number of choices that establish it.
    held: RefCell<Vec<usize>>,
    /// The number of tables that agree with the choices.
    agreeing: Cell<u128>,
    /// The slots with a cell that was read, and the targets of links. Others are interchangeable. `None` where no slots are.
    told_apart: Option<Cell<Slots>>,
}

/// A set of slots, at most [`MOST_SLOTS`], one bit each: of vertices, half-edges, boundary components and faces.
type Slots = [u16; 4];

#[derive(Clone, Copy)]
enum Kind {
    Vertex,
    HalfEdge,
    Boundary,
    Face,
}

const OPEN: u8 = u8::MAX;

/// The records of one kind: the number of cells before them, the number of cells of each, and whether they can be vacant.
#[derive(Clone, Copy, Default)]
struct Records {
    count: usize,
    before: usize,
    width: usize,
    vacant: bool,
}

/// A column of labels: the number of cells before it, and the largest number of entries. The first cell is the number of entries.
#[derive(Clone, Copy)]
struct Labels {
    before: usize,
    longest: usize,
}

/// The numbers of the cells of a record. The first cell states whether it is vacant.
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
    pub(super) const INNER: usize = 3;
}

/// The values of a cell, by numbers from 0. For each, the number of ways to set the cells of the same record that depend on it.
#[derive(Clone)]
struct Domain {
    ways: Vec<u128>,
    all: u128,
    /// The slot that the value leads to, if any.
    leads_to: Vec<Option<(Kind, usize)>>,
    /// The column, if its numbers are only compared with each other. A value is then a place among the numbers read.
    order_of: Option<Column>,
}

/// A cell with a value, the number of tables that agreed before, and the slots that were told apart before.
#[derive(Clone, Copy)]
struct Choice {
    cell: usize,
    agreeing: u128,
    told_apart: Slots,
}

/// The first choices of a run, each with its cell: a branch of the tree of all runs.
pub(super) type Branch = Vec<(usize, u8)>;

impl Domain {
    fn of(ways: Vec<u128>) -> Option<Self> {
        let all = ways.iter().try_fold(0_u128, |all, ways| all.checked_add(*ways))?;
        (ways.len() < usize::from(OPEN)).then_some(Self { ways, all, leads_to: Vec::new(), order_of: None })
    }

    /// The domain of a link to slots of this kind: nil, each slot, and the one past the end. Starts have slots of two kinds.
    fn links(slots: &[(Kind, usize)], matters: bool) -> Option<Self> {
        let mut leads_to = vec![None];
        for (kind, count) in slots {
            leads_to.extend((0..*count).map(|slot| Some((*kind, slot))));
            leads_to.push(None);
        }
        Some(Self { leads_to, ..Self::plain(1 + slots.iter().map(|(_, count)| count + 1).sum::<usize>(), matters)? })
    }

    /// The domain of a cell without dependent cells; a single value for an irrelevant cell.
    fn plain(values: usize, matters: bool) -> Option<Self> {
        Self::of(vec![1; if matters { values } else { 1 }])
    }
}

impl OpenTable {
    /// Returns the table of this work, with all cells open.
    ///
    /// # Errors
    /// [`LazyError::TooMany`] if there are more tables than can be counted, or too many slots.
    pub(super) fn new(work: &LazyWork) -> Result<Self, LazyError> {
        Self::with_cells(work).ok_or(LazyError::TooMany)
    }

    /// Adds labels with open cells: columns of these shapes.
    ///
    /// # Errors
    /// [`LazyError::TooMany`] if there are more tables with labels than can be counted.
    pub(super) fn with_labels(mut self, shapes: &[Shape]) -> Result<Self, LazyError> {
        shapes.iter().try_for_each(|shape| self.add_labels(shape)).ok_or(LazyError::TooMany).map(|()| self)
    }

    fn add_labels(&mut self, shape: &Shape) -> Option<()> {
        let entry = match shape.entries {
            Entries::Links(numbers) => Domain::plain(1 + numbers, true)?,
            Entries::Ordered(numbers) => {
                let places = Domain::plain(Order::places(shape.longest), true)?;
                Domain { all: 1 + numbers as u128, order_of: Some(shape.column), ..places }
            }
        };
        let shortest = if shape.is_any_length { 0 } else { shape.longest };
        let ways = (shortest..=shape.longest).map(|length| entry.all.checked_pow(length as u32));
        let lengths = Domain::of(ways.collect::<Option<_>>()?)?;
        self.agreeing.set(self.agreeing.get().checked_mul(lengths.all)?);
        self.labels[shape.column as usize] = Some(Labels { before: self.domains.len(), longest: shape.longest });
        self.domains.push(lengths);
        self.domains.resize(self.domains.len() + shape.longest, entry);
        self.values.resize(self.domains.len(), Cell::new(OPEN));
        self.numbers.resize(self.domains.len(), Cell::new(0));
        Some(())
    }

    fn with_cells(work: &LazyWork) -> Option<Self> {
        if [work.vertices, work.half_edges, work.boundaries, work.faces].iter().any(|slots| *slots > MOST_SLOTS) {
            return None;
        }
        let parts = work.parts();
        let has = |part| parts.has(part);
        let (by_record, has_holes) = (has(Part::BoundaryComponents), has(Part::Holes));
        let (to_vertex, to_half_edge) = ((Kind::Vertex, work.vertices), (Kind::HalfEdge, work.half_edges));
        let (to_boundary, to_face) = ((Kind::Boundary, work.boundaries), (Kind::Face, work.faces));
        let starts = Domain::links(&[to_half_edge, to_vertex], true)?;
        let link = |to| Domain::links(&[to], true);
        // Each component of a valid table has one inner boundary component, so no list is longer.
        let longest = if has_holes { work.vertices } else { 0 };
        let entry = if by_record { link(to_boundary)? } else { starts.clone() };
        let lengths = (0..=longest as u32).map(|length| entry.all.checked_pow(length)).collect::<Option<_>>()?;
        let vertex = vec![
            Domain::links(&[to_half_edge], has(Part::Leaving))?,
            Domain::links(&[to_boundary], by_record && has_holes)?,
        ];
        let half_edge = vec![
            link(to_vertex)?,
            link(to_half_edge)?,
            link(to_half_edge)?,
            Domain::links(&[to_half_edge], has(Part::Prev))?,
            Domain::links(&[if by_record { to_boundary } else { to_face }], has(Part::Faces))?,
        ];
        // A place is nil, the outer one, or a position up to the one past the end.
        let boundary = vec![link(to_face)?, starts, Domain::plain(2 + longest + 1, has(Part::Places))?];
        let mut face = vec![link(if by_record { to_boundary } else { to_half_edge })?, Domain::of(lengths)?];
        let with_list = face.iter().try_fold(1, |ways: u128, domain| ways.checked_mul(domain.all))?;
        face.resize(face.len() + longest, entry);

        let mut table = Self {
            parts,
            vertices: Records::default(),
            half_edges: Records::default(),
            boundaries: Records::default(),
            faces: Records::default(),
            labels: [None; Column::ALL.len()],
            values: Vec::new(),
            numbers: Vec::new(),
            domains: Vec::new(),
            choices: RefCell::default(),
            held: RefCell::default(),
            agreeing: Cell::new(1),
            told_apart: None,
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

    /// Returns the table in which tables that differ only in the numbers of their slots are equivalent.
    ///
    /// Two slots of a kind that are not told apart can exchange their numbers without changing anything read. A link to one of
    /// them therefore leads to the first and stands for all. A run covers all of these tables if its reader treats them alike.
    pub(super) fn up_to_numbers(self) -> Self {
        Self { told_apart: Some(Cell::default()), ..self }
    }

    /// Adds records with these cells, which can be set in `ways` ways.
    fn add(&mut self, count: usize, ways: u128, cells: &[Domain], vacant: bool) -> Option<Records> {
        let live = Domain::of(if vacant { vec![ways, 1] } else { vec![ways] })?;
        let records = Records { count, before: self.values.len(), width: 1 + cells.len(), vacant };
        for _ in 0..count {
            self.agreeing.set(self.agreeing.get().checked_mul(live.all)?);
            self.domains.push(live.clone());
            self.domains.extend_from_slice(cells);
        }
        self.values.resize(self.domains.len(), Cell::new(OPEN));
        Some(records)
    }

    /// Returns the number of tables that agree with all cells read.
    pub(super) fn agreeing(&self) -> u128 {
        self.agreeing.get()
    }

    /// Calls `run`, which reads the table, until all tables had a run, or `run` returns false. Earlier cells keep their values.
    pub(super) fn runs(&self, mut run: impl FnMut(&Self) -> bool) {
        let before = self.choices.borrow().len();
        while run(self) && self.advance(before) {}
        self.retract(before);
    }

    /// Returns true if all of these statements hold for the table. They are tried in order.
    ///
    /// A statement that holds is not tried again while the cells read by then keep their values: it would read no others. All
    /// calls must therefore be about the same statements.
    pub(super) fn all_hold(&self, statements: usize, holds: impl Fn(usize) -> bool) -> bool {
        let known = self.held.borrow().len();
        (known..statements).all(|statement| {
            let is_kept = holds(statement);
            if is_kept {
                self.held.borrow_mut().push(self.choices.borrow().len());
            }
            is_kept
        })
    }

    /// Returns the branches of the runs of a reader: their first choices, up to a depth.
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

    /// Returns the branches with one more choice than this one, for the next cell of the reader, or none after the last.
    pub(super) fn longer(&self, branch: &Branch, read: impl FnOnce(&Self)) -> Vec<Branch> {
        self.enter(branch);
        read(self);
        let next = self.choices.borrow().get(branch.len()).map(|choice| choice.cell);
        self.retract(branch.len());
        let values = |cell: usize| (0..self.domains[cell].ways.len() as u8).map(move |value| (cell, value));
        let choices = next.into_iter().flat_map(values).filter(|(cell, value)| self.agreeing_with(*cell, *value) > 0);
        let longer = choices.map(|choice| branch.iter().copied().chain([choice]).collect()).collect();
        self.retract(0);
        longer
    }

    pub(super) fn enter(&self, branch: &[(usize, u8)]) {
        for (cell, value) in branch {
            self.choose(*cell, *value);
        }
    }

    /// Opens the cells that were read after the first `depth` ones.
    pub(super) fn retract(&self, depth: usize) {
        let mut choices = self.choices.borrow_mut();
        while choices.len() > depth {
            if let Some(choice) = choices.pop() {
                self.values[choice.cell].set(OPEN);
                self.agreeing.set(choice.agreeing);
                if let Some(told_apart) = &self.told_apart {
                    told_apart.set(choice.told_apart);
                }
            }
        }
        let mut held = self.held.borrow_mut();
        let known = held.partition_point(|choices| *choices <= depth);
        held.truncate(known);
    }

    /// Reads the table, with the first value in each open cell.
    pub(super) fn read<T>(&self, read: impl FnOnce(&Self) -> T) -> T {
        let depth = self.choices.borrow().len();
        let found = read(self);
        self.retract(depth);
        found
    }

    /// Advances the last cell with another value, after the first `depth` ones; false without such a cell.
    fn advance(&self, depth: usize) -> bool {
        loop {
            let length = self.choices.borrow().len();
            let choice = self.choices.borrow().get(depth..).and_then(<[Choice]>::last).copied();
            let Some(Choice { cell, .. }) = choice else { return false };
            let next = self.values[cell].get() + 1;
            self.retract(length - 1);
            if self.choose_from(cell, next) {
                return true;
            }
        }
    }

    /// Gives the cell the first value from this one on, skipping values of interchangeable slots; false without such a value.
    fn choose_from(&self, cell: usize, first: u8) -> bool {
        let values = first..self.domains[cell].ways.len() as u8;
        let value = values.into_iter().find(|value| self.agreeing_with(cell, *value) > 0);
        value.is_some_and(|value| {
            self.choose(cell, value);
            true
        })
    }

    fn choose(&self, cell: usize, value: u8) {
        let agreeing = self.agreeing.get();
        let told_apart = self.told_apart.as_ref().map_or_else(Slots::default, Cell::get);
        self.choices.borrow_mut().push(Choice { cell, agreeing, told_apart });
        self.agreeing.set(self.agreeing_with(cell, value));
        if let Some(column) = self.domains[cell].order_of {
            self.numbers[cell].set(self.order(column).number(value.into()));
        }
        self.values[cell].set(value);
        if let Some(told_apart) = &self.told_apart {
            let mut slots = self.with_owner(told_apart.get(), cell);
            if let Some((kind, slot)) = self.leads_to(cell, value) {
                slots[kind as usize] |= 1 << slot;
            }
            told_apart.set(slots);
        }
    }

    /// Returns the number of tables that agree with the cells read and this value of an open cell; 0 if another represents it.
    fn agreeing_with(&self, cell: usize, value: u8) -> u128 {
        let (agreeing, Domain { ways, all, order_of, .. }) = (self.agreeing.get(), &self.domains[cell]);
        match order_of {
            Some(column) => self.order(*column).agreeing(agreeing, *all, value.into()),
            None => agreeing / all * ways[usize::from(value)] * self.stands_for(cell, value),
        }
    }

    /// Returns the numbers that were read in a column.
    fn order(&self, column: Column) -> Order {
        let mut order = Order::default();
        if let Some(Labels { before, longest }) = self.labels[column as usize] {
            let read = (before + 1..=before + longest).filter(|cell| self.values[*cell].get() != OPEN);
            read.for_each(|cell| order.add(self.numbers[cell].get()));
        }
        order
    }

    fn leads_to(&self, cell: usize, value: u8) -> Option<(Kind, usize)> {
        self.domains[cell].leads_to.get(usize::from(value)).copied().flatten()
    }

    /// The number of slots that the value represents: 1 for a slot told apart from all others, 0 if another represents it.
    fn stands_for(&self, cell: usize, value: u8) -> u128 {
        let (Some(told_apart), Some((kind, slot))) = (&self.told_apart, self.leads_to(cell, value)) else { return 1 };
        let told_apart = self.with_owner(told_apart.get(), cell)[kind as usize];
        let others = !told_apart & ((1 << self.records(kind).count) - 1);
        match others >> slot & 1 {
            0 => 1,
            _ if others.trailing_zeros() as usize == slot => others.count_ones().into(),
            _ => 0,
        }
    }

    /// Returns these slots, and the slot of the record with this cell.
    fn with_owner(&self, mut slots: Slots, cell: usize) -> Slots {
        for kind in [Kind::Vertex, Kind::HalfEdge, Kind::Boundary, Kind::Face] {
            let Records { count, before, width, .. } = self.records(kind);
            if let Some(at) = cell.checked_sub(before).filter(|at| *at < count * width) {
                slots[kind as usize] |= 1 << (at / width);
            }
        }
        slots
    }

    fn records(&self, kind: Kind) -> Records {
        match kind {
            Kind::Vertex => self.vertices,
            Kind::HalfEdge => self.half_edges,
            Kind::Boundary => self.boundaries,
            Kind::Face => self.faces,
        }
    }

    fn value(&self, cell: usize) -> u8 {
        if self.values[cell].get() == OPEN {
            // The first value is nil, or marks the record as live.
            self.choose(cell, 0);
        }
        self.values[cell].get()
    }

    /// Returns true if the record is live. This is read first, as the other cells depend on it.
    fn is_live(&self, records: Records, record: usize) -> bool {
        let cell = records.before + record * records.width + cell::VACANT;
        record < records.count && (!records.vacant || self.value(cell) == 0)
    }

    /// Returns the value of a cell of a record; nil if that is vacant.
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

    /// Returns the cell of an entry, if the list is that long.
    fn entry(&self, face: usize, position: usize) -> Option<usize> {
        (position < self.inner_count(face)).then_some(cell::INNER + position)
    }

    /// Returns the link, if it belongs to boundary components with records, or to faces without them.
    fn only(&self, by_record: bool, link: impl FnOnce() -> Link) -> Link {
        if by_record == self.parts.has(Part::BoundaryComponents) { link() } else { None }
    }
}

/// The first value of a link is nil, and the others are the numbers from 0.
impl LabelSource for OpenTable {
    fn count(&self, column: Column) -> usize {
        match self.labels[column as usize] {
            None => 0,
            Some(Labels { before, longest }) if self.domains[before].ways.len() == 1 => longest,
            Some(Labels { before, .. }) => self.value(before).into(),
        }
    }

    fn at(&self, column: Column, entry: usize) -> Option<u32> {
        let Labels { before, .. } = self.labels[column as usize]?;
        let cell = before + 1 + entry;
        let value = if entry < self.count(column) { self.value(cell) } else { return None };
        let is_link = self.domains[cell].order_of.is_none();
        Some(if is_link { u32::from(value).checked_sub(1).unwrap_or(u32::MAX) } else { self.numbers[cell].get() })
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
