//! G1 finite: coordinates are finite, and no edge has zero length.
//!
//! A coordinate also breaks the rule if the predicates are not exact for it. Segments between bends must have a length.

use crate::drawing::columns::Columns;
use twinedge::validate::{Findings, Flow, Rule, Violation};
use twinedge_geometry::predicates::in_range;

/// Runs G1.
pub(crate) fn check(findings: &mut Findings, columns: &Columns) -> Flow {
    let mut checked = 0;
    for v in columns.vertices() {
        checked += 1;
        if !in_range(columns.points[v]) {
            findings.add(Violation::NotFinite { vertex: v })?;
        }
    }
    findings.checked(Rule::G1, checked);
    let bends = &columns.bends;
    for place in (0..bends.points.len()).filter(|place| !in_range(bends.points[*place])) {
        let (half_edge, bend) = bends.owner(place);
        findings.add(Violation::BendNotFinite { half_edge, bend })?;
    }
    for half_edge in columns.half_edges().filter(|h| columns.is_asked(*h)) {
        if bends.range(half_edge).is_empty() {
            if columns.tail(half_edge) == columns.head(half_edge) {
                findings.add(Violation::ZeroLength { half_edge })?;
            }
            continue;
        }
        let mut from = columns.tail(half_edge);
        for (segment, to) in columns.line(half_edge).enumerate() {
            if std::mem::replace(&mut from, to) == to {
                findings.add(Violation::SegmentZeroLength { half_edge, segment })?;
            }
        }
    }
    Ok(())
}
