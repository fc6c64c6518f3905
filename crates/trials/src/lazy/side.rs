//! All tables, judged by one judge and, if it accepts them, by the other.

use super::labels::{LazyLabels, shapes};
use super::open_table::{Branch, OpenTable};
use super::work::{Claim, LazyError, LazyWork};
use crate::random::Random;
use crate::run::{Estimate, Run};
use crate::verdict::Validator;
use std::time::Instant;
use twinedge::validate::reference::first_broken_of;
use twinedge::validate::{Expectation, Rule, Table, View, accepts};
use twinedge_certificate::{Labels, passes, passes_surface};

/// A number of branches that suffices for all threads and parts.
const ENOUGH_BRANCHES: usize = 512;

/// All tables, judged by one and, if it accepts them, by the other.
pub(super) struct Side<'a> {
    work: &'a LazyWork,
    pub(super) name: &'static str,
    pub(super) tables: Tables,
    judges: [Judge<'a>; 2],
}

type Judge<'a> = Box<dyn Fn(&OpenTable) -> bool + Sync + 'a>;

#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Tables {
    Plain,
    /// Tables that differ only in the numbers of their slots are equivalent.
    UpToNumbers,
    WithLabels,
}

#[derive(Default)]
pub(super) struct Judgement {
    pub(super) runs: u128,
    pub(super) accepted: u128,
    pub(super) covered: u128,
    pub(super) differences: u128,
    pub(super) finding: Option<String>,
}

impl<'a> Side<'a> {
    pub(super) fn all(work: &'a LazyWork, validator: &'a dyn Acceptor) -> Vec<Self> {
        if work.certificates { Self::of_certificates(work, validator) } else { Self::of_tables(work, validator) }
    }

    /// The validator before the reference, and vice versa.
    fn of_tables(work: &'a LazyWork, validator: &'a dyn Acceptor) -> Vec<Self> {
        let judge = || -> Judge<'a> { Box::new(|table| validator.accepts(table, &work.expectation)) };
        vec![
            Self { work, name: "validator", tables: Tables::Plain, judges: [judge(), is_right(work)] },
            Self { work, name: "reference", tables: Tables::UpToNumbers, judges: [is_right(work), judge()] },
        ]
    }

    /// The sides: valid tables have labels that pass; tables with such labels are valid; and both together, in the same number.
    fn of_certificates(work: &'a LazyWork, checker: &'a dyn Acceptor) -> Vec<Self> {
        let passes =
            || -> Judge<'a> { Box::new(|table| checker.passes(table, LazyLabels::new(table), &work.expectation)) };
        let (right, pass) = (is_right(work), passes());
        let both = Box::new(move |table: &OpenTable| right(table) && pass(table));
        let is_certified = Box::new(|table: &OpenTable| is_certified(table, work, checker));
        vec![
            Self { work, name: "reference", tables: Tables::Plain, judges: [is_right(work), is_certified] },
            Self { work, name: "checker", tables: Tables::WithLabels, judges: [passes(), is_right(work)] },
            Self { work, name: "both", tables: Tables::WithLabels, judges: [both, passes()] },
        ]
    }

    pub(super) fn table(&self) -> Result<OpenTable, LazyError> {
        let table = OpenTable::new(self.work)?;
        match self.tables {
            Tables::Plain => Ok(table),
            Tables::UpToNumbers => Ok(table.up_to_numbers()),
            Tables::WithLabels => table.with_labels(&shapes(self.work)?),
        }
    }

    pub(super) fn judge(&self, run: &Run<'_>) -> Result<Vec<Judgement>, LazyError> {
        let branches = self.branches(&self.table()?);
        let ours: Vec<&Branch> = run.part().numbers(branches.len()).map(|number| &branches[number]).collect();
        let threads = run.each(
            self.name,
            ours.len(),
            || (self.table(), Judgement::default()),
            |(table, judged), number| {
                if let Ok(table) = table {
                    self.follow(table, ours[number], judged, run);
                }
            },
        );
        threads.into_iter().map(|(table, judged)| table.map(|_| judged)).collect()
    }

    pub(super) fn accepts(&self, judge: usize, table: &OpenTable) -> bool {
        self.judges[judge](table)
    }

    /// Returns enough branches for all threads, if the runs make that many choices. They depend on the judge alone.
    pub(super) fn branches(&self, table: &OpenTable) -> Vec<Branch> {
        let mut depth = 1;
        loop {
            let branches = table.branches(depth, |table| {
                self.accepts(0, table);
            });
            if branches.len() >= ENOUGH_BRANCHES || branches.iter().all(|branch| branch.len() < depth) {
                return branches;
            }
            depth += 1;
        }
    }

    fn follow(&self, table: &OpenTable, branch: &Branch, judged: &mut Judgement, run: &Run<'_>) {
        table.enter(branch);
        table.runs(|table| {
            let is_accepted = self.accepts(0, table);
            judged.runs += 1;
            judged.covered += table.agreeing();
            if is_accepted {
                judged.accepted += table.agreeing();
                table.runs(|table| {
                    if !self.accepts(1, table) {
                        self.note(table, judged);
                    }
                    true
                });
            }
            !judged.runs.is_multiple_of(1024) || !run.is_stopped()
        });
        table.retract(0);
    }

    fn note(&self, table: &OpenTable, judged: &mut Judgement) {
        judged.differences += table.agreeing();
        if judged.finding.is_none() {
            let (text, labels) = table.read(|table| (Table::copy_of(table), LazyLabels::new(table).to_string()));
            let text = text.map(|table| table.to_string()).unwrap_or_default();
            judged.finding = Some(format!("accepted by the {} alone: {text}{labels}", self.name));
        }
    }
}

/// Returns the reference, which treats tables alike if they differ only in the numbers of their slots.
fn is_right(work: &LazyWork) -> Judge<'_> {
    let holds =
        |table: &OpenTable, rule: usize| first_broken_of(table, &work.expectation, &ORDER[rule..=rule]).is_none();
    Box::new(move |table| table.all_hold(ORDER.len(), |rule| holds(table, rule)))
}

/// Returns true if the checker accepts the labels that are made for the table. All its cells are read.
fn is_certified(table: &OpenTable, work: &LazyWork, checker: &dyn Acceptor) -> bool {
    let Some(table) = Table::copy_of(table) else { return false };
    let labels = match work.claim() {
        Ok(Claim::Plane) => Labels::new(&table).ok(),
        Ok(Claim::Surface(genus)) => Labels::of_surface(&table).ok().filter(|made| made.1 == genus).map(|made| made.0),
        Err(_) => None,
    };
    labels.is_some_and(|labels| checker.passes(&table, LazyLabels::new(&labels), &work.expectation))
}

/// A validator under test that answers yes or no: [`lazy()`](crate::lazy()) compares it with the reference.
pub trait Acceptor: Sync {
    /// Returns true if the structure keeps all rules.
    ///
    /// The fewer records it reads of an invalid structure, the fewer runs are needed.
    fn accepts(&self, view: &dyn View, expectation: &Expectation) -> bool;

    /// Returns true if the labels show that the structure keeps all rules. The expectation claims only what certificates can
    /// claim: the plane, or closed surfaces of a genus.
    ///
    /// The default is the checker of the library: [`passes`] and [`passes_surface`].
    fn passes(&self, view: &dyn View, labels: LazyLabels<'_>, expectation: &Expectation) -> bool {
        match Claim::of(expectation) {
            Some(Claim::Plane) => passes(view, &labels),
            Some(Claim::Surface(genus)) => passes_surface(view, &labels, genus),
            None => false,
        }
    }
}

/// The fast path of the library: [`accepts`].
impl Acceptor for Validator {
    fn accepts(&self, view: &dyn View, expectation: &Expectation) -> bool {
        accepts(view, expectation)
    }
}

/// The sentences of the reference, in an order that reads few cells of invalid tables: rules that link cells to one another come
/// before R1, which reads all of them.
const ORDER: [Rule; 22] = [
    Rule::L2,
    Rule::L1,
    Rule::L3,
    Rule::V1,
    Rule::V2,
    Rule::T3,
    Rule::M1,
    Rule::M2,
    Rule::M4,
    Rule::M5,
    Rule::B1,
    Rule::B2,
    Rule::R1,
    Rule::F1,
    Rule::F2,
    Rule::T1,
    Rule::T2,
    Rule::T4,
    Rule::M3,
    Rule::M6,
    Rule::M7,
    Rule::M8,
];

/// The number of branches of one length that are followed.
const BRANCHES: usize = 4096;

/// The seed of the choice of branches: the same work always has the same number of runs.
const SEED: u64 = 1975;

impl LazyWork {
    /// Returns the approximate number of runs of all judges, and the number that one core of this machine does per second.
    ///
    /// Random branches of the tree of all runs are followed, all in step. Of the branches that are one choice longer, 4,096
    /// random ones are kept, and each stands for an equal share of all. A run that ends there counts with the same weight. The
    /// mean of the counts is the number of all runs; as long as there are no more branches of a length, it is exact. It varies
    /// less than for single random paths (D. Knuth, *Estimating the efficiency of backtrack programs*, 1975), since short runs
    /// are counted and not drawn: R. Vaisman and D. Kroese, *Stochastic enumeration method for counting trees*, 2017.
    ///
    /// It takes seconds. In all cases so far, the estimated and actual numbers of runs differ by less than a factor of two.
    ///
    /// # Errors
    /// [`LazyError`], as for [`lazy()`](crate::lazy()).
    ///
    /// # Panics
    /// If the validator panics.
    #[allow(clippy::cast_sign_loss, reason = "no number of runs or seconds is negative")]
    pub fn estimate(&self, validator: &dyn Acceptor) -> Result<Estimate, LazyError> {
        let mut random = Random::new(SEED, 0);
        let (mut runs, mut seconds) = (0.0, 0.0);
        for side in Side::all(self, validator) {
            let table = side.table()?;
            let mut branches = vec![Branch::new()];
            // The number of branches that each of them represents.
            let mut each = 1.0;
            while !branches.is_empty() {
                let mut longer = Vec::new();
                for branch in &branches {
                    let more = table.longer(branch, |table| {
                        side.accepts(0, table);
                    });
                    if more.is_empty() {
                        runs += each;
                        seconds += each * seconds_of_run(&side, &table, branch);
                    }
                    longer.extend(more);
                }
                let all = longer.len();
                draw(&mut longer, &mut random);
                each *= all as f64 / longer.len().max(1) as f64;
                branches = longer;
            }
        }
        Ok(Estimate { amount: runs.round() as u128, unit: "runs", per_second: (runs / seconds) as u64 })
    }
}

/// Returns the seconds of the run of a branch after one that differs in the last choice.
fn seconds_of_run(side: &Side<'_>, table: &OpenTable, branch: &Branch) -> f64 {
    let (before, last) = branch.split_at(branch.len().saturating_sub(1));
    table.enter(before);
    side.accepts(0, table);
    table.retract(before.len());
    table.enter(last);
    let start = Instant::now();
    side.accepts(0, table);
    let seconds = start.elapsed().as_secs_f64();
    table.retract(0);
    seconds
}

/// Keeps up to [`BRANCHES`] of the branches.
fn draw(branches: &mut Vec<Branch>, random: &mut Random) {
    for kept in 0..branches.len().min(BRANCHES) {
        let drawn = kept + random.below(branches.len() - kept);
        branches.swap(kept, drawn);
    }
    branches.truncate(BRANCHES);
}
