//! The audit of arcs: A0 … A3, and the validator's rules.

use super::finding::{RULES, placed};
use super::topology::ArcTopology;
use twinedge::validate::{Collect, Expectation, Only, Part, Parts, Unchecked};
use twinedge_diagnosis::{Diagnosis, Kind, Reason, RuleLine};
use twinedge_diagnosis::{TopologyAudit, TopologyCounts};
use twinedge_map::{places, validate_embedding};

/// Judges the arcs of a file and the polygons that they form. Up to `limit` violations are kept, in the order of the rules;
/// all are counted. The rules about faces need A1: if it is broken, they are reported as not checked.
///
/// O(n log n) for n positions, plus O(p) for p pairs of segments with overlapping boxes, if arcs clash.
///
/// ```
/// use twinedge_layers::ReadError;
/// use twinedge_layers::topojson::{audit, read};
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
/// assert_eq!(found.violations()[0].kind.name(), "not_joined");
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
    let own = RULES.into_iter().enumerate().map(|(i, [id, name, unit, statement])| {
        let violations = findings.counts[i];
        RuleLine { id, name, statement, checked: checked[i], unit, violations, unchecked: None, left_out: None }
    });
    let mut rules: Vec<RuleLine> = own.chain(RuleLine::of(&report)).collect();
    for rule in rules.iter_mut().filter(|_| !is_joined) {
        if matches!(rule.unchecked, Some(Reason::Validator(Unchecked::Lacks(_)))) {
            rule.unchecked = Some(Reason::Broken("A1"));
        }
    }
    let theirs = report.violations().iter().map(|violation| {
        let records = violation.records().into_iter().flatten().map(|record| topology.name(record));
        let diagnosis = Diagnosis {
            // The fields are the numbers of half-edges.
            kind: Kind::Named { kind: violation.kind() },
            message: violation.named(|record| topology.name(record)).message(),
            ..violation.into()
        };
        placed(diagnosis, records.collect(), places(topology, violation).into_iter().map(Into::into).collect())
    });
    let violations = findings.kept.iter().cloned().chain(theirs).collect();
    let counts = TopologyCounts {
        nodes: topology.points.len(),
        isolated_nodes: 0,
        edges: topology.ends.iter().filter(|ends| ends[0] != super::topology::NIL).count(),
        faces: topology.names.len(),
        components: report.counts().components,
        bends: topology.bends.len(),
        repeated_points: topology.repeated_points,
    };
    TopologyAudit::new(counts, rules, violations, limit)
}
