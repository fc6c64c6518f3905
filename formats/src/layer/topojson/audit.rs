//! The audit of arcs: A0 … A3, and the validator's rules.

use super::finding::RULES;
use super::topology::ArcTopology;
use crate::topology_audit::{TopologyAudit, TopologyCounts, TopologyRule, TopologyViolation, not_checked};
use twinedge::validate::{Collect, Expectation, Only, Part, Parts, Unchecked, places, validate_embedding};

/// Judges the arcs of a file, and the polygons that are made of them. Up to `limit` violations are kept, those of the first rules
/// before others; all are counted. The rules about faces need A1: where it is broken, they are reported as not checked.
///
/// O(n log n) for n positions, and p more for p pairs of segments whose boxes meet, if arcs clash.
///
/// ```
/// use twinedge_formats::layer::ReadError;
/// use twinedge_formats::layer::topojson::{audit, read};
///
/// // Two squares side by side. Index −1 is arc 0 backwards.
/// let text = r#"{"type": "Topology", "arcs": [[[1, 0], [1, 1]], [[1, 1], [0, 1], [0, 0], [1, 0]], [[1, 0], [2, 0], [2, 1], [1, 1]]],
///     "objects": {"squares": {"type": "MultiPolygon", "arcs": [[[0, 1]], [[2, -1]]]}}}"#;
/// let found = audit(&read(&mut text.as_bytes(), None, 100)?, 100);
/// assert!(found.is_valid(), "{found}");
/// assert_eq!((found.counts().nodes, found.counts().edges, found.counts().faces), (2, 3, 2));
///
/// // Both on the same side of the arc between them.
/// let found = audit(&read(&mut text.replace("-1", "0").as_bytes(), None, 100)?, 100);
/// assert_eq!(found.violations()[0].kind, "not_joined");
/// # Ok::<_, ReadError>(())
/// ```
#[must_use]
pub fn audit(topology: &ArcTopology, limit: usize) -> TopologyAudit {
    let findings = &topology.findings;
    let is_joined = findings.counts[1] == 0;
    let parts = if is_joined { Parts::ALL } else { Parts::ALL.without(Part::Faces) };
    // The area that no polygon covers is open.
    let report = validate_embedding(&Only::new(topology, parts), &Expectation::plane().open(), Collect::AtMost(limit));
    let arcs = topology.ends.len() as u64;
    let checked = [arcs, topology.indices, 2 * arcs, arcs];
    let mut rules: Vec<TopologyRule> = RULES
        .iter()
        .enumerate()
        .map(|(i, (id, name, unit))| TopologyRule {
            id,
            name,
            checked: checked[i],
            unit,
            violations: findings.counts[i],
            unchecked: None,
        })
        .collect();
    rules.extend(report.outcomes().map(|(rule, outcome)| {
        let mut found = TopologyRule::of(rule, &outcome);
        if !is_joined && matches!(outcome.unchecked, Some(Unchecked::Lacks(_))) {
            found.unchecked = Some("needs A1, which is broken".to_owned());
        }
        found
    }));
    let mut violations = findings.kept.clone();
    violations.extend(report.violations().iter().map(|violation| TopologyViolation {
        rule: violation.rule().id(),
        kind: violation.kind(),
        message: violation.named(|record| topology.name(record)).to_string(),
        at: places(topology, violation).into_iter().map(Into::into).collect(),
        records: violation.records().into_iter().flatten().map(|record| topology.name(record)).collect(),
        lines: Vec::new(),
        cause: violation.cause(),
        remedy: violation.remedy(),
    }));
    violations.sort_by_key(|one| rules.iter().position(|rule| rule.id == one.rule));
    violations.truncate(limit);
    let counts = TopologyCounts {
        nodes: topology.points.len(),
        isolated_nodes: 0,
        edges: topology.ends.iter().filter(|ends| ends[0] != super::topology::NIL).count(),
        faces: topology.names.len(),
        components: report.counts().components,
        bends: topology.bends.len(),
        repeated_points: topology.repeated_points,
    };
    // Without joined arcs, rules of faces are left out that apply.
    let unchecked = if is_joined {
        not_checked(&report)
    } else {
        report.outcomes().filter(|(_, one)| one.unchecked.is_some()).count()
    };
    TopologyAudit { valid: report.is_valid() && findings.counts == [0; 4], counts, rules, violations, unchecked }
}
