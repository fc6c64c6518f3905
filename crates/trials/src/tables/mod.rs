//! All tables of a few records, valid or invalid.
//!
//! Some fields are free: they take all values, in all combinations. The validator and the reference must find the same first
//! broken rule, or none; and the number of valid tables must equal the formulas for maps on labelled half-edges.
//!
//! | half-edges | free fields |
//! | --- | --- |
//! | 0 | two isolated vertices in one face: all fields but leaving, nil included |
//! | 2, no faces | two vertices: origin, twin, next, prev and leaving, nil included; from a bound of 4 on also dangling links |
//! | 2, faces | an edge in one face and a loop between two faces, as in textbooks: all fields but leaving, nil included |
//! | 2, faces, from a bound of 4 on | every field, leaving included, of both, and of an edge with a boundary component; the links between half-edges are live. A loop with two boundary components: its links are fixed, all else is free |
//! | 2, a face, an open border | every field of a loop, with the claim of a disc, by M1, M3, M5, M6 and M7 |
//! | 4, no faces, no leaving | origin, twin and next on two vertices; twin and next; next and prev for every pairing of twins; twin or nil, and next, with open borders, also with the claims of a square and of a torus, by M1 … M7 |
//! | 6 and more | next, for every pairing of twins; no prev, leaving or face |
//!
//! If origins are not free, they follow from twin and next.

pub(crate) mod formulas;
mod jobs;

use crate::enumerate::{TableCells, for_each_assignment};
use crate::outcome::{Outcome, Results, faults};
use crate::rows::{add_findings, add_rows, narrow, rows};
use crate::run::{Estimate, Run};
use crate::verdict::{Checker, Judgement};
use jobs::{Assignments, Job, jobs};

/// Judges all tables of a few records by a validator and by the reference.
///
/// Time grows with (n − 1)!! · nⁿ for n half-edges: see [`TablesWork::estimate`].
///
/// # Panics
/// If the checker panics.
///
/// # Examples
/// ```
/// use twinedge_trials::tables::TablesWork;
/// use twinedge_trials::{Run, Validator, tables};
/// let outcome = tables(TablesWork { half_edges: 0 }, &Validator, &Run::default()).into_result()?;
/// // Two isolated vertices: which boundary component is which vertex, and in which order they are listed.
/// assert_eq!(outcome.tables[0].right, 2 * 2);
/// # Ok::<(), twinedge_trials::Failed>(())
/// ```
pub fn tables(work: TablesWork, checker: &dyn Checker, run: &Run<'_>) -> Outcome<TablesResults> {
    let mut rows = Vec::new();
    let mut findings = Vec::new();
    // Pieces are counted across all jobs, so that small jobs do not all go to the first part.
    let mut piece = 0;
    for job in jobs(work.half_edges) {
        let pieces: Vec<Assignments> = job.assignments.iter().flat_map(Assignments::split).collect();
        let next = piece + pieces.len() as u64;
        let ours = (piece..).zip(pieces).filter(|(number, _)| run.part().has(*number)).map(|(_, piece)| piece);
        let (row, found) = judge(&job, &ours.collect::<Vec<_>>(), checker, run);
        piece = next;
        rows.push(row);
        add_findings(&mut findings, &found);
        if run.is_stopped() {
            break;
        }
    }
    Outcome::new(work, run, TablesResults { tables: rows, findings })
}

fn judge(job: &Job, pieces: &[Assignments], checker: &dyn Checker, run: &Run<'_>) -> (TablesRow, Vec<String>) {
    let stage = format!("{} half-edges: {}", job.half_edges, job.name);
    let found = run.each(&stage, pieces.len(), Judgement::default, |judged, number| {
        let piece = &pieces[number];
        for_each_assignment(&mut piece.table.clone(), &piece.cells, |table| {
            if run.is_stopped() {
                return;
            }
            if job.derive_origins {
                let mut table = table.clone();
                table.derive_origins();
                judged.compare(&table, &job.expectation, checker);
            } else {
                judged.compare(table, &job.expectation, checker);
            }
        });
    });
    let judged = Judgement::sum(found);
    let all = narrow(job.assignments.iter().map(Assignments::len).sum());
    let row = TablesRow {
        half_edges: job.half_edges,
        free: job.name.to_owned(),
        all,
        judged: judged.tables,
        right: judged.accepted,
        right_by_formula: narrow(job.right),
        disagreements: judged.disagreements,
        done: all == judged.tables,
    };
    (row, judged.findings)
}

/// The results of [`tables()`](crate::tables()).
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct TablesResults {
    /// The tables, by their size and by the free fields.
    pub tables: Vec<TablesRow>,
    /// The first disagreements. All are counted in the rows.
    pub findings: Vec<String>,
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

impl Results for TablesResults {
    type Work = TablesWork;

    fn reasons(&self, _: &Self::Work, is_complete: bool) -> Vec<String> {
        let mut reasons = Vec::new();
        if is_complete {
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
        reasons.extend(faults("disagreements", disagreements, &self.findings));
        reasons
    }

    fn absorb(&mut self, other: &Self) {
        add_rows(&mut self.tables, &other.tables);
        add_findings(&mut self.findings, &other.findings);
    }

    fn complete(&mut self) {
        for row in &mut self.tables {
            row.done = row.judged == row.all;
        }
    }
}

/// The work of `tables`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct TablesWork {
    /// The largest number of half-edges.
    pub half_edges: usize,
}

impl TablesWork {
    /// Returns the approximate number of judged tables; `u128::MAX` for more than it can hold.
    #[must_use]
    pub fn estimate(&self) -> Estimate {
        let n = self.half_edges as u128;
        // The last two jobs contain nearly all of them.
        let paired = formulas::pairings(n / 2).saturating_mul(n.saturating_pow(u32::try_from(n).unwrap_or(u32::MAX)));
        Estimate { amount: paired.saturating_mul(2).saturating_add(5_000_000), unit: "tables", per_second: 500_000 }
    }
}
