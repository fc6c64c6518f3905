//! What the audit of a topology found whose edges are kept as lines with bends: of PostGIS, or of TopoJSON.

use std::fmt;
use twinedge::validate::{Report, Rule, RuleOutcome};

/// What an audit found. `Display` prints all of it as text; with the feature `serde` it is serialized as
///
/// ```text
/// {
///   "valid": false,
///   "counts": {"nodes": 5, "isolated_nodes": 1, "edges": 5, "faces": 4, "components": 3, "bends": 7, "repeated_points": 0},
///   "rules": [{"id": "P0", "name": "ids", "checked": 14, "unit": "rows", "violations": 0, "unchecked": null}, …],
///   "violations": [{"rule": "R1", "kind": "dangling", "message": "next_left_edge of edge 3 is 99, and there is no such edge",
///                   "at": [[10.0, 0.0], [10.0, 10.0]], "records": ["edge +3"]}]
/// }
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct TopologyAudit {
    pub(crate) valid: bool,
    pub(crate) counts: TopologyCounts,
    pub(crate) rules: Vec<TopologyRule>,
    pub(crate) violations: Vec<TopologyViolation>,
    #[cfg_attr(feature = "serde", serde(skip))]
    pub(crate) unchecked: usize,
}

/// How many there are of everything.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct TopologyCounts {
    /// Nodes.
    pub nodes: usize,
    /// Nodes without edges.
    pub isolated_nodes: usize,
    /// Edges.
    pub edges: usize,
    /// Faces: face 0 of PostGIS included, the polygons of TopoJSON.
    pub faces: usize,
    /// Connected components of nodes and edges, if they could be counted.
    pub components: Option<usize>,
    /// Points of lines between their ends.
    pub bends: usize,
    /// Points of lines that repeat the one before them. They are legal.
    pub repeated_points: u64,
}

/// The outcome of a rule.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct TopologyRule {
    /// `P0` … `P4` of PostGIS or `A0` … `A3` of TopoJSON, `R1` … `T4`, `G1` … `G5`.
    pub id: &'static str,
    /// Its name.
    pub name: &'static str,
    /// How many of its unit were checked.
    pub checked: u64,
    /// What is counted.
    pub unit: &'static str,
    /// How many violations there are, kept or not.
    pub violations: u64,
    /// Why it was not checked, or not on everything.
    pub unchecked: Option<String>,
}

impl TopologyRule {
    /// The outcome of a rule of the validator.
    pub(crate) fn of(rule: Rule, outcome: &RuleOutcome) -> Self {
        Self {
            id: rule.id(),
            name: rule.name(),
            checked: outcome.checked,
            unit: rule.unit(outcome.checked),
            violations: outcome.violations,
            unchecked: outcome.unchecked.map(|why| why.to_string()),
        }
    }
}

/// One violation, in the words of the database or file.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct TopologyViolation {
    /// The id of the rule.
    pub rule: &'static str,
    /// The name of the violation, in snake case.
    pub kind: &'static str,
    /// What is wrong, in a sentence with the ids of the database, or the numbers of the file.
    pub message: String,
    /// Where it is: nodes, ends of edges, bends.
    pub at: Vec<[f64; 2]>,
    /// The records that it names, as the database or file does: `edge +17`, `node 80`, `face 6`.
    pub records: Vec<String>,
    /// The lines of the edges among them, whole.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub lines: Vec<Vec<[f64; 2]>>,
    /// What usually causes it.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub cause: &'static str,
    /// What mends it.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub remedy: &'static str,
}

impl TopologyAudit {
    /// Whether no rule is broken, and every rule that applies was checked.
    #[must_use]
    pub const fn is_valid(&self) -> bool {
        self.valid
    }

    /// How many there are of everything.
    #[must_use]
    pub const fn counts(&self) -> &TopologyCounts {
        &self.counts
    }

    /// The outcome of each rule: those of the format, then those of the validator.
    #[must_use]
    pub fn rules(&self) -> &[TopologyRule] {
        &self.rules
    }

    /// The violations that were kept, in the order of the rules.
    #[must_use]
    pub fn violations(&self) -> &[TopologyViolation] {
        &self.violations
    }

    /// How many rules that apply were not checked, or not on everything.
    #[must_use]
    pub const fn unchecked_count(&self) -> usize {
        self.unchecked
    }

    /// How many violations there are, kept or not.
    #[must_use]
    pub fn violation_count(&self) -> u64 {
        self.rules.iter().map(|rule| rule.violations).sum()
    }
}

/// The counts come first, then the rules, the violations, and the verdict.
impl fmt::Display for TopologyAudit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let TopologyCounts { nodes, isolated_nodes, edges, faces, components, bends, repeated_points } = self.counts;
        let components = components.map_or_else(|| "unknown".to_owned(), |count| count.to_string());
        for (what, count) in [
            ("nodes (V)", nodes.to_string()),
            ("edges (E)", edges.to_string()),
            ("faces (F)", faces.to_string()),
            ("components", components),
            ("isolated nodes", isolated_nodes.to_string()),
            ("bends", bends.to_string()),
            ("repeated points", repeated_points.to_string()),
        ] {
            writeln!(f, "{what:28} {count:>12}")?;
        }
        for TopologyRule { id, name, checked, unit, violations, unchecked } in &self.rules {
            write!(f, "{id} {name:10} ")?;
            match (violations, unchecked) {
                (0, None) => writeln!(f, "ok, {checked} {unit}")?,
                (0, Some(why)) => writeln!(f, "not checked: {why}")?,
                (n, why) => {
                    write!(f, "BROKEN, {n} violation{} in {checked} {unit}", if *n == 1 { "" } else { "s" })?;
                    match why {
                        Some(why) => writeln!(f, "; not checked {why}")?,
                        None => writeln!(f)?,
                    }
                }
            }
        }
        for TopologyViolation { rule, message, .. } in &self.violations {
            writeln!(f, "{rule}: {message}")?;
        }
        let more = self.violation_count().saturating_sub(self.violations.len() as u64);
        if more > 0 {
            writeln!(f, "… and {more} more")?;
        }
        f.write_str(if self.valid { "valid" } else { "not valid" })?;
        match self.unchecked {
            0 => Ok(()),
            1 => f.write_str("; 1 rule not checked"),
            n => write!(f, "; {n} rules not checked"),
        }
    }
}

/// How many rules of a report apply and were not checked.
pub(crate) fn not_checked(report: &Report) -> usize {
    report.outcomes().filter(|(_, outcome)| outcome.unchecked.is_some_and(|why| !why.is_by_design())).count()
}
