//! Corrupting a table and asking both validators.

use super::watch::{HUNG, Watch, Watched};
use crate::caught::caught;
use crate::judgement::{in_words, judgement};
use crate::random::Random;
use crate::work;
use serde::Serialize;
use std::collections::BTreeMap;
use std::fmt;
use std::sync::Arc;
use std::time::Duration;
use twinedge::program::census::Discovery;
use twinedge::validate::enumerate::{Cell, Value, for_each_corruption};
use twinedge::validate::reference::first_broken_rule;
use twinedge::validate::{Expectation, Link, Part, Rule, Start, Table};

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
    /// Whether it has one edge and two vertices at most.
    is_smallest: bool,
}

impl Specimen {
    /// The tables of a map, each with a vacant row, in both forms. None if there is no memory for them.
    pub(super) fn all(found: &Discovery) -> Option<[Self; 2]> {
        let records = Table::copy_of(found.runner.subject())?;
        let mut textbook = records.clone();
        drop_boundaries(&mut textbook);
        let map = found.runner.subject();
        let is_smallest = map.edge_count() <= 1 && map.vertex_count() <= 2;
        Some([(Form::Records, records), (Form::Textbook, textbook)].map(|(form, mut table)| {
            table.vertices.push(None);
            table.half_edges.push(None);
            table.boundaries.push(None);
            table.faces.push(None);
            Self { form, table, program: found.program.to_string(), is_smallest }
        }))
    }

    /// The empty map.
    #[cfg(test)]
    pub(super) fn example() -> Self {
        let program = twinedge::program::Program::default().to_string();
        Self { form: Form::Records, table: Table::default(), program, is_smallest: true }
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

/// Some changed cells of a specimen.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corruption<'a> {
    specimen: &'a Specimen,
    changes: [Option<(Cell, Value)>; 2],
}

impl<'a> Corruption<'a> {
    /// The first two changes are kept.
    pub(super) fn new(specimen: &'a Specimen, changes: &[(Cell, Value)]) -> Self {
        Self { specimen, changes: [0, 1].map(|i| changes.get(i).copied()) }
    }
}

impl fmt::Display for Corruption<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, (cell, value)) in self.changes.iter().flatten().enumerate() {
            write!(f, "{}{cell:?} = {value:?}", if i == 0 { "" } else { " and " })?;
        }
        write!(f, ", in the {} of\n{}", self.specimen.form.name(), self.specimen.program)
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
    /// Caught, but the validator takes another rule for the first broken one.
    pub(super) other_rule: u64,
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
        self.other_rule += other.other_rule;
        self.hung += other.hung;
        self.panics += other.panics;
        self.slowest = self.slowest.max(other.slowest);
    }

    /// Of one corruption: what the validator says, or that it panics, the first broken rule by the reference, and the time.
    fn of(answer: &Result<(bool, Option<Rule>), String>, broken: Option<Rule>, time: Duration) -> Self {
        let (alarm, named) = match *answer {
            Ok((valid, named)) => (!valid || named.is_some(), named),
            Err(_) => (false, None),
        };
        let wrong = broken.is_some();
        Self {
            corruptions: 1,
            wrong: wrong.into(),
            caught: (wrong && alarm).into(),
            missed: (wrong && !alarm).into(),
            false_alarms: (!wrong && alarm).into(),
            other_rule: (wrong && alarm && named != broken).into(),
            hung: (time > HUNG).into(),
            panics: answer.is_err().into(),
            slowest: time,
        }
    }

    /// How often something was amiss.
    pub(super) const fn disagreements(&self) -> u64 {
        self.missed + self.false_alarms + self.other_rule + self.hung + self.panics
    }
}

/// What was found.
#[derive(Clone, Debug, Default)]
pub(super) struct Judged {
    /// Maps of which all single corruptions were judged, in all forms.
    pub(super) maps: usize,
    pub(super) fields: BTreeMap<(Form, &'static str), Tally>,
    /// All pairs of corruptions of the smallest maps.
    pub(super) small_pairs: Tally,
    /// Pairs that were drawn by lot.
    pub(super) pairs: Tally,
    /// How often each rule was the first broken one, by the reference.
    pub(super) first_broken: BTreeMap<Rule, u64>,
    /// The first disagreements.
    pub(super) findings: Vec<String>,
}

impl Judged {
    const MOST_FINDINGS: usize = 10;

    pub(super) fn add(&mut self, other: &Self) {
        self.maps += other.maps;
        for (field, tally) in &other.fields {
            self.fields.entry(*field).or_default().add(tally);
        }
        self.small_pairs.add(&other.small_pairs);
        self.pairs.add(&other.pairs);
        for (rule, count) in &other.first_broken {
            *self.first_broken.entry(*rule).or_default() += count;
        }
        self.findings.extend_from_slice(&other.findings);
        self.findings.truncate(Self::MOST_FINDINGS);
    }

    fn note(&mut self, finding: impl FnOnce() -> String) {
        if self.findings.len() < Self::MOST_FINDINGS {
            self.findings.push(finding());
        }
    }
}

/// One thread that asks both validators.
#[derive(Debug)]
pub(super) struct Judge<'a> {
    watched: Arc<Watched<'a>>,
}

impl<'a> Judge<'a> {
    pub(super) fn new(watch: &Watch<'a>) -> Self {
        Self { watched: watch.thread() }
    }

    /// All single corruptions of a map in all its forms, and all pairs if it is one of the smallest.
    pub(super) fn corrupt(&self, map: &'a [Specimen]) {
        for specimen in map {
            self.corrupt_once(specimen);
            if specimen.is_smallest {
                self.corrupt_twice(specimen);
            }
        }
        if !work::stopped() {
            self.watched.judged().maps += 1;
        }
    }

    fn corrupt_once(&self, specimen: &'a Specimen) {
        let form = specimen.form;
        for_each_corruption(&mut specimen.table.clone(), &form.expectation(), |table, cell, value| {
            if work::stopped() {
                return;
            }
            let tally = self.compare(Corruption::new(specimen, &[(cell, value)]), table);
            self.watched.judged().fields.entry((form, field(cell))).or_default().add(&tally);
        });
    }

    /// Some faults of a validator show in no single corruption. A half-edge that is its own twin, for one, is no longer that
    /// of its former twin, which breaks the same rule, unless this one is its own twin as well.
    fn corrupt_twice(&self, specimen: &'a Specimen) {
        let expectation = specimen.form.expectation();
        for_each_corruption(&mut specimen.table.clone(), &expectation, |once, first, value| {
            for_each_corruption(&mut once.clone(), &expectation, |twice, second, other| {
                if first < second && !work::stopped() {
                    let corruption = Corruption::new(specimen, &[(first, value), (second, other)]);
                    let tally = self.compare(corruption, twice);
                    self.watched.judged().small_pairs.add(&tally);
                }
            });
        });
    }

    /// Pairs of corruptions, of maps and fields that are drawn by lot.
    pub(super) fn corrupt_pairs(&self, specimens: &[&'a Specimen], seed: u64, share: u64, count: u32) {
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
            let tally = self.compare(Corruption::new(specimen, &changes), &table);
            self.watched.judged().pairs.add(&tally);
        }
    }

    /// Asks both validators, and notes where they differ.
    fn compare(&self, corruption: Corruption<'a>, table: &Table) -> Tally {
        let expectation = corruption.specimen.form.expectation();
        let (answer, slowest) = self.watched.time(corruption, || caught(|| judgement(table, expectation)));
        let broken = first_broken_rule(table, &expectation);
        let tally = Tally::of(&answer, broken, slowest);
        let mut judged = self.watched.judged();
        if let Some(rule) = broken {
            *judged.first_broken.entry(rule).or_default() += 1;
        }
        if tally.disagreements() > 0 {
            judged.note(|| {
                let validator = match answer {
                    Err(panic) => format!("panics: {panic}"),
                    Ok(_) if slowest > HUNG => format!("takes {:.1} s", slowest.as_secs_f64()),
                    Ok((valid, named)) if valid == named.is_none() => format!("takes it for {}", in_words(named)),
                    Ok(_) => "takes it for wrong, by no rule".to_owned(),
                };
                format!("{}, and the validator {validator}: {corruption}", in_words(broken))
            });
        }
        tally
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wrong_table_that_is_caught_by_another_rule_is_a_disagreement() {
        let tally = |answer, broken| Tally::of(&answer, broken, Duration::ZERO);
        let same = tally(Ok((false, Some(Rule::L1))), Some(Rule::L1));
        assert_eq!((same.caught, same.other_rule, same.disagreements()), (1, 0, 0));
        let other = tally(Ok((false, Some(Rule::L3))), Some(Rule::L1));
        assert_eq!((other.caught, other.other_rule, other.disagreements()), (1, 1, 1));
        let unnamed = tally(Ok((false, None)), Some(Rule::L1));
        assert_eq!((unnamed.caught, unnamed.other_rule), (1, 1));
        assert_eq!(tally(Ok((true, None)), Some(Rule::L1)).missed, 1);
        assert_eq!(tally(Ok((false, Some(Rule::L1))), None).false_alarms, 1);
        assert_eq!(tally(Ok((true, None)), None).disagreements(), 0);
        assert_eq!(tally(Err("panics".to_owned()), None).disagreements(), 1);
    }
}
