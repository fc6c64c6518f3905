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
//! A rule of the reference that has held is not asked again while the cells that it read keep their values.
//!
//! Each run counts the tables for which it stands: the product of the numbers of values of the cells that it has not read. They must add up to
//! the number of all tables, so that none is left out and none is judged twice. For closed surfaces, and for the plane without holes, the
//! number of right tables is known by a recount of the maps, whatever of M1 … M8 is asked for, and as many must be accepted.
//!
//! # Certificates
//!
//! With [`LazyWork::certificates`] the [checker of certificates](twinedge_certificate) is judged: labels are cells, too, as are the lengths of their
//! columns. Each table that the reference accepts must pass with the labels that are made for it: nothing right is without certificate. The checker goes through all tables with
//! all labels, and the reference judges each table that passes with some: nothing wrong has a certificate. Then the reference goes through them before the checker does;
//! as many must be accepted by both.
//!
//! A checker compares ranks with ranks, and positions with positions, and does nothing else with these numbers. So a run stands for all that are in the same order.

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
/// [`LazyError`] if they cannot be counted, or certificates are asked for and do not claim what the tables are held to.
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
