//! Reports as documents. Reading refuses reports that no validation could produce.

use super::names::Record;
use super::violation::Violation;
use super::{Bounds, Counts, Report, RuleOutcome, Unchecked};
use crate::validate::rule::Rule;
use alloc::string::String;
use alloc::vec::Vec;
use core::fmt;
use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// An inconsistency in a report being read, which cannot come from a validation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Inconsistency {
    /// The report has another version.
    Schema,
    /// A violation claims to break another rule than this one.
    OtherRule(Rule),
    /// The verdict contradicts the outcomes.
    Verdict,
    /// The rules are not in order, or one is repeated.
    RuleOrder(Rule),
    /// A rule that every validation checks has no outcome, or only some rules about coordinates have one.
    MissingRule(Rule),
    /// The violations are not in the order of the rules.
    ViolationOrder(Rule),
    /// More violations of a rule are kept than its outcome counts, or it has no outcome.
    ViolationCount(Rule),
    /// The total number of violations cannot be represented.
    TooManyViolations,
    /// A rule is unchecked because of another rule, which is not broken.
    NotBroken(Rule),
    /// Every rule holds, but a count is missing.
    NotCounted,
    /// Every rule holds, but no structure has these counts.
    Counts,
    /// Every rule holds, but the counts break Euler's formula.
    Euler,
    /// The bounds differ from T4.
    Bounds,
}

impl fmt::Display for Inconsistency {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Schema => write!(f, "expected the schema {REPORT_SCHEMA}"),
            Self::OtherRule(rule) => write!(f, "a violation of {rule} names another rule"),
            Self::Verdict => f.write_str("`valid` contradicts the outcomes of the rules"),
            Self::RuleOrder(rule) => write!(f, "the outcome of {rule} is not in the order of the rules"),
            Self::ViolationOrder(rule) => write!(f, "a violation of {rule} is not in the order of the rules"),
            Self::ViolationCount(rule) => write!(f, "more violations of {rule} than its outcome counts"),
            Self::MissingRule(rule) => write!(f, "{rule} has no outcome"),
            Self::TooManyViolations => f.write_str("the numbers of violations add up to more than can be counted"),
            Self::Euler => f.write_str("every rule holds, but the counts break Euler's formula"),
            Self::Bounds => f.write_str("the bounds are not those of T4"),
            Self::NotBroken(rule) => write!(f, "a rule was not checked because {rule} is broken, which it is not"),
            Self::NotCounted => f.write_str("every rule holds, but components, cycles, borders or genus are missing"),
            Self::Counts => f.write_str("the counts contradict each other"),
        }
    }
}

/// The name and version of the form of a written [`Report`]: the value of its key `schema`. See `docs/report.md`.
///
/// Within a version, keys and names may be added, but none changes or disappears.
pub const REPORT_SCHEMA: &str = "twinedge-report/1";

/// A violation as an entry of a report: rule, kind, fields, records and message.
///
/// ```
/// use twinedge::validate::{Described, Violation};
/// let written = serde_json::to_value(Described(&Violation::TwinIsSelf { half_edge: 3 }))?;
/// assert_eq!(written, serde_json::json!({
///     "rule": "L1",
///     "kind": "twin_is_self",
///     "fields": { "half_edge": 3 },
///     "records": [{ "half_edge": 3 }],
///     "message": "half-edge 3 is its own twin, so its edge has one side only",
/// }));
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Described<'a>(pub &'a Violation);

impl Serialize for Described<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(Serialize)]
        struct Entry<'a> {
            rule: Rule,
            #[serde(flatten)]
            violation: &'a Violation,
            records: Vec<Record>,
            message: String,
        }
        let Self(violation) = *self;
        let records = violation.records().into_iter().flatten().collect();
        Entry { rule: violation.rule(), violation, records, message: violation.message() }.serialize(serializer)
    }
}

#[derive(Serialize, Deserialize)]
struct OutcomeEntry {
    id: Rule,
    #[serde(flatten)]
    outcome: RuleOutcome,
}

impl Serialize for Report {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(Serialize)]
        #[serde(rename = "Report")]
        struct Document<'a> {
            schema: &'static str,
            valid: bool,
            counts: &'a Counts,
            bounds: Option<Bounds>,
            rules: Vec<OutcomeEntry>,
            violation_count: u64,
            violations: Vec<Described<'a>>,
        }
        Document {
            schema: REPORT_SCHEMA,
            valid: self.is_valid(),
            counts: &self.counts,
            bounds: self.bounds,
            rules: self.outcomes().map(|(id, outcome)| OutcomeEntry { id, outcome }).collect(),
            violation_count: self.violation_count(),
            violations: self.violations.iter().map(Described).collect(),
        }
        .serialize(serializer)
    }
}

/// A violation being read. Derived entries are compared.
#[derive(Deserialize)]
struct ViolationEntry {
    rule: Rule,
    #[serde(flatten)]
    violation: Violation,
}

/// The keys of a report that are read. The others are derived.
#[derive(Deserialize)]
#[serde(rename = "Report")]
struct Fields {
    schema: String,
    valid: bool,
    rules: Vec<OutcomeEntry>,
    violations: Vec<ViolationEntry>,
    counts: Counts,
    bounds: Option<Bounds>,
}

impl Fields {
    fn check(self) -> Result<Report, Inconsistency> {
        let Self { schema, valid, rules, violations, counts, bounds } = self;
        if schema != REPORT_SCHEMA {
            return Err(Inconsistency::Schema);
        }
        if let Some(entry) = violations.iter().find(|entry| entry.rule != entry.violation.rule()) {
            return Err(Inconsistency::OtherRule(entry.violation.rule()));
        }
        let outcomes: Vec<_> = rules.into_iter().map(|entry| (entry.id, entry.outcome)).collect();
        let violations: Vec<_> = violations.into_iter().map(|entry| entry.violation).collect();
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
        if outcomes.iter().try_fold(0_u64, |sum, (_, o)| sum.checked_add(o.violations)).is_none() {
            return Err(Inconsistency::TooManyViolations);
        }
        let has = |rule: Rule| outcomes.iter().any(|(r, _)| *r == rule);
        let geometric = outcomes.iter().any(|(rule, _)| rule.is_geometric());
        let is_needed = |rule: Rule| !rule.is_optional() && (geometric || !rule.is_geometric());
        if let Some(rule) = Rule::ALL.iter().find(|rule| is_needed(**rule) && !has(**rule)) {
            return Err(Inconsistency::MissingRule(*rule));
        }
        let report = Report { outcomes, violations, counts, bounds };
        match report.is_valid() {
            is_valid if is_valid != valid => Err(Inconsistency::Verdict),
            true => counts_agree(&report).map(|()| report),
            false => Ok(report),
        }
    }
}

/// Checks the counts of a valid structure against one another.
fn counts_agree(report: &Report) -> Result<(), Inconsistency> {
    let Counts { vertices, half_edges, edges, isolated_vertices, components, cycles, borders, genus, .. } =
        report.counts;
    let (Some(components), Some(cycles), Some(borders), Some(genus)) = (components, cycles, borders, genus) else {
        return Err(Inconsistency::NotCounted);
    };
    // Each edge has one half-edge or two, and each component has a vertex.
    let fit = isolated_vertices <= components
        && components <= vertices
        && edges <= half_edges
        && half_edges <= edges.saturating_mul(2)
        && cycles <= half_edges;
    if !fit {
        return Err(Inconsistency::Counts);
    }
    let outcome = |rule| report.outcome(rule).unwrap_or_default();
    let is_plane = outcome(Rule::T1).unchecked != Some(Unchecked::PlaneOnly);
    let sum = |all: &[usize]| all.iter().map(|n| *n as i128).sum::<i128>();
    let left = sum(&[vertices, cycles, borders, isolated_vertices]) - sum(&[edges]);
    if left != 2 * (sum(&[components]) - sum(&[genus])) || is_plane && genus > 0 {
        return Err(Inconsistency::Euler);
    }
    let is_bounded = outcome(Rule::T4).unchecked.is_none();
    let most = |times: usize, less: usize| vertices.checked_mul(times)?.checked_sub(less);
    let bounds = most(3, 6).zip(most(2, 4)).filter(|_| is_bounded);
    let expected = bounds.map(|(most_edges, most_faces)| Bounds { most_edges, most_faces });
    let within = expected.is_none_or(|most| edges <= most.most_edges && report.counts.faces <= most.most_faces);
    if report.bounds != expected || is_bounded != expected.is_some() || !within {
        return Err(Inconsistency::Bounds);
    }
    Ok(())
}

impl<'de> Deserialize<'de> for Report {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Fields::deserialize(deserializer)?.check().map_err(D::Error::custom)
    }
}
