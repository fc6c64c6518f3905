//! M8 kept: if a half-edge without twin or face leaves a vertex, the half-edge kept by that vertex lacks a twin or a face.
//!
//! Checked if asked for.

use super::live::Census;
use super::passes_over;
use crate::validate::columns::{NIL, column};
use crate::validate::findings::{Findings, Flow};
use crate::validate::report::{Unchecked, Violation};
use crate::validate::rule::Rule;
use crate::validate::structure::Part;
use crate::validate::subject::Subject;

/// Runs M8, which needs live links and V1.
pub(crate) fn check(subject: Subject<'_>, census: &Census, findings: &mut Findings) -> Flow {
    let broken = census.links_broken().or_else(|| findings.broken(&[Rule::V1]));
    if passes_over(subject, Rule::M8, broken, findings) {
        return Ok(());
    }
    if !subject.has(Part::Leaving) {
        findings.not_checked(Rule::M8, Unchecked::Lacks(Part::Leaving));
        return Ok(());
    }
    findings.checked(Rule::M8, census.vertices as u64);
    // R1 has shown that nothing is missing.
    if !subject.is_open() {
        return Ok(());
    }
    let is_on_border = |h: usize| subject.view.twin(h).is_none() || subject.lacks_face(h);
    // For each vertex the first half-edge of the border that leaves it.
    let mut border = column(subject.extent.vertices.0, NIL)?;
    for h in subject.half_edges().filter(|h| is_on_border(*h as usize)) {
        if let Some(border) = border.get_mut(subject.origin(h) as usize) {
            *border = h.min(*border);
        }
    }
    for vertex in subject.vertices().filter(|v| border[*v] != NIL) {
        let Some(half_edge) = subject.extent.half_edges.existing(subject.view.leaving(vertex)) else { continue };
        if !is_on_border(half_edge) {
            findings.add(Violation::KeptInside { vertex, half_edge, border: border[vertex] as usize })?;
        }
    }
    Ok(())
}
