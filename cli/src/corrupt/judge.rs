//! Corrupting a table and asking both validators.

use super::watch::{HUNG, Watch, Watched};
use crate::random::Random;
use crate::work;
use serde::Serialize;
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::time::Duration;
use twinedge::program::census::Found;
use twinedge::validate::enumerate::{Cell, Value, for_each_corruption};
use twinedge::validate::reference::first_broken_rule;
use twinedge::validate::{Collect, Expectation, Link, Part, Start, Table, validate};

/// What the tables of a map look like.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum Form {
    /// With records for boundary components.
    Records,
    /// Without, as in the textbooks: half-edges name their face, and faces name half-edges.
    Textbook,
}

impl Form {
    pub(super) const fn name(self) -> &'static str {
        match self {
            Self::Records => "records",
            Self::Textbook => "textbook",
        }
    }

    const fn expectation(self) -> Expectation {
        match self {
            Self::Records => Expectation::plane(),
            Self::Textbook => Expectation::plane().without(Part::BoundaryComponents),
        }
    }
}

/// One map in one form.
#[derive(Clone, Debug)]
pub(super) struct Specimen {
    form: Form,
    table: Table,
    program: String,
}

impl Specimen {
    /// The tables of a map, each with a vacant row. None if there is no memory for it.
    pub(super) fn new(found: &Found, form: Form) -> Option<Self> {
        let mut table = Table::copy_of(found.runner.kernel())?;
        if form == Form::Textbook {
            drop_boundaries(&mut table);
        }
        table.vertices.push(None);
        table.half_edges.push(None);
        table.boundaries.push(None);
        table.faces.push(None);
        Some(Self { form, table, program: found.program.to_string() })
    }
}

/// Takes the records for boundary components away: half-edges name their face instead, and faces where their cycles start.
fn drop_boundaries(table: &mut Table) {
    let boundaries = std::mem::take(&mut table.boundaries);
    let record = |b: Link| boundaries.get(b?).copied().flatten();
    for half_edge in table.half_edges.iter_mut().flatten() {
        half_edge.face = record(half_edge.boundary.take()).and_then(|b| b.face);
    }
    for vertex in table.vertices.iter_mut().flatten() {
        vertex.isolated = None;
    }
    for face in table.faces.iter_mut().flatten() {
        face.outer_half_edge = match record(face.outer.take()).and_then(|b| b.start) {
            Some(Start::HalfEdge(h)) => Some(h),
            _ => None,
        };
        face.inner_starts = std::mem::take(&mut face.inner).into_iter().map(|b| record(b)?.start).collect();
    }
}

/// What came of some corruptions.
#[derive(Clone, Debug, Default)]
pub(super) struct Tally {
    pub(super) corruptions: u64,
    /// Wrong by the reference.
    pub(super) wrong: u64,
    /// Wrong, and the validator says so.
    pub(super) caught: u64,
    pub(super) missed: u64,
    pub(super) false_alarms: u64,
    pub(super) hung: u64,
    pub(super) panics: u64,
    pub(super) slowest: Duration,
}

impl Tally {
    pub(super) fn add(&mut self, other: &Self) {
        self.corruptions += other.corruptions;
        self.wrong += other.wrong;
        self.caught += other.caught;
        self.missed += other.missed;
        self.false_alarms += other.false_alarms;
        self.hung += other.hung;
        self.panics += other.panics;
        self.slowest = self.slowest.max(other.slowest);
    }
}

/// What one thread found.
#[derive(Clone, Debug, Default)]
pub(super) struct Judged {
    pub(super) fields: BTreeMap<(Form, &'static str), Tally>,
    pub(super) pairs: Tally,
    /// The first disagreements.
    pub(super) findings: Vec<String>,
}

impl Judged {
    pub(super) const MOST_FINDINGS: usize = 10;
}

/// One thread that asks both validators.
#[derive(Debug)]
pub(super) struct Judge<'a> {
    watch: &'a Watch,
    watched: Arc<Watched>,
    judged: Judged,
}

impl<'a> Judge<'a> {
    pub(super) fn new(watch: &'a Watch) -> Self {
        Self { watch, watched: watch.thread(), judged: Judged::default() }
    }

    pub(super) fn into_judged(self) -> Judged {
        self.judged
    }

    /// All single corruptions of a map.
    pub(super) fn corrupt(&mut self, specimen: &Specimen) {
        let Specimen { form, table, program } = specimen;
        self.watched.about(format!("a field of the {} of\n{program}", form.name()));
        for_each_corruption(&mut table.clone(), &form.expectation(), |table, cell, value| {
            if work::stopped() {
                return;
            }
            let tally = self.compare(specimen, table, &[(cell, value)]);
            self.judged.fields.entry((*form, field(cell))).or_default().add(&tally);
        });
    }

    /// Pairs of corruptions, of maps and fields that are drawn by lot.
    pub(super) fn corrupt_pairs(&mut self, specimens: &[Specimen], seed: u64, share: u64, count: u32) {
        let mut random = Random::new(seed, share);
        for _ in 0..count {
            let Some(specimen) = specimens.get(random.below(specimens.len())).filter(|_| !work::stopped()) else {
                return;
            };
            let mut table = specimen.table.clone();
            let mut cells = table.cells(&specimen.form.expectation());
            let mut changes = Vec::new();
            while changes.len() < 2 && !cells.is_empty() {
                let cell = cells.swap_remove(random.below(cells.len()));
                let values = table.values(cell);
                let Some(value) = values.get(random.below(values.len())) else { continue };
                if table.set(cell, *value) != Some(*value) {
                    changes.push((cell, *value));
                }
            }
            self.watched.about(format!("{changes:?} in the {} of\n{}", specimen.form.name(), specimen.program));
            let tally = self.compare(specimen, &table, &changes);
            self.judged.pairs.add(&tally);
        }
    }

    fn compare(&mut self, specimen: &Specimen, table: &Table, changes: &[(Cell, Value)]) -> Tally {
        let expectation = specimen.form.expectation();
        let validation = || catch_unwind(AssertUnwindSafe(|| validate(table, &expectation, Collect::First).is_valid()));
        let (valid, slowest) = self.watch.time(&self.watched, validation);
        let broken = first_broken_rule(table, &expectation);
        let (wrong, alarm, panicked) = (broken.is_some(), matches!(valid, Ok(false)), valid.is_err());
        if panicked || wrong != alarm {
            let reference = broken.map_or_else(|| "right".to_owned(), |rule| format!("wrong by {rule}"));
            let validator =
                if panicked { "panics" } else { ["takes it for right", "takes it for wrong"][usize::from(alarm)] };
            if self.judged.findings.len() < Judged::MOST_FINDINGS {
                let (form, program) = (specimen.form.name(), &specimen.program);
                self.judged.findings.push(format!(
                    "{changes:?} is {reference}, and the validator {validator}, in the {form} of\n{program}"
                ));
            }
        }
        Tally {
            corruptions: 1,
            wrong: wrong.into(),
            caught: (wrong && alarm).into(),
            missed: (wrong && !alarm).into(),
            false_alarms: (!wrong && alarm).into(),
            hung: (slowest > HUNG).into(),
            panics: panicked.into(),
            slowest,
        }
    }
}

/// The kind of field that a cell is.
const fn field(cell: Cell) -> &'static str {
    match cell {
        Cell::Origin(_) => "half-edge: origin",
        Cell::Twin(_) => "half-edge: twin",
        Cell::Next(_) => "half-edge: next",
        Cell::Prev(_) => "half-edge: prev",
        Cell::Boundary(_) => "half-edge: boundary",
        Cell::Face(_) => "half-edge: face",
        Cell::Leaving(_) => "vertex: leaving",
        Cell::Isolated(_) => "vertex: isolated",
        Cell::BoundaryFace(_) => "boundary: face",
        Cell::BoundaryStart(_) => "boundary: start",
        Cell::BoundaryPlace(_) => "boundary: place",
        Cell::Outer(_) => "face: outer",
        Cell::Inner(..) => "face: inner",
        Cell::OuterHalfEdge(_) => "face: outer half-edge",
        Cell::InnerStart(..) => "face: inner start",
    }
}
