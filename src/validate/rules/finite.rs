//! G1 finite: coordinates are finite, and no edge has zero length.
//!
//! A coordinate is also refused if it is out of the range in which the predicates are exact.

use crate::geometry::predicates::in_range;
use crate::validate::findings::{Findings, Flow};
use crate::validate::geometric::columns::Columns;
use crate::validate::rule::Rule;
use crate::validate::violation::Violation;

/// Runs G1.
pub(in crate::validate) fn check(findings: &mut Findings, columns: &Columns) -> Flow {
    let mut checked = 0;
    for v in columns.vertices() {
        checked += 1;
        if !in_range(columns.points[v]) {
            findings.add(Violation::NotFinite { vertex: v })?;
        }
    }
    findings.checked(Rule::G1, checked);
    for h in columns.half_edges() {
        // Nil is larger than any half-edge.
        if (h as u32) < columns.twin[h] && columns.tail(h) == columns.head(h) {
            findings.add(Violation::ZeroLength { half_edge: h })?;
        }
    }
    Ok(())
}
