//! The outcome of `tables`.

use super::work::TablesWork;
use crate::rows::{INTERRUPTED, add_findings, add_rows, rows};
use crate::shard::Shard;
use crate::sum::Outcome;

/// The outcome of [`tables()`](crate::tables()).
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct TablesOutcome {
    /// The work.
    pub work: TablesWork,
    /// The part of it.
    pub shard: Shard,
    /// The tables, by their size and by the free fields.
    pub tables: Vec<TablesRow>,
    /// The first disagreements. All are counted in the rows.
    pub findings: Vec<String>,
    /// True if the run was stopped early.
    pub interrupted: bool,
}

rows! {
    /// Tables with the same free fields.
    #[derive(Clone, Debug, PartialEq, Eq)]
    pub struct TablesRow {
        /// The number of half-edges.
        key half_edges: usize = "half-edges" 10;
        /// The free fields.
        label free: String = "free" 52;
        /// The number of all tables.
        given all: u64;
        /// The number of judged ones.
        count judged: u64 = "tables" 13;
        /// The number of valid ones, by the validator.
        count right: u64 = "right" 9 is right_by_formula;
        /// The number of all valid ones, by a formula.
        given right_by_formula: u64 = "formula" 10;
        /// The number of differences between the validator and the reference.
        zero disagreements: u64 = "disagreements" 13;
        /// True if all tables were judged.
        given done: bool;
    }
}

impl TablesRow {
    /// Returns true if all tables were judged, the count equals the formula, and there was no disagreement.
    #[must_use]
    pub const fn is_ok(&self) -> bool {
        self.done && self.right == self.right_by_formula && self.disagreements == 0
    }
}

impl Outcome for TablesOutcome {
    type Work = TablesWork;

    fn work(&self) -> TablesWork {
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
            let rows = self.tables.iter().filter(|row| !row.done || row.right != row.right_by_formula);
            reasons.extend(rows.map(|row| {
                let TablesRow { half_edges, free, all, judged, right, right_by_formula, .. } = row;
                format!(
                    "half-edges: {half_edges}, free: {free}: judged {judged} of {all}, right {right} instead of \
                     {right_by_formula}"
                )
            }));
        }
        let disagreements: u64 = self.tables.iter().map(|row| row.disagreements).sum();
        if disagreements > 0 {
            reasons.push(format!("disagreements: {disagreements}"));
            reasons.extend(self.findings.iter().cloned());
        }
        reasons
    }

    fn absorb(&mut self, other: &Self) {
        add_rows(&mut self.tables, &other.tables);
        add_findings(&mut self.findings, &other.findings);
    }

    fn complete(&mut self) {
        self.shard = Shard::WHOLE;
        for row in &mut self.tables {
            row.done = row.judged == row.all;
        }
    }
}
