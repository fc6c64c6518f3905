//! M4 closed: every half-edge has a twin and bounds a face.
//!
//! Checked if asked for.

use super::live::Census;
use super::passes_over;
use crate::validate::findings::{Findings, Flow};
use crate::validate::report::{Field, Violation};
use crate::validate::rule::Rule;
use crate::validate::structure::Part;
use crate::validate::subject::Subject;

/// Runs M4, which needs live links.
pub(crate) fn check(subject: Subject<'_>, census: &Census, findings: &mut Findings) -> Flow {
    if passes_over(subject, Rule::M4, census.links_broken(), findings) {
        return Ok(());
    }
    findings.checked(Rule::M4, census.half_edges as u64);
    // R1 has shown that nothing is missing.
    if !subject.is_open() {
        return Ok(());
    }
    let face = if subject.has(Part::BoundaryComponents) { Field::Boundary } else { Field::Face };
    for h in subject.half_edges() {
        let half_edge = h as usize;
        let lacks = if subject.view.twin(half_edge).is_none() {
            Field::Twin
        } else if subject.lacks_face(half_edge) {
            face
        } else {
            continue;
        };
        let vertices = [subject.origin(h), subject.target(h)].map(|v| v as usize);
        findings.add(Violation::OnBorder { half_edge, vertices, lacks })?;
    }
    Ok(())
}
