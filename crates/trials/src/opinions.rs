//! Two opinions: the fast validator and the reference on one structure.

use std::fmt;
use twinedge::validate::reference::{broken_rules, first_broken_rule};
use twinedge::validate::{Collect, Expectation, Report, Rule, Unchecked, View, validate};

/// A difference between the fast validator and the reference on one structure.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Disagreement {
    /// The first broken rules differ, or only one validator finds a broken rule.
    FirstBrokenRule {
        /// By the fast validator.
        fast: Option<Rule>,
        /// By the reference.
        reference: Option<Rule>,
    },
    /// A later rule, which the fast validator checked, is broken according to only one of them.
    LaterRule {
        /// The rule.
        rule: Rule,
        /// True if the fast validator finds it broken, false if the reference does.
        fast: bool,
    },
    /// The report of the fast validator contradicts itself: it calls the structure invalid without a broken rule, or valid with
    /// one.
    Incoherent {
        /// True if the report calls the structure valid.
        valid: bool,
        /// The first broken rule in the same report.
        fast: Option<Rule>,
    },
}

struct RuleText(Option<Rule>);

impl fmt::Display for RuleText {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Some(rule) => write!(f, "{rule}"),
            None => f.write_str("none"),
        }
    }
}

impl fmt::Display for Disagreement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::FirstBrokenRule { fast, reference } => write!(
                f,
                "the first broken rule is {} by the fast validator, {} by the reference",
                RuleText(fast),
                RuleText(reference)
            ),
            Self::LaterRule { rule, fast: true } => {
                write!(f, "{rule} is broken by the fast validator, but not by the reference")
            }
            Self::LaterRule { rule, fast: false } => {
                write!(f, "{rule} is broken by the reference, but not by the fast validator")
            }
            Self::Incoherent { valid, fast } => {
                let called = if valid { "valid" } else { "invalid" };
                write!(f, "the report calls the structure {called}, and its first broken rule is {}", RuleText(fast))
            }
        }
    }
}

impl std::error::Error for Disagreement {}

/// Judges a structure by both validators, and returns the common first broken rule; `None` if both call the structure valid.
///
/// Both must find the same first broken rule, if any. Where R1 holds, they must also agree on each later rule, except rules
/// that the fast validator does not check because another one is broken.
///
/// Cost: O(n³) and more, as for the reference.
///
/// # Errors
/// [`Disagreement`] if they differ. If the answers of the structure do not change, that is a fault of this crate.
///
/// ```
/// use twinedge_trials::opinions::compare;
/// use twinedge::validate::{Expectation, Rule, Table};
/// // An edge between two vertices whose two half-edges both say that they start at vertex 0.
/// let table: Table = "V 2 0 - 1 - H 2 0 1 1 1 0 0 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0".parse()?;
/// assert_eq!(compare(&table, &Expectation::plane()), Ok(Some(Rule::V1)));
/// # Ok::<(), twinedge::validate::ParseTableError>(())
/// ```
pub fn compare(view: &dyn View, expectation: &Expectation) -> Result<Option<Rule>, Disagreement> {
    let report = validate(view, expectation, Collect::AtMost(0));
    let broken = broken_rules(view, expectation);
    disagreement(&report, &broken).map_or(Ok(broken.first().copied()), Err)
}

/// Like [`compare`], but skips later rules, which takes less time.
///
/// # Errors
/// [`Disagreement`] if they differ.
pub fn compare_first(view: &dyn View, expectation: &Expectation) -> Result<Option<Rule>, Disagreement> {
    let report = validate(view, expectation, Collect::AtMost(0));
    let reference = first_broken_rule(view, expectation);
    first(&report, reference).map_or(Ok(reference), Err)
}

/// Returns the difference between a report of the fast validator and the [`broken_rules`] of the reference; `None` if they
/// agree.
#[must_use]
pub fn disagreement(report: &Report, broken: &[Rule]) -> Option<Disagreement> {
    let reference = broken.first().copied();
    if let Some(difference) = first(report, reference) {
        return Some(difference);
    }
    if reference == Some(Rule::R1) {
        return None;
    }
    report.outcomes().find_map(|(rule, outcome)| {
        let fast = outcome.violations > 0;
        let declined = matches!(outcome.unchecked, Some(Unchecked::Broken(_)));
        let differs = !declined && !rule.is_geometric() && fast != broken.contains(&rule);
        differs.then_some(Disagreement::LaterRule { rule, fast })
    })
}

fn first(report: &Report, reference: Option<Rule>) -> Option<Disagreement> {
    let fast = report.broken_rules().find(|rule| !rule.is_geometric());
    let valid = report.is_valid();
    if valid != report.broken_rules().next().is_none() {
        return Some(Disagreement::Incoherent { valid, fast });
    }
    (fast != reference).then_some(Disagreement::FirstBrokenRule { fast, reference })
}
