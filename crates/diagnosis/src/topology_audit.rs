//! Findings of the audit of a topology whose edges are kept as lines with bends: of PostGIS, or of TopoJSON.

use crate::{Diagnosis, RuleLine, write_list};
use std::fmt;

/// The findings of an audit. `Display` prints it as text; with the feature `serde` it is serialized as in `docs/report.md`:
///
/// ```text
/// {
///   "schema": "twinedge-report/1",
///   "valid": false,
///   "counts": {"vertices": 5, "isolated_vertices": 1, "nodes": 5, "isolated_nodes": 1, "edges": 5, "faces": 4, "components": 3,
///              "bends": 7, "repeated_points": 0},
///   "rules": [{"id": "P0", "name": "ids", "checked": 14, "unit": "rows", "violations": 0, "unchecked": null}, …],
///   "violation_count": 1,
///   "violations": [{"rule": "R1", "kind": "dangling", "records": ["edge +3"], "at": [[10.0, 0.0], [10.0, 10.0]],
///                   "message": "next_left_edge of edge 3 is 99, and there is no such edge", "cause": "…", "remedy": "…"}]
/// }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct TopologyAudit {
    counts: TopologyCounts,
    rules: Vec<RuleLine>,
    violations: Vec<Diagnosis>,
}

/// The counts of a topology.
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

impl TopologyAudit {
    /// Creates an audit: sorts the violations by rule, and keeps up to a limit. The rules count all of them.
    #[must_use]
    pub fn new(counts: TopologyCounts, rules: Vec<RuleLine>, mut violations: Vec<Diagnosis>, limit: usize) -> Self {
        violations.sort_by_key(|one| rules.iter().position(|rule| Some(rule.id) == one.rule));
        violations.truncate(limit);
        Self { counts, rules, violations }
    }

    /// Returns true if no rule is broken, and every rule that applies was checked.
    #[must_use]
    pub fn is_valid(&self) -> bool {
        self.violation_count() == 0 && self.unchecked_count() == 0
    }

    /// Returns the counts.
    #[must_use]
    pub const fn counts(&self) -> &TopologyCounts {
        &self.counts
    }

    /// Returns the outcome of each rule: first for the format, then for the validator.
    #[must_use]
    pub fn rules(&self) -> &[RuleLine] {
        &self.rules
    }

    /// Returns the kept violations, in the order of the rules, with the names of the database or file.
    #[must_use]
    pub fn violations(&self) -> &[Diagnosis] {
        &self.violations
    }

    /// Returns the number of rules that apply and were not checked, or not on all records.
    #[must_use]
    pub fn unchecked_count(&self) -> usize {
        self.rules.iter().filter(|rule| rule.is_open()).count()
    }

    /// Returns the number of violations, kept or not.
    #[must_use]
    pub fn violation_count(&self) -> u64 {
        self.rules.iter().map(|rule| rule.violations).sum()
    }
}

#[cfg(feature = "serde")]
impl serde::Serialize for TopologyAudit {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        /// The counts, also under the names that all audits share.
        #[derive(serde::Serialize)]
        struct Counts<'a> {
            vertices: usize,
            isolated_vertices: usize,
            #[serde(flatten)]
            own: &'a TopologyCounts,
        }
        let own = &self.counts;
        let counts = Counts { vertices: own.nodes, isolated_vertices: own.isolated_nodes, own };
        crate::Document::new(self.is_valid(), counts, &self.rules)
            .named(&self.rules)
            .violations(&self.violations, self.violation_count())
            .serialize(serializer)
    }
}

/// The counts come first, then the rules, the violations, and the verdict.
impl fmt::Display for TopologyAudit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let TopologyCounts { nodes, isolated_nodes, edges, faces, components, bends, repeated_points } = self.counts;
        for (what, count) in [
            ("nodes (V)", nodes.to_string()),
            ("edges (E)", edges.to_string()),
            ("faces (F)", faces.to_string()),
            ("components", components.map_or_else(|| "unknown".to_owned(), |count| count.to_string())),
            ("isolated nodes", isolated_nodes.to_string()),
            ("bends", bends.to_string()),
            ("repeated points", repeated_points.to_string()),
        ] {
            writeln!(f, "{what:28} {count:>12}")?;
        }
        for rule in &self.rules {
            writeln!(f, "{rule}")?;
        }
        write_list(f, &self.violations, self.violation_count())?;
        f.write_str(if self.is_valid() { "valid" } else { "not valid" })?;
        match self.unchecked_count() {
            0 => Ok(()),
            1 => f.write_str("; 1 rule not checked"),
            n => write!(f, "; {n} rules not checked"),
        }
    }
}
