//! An audit as one JSON object.

use super::{Diagnosis, Reason, RuleLine};
use serde::Serialize;
use twinedge::validate::{Bounds, REPORT_SCHEMA};

/// An audit in the form of `docs/report.md`. `counts` are the counts of the audit.
///
/// ```
/// use twinedge::validate::Violation;
/// use twinedge_diagnosis::{Diagnosis, Document};
///
/// let found = [Diagnosis::from(&Violation::TwinIsSelf { half_edge: 3 })];
/// let written = serde_json::to_value(Document::new(false, (), &[]).violations(&found, 1))?;
/// assert_eq!(written["schema"], "twinedge-report/1");
/// assert_eq!(written["violations"][0]["records"], serde_json::json!([{ "half_edge": 3 }]));
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Debug, Serialize)]
pub struct Document<'a, C> {
    schema: &'static str,
    valid: bool,
    counts: C,
    bounds: Option<Bounds>,
    #[serde(skip_serializing_if = "Option::is_none")]
    finding_count: Option<u64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    findings: Option<&'a [Diagnosis]>,
    rules: Vec<Line>,
    violation_count: u64,
    violations: &'a [Diagnosis],
}

#[derive(Clone, Debug, Serialize)]
struct Line {
    id: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    name: Option<&'static str>,
    checked: u64,
    #[serde(skip_serializing_if = "Option::is_none")]
    unit: Option<&'static str>,
    violations: u64,
    unchecked: Option<Reason>,
    #[serde(skip_serializing_if = "Option::is_none")]
    left_out: Option<u64>,
}

impl<'a, C> Document<'a, C> {
    /// Creates an audit without findings.
    #[must_use]
    pub fn new(valid: bool, counts: C, rules: &[RuleLine]) -> Self {
        let line = |&RuleLine { id, checked, violations, unchecked, left_out, .. }: &RuleLine| Line {
            id,
            name: None,
            checked,
            unit: None,
            violations,
            unchecked,
            left_out,
        };
        Self {
            schema: REPORT_SCHEMA,
            valid,
            counts,
            bounds: None,
            finding_count: None,
            findings: None,
            rules: rules.iter().map(line).collect(),
            violation_count: 0,
            violations: &[],
        }
    }

    /// Adds the names and units of the rules.
    #[must_use]
    pub fn named(mut self, rules: &[RuleLine]) -> Self {
        for (line, rule) in self.rules.iter_mut().zip(rules) {
            (line.name, line.unit) = (Some(rule.name), Some(rule.unit));
        }
        self
    }

    /// Adds the listed violations, and their total number.
    #[must_use]
    pub fn violations(self, listed: &'a [Diagnosis], count: u64) -> Self {
        Self { violations: listed, violation_count: count, ..self }
    }

    /// Adds the listed findings, and their total number.
    #[must_use]
    pub fn findings(self, listed: &'a [Diagnosis], count: u64) -> Self {
        Self { findings: Some(listed), finding_count: Some(count), ..self }
    }

    /// Adds the bounds of rule T4, if they are known.
    #[must_use]
    pub fn bounds(self, bounds: Option<Bounds>) -> Self {
        Self { bounds, ..self }
    }
}
