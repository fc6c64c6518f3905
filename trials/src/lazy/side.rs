//! All tables, judged by one judge and, where it accepts them, by the other.

use super::acceptor::{Acceptor, Reference};
use super::open_table::{Branch, OpenTable};
use super::work::{LazyWork, TooManyTables};
use crate::run::Run;

const REFERENCE: &str = "reference";

/// The number of branches that suffices for all threads and parts.
const ENOUGH_BRANCHES: usize = 512;

/// All tables, judged by one and, where it accepts them, by the other.
pub(super) struct Side<'a> {
    work: &'a LazyWork,
    pub(super) name: &'static str,
    judges: [&'a dyn Acceptor; 2],
}

/// The findings of one thread.
#[derive(Default)]
pub(super) struct Judgement {
    pub(super) runs: u128,
    pub(super) accepted: u128,
    pub(super) covered: u128,
    pub(super) differences: u128,
    pub(super) finding: Option<String>,
}

impl<'a> Side<'a> {
    /// The validator before the reference, and the other way round.
    pub(super) fn both(work: &'a LazyWork, validator: &'a dyn Acceptor) -> [Self; 2] {
        let side = |name, judges| Self { work, name, judges };
        [side("validator", [validator, &Reference]), side(REFERENCE, [&Reference, validator])]
    }

    /// The table for the first judge. The reference says the same of tables that differ in the numbers of their slots only.
    pub(super) fn table(&self) -> Result<OpenTable, TooManyTables> {
        let table = OpenTable::new(self.work)?;
        Ok(if self.name == REFERENCE { table.up_to_numbers() } else { table })
    }

    /// Judges this part of all tables.
    pub(super) fn judge(&self, run: &Run<'_>) -> Result<Vec<Judgement>, TooManyTables> {
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
        self.judges[judge].accepts(table, &self.work.expectation)
    }

    /// Enough branches for all threads, if the runs make as many choices. They depend on the judge alone.
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
