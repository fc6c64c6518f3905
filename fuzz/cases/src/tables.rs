//! The target that passes arbitrary structures to the validator.

use arbitrary::Unstructured;
use std::cell::RefCell;
use twinedge::dcel::Dcel;
use twinedge::program::choose::Choose;
use twinedge::program::{Program, Runner};
use twinedge::validate::reference::broken_rules;
use twinedge::validate::{
    BoundaryPlace, BoundaryRow, Collect, Expectation, FaceRow, HalfEdgeRow, Link, Part, Parts, Report, Start, Table,
    VertexRow, View, validate,
};
use twinedge_trials::enumerate::TableCells;
use twinedge_trials::forms::{Form, projections};
use twinedge_trials::opinions::disagreement;

/// The largest number of records of a kind in a table for the reference validator, which takes cubic time.
const SMALL: usize = 12;

/// Numbers from bytes.
pub(crate) struct Source<'a>(pub(crate) Unstructured<'a>);

impl Source<'_> {
    pub(crate) fn below(&mut self, n: usize) -> usize {
        Choose::choose(&mut self.0, n)
    }

    pub(crate) fn one_in(&mut self, n: usize) -> bool {
        self.below(n) == 1
    }

    /// Mostly an existing index; otherwise nil, one past the end, or a huge one.
    fn link(&mut self, n: usize) -> Link {
        match self.below(16) {
            0 => None,
            1 => Some(n),
            2 => Some(usize::MAX - self.below(3)),
            _ => Some(self.below(n)),
        }
    }

    fn start(&mut self, half_edges: usize, vertices: usize) -> Option<Start> {
        if self.one_in(3) { self.link(vertices).map(Start::Vertex) } else { self.link(half_edges).map(Start::HalfEdge) }
    }

    fn place(&mut self, longest: usize) -> Option<BoundaryPlace> {
        if self.below(2) == 0 { Some(BoundaryPlace::Outer) } else { self.link(longest).map(BoundaryPlace::Inner) }
    }

    fn rows<T>(&mut self, n: usize, mut row: impl FnMut(&mut Self) -> T) -> Vec<Option<T>> {
        (0..n).map(|_| (!self.one_in(16)).then(|| row(self))).collect()
    }

    /// Any table.
    pub(crate) fn table(&mut self) -> Table {
        let most = if self.one_in(8) { 200 } else { SMALL + 1 };
        let [v, h, b, f] = [(); 4].map(|()| self.below(most));
        let longest = 4;
        Table {
            parts: Parts::ALL,
            vertices: self.rows(v, |s| VertexRow { leaving: s.link(h), isolated: s.link(b) }),
            half_edges: self.rows(h, |s| HalfEdgeRow {
                origin: s.link(v),
                twin: s.link(h),
                next: s.link(h),
                prev: s.link(h),
                boundary: s.link(b),
                face: s.link(f),
            }),
            boundaries: self.rows(b, |s| BoundaryRow {
                face: s.link(f),
                start: s.start(h, v),
                place: s.place(longest),
            }),
            faces: self.rows(f, |s| FaceRow {
                outer: s.link(b),
                inner: (0..s.below(longest)).map(|_| s.link(b)).collect(),
                outer_half_edge: s.link(h),
                inner_starts: (0..s.below(longest)).map(|_| s.start(h, v)).collect(),
            }),
        }
    }

    pub(crate) fn form(&mut self) -> Form {
        let mut expectation = if self.one_in(4) { Expectation::surface() } else { Expectation::plane() };
        if self.one_in(4) {
            expectation = expectation.open();
        }
        let mut parts = Parts::ALL;
        if self.one_in(2) {
            for part in Part::ALL {
                if self.one_in(3) {
                    parts = parts.without(part);
                }
            }
        }
        Form::new(expectation, parts)
    }

    /// A map that is valid in this form, with a few cells set to something else.
    pub(crate) fn corrupt_map(&mut self, form: Form) -> Table {
        let corruptions = self.below(4);
        let choices: Vec<(usize, usize)> =
            (0..corruptions).map(|_| (self.below(0x1_0000), self.below(0x1_0000))).collect();
        let mut table = right_map(self.0.bytes(self.0.len()).unwrap_or_default(), &form);
        for (cell, value) in choices {
            let cells = table.cells(form.parts);
            let Some(cell) = cells.get(cell % cells.len().max(1)) else { continue };
            let values = table.values(*cell);
            table.set(*cell, values[value % values.len()]);
        }
        table
    }
}

/// The map that a program makes, stored in this form. If open boundaries are expected, the bytes decide whether it has
/// one, and where.
///
/// # Panics
/// Never: there is always a valid form.
#[must_use]
pub fn right_map(program: &[u8], form: &Form) -> Table {
    let mut forms = {
        let mut program = Program::from_bytes(program);
        program.0.truncate(40);
        let mut runner = Runner::new(Dcel::new());
        runner.run(&program);
        projections(&Table::copy_of(runner.subject()).unwrap_or_default(), form)
    };
    // This consumes no byte, so that inputs keep their meaning.
    let chosen = program.iter().fold(0_usize, |sum, byte| sum + usize::from(*byte)) % forms.len();
    forms.swap_remove(chosen)
}

/// A structure that answers differently each time.
pub(crate) struct Fickle<'a> {
    parts: Parts,
    slots: [usize; 4],
    source: RefCell<Source<'a>>,
}

impl<'a> Fickle<'a> {
    pub(crate) fn new(parts: Parts, mut source: Source<'a>) -> Self {
        let slots = [(); 4].map(|()| source.below(64));
        Self { parts, slots, source: RefCell::new(source) }
    }

    fn link(&self, kind: usize) -> Link {
        self.source.borrow_mut().link(self.slots[kind])
    }
}

impl View for Fickle<'_> {
    fn parts(&self) -> Parts {
        self.parts
    }
    fn vertex_slots(&self) -> usize {
        self.slots[0]
    }
    fn half_edge_slots(&self) -> usize {
        self.slots[1]
    }
    fn boundary_slots(&self) -> usize {
        self.slots[2]
    }
    fn face_slots(&self) -> usize {
        self.slots[3]
    }
    fn is_vertex(&self, _: usize) -> bool {
        !self.source.borrow_mut().one_in(16)
    }
    fn is_half_edge(&self, _: usize) -> bool {
        !self.source.borrow_mut().one_in(16)
    }
    fn origin(&self, _: usize) -> Link {
        self.link(0)
    }
    fn twin(&self, _: usize) -> Link {
        self.link(1)
    }
    fn next(&self, _: usize) -> Link {
        self.link(1)
    }
    fn prev(&self, _: usize) -> Link {
        self.link(1)
    }
    fn boundary(&self, _: usize) -> Link {
        self.link(2)
    }
    fn face(&self, _: usize) -> Link {
        self.link(3)
    }
    fn leaving(&self, _: usize) -> Link {
        self.link(1)
    }
    fn isolated(&self, _: usize) -> Link {
        self.link(2)
    }
    fn boundary_face(&self, _: usize) -> Link {
        self.link(3)
    }
    fn boundary_start(&self, _: usize) -> Option<Start> {
        self.source.borrow_mut().start(self.slots[1], self.slots[0])
    }
    fn boundary_place(&self, _: usize) -> Option<BoundaryPlace> {
        self.source.borrow_mut().place(4)
    }
    fn outer(&self, _: usize) -> Link {
        self.link(2)
    }
    fn inner_count(&self, _: usize) -> usize {
        match self.source.borrow_mut().below(64) {
            63 => usize::MAX,
            n => n % 4,
        }
    }
    fn inner(&self, _: usize, _: usize) -> Link {
        self.link(2)
    }
    fn outer_half_edge(&self, _: usize) -> Link {
        self.link(1)
    }
    fn inner_start(&self, _: usize, _: usize) -> Option<Start> {
        self.source.borrow_mut().start(self.slots[1], self.slots[0])
    }
}

/// Passes any table, a valid map of the expected form with a few cells changed, or a structure that changes its answers
/// to the validator. The validator returns, does not contradict itself, and on small tables agrees with the reference
/// validator.
///
/// # Panics
/// If it contradicts itself or the reference.
pub fn validator_total(bytes: &[u8]) {
    let mut source = Source(Unstructured::new(bytes));
    let mode = source.below(4);
    let form = source.form();
    let Form { expectation, parts } = form;
    match mode {
        0 => judged(&Table { parts, ..source.table() }, expectation),
        3 => {
            coherent(&validate(&Fickle::new(parts, source), &expectation, Collect::AtMost(5)), 5);
        }
        _ => judged(&source.corrupt_map(form), expectation),
    }
}

fn judged(table: &Table, expectation: Expectation) {
    let report = validate(table, &expectation, Collect::All);
    coherent(&report, Collect::DEFAULT_CAP);
    for (collect, cap) in [(Collect::First, 1), (Collect::AtMost(0), 0)] {
        let other = validate(table, &expectation, collect);
        coherent(&other, cap);
        assert_eq!(other.is_valid(), report.is_valid(), "{collect:?}: {table:?}\n{expectation:?}\n{report}");
    }
    let kinds = [table.vertices.len(), table.half_edges.len() / 2, table.boundaries.len(), table.faces.len()];
    if kinds.iter().all(|n| *n <= SMALL) {
        let difference = disagreement(&report, &broken_rules(table, &expectation));
        assert_eq!(difference, None, "{table:#?}\n{expectation:?}\n{report}");
    }
}

/// Checks that the statements of a report agree with each other.
fn coherent(report: &Report, cap: usize) {
    let found = report.violation_count();
    assert_eq!(report.violations().len() as u64, found.min(cap as u64), "{report}");
    assert!(found == 0 || !report.is_valid(), "{report}");
    assert_eq!(report.figures().is_some(), report.is_valid(), "{report}");
    assert!(!report.to_string().is_empty());
}
