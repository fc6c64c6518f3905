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
mod outcome;
mod work;

pub use outcome::{TablesOutcome, TablesRow};
pub use work::TablesWork;

use crate::enumerate::{TableCells, for_each_assignment};
use crate::rows::{add_findings, narrow};
use crate::run::Run;
use crate::verdict::{Checker, in_words};
use jobs::{Assignments, Job, jobs};
use twinedge::validate::reference::first_broken_rule;
use twinedge::validate::{Expectation, Table};

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
/// use twinedge_trials::{Outcome, Run, Validator, tables};
/// let outcome = tables(TablesWork { half_edges: 0 }, &Validator, &Run::default()).into_result()?;
/// // Two isolated vertices: which boundary component is which vertex, and in which order they are listed.
/// assert_eq!(outcome.tables[0].right, 2 * 2);
/// # Ok::<(), twinedge_trials::Failed>(())
/// ```
pub fn tables(work: TablesWork, checker: &dyn Checker, run: &Run<'_>) -> TablesOutcome {
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
        add_findings(&mut findings, found.as_slice());
        if run.is_stopped() {
            break;
        }
    }
    TablesOutcome { work, shard: run.part(), tables: rows, findings, interrupted: run.is_stopped() }
}

#[derive(Default)]
struct Judgement {
    tables: u64,
    right: u64,
    disagreements: u64,
    finding: Option<String>,
}

fn judge(job: &Job, pieces: &[Assignments], checker: &dyn Checker, run: &Run<'_>) -> (TablesRow, Option<String>) {
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
                judged.compare(&table, job.expectation, checker);
            } else {
                judged.compare(table, job.expectation, checker);
            }
        });
    });
    let sum = |count: fn(&Judgement) -> u64| found.iter().map(count).sum::<u64>();
    let (all, judged) = (narrow(job.assignments.iter().map(Assignments::len).sum()), sum(|judged| judged.tables));
    let row = TablesRow {
        half_edges: job.half_edges,
        free: job.name.to_owned(),
        all,
        judged,
        right: sum(|judged| judged.right),
        right_by_formula: narrow(job.right),
        disagreements: sum(|judged| judged.disagreements),
        done: all == judged,
    };
    (row, found.into_iter().find_map(|judged| judged.finding))
}

impl Judgement {
    fn compare(&mut self, table: &Table, expectation: Expectation, checker: &dyn Checker) {
        let verdict = checker.check(table, &expectation);
        let reference = first_broken_rule(table, &expectation);
        self.tables += 1;
        self.right += u64::from(verdict.valid);
        if !verdict.agrees(reference) {
            self.disagreements += 1;
            self.finding.get_or_insert_with(|| {
                format!("{verdict} to the validator, {} to the reference:\n{table:#?}", in_words(reference))
            });
        }
        checker.checked(table, &expectation, verdict);
    }
}
