//! Corrupting tables and comparing a validator with the reference.

use super::exchange::Exchange;
use super::outcome::Tally;
use super::specimen::{Corruption, Family, Specimen};
use super::watch::{HUNG, Watch, Watchpoint, lock};
use crate::enumerate::{Cell, TableCells, for_each_corruption};
use crate::random::Random;
use crate::rows::{MOST_FINDINGS, Row, add_findings};
use crate::run::Run;
use crate::verdict::{Checker, Verdict, in_words};
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex};
use std::time::Duration;
use twinedge::program::panics::catch;
use twinedge::validate::reference::first_broken_rule;
use twinedge::validate::{Rule, Table};

#[derive(Clone, Debug, Default)]
pub(super) struct Judgement {
    /// The number of maps with all single corruptions judged, in all forms.
    pub(super) maps: usize,
    pub(super) fields: BTreeMap<(Family, &'static str), Tally>,
    pub(super) small_pairs: Tally,
    pub(super) pairs: Tally,
    /// For each rule, the number of tables that break it first, by the reference.
    pub(super) first_broken: BTreeMap<Rule, u64>,
    /// For each expectation and rule, this number for the tables in every form. `None` counts the valid ones.
    pub(super) by_expectation: BTreeMap<(usize, Option<Rule>), u64>,
    pub(super) hung: u64,
    pub(super) panics: u64,
    pub(super) findings: Vec<String>,
}

impl Judgement {
    fn add(&mut self, other: &Self) {
        self.maps += other.maps;
        for (field, tally) in &other.fields {
            self.fields.entry(*field).or_default().add(tally);
        }
        self.small_pairs.add(&other.small_pairs);
        self.pairs.add(&other.pairs);
        for (rule, count) in &other.first_broken {
            *self.first_broken.entry(*rule).or_default() += count;
        }
        for (rule, count) in &other.by_expectation {
            *self.by_expectation.entry(*rule).or_default() += count;
        }
        self.hung += other.hung;
        self.panics += other.panics;
        add_findings(&mut self.findings, &other.findings);
    }
}

pub(super) struct Court<'a> {
    checker: &'a dyn Checker,
    run: &'a Run<'a>,
    watch: &'a Watch<Corruption<'a>>,
    judged: Mutex<Vec<Arc<Mutex<Judgement>>>>,
}

impl<'a> Court<'a> {
    pub(super) const fn new(checker: &'a dyn Checker, run: &'a Run<'a>, watch: &'a Watch<Corruption<'a>>) -> Self {
        Self { checker, run, watch, judged: Mutex::new(Vec::new()) }
    }

    /// Returns the findings of all threads up to now. Threads may be at work.
    pub(super) fn judged(&self) -> Judgement {
        let mut all = Judgement::default();
        lock(&self.judged).iter().for_each(|judged| all.add(&lock(judged)));
        all
    }
}

/// One thread that runs the validator and the reference.
pub(super) struct Judge<'a> {
    court: &'a Court<'a>,
    watched: Arc<Watchpoint<Corruption<'a>>>,
    judged: Arc<Mutex<Judgement>>,
}

impl<'a> Judge<'a> {
    pub(super) fn new(court: &'a Court<'a>) -> Self {
        let judged = Arc::new(Mutex::new(Judgement::default()));
        lock(&court.judged).push(judged.clone());
        Self { court, watched: court.watch.thread(), judged }
    }

    fn is_stopped(&self) -> bool {
        self.court.run.is_stopped()
    }

    /// Judges all single corruptions and exchanges of a map in its forms, and all pairs if it is one of the smallest. In every
    /// form: structural exchanges, the others if it is one of the smallest, and the unchanged table.
    pub(super) fn corrupt(&self, map: &'a [Specimen]) {
        for specimen in map {
            let in_every_form = specimen.form == Family::Every;
            if in_every_form && !self.is_stopped() {
                let tally = self.compare(Corruption::new(specimen, &[]), &specimen.table);
                lock(&self.judged).fields.entry((specimen.form, "nothing")).or_default().add(&tally);
            }
            if specimen.is_smallest || !in_every_form {
                self.corrupt_once(specimen);
                self.exchange(specimen, &Exchange::all(&specimen.table, specimen.parts()));
            } else {
                self.exchange(specimen, &Exchange::structural(&specimen.table, specimen.parts()));
            }
            if specimen.is_smallest && !in_every_form {
                self.corrupt_twice(specimen);
            }
        }
        if !map.is_empty() && !self.is_stopped() {
            lock(&self.judged).maps += 1;
        }
    }

    fn corrupt_once(&self, specimen: &'a Specimen) {
        for_each_corruption(&mut specimen.table.clone(), specimen.parts(), |table, cell, value| {
            if self.is_stopped() {
                return;
            }
            let tally = self.compare(Corruption::new(specimen, &[(cell, value)]), table);
            let field = if specimen.form == Family::Every { "one field" } else { field(cell) };
            lock(&self.judged).fields.entry((specimen.form, field)).or_default().add(&tally);
        });
    }

    fn exchange(&self, specimen: &'a Specimen, exchanges: &[Exchange]) {
        for exchange in exchanges {
            if self.is_stopped() {
                return;
            }
            let mut table = specimen.table.clone();
            if exchange.apply(&mut table, specimen.parts()) {
                let tally = self.compare(Corruption::exchanged(specimen, *exchange), &table);
                lock(&self.judged).fields.entry((specimen.form, exchange.kind())).or_default().add(&tally);
            }
        }
    }

    /// Some faults of a validator appear in no single corruption. For example, a half-edge that becomes its own twin is no longer
    /// the twin of its former twin, which breaks the same rule, unless the former twin becomes its own twin as well.
    fn corrupt_twice(&self, specimen: &'a Specimen) {
        let parts = specimen.parts();
        for_each_corruption(&mut specimen.table.clone(), parts, |once, first, value| {
            for_each_corruption(&mut once.clone(), parts, |twice, second, other| {
                if first < second && !self.is_stopped() {
                    let corruption = Corruption::new(specimen, &[(first, value), (second, other)]);
                    let tally = self.compare(corruption, twice);
                    lock(&self.judged).small_pairs.add(&tally);
                }
            });
        });
    }

    /// Judges pairs of corruptions of random maps and fields: those with this number among the streams of a seed.
    pub(super) fn corrupt_pairs(&self, specimens: &[&'a Specimen], seed: u64, stream: u64, count: u32) {
        let mut random = Random::new(seed, stream);
        for _ in 0..count {
            let Some(specimen) = specimens.get(random.below(specimens.len())).filter(|_| !self.is_stopped()) else {
                return;
            };
            let mut table = specimen.table.clone();
            let mut cells = table.cells(specimen.parts());
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
            lock(&self.judged).pairs.add(&tally);
        }
    }

    /// Runs the validator and the reference, and records differences.
    fn compare(&self, corruption: Corruption<'a>, table: &Table) -> Tally {
        let (checker, expectation) = (self.court.checker, &corruption.specimen.expectation);
        let (answer, time) = self.watched.time(corruption, || catch(|| checker.check(table, expectation)));
        if let Ok(verdict) = answer {
            checker.checked(table, expectation, verdict);
        }
        let broken = first_broken_rule(table, expectation);
        let tally = tally(&answer, broken, time);
        let mut judged = lock(&self.judged);
        if let Some(rule) = broken {
            *judged.first_broken.entry(rule).or_default() += 1;
        }
        if let Some(number) = corruption.specimen.number {
            *judged.by_expectation.entry((number, broken)).or_default() += 1;
        }
        judged.hung += u64::from(time > HUNG);
        judged.panics += u64::from(answer.is_err());
        let is_wrong = tally.disagreements() > 0 || time > HUNG || answer.is_err();
        if is_wrong && judged.findings.len() < MOST_FINDINGS {
            let validator = match answer {
                Err(panic) => format!("panics: {panic}"),
                Ok(_) if time > HUNG => format!("takes {:.1} s", time.as_secs_f64()),
                Ok(verdict) => format!("takes it for {verdict}"),
            };
            judged.findings.push(format!("{}, and the validator {validator}: {corruption}", in_words(broken)));
        }
        tally
    }
}

/// Counts one corruption: `answer` is the validator's verdict or panic message, `broken` the reference's first broken rule.
fn tally(answer: &Result<Verdict, String>, broken: Option<Rule>, time: Duration) -> Tally {
    let (alarm, named) = match *answer {
        Ok(verdict) => (verdict.is_alarm(), verdict.broken),
        Err(_) => (false, None),
    };
    let wrong = broken.is_some();
    Tally {
        corruptions: 1,
        wrong: wrong.into(),
        caught: (wrong && alarm).into(),
        missed: (wrong && !alarm).into(),
        false_alarms: (!wrong && alarm).into(),
        other_rule: (wrong && alarm && named != broken).into(),
        slowest: time,
    }
}

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
    fn each_way_to_differ_is_counted_by_itself() {
        let tally = |valid, named, broken| tally(&Ok(Verdict { valid, broken: named }), broken, Duration::ZERO);
        let same = tally(false, Some(Rule::L1), Some(Rule::L1));
        assert_eq!((same.caught, same.other_rule, same.disagreements()), (1, 0, 0));
        let other = tally(false, Some(Rule::L3), Some(Rule::L1));
        assert_eq!((other.caught, other.other_rule, other.disagreements()), (1, 1, 1));
        let unnamed = tally(false, None, Some(Rule::L1));
        assert_eq!((unnamed.caught, unnamed.other_rule), (1, 1));
        assert_eq!(tally(true, None, Some(Rule::L1)).missed, 1);
        assert_eq!(tally(false, Some(Rule::L1), None).false_alarms, 1);
        assert_eq!(tally(true, None, None).disagreements(), 0);
    }
}
