//! Validators of tables under test, and their verdicts in the form of the reference.

use crate::random::Random;
use crate::rows::{MOST_FINDINGS, add_findings};
use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hash as _, Hasher as _};
use twinedge::validate::reference::first_broken_rule;
use twinedge::validate::{Collect, Expectation, Parts, Report, Rule, Surface, Table, View, accepts, validate};
use twinedge_certificate::{Certificate, Column, Labels, check, check_surface};

/// The verdict of a validator on a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Verdict {
    /// True if it accepts the table.
    pub valid: bool,
    /// The first broken rule, by the validator.
    pub broken: Option<Rule>,
}

impl Verdict {
    /// Returns true if it agrees with a reference that finds this rule broken first, or none.
    #[must_use]
    pub fn agrees(self, reference: Option<Rule>) -> bool {
        self.valid == reference.is_none() && self.broken == reference
    }

    /// Returns true if it reports a fault.
    pub(crate) const fn is_alarm(self) -> bool {
        !self.valid || self.broken.is_some()
    }
}

impl std::fmt::Display for Verdict {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match (self.valid, self.broken) {
            (true, None) => f.write_str("right"),
            (true, Some(rule)) => write!(f, "right, although {rule} is broken,"),
            (false, None) => f.write_str("wrong by no rule"),
            (false, Some(rule)) => write!(f, "wrong by {rule}"),
        }
    }
}

/// A validator under test: [`corrupt()`](crate::corrupt()), [`tables()`](crate::tables()) and [`sample()`](crate::sample())
/// compare it with the reference [`first_broken_rule`](twinedge::validate::reference::first_broken_rule).
///
/// ```
/// use twinedge::validate::{Expectation, Rule, Table};
/// use twinedge_trials::tables::TablesWork;
/// use twinedge_trials::{Checker, Run, Verdict, tables};
/// /// A validator that finds nothing.
/// struct Blind;
/// impl Checker for Blind {
///     fn check(&self, _: &Table, _: &Expectation) -> Verdict {
///         Verdict { valid: true, broken: None }
///     }
/// }
/// assert!(!tables(TablesWork { half_edges: 0 }, &Blind, &Run::default()).is_ok());
/// ```
pub trait Checker: Sync {
    /// Judges a table by this expectation.
    fn check(&self, table: &Table, expectation: &Expectation) -> Verdict;

    /// Called after each table, with the result of [`Checker::check`]. The time for this is not counted.
    fn checked(&self, table: &Table, expectation: &Expectation, verdict: Verdict) {
        let _ = (table, expectation, verdict);
    }
}

/// The validator of the library: [`validate`].
#[derive(Clone, Copy, Debug, Default)]
pub struct Validator;

impl Checker for Validator {
    fn check(&self, table: &Table, expectation: &Expectation) -> Verdict {
        // Stopping at the first violation is not enough: rules that run together may find a later rule's violation first.
        let report = validate(table, expectation, Collect::AtMost(0));
        let broken = report.outcomes().find(|(_, outcome)| outcome.violations > 0).map(|(rule, _)| rule);
        Verdict { valid: report.is_valid(), broken }
    }
}

/// The fast path of the library's validator, which accepts all valid structures: [`accepts`]. It also differs from the reference
/// if it leaves a valid table to the rules.
#[derive(Clone, Copy, Debug, Default)]
pub struct FastPath;

impl Checker for FastPath {
    fn check(&self, table: &Table, expectation: &Expectation) -> Verdict {
        let valid = accepts(table, expectation);
        let broken = Validator.check(table, expectation).broken.or(Some(Rule::R1));
        Verdict { valid, broken: broken.filter(|_| !valid) }
    }
}

/// The verdicts of a validator on some tables, compared with the reference.
#[derive(Default)]
pub(crate) struct Judgement {
    pub(crate) tables: u64,
    /// The tables that the validator accepts.
    pub(crate) accepted: u64,
    /// For each rule, the number of tables that break it first, by the reference.
    pub(crate) first_broken: BTreeMap<Rule, u64>,
    pub(crate) disagreements: u64,
    pub(crate) findings: Vec<String>,
}

impl Judgement {
    pub(crate) fn compare(&mut self, table: &Table, expectation: &Expectation, checker: &dyn Checker) {
        let verdict = checker.check(table, expectation);
        let reference = first_broken_rule(table, expectation);
        self.tables += 1;
        self.accepted += u64::from(verdict.valid);
        if let Some(rule) = reference {
            *self.first_broken.entry(rule).or_default() += 1;
        }
        if !verdict.agrees(reference) {
            self.disagreements += 1;
            if self.findings.len() < MOST_FINDINGS {
                let reference = in_words(reference);
                self.findings.push(format!("{verdict} to the validator, {reference} to the reference:\n{table}"));
            }
        }
        checker.checked(table, expectation, verdict);
    }

    pub(crate) fn sum(judgements: Vec<Self>) -> Self {
        let mut sum = Self::default();
        for judged in judgements {
            sum.tables += judged.tables;
            sum.accepted += judged.accepted;
            for (rule, count) in judged.first_broken {
                *sum.first_broken.entry(rule).or_default() += count;
            }
            sum.disagreements += judged.disagreements;
            add_findings(&mut sum.findings, &judged.findings);
        }
        sum
    }
}

/// Returns the report of the library's validator on a structure. The pointer lets it be compiled only once.
pub(crate) fn judge(structure: &dyn View, expectation: &Expectation) -> Report {
    validate(structure, expectation, Collect::First)
}

/// Returns a first broken rule in words.
pub(crate) fn in_words(broken: Option<Rule>) -> String {
    broken.map_or_else(|| "right".to_owned(), |rule| format!("wrong by {rule}"))
}

/// A validator that uses certificates only: a table is valid if its own labels pass, or random ranks, or modified labels; with
/// the table, and in a plane as a self-contained certificate. It differs from the reference if and only if one of these does: its
/// result is then the first broken rule, or R1.
///
/// Open structures, and meshes with further expectations, have no labels: these are left to [`Validator`].
#[derive(Clone, Copy, Debug, Default)]
pub struct Certificates;

impl Checker for Certificates {
    fn check(&self, table: &Table, expectation: &Expectation) -> Verdict {
        let Some((labels, genus)) = labels(table, expectation) else { return Validator.check(table, expectation) };
        let passes = |labels: &Labels| match genus {
            None => check(table, labels).is_ok(),
            // A surface passes with its own genus, and with no other.
            Some(genus) => (0..=genus + 1).filter(|genus| check_surface(table, labels, *genus).is_ok()).count() == 1,
        };
        let mut random = random_of(table);
        let mut changed = labels.clone();
        for _ in 0..2 {
            change(&mut changed, &mut random);
        }
        let all = [random_ranks(&labels, &mut random), labels, changed];
        let stands_alone = |labels: &Labels| Certificate::new(table, labels).is_ok_and(|alone| alone.check().is_ok());
        let beside = all.iter().any(passes);
        let alone = if genus.is_none() { all.iter().any(stands_alone) } else { beside };
        let broken = first_broken_rule(table, expectation);
        let valid = if beside == alone { beside } else { broken.is_some() };
        Verdict { valid, broken: if valid { None } else { broken.or(Some(Rule::R1)) } }
    }
}

/// Returns certificates of a table of a plane subdivision: with its own labels, with random ranks, and two with one changed
/// number. `None` for a table that lacks a part.
#[must_use]
pub fn certificates_of(table: &Table) -> Option<[Certificate; 4]> {
    if table.parts != Parts::ALL {
        return None;
    }
    let labels = Labels::new(table).ok()?;
    let own = Certificate::new(table, &labels).ok()?;
    let mut random = random_of(table);
    let ranked = Certificate::new(table, &random_ranks(&labels, &mut random)).ok()?;
    let mut changed = || {
        let mut columns = own.columns().clone();
        change(&mut columns, &mut random);
        Certificate::from_columns(columns)
    };
    Some([changed()?, changed()?, ranked, own])
}

/// Returns the labels of a table for this expectation, and the genus on surfaces. `None` where the expectation has no labels.
fn labels(table: &Table, expectation: &Expectation) -> Option<(Labels, Option<usize>)> {
    let asks = Rule::ALL.iter().any(|rule| rule.is_optional() && expectation.asks_for(*rule));
    match expectation.surface_kind() {
        _ if asks || expectation.is_open() => None,
        Surface::Plane => Labels::new(table).ok().map(|labels| (labels, None)),
        _ => Labels::of_surface(table).ok().map(|(labels, genus)| (labels, Some(genus))),
    }
}

/// Returns the same random numbers every time for the same table.
fn random_of(table: &Table) -> Random {
    let mut hasher = DefaultHasher::new();
    table.to_string().hash(&mut hasher);
    Random::new(hasher.finish(), 0)
}

fn random_ranks(labels: &Labels, random: &mut Random) -> Labels {
    let mut labels = labels.clone();
    let count = labels.column(Column::HalfEdgeRank).len();
    labels.column_mut(Column::HalfEdgeRank).iter_mut().for_each(|rank| *rank = random.below(count) as u32);
    labels
}

/// Sets one number, if there is one, to another possible number, to nil, or to the content of a vacant slot.
fn change(labels: &mut Labels, random: &mut Random) {
    let filled: Vec<Column> = Column::ALL.into_iter().filter(|column| !labels.column(*column).is_empty()).collect();
    let Some(column) = filled.get(random.below(filled.len())) else { return };
    let column = labels.column_mut(*column);
    let (at, value) = (random.below(column.len()), random.below(column.len() + 3) as u32);
    column[at] = if value as usize > column.len() { u32::MAX - (value - column.len() as u32 - 1) } else { value };
}
