//! All tables of a size, with every cell free, by runs on tables whose cells are open until they are read.
//!
//! A validator that stops as soon as it knows its answer reads few cells of an invalid table. Its run on one table is its run on
//! all tables that have the same values in these cells, so one run covers all of them (*lazy enumeration*: Korat, lazy
//! `SmallCheck`). In the next run, the last cell read has its next value. In this way about 10^7 runs judge all of 10^21 tables.
//!
//! # What is shown
//!
//! Two judges go through all tables, each on its own: the [`Acceptor`], which is the validator, and the reference, rule by rule
//! in an order that reads little. Each table that one of them accepts is judged by the other, and both must accept the same
//! number. Both then accept exactly the same tables: no invalid one is accepted, and no valid one is rejected.
//!
//! The sentences of the reference are independent of the numbers of slots. If it reads a link to slots that it has not
//! distinguished yet, one of them stands for all, and the accepted tables are counted with this multiplicity. The validator reads
//! every table unchanged. A rule of the reference that holds is not checked again while the cells that it read keep their values.
//!
//! Each run counts the tables that it covers: the product of the numbers of values of the unread cells. The sum must be the
//! number of all tables, so that none is left out and none is judged twice. For closed surfaces, and for the plane without holes,
//! a recount of the maps determines the number of valid tables, for any of M1 … M8, which accepted ones must equal.
//!
//! # Certificates
//!
//! With [`LazyWork::certificates`] the [checker of certificates](twinedge_certificate) is judged: labels are cells as well, and
//! so are the lengths of their columns. Each table that the reference accepts must pass with the labels made for it: no valid
//! table is without certificate. The checker goes through all tables with all labels, and the reference judges each that passes
//! with some labels: no invalid table has a certificate. Finally the reference goes first; both must accept the same number.
//!
//! A checker compares ranks with ranks, and positions with positions, and uses these numbers for nothing else. One run therefore
//! covers all numbers in the same order.

mod acceptor;
mod estimate;
mod labels;
mod many;
mod open_table;
mod order;
mod outcome;
mod recount;
mod side;
mod work;

pub use acceptor::Acceptor;
pub use labels::{LazyColumn, LazyLabels};
pub use many::Many;
pub use outcome::{JudgeRow, LazyOutcome};
pub use work::{LazyError, LazyWork};

use crate::rows::{add_findings, narrow};
use crate::run::Run;
use side::{Judgement, Side, Tables};

/// Judges all tables of a size by a validator and by the reference.
///
/// Two half-edges take a moment, six half-edges on two vertices about 10^7 runs.
///
/// # Errors
/// [`LazyError`] if the tables cannot be counted, or if certificates cannot claim the expectation.
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
///     certificates: false,
/// };
/// let outcome = lazy(work, &Validator, &Run::default())?.into_result()?;
/// // A loop at one of the vertices, or an edge between both.
/// assert_eq!(outcome.accepted, 2 + 2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn lazy(work: LazyWork, validator: &dyn Acceptor, run: &Run<'_>) -> Result<LazyOutcome, LazyError> {
    let mut findings = Vec::new();
    let mut rows = Vec::new();
    for side in Side::all(&work, validator) {
        let all = side.table()?.agreeing();
        let found = side.judge(run)?;
        let sum = |count: fn(&Judgement) -> u128| found.iter().map(count).sum::<u128>();
        rows.push(JudgeRow {
            judge: side.name.to_owned(),
            runs: narrow(sum(|found| found.runs)),
            accepted: narrow(sum(|found| found.accepted)),
            right: if side.tables == Tables::WithLabels { None } else { recount::right(&work) },
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
