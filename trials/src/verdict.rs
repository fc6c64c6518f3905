//! The verdict of a validator on a table, in the form of the reference.

use twinedge::validate::{Collect, Expectation, Report, Rule, Table, View, accepts, validate};

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
/// use twinedge_trials::{Checker, Outcome, Run, Verdict, tables};
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

/// Returns the report of the library's validator on a structure. The pointer lets it be compiled only once.
pub(crate) fn judge(structure: &dyn View, expectation: &Expectation) -> Report {
    validate(structure, expectation, Collect::First)
}

/// Returns a first broken rule in words.
pub(crate) fn in_words(broken: Option<Rule>) -> String {
    broken.map_or_else(|| "right".to_owned(), |rule| format!("wrong by {rule}"))
}
