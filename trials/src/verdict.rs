//! The verdict of a validator on a table, in the form in which the reference answers.

use twinedge::validate::{Collect, Expectation, Report, Rule, Table, View, accepts, validate};

/// The verdict of a validator on a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Verdict {
    /// True if it takes the table for valid.
    pub valid: bool,
    /// The first rule that it finds broken.
    pub broken: Option<Rule>,
}

impl Verdict {
    /// Tells whether it says the same as a reference that finds this rule broken first, or none.
    #[must_use]
    pub fn agrees(self, reference: Option<Rule>) -> bool {
        self.valid == reference.is_none() && self.broken == reference
    }

    /// Tells whether it says that something is wrong.
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

/// A validator under test: [`corrupt()`](crate::corrupt()), [`tables()`](crate::tables()) and [`sample()`](crate::sample()) compare it with the reference
/// [`first_broken_rule`](twinedge::validate::reference::first_broken_rule).
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
    /// Judges a table that is held to this expectation.
    fn check(&self, table: &Table, expectation: &Expectation) -> Verdict;

    /// Called after each table, with what [`Checker::check`] said. The time that this takes is not counted.
    fn checked(&self, table: &Table, expectation: &Expectation, verdict: Verdict) {
        let _ = (table, expectation, verdict);
    }
}

/// The validator of the library: [`validate`].
#[derive(Clone, Copy, Debug, Default)]
pub struct Validator;

impl Checker for Validator {
    fn check(&self, table: &Table, expectation: &Expectation) -> Verdict {
        // To stop at the first violation would not do: of rules that are run together it need not be the first one's.
        let report = validate(table, expectation, Collect::AtMost(0));
        let broken = report.outcomes().find(|(_, outcome)| outcome.violations > 0).map(|(rule, _)| rule);
        Verdict { valid: report.is_valid(), broken }
    }
}

/// The fast path of the library's validator, which accepts whatever is right: [`accepts`]. It differs from the reference if it
/// leaves a right table to the rules, too.
#[derive(Clone, Copy, Debug, Default)]
pub struct FastPath;

impl Checker for FastPath {
    fn check(&self, table: &Table, expectation: &Expectation) -> Verdict {
        let valid = accepts(table, expectation);
        let broken = Validator.check(table, expectation).broken.or(Some(Rule::R1));
        Verdict { valid, broken: broken.filter(|_| !valid) }
    }
}

/// The report of the library's validator on a structure. Through a pointer: it is compiled once then, and not for every structure.
pub(crate) fn judge(structure: &dyn View, expectation: &Expectation) -> Report {
    validate(structure, expectation, Collect::First)
}

/// A first broken rule in words.
pub(crate) fn in_words(broken: Option<Rule>) -> String {
    broken.map_or_else(|| "right".to_owned(), |rule| format!("wrong by {rule}"))
}
