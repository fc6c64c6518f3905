//! The outcome of `lazy`.

use super::many::Many;
use super::work::LazyWork;
use crate::rows::{INTERRUPTED, add_findings, add_rows, rows};
use crate::shard::Shard;
use crate::sum::Outcome;

/// The outcome of [`lazy()`](crate::lazy()).
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct LazyOutcome {
    /// The work.
    pub work: LazyWork,
    /// The part of it.
    pub shard: Shard,
    /// The approximate number of tables.
    pub tables: String,
    /// The approximate number with labels, each table with all labels; `None` without certificates.
    pub with_labels: Option<String>,
    /// The runs of the first judge: the validator, or the reference for certificates.
    pub runs: u64,
    /// The tables that it accepts.
    pub accepted: u64,
    /// The tables that one judge accepts and the other one rejects.
    pub differences: u64,
    /// The results of each judge.
    pub judges: Vec<JudgeRow>,
    /// The first differences. All are counted in the rows.
    pub findings: Vec<String>,
    /// True if the run was stopped early.
    pub interrupted: bool,
}

rows! {
    /// The runs of a judge on tables whose cells are open until it reads them.
    #[derive(Clone, Debug, PartialEq, Eq)]
    pub struct JudgeRow {
        /// The judge.
        label judge: String = "judge" 10;
        /// The number of runs.
        count runs: u64 = "runs" 13;
        /// The accepted tables, or tables with labels.
        count accepted: u64 = "accepted" 12 is right;
        /// The number of valid tables, by a recount without the validator, if there is one.
        given right: Option<u64>;
        /// The tables that the other judge rejects.
        zero differences: u64 = "differences" 11;
        /// The number of all tables, or of all with labels.
        given all: Many;
        /// The number of tables that the runs cover.
        count covered: Many;
    }
}

impl LazyOutcome {
    pub(super) fn new(work: LazyWork, shard: Shard, judges: Vec<JudgeRow>) -> Self {
        let tables = judges.first().map(|row| row.all.rounded()).unwrap_or_default();
        let with_labels = judges.last().filter(|_| work.certificates).map(|row| row.all.rounded());
        let mut outcome = Self {
            work,
            shard,
            tables,
            with_labels,
            runs: 0,
            accepted: 0,
            differences: 0,
            judges,
            findings: Vec::new(),
            interrupted: false,
        };
        outcome.total();
        outcome
    }

    fn total(&mut self) {
        (self.runs, self.accepted) = self.judges.first().map_or((0, 0), |row| (row.runs, row.accepted));
        self.differences = self.judges.iter().map(|row| row.differences).sum();
    }
}

impl Outcome for LazyOutcome {
    type Work = LazyWork;

    fn work(&self) -> LazyWork {
        self.work
    }

    fn shard(&self) -> Shard {
        self.shard
    }

    fn is_interrupted(&self) -> bool {
        self.interrupted
    }

    fn reasons(&self) -> Vec<String> {
        let mut reasons = Vec::new();
        if self.interrupted {
            reasons.push(INTERRUPTED.to_owned());
        } else if self.shard.is_whole() {
            for row @ JudgeRow { judge, accepted, right, all, covered, .. } in &self.judges {
                if covered != all {
                    reasons.push(format!("{judge}: the runs stand for {covered} of {all} tables"));
                }
                // The judges of the same tables accept the same number.
                let first = self.judges.iter().find(|first| first.all == *all).unwrap_or(row);
                if *accepted != first.accepted {
                    reasons.push(format!("{judge}: accepted {accepted}, but the {} {}", first.judge, first.accepted));
                }
                if *accepted == u64::MAX {
                    reasons.push(format!("{judge}: accepted more than can be counted"));
                }
                if let Some(right) = right.filter(|right| right != accepted) {
                    reasons.push(format!("{judge}: accepted {accepted} instead of {right}"));
                }
            }
        }
        if self.differences > 0 {
            reasons.push(format!("differences: {}", self.differences));
            reasons.extend(self.findings.iter().cloned());
        }
        reasons
    }

    fn absorb(&mut self, other: &Self) {
        add_rows(&mut self.judges, &other.judges);
        add_findings(&mut self.findings, &other.findings);
    }

    fn complete(&mut self) {
        self.shard = Shard::WHOLE;
        self.total();
    }
}
