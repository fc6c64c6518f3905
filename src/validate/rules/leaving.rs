//! V1 leaving: the half-edge kept by a vertex leaves that vertex.

use crate::validate::fast_path::Facts;
use crate::validate::findings::{Findings, Flow};
use crate::validate::report::{Unchecked, Violation};
use crate::validate::rule::Rule;
use crate::validate::structure::Part;
use crate::validate::subject::Subject;

/// Runs V1.
pub(crate) fn check(subject: Subject<'_>, facts: &Facts, findings: &mut Findings) -> Flow {
    if !subject.has(Part::Leaving) {
        findings.not_checked(Rule::V1, Unchecked::Lacks(Part::Leaving));
        return Ok(());
    }
    if let Some(known) = facts.vertices {
        findings.checked(Rule::V1, (known.live - known.isolated) as u64);
        return Ok(());
    }
    let mut checked = 0;
    for vertex in subject.vertices() {
        let Some(half_edge) = subject.live_half_edge(subject.view.leaving(vertex)) else { continue };
        let origin = subject.origin(half_edge as u32);
        if !subject.is_live_vertex(origin) {
            continue;
        }
        checked += 1;
        let origin = origin as usize;
        if origin != vertex {
            findings.add(Violation::NotLeaving { vertex, half_edge, origin })?;
        }
    }
    findings.checked(Rule::V1, checked);
    Ok(())
}
