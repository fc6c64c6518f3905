//! All tables, judged by one judge and, if it accepts them, by the other.

use super::acceptor::{self, Acceptor};
use super::labels::{LazyLabels, shapes};
use super::open_table::{Branch, OpenTable};
use super::work::{Claim, LazyError, LazyWork};
use crate::run::Run;
use twinedge::validate::Table;
use twinedge_certificate::Labels;

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
    Box::new(|table| acceptor::is_right(table, &work.expectation))
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
