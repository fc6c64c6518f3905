//! Reports that are read again: what a validation could not have reported is refused.

use super::counts::{Bounds, Counts};
use super::report::{Report, RuleOutcome, Unchecked};
use super::rule::Rule;
use super::violation::Violation;
use alloc::vec::Vec;
use core::fmt;
use serde::de::Error as _;
use serde::{Deserialize, Deserializer};

/// Why a report that is read cannot come from a validation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Inconsistency {
    /// The rules are not in order, or one is there twice.
    RuleOrder(Rule),
    /// The violations are not in the order of the rules.
    ViolationOrder(Rule),
    /// More violations of a rule are kept than its outcome counts, or it has no outcome.
    ViolationCount(Rule),
    /// A rule that cannot be checked because another is broken, which is not.
    NotBroken(Rule),
    /// Every rule holds, but something was not counted.
    NotCounted,
    /// Every rule holds, with more isolated vertices than vertices or more edges than half-edges.
    Counts,
}

impl fmt::Display for Inconsistency {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::RuleOrder(rule) => write!(f, "the outcome of {rule} is not in the order of the rules"),
            Self::ViolationOrder(rule) => write!(f, "a violation of {rule} is not in the order of the rules"),
            Self::ViolationCount(rule) => write!(f, "more violations of {rule} than its outcome counts"),
            Self::NotBroken(rule) => write!(f, "a rule was not checked because {rule} is broken, which it is not"),
            Self::NotCounted => f.write_str("every rule holds, but components, cycles, borders or genus are missing"),
            Self::Counts => f.write_str("the counts contradict each other"),
        }
    }
}

/// The fields of a [`Report`].
#[derive(Deserialize)]
#[serde(rename = "Report")]
struct Fields {
    outcomes: Vec<(Rule, RuleOutcome)>,
    violations: Vec<Violation>,
    counts: Counts,
    bounds: Option<Bounds>,
}

impl Fields {
    fn check(self) -> Result<Report, Inconsistency> {
        let Self { outcomes, violations, counts, bounds } = self;
        if let Some(pair) = outcomes.windows(2).find(|pair| pair[0].0 >= pair[1].0) {
            return Err(Inconsistency::RuleOrder(pair[1].0));
        }
        if let Some(pair) = violations.windows(2).find(|pair| pair[0].rule() > pair[1].rule()) {
            return Err(Inconsistency::ViolationOrder(pair[1].rule()));
        }
        let counted = |rule: Rule| outcomes.iter().find(|(r, _)| *r == rule).map_or(0, |(_, o)| o.violations);
        let kept = |rule: Rule| violations.iter().filter(|violation| violation.rule() == rule).count() as u64;
        if let Some(rule) = Rule::ALL.iter().find(|rule| kept(**rule) > counted(**rule)) {
            return Err(Inconsistency::ViolationCount(*rule));
        }
        for (_, outcome) in &outcomes {
            match outcome.unchecked {
                Some(Unchecked::Broken(rule)) if counted(rule) == 0 && rule != Rule::R1 => {
                    return Err(Inconsistency::NotBroken(rule));
                }
                _ => {}
            }
        }
        let Counts { vertices, half_edges, edges, isolated_vertices, components, cycles, borders, genus, .. } = counts;
        let report = Report { outcomes, violations, counts, bounds };
        let all_counted = components.is_some() && cycles.is_some() && borders.is_some() && genus.is_some();
        match report.is_valid() {
            true if !all_counted => Err(Inconsistency::NotCounted),
            true if isolated_vertices > vertices || edges > half_edges => Err(Inconsistency::Counts),
            _ => Ok(report),
        }
    }
}

impl<'de> Deserialize<'de> for Report {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Fields::deserialize(deserializer)?.check().map_err(D::Error::custom)
    }
}
