//! All tables of a size, every cell free, by runs on tables whose cells are open until they are read.
//!
//! A validator that stops where it knows its answer reads few cells of a wrong table. Its run on one table is its run on all tables that have the
//! same values in these cells, so one run stands for all of them (*lazy enumeration*: Korat, lazy `SmallCheck`). The next run gives the
//! cell that was read last its next value. In this way all tables are judged, in about 10^7 runs for 10^21 of them.
//!
//! # What is shown
//!
//! Two judges go through all tables, each for itself: the [`Acceptor`], which is the validator, and the reference, rule by rule in an order
//! that reads little. Each table that one of both accepts is judged by the other one, and both must accept as many. Then both accept
//! the same tables, of all that there are: nothing wrong is accepted, and nothing right is refused.
//!
//! The sentences of the reference do not know numbers of slots. So where it reads a link to slots that nothing has told apart yet, one of them
//! stands for all, and the tables that it accepts are counted with the number of those for which they stand. The validator reads every table as it is.
//!
//! Each run counts the tables for which it stands: the product of the numbers of values of the cells that it has not read. They must add up to
//! the number of all tables, so that none is left out and none is judged twice. For closed surfaces, and for the plane without holes, the
//! number of right tables is known by a recount of the maps, whatever of M1 … M8 is asked for, and as many must be accepted.

mod many;
mod open_table;
mod outcome;
mod recount;
mod work;

pub use many::Many;
pub use outcome::{JudgeRow, LazyOutcome};
pub use work::{LazyWork, TooManyTables};

use crate::rows::{add_findings, narrow};
use crate::run::Run;
use crate::verdict::Validator;
use open_table::{Branch, OpenTable};
use twinedge::validate::reference::first_broken_of;
use twinedge::validate::{Expectation, Rule, View, accepts};

/// A validator under test that says yes or no: [`lazy()`] compares it with the reference.
pub trait Acceptor: Sync {
    /// Tells whether the structure keeps all rules.
    ///
    /// The fewer records of a wrong one it reads, the fewer runs there are.
    fn accepts(&self, view: &dyn View, expectation: &Expectation) -> bool;
}

/// The fast path of the library: [`accepts`].
impl Acceptor for Validator {
    fn accepts(&self, view: &dyn View, expectation: &Expectation) -> bool {
        accepts(view, expectation)
    }
}

/// Statement by statement, in an order in which few cells are read of wrong tables: what ties cells to one another comes
/// before R1, which reads them all.
struct Reference;

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

impl Acceptor for Reference {
    fn accepts(&self, view: &dyn View, expectation: &Expectation) -> bool {
        first_broken_of(view, expectation, &ORDER).is_none()
    }
}

const REFERENCE: &str = "reference";

/// The number of branches that suffices for all threads and parts.
const ENOUGH_BRANCHES: usize = 512;

/// Judges all tables of a size by a validator and by the reference.
///
/// Two half-edges take a moment, six half-edges on two vertices about 10^7 runs.
///
/// # Errors
/// [`TooManyTables`] if they cannot be counted.
///
/// # Panics
/// If the validator panics.
///
/// # Examples
/// ```
/// use twinedge::validate::{Expectation, Part, Parts};
/// use twinedge_trials::lazy::LazyWork;
/// use twinedge_trials::{Outcome, Run, Validator, lazy};
/// // Origin, twin, next and prev of two half-edges on two vertices.
/// let work = LazyWork {
///     expectation: Expectation::surface(),
///     parts: Parts::NONE.with(Part::Prev),
///     vertices: 2,
///     half_edges: 2,
///     boundaries: 0,
///     faces: 0,
///     vacant: false,
/// };
/// let outcome = lazy(work, &Validator, &Run::default())?.into_result()?;
/// // A loop at one of the vertices, or an edge between both.
/// assert_eq!(outcome.accepted, 2 + 2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn lazy(work: LazyWork, validator: &dyn Acceptor, run: &Run<'_>) -> Result<LazyOutcome, TooManyTables> {
    let all = OpenTable::new(&work)?.agreeing();
    let judges: [(&str, [&dyn Acceptor; 2]); 2] =
        [("validator", [validator, &Reference]), (REFERENCE, [&Reference, validator])];
    let mut findings = Vec::new();
    let mut rows = Vec::new();
    for (name, judges) in judges {
        let found = Side { work: &work, name, judges }.judge(run)?;
        let sum = |count: fn(&Judgement) -> u128| found.iter().map(count).sum::<u128>();
        rows.push(JudgeRow {
            judge: name.to_owned(),
            runs: narrow(sum(|found| found.runs)),
            accepted: narrow(sum(|found| found.accepted)),
            right: recount::right(&work),
            differences: narrow(sum(|found| found.differences)),
            all: Many(all),
            covered: Many(sum(|found| found.covered)),
        });
        let found: Vec<String> = found.into_iter().filter_map(|found| found.finding).collect();
        add_findings(&mut findings, &found);
    }
    let outcome = LazyOutcome::new(work, run.part(), rows);
    Ok(LazyOutcome { findings, interrupted: run.is_stopped(), ..outcome })
}

/// All tables, judged by one and, where it accepts them, by the other.
struct Side<'a> {
    work: &'a LazyWork,
    name: &'static str,
    judges: [&'a dyn Acceptor; 2],
}

/// The findings of one thread.
#[derive(Default)]
struct Judgement {
    runs: u128,
    accepted: u128,
    covered: u128,
    differences: u128,
    finding: Option<String>,
}

impl Side<'_> {
    /// The table for the first judge. The reference says the same of tables that differ in the numbers of their slots only.
    fn table(&self) -> Result<OpenTable, TooManyTables> {
        let table = OpenTable::new(self.work)?;
        Ok(if self.name == REFERENCE { table.up_to_numbers() } else { table })
    }

    fn judge(&self, run: &Run<'_>) -> Result<Vec<Judgement>, TooManyTables> {
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

    fn accepts(&self, judge: usize, table: &OpenTable) -> bool {
        self.judges[judge].accepts(table, &self.work.expectation)
    }

    /// Enough branches for all threads, if the runs make as many choices. They depend on the judge alone.
    fn branches(&self, table: &OpenTable) -> Vec<Branch> {
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

    /// Does the runs of one branch.
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

    /// Notes a table that the other judge rejects.
    fn note(&self, table: &OpenTable, judged: &mut Judgement) {
        judged.differences += table.agreeing();
        if judged.finding.is_none() {
            let text = table.to_table().map(|table| table.to_string()).unwrap_or_default();
            judged.finding = Some(format!("accepted by the {} alone: {text}", self.name));
        }
    }
}
