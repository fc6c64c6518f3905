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

mod labels;
mod open_table;
mod recount;
mod side;
mod work;

pub use labels::{LazyColumn, LazyLabels};
pub use side::Acceptor;
pub use work::{LazyError, LazyWork};

use crate::outcome::{Outcome, Results, faults};
use crate::rows::{add_findings, add_rows, narrow, rows};
use crate::run::Run;
use side::{Judgement, Side, Tables};
use std::fmt;
use std::ops::AddAssign;

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
/// use twinedge_trials::{Run, Validator, lazy};
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
pub fn lazy(work: LazyWork, validator: &dyn Acceptor, run: &Run<'_>) -> Result<Outcome<LazyResults>, LazyError> {
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
    Ok(Outcome::new(work, run, LazyResults::new(work, rows, findings)))
}

/// The results of [`lazy()`](crate::lazy()).
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct LazyResults {
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

impl LazyResults {
    fn new(work: LazyWork, judges: Vec<JudgeRow>, findings: Vec<String>) -> Self {
        let tables = judges.first().map(|row| row.all.rounded()).unwrap_or_default();
        let with_labels = judges.last().filter(|_| work.certificates).map(|row| row.all.rounded());
        let mut outcome = Self { tables, with_labels, runs: 0, accepted: 0, differences: 0, judges, findings };
        outcome.total();
        outcome
    }

    fn total(&mut self) {
        (self.runs, self.accepted) = self.judges.first().map_or((0, 0), |row| (row.runs, row.accepted));
        self.differences = self.judges.iter().map(|row| row.differences).sum();
    }
}

impl Results for LazyResults {
    type Work = LazyWork;

    fn reasons(&self, _: &Self::Work, is_complete: bool) -> Vec<String> {
        let mut reasons = Vec::new();
        if is_complete {
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
        reasons.extend(faults("differences", self.differences, &self.findings));
        reasons
    }

    fn absorb(&mut self, other: &Self) {
        add_rows(&mut self.judges, &other.judges);
        add_findings(&mut self.findings, &other.findings);
    }

    fn complete(&mut self) {
        self.total();
    }
}

/// A number of tables.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(into = "String", try_from = "String")
)]
pub struct Many(pub u128);

impl Many {
    /// Returns the order of magnitude: `10^21.7`.
    #[must_use]
    pub fn rounded(self) -> String {
        format!("10^{:.1}", (self.0.max(1) as f64).log10())
    }
}

impl fmt::Display for Many {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl AddAssign for Many {
    fn add_assign(&mut self, other: Self) {
        self.0 += other.0;
    }
}

impl From<Many> for String {
    fn from(many: Many) -> Self {
        many.to_string()
    }
}

impl TryFrom<String> for Many {
    type Error = std::num::ParseIntError;

    fn try_from(text: String) -> Result<Self, Self::Error> {
        text.parse().map(Self)
    }
}
