//! What was found, as the formats with a map show it.

use super::packed::Window;
use crate::coverage::Named;
use crate::output::{counted, grouped};
use crate::trace::{Position, Trace, place};
use serde::Serialize;
use twinedge::validate::{Embedding, Report, Rule, RuleOutcome, Violation};
use twinedge_formats::layer::Crs;

/// What was found in an input.
#[derive(Debug, Default, Serialize)]
pub(super) struct Document {
    pub(super) input: String,
    pub(super) valid: bool,
    /// Whether it is valid, in a sentence.
    pub(super) verdict: String,
    /// What a reader should know about the input, a sentence each.
    pub(super) notes: Vec<String>,
    pub(super) counts: Vec<(&'static str, String)>,
    pub(super) rules: Vec<RuleLine>,
    /// The unit of lengths, if there are any.
    pub(super) unit: Option<&'static str>,
    /// What is listed.
    pub(super) findings: Vec<Marked>,
    /// How many there are, listed or not.
    pub(super) total: u64,
    /// The features of the map: name, id, and a colour that neighbours have not.
    pub(super) features: Vec<(Option<String>, Option<String>, usize)>,
    #[serde(skip)]
    pub(super) crs: Option<Crs>,
}

/// The outcome of a rule.
#[derive(Debug, Serialize)]
pub(super) struct RuleLine {
    pub(super) id: &'static str,
    pub(super) name: &'static str,
    /// What it says, if it is one of the validator or of coverages.
    pub(super) statement: Option<&'static str>,
    /// What came of it, in words.
    pub(super) outcome: String,
    /// How many violations or findings there are.
    pub(super) found: u64,
}

/// A violation, or a finding of a coverage.
#[derive(Debug, Default, Serialize)]
pub(super) struct Marked {
    pub(super) rule: &'static str,
    /// The name of the rule.
    pub(super) name: &'static str,
    pub(super) kind: &'static str,
    pub(super) message: String,
    /// Whether it makes the input invalid.
    pub(super) violation: bool,
    pub(super) records: Vec<String>,
    #[serde(serialize_with = "numbers")]
    pub(super) features: Vec<Named>,
    pub(super) area: Option<f64>,
    pub(super) width: Option<f64>,
    pub(super) length: Option<f64>,
    pub(super) cause: Option<&'static str>,
    pub(super) remedy: Option<&'static str>,
    /// Where to look.
    pub(super) at: Option<Position>,
    pub(super) trace: Trace,
}

fn numbers<S: serde::Serializer>(features: &[Named], to: S) -> Result<S::Ok, S::Error> {
    to.collect_seq(features.iter().map(|feature| feature.number))
}

impl Marked {
    /// A violation, with the records named by their indices.
    pub(super) fn of_violation<E: Embedding + ?Sized>(structure: &E, violation: &Violation, explain: bool) -> Self {
        Self {
            rule: violation.rule().id(),
            name: violation.rule().name(),
            kind: violation.kind(),
            message: violation.to_string(),
            violation: true,
            records: violation.records().into_iter().flatten().map(|record| record.to_string()).collect(),
            features: Vec::new(),
            area: None,
            width: None,
            length: None,
            cause: explain.then(|| violation.cause()),
            remedy: explain.then(|| violation.remedy()),
            at: place(structure, violation),
            trace: Trace::of_violation(structure, violation),
        }
    }
}

/// How many records there are.
pub(super) fn counts(report: &Report) -> Vec<(&'static str, String)> {
    let counts = report.counts();
    let or_unknown = |n: Option<usize>| n.map_or_else(|| "unknown".to_owned(), grouped);
    vec![
        ("vertices", grouped(counts.vertices)),
        ("edges", grouped(counts.edges)),
        ("faces", grouped(counts.faces)),
        ("components", or_unknown(counts.components)),
        ("isolated vertices", grouped(counts.isolated_vertices)),
        ("genus", or_unknown(counts.genus)),
    ]
}

/// What came of the rules of the validator.
pub(super) fn rule_lines(report: &Report) -> Vec<RuleLine> {
    let line = |(rule, outcome): (Rule, RuleOutcome)| {
        let checked = format!("{} {}", grouped(outcome.checked), rule.unit(outcome.checked));
        let words = match (outcome.violations, outcome.unchecked) {
            (0, None) => format!("holds for {checked}"),
            (0, Some(why)) => format!("not checked: {why}"),
            (n, _) => format!("{} in {checked}", counted(n as usize, "violation")),
        };
        let (id, name, statement) = (rule.id(), rule.name(), Some(rule.statement()));
        RuleLine { id, name, statement, outcome: words, found: outcome.violations }
    };
    report.outcomes().map(line).collect()
}

impl Document {
    /// Around each finding.
    pub(super) fn windows(&self) -> Vec<Window> {
        let of = |one: &Marked| {
            let Trace { points, lines, polygons } = &one.trace;
            let rings = polygons.iter().flatten().chain(lines).flatten();
            Window::around(rings.chain(points).chain(&one.at))
        };
        self.findings.iter().filter_map(of).collect()
    }
}
