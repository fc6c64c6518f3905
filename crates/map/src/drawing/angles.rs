//! G2 angles: half-edges around a vertex are in angular order.
//!
//! In one clockwise turn around a vertex, the angle rises exactly once. An edge with bends has the direction to its nearest bend.

use crate::drawing::columns::Columns;
use crate::numbers::NIL;
use core::cmp::Ordering;
use twinedge::validate::{Findings, Flow, Rule, Violation};
use twinedge_geometry::predicates::compare_angle;

/// Runs G2.
pub(crate) fn check(findings: &mut Findings, columns: &Columns) -> Flow {
    let mut seen = vec![false; columns.points.len()];
    let mut checked = 0;
    // A walk ends at an open boundary, so it begins at the half-edge that follows that border.
    let borders = columns.half_edges().filter(|h| columns.twin[*h] == NIL).map(|h| columns.next(h));
    for first in borders.chain(columns.half_edges()) {
        let v = columns.origin(first);
        if std::mem::replace(&mut seen[v], true) {
            continue;
        }
        checked += 1;
        let center = columns.points[v];
        let mut rises = 0;
        let mut h = first;
        while let Some(after) = columns.clockwise(h) {
            if compare_angle(center, columns.towards(h), columns.towards(after)) == Ordering::Less {
                rises += 1;
                if rises > 1 {
                    findings.add(Violation::OutOfOrder { vertex: v, half_edge: h, found: after })?;
                    break;
                }
            }
            h = after;
            if h == first {
                break;
            }
        }
    }
    findings.checked(Rule::G2, checked);
    Ok(())
}
