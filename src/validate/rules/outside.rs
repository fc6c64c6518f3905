//! T1 outside: each component has exactly one inner boundary component, its outside.

use super::containment_unchecked;
use crate::validate::columns::{Components, NIL, column};
use crate::validate::findings::{Findings, Halt};
use crate::validate::report::{Record, Violation};
use crate::validate::rule::Rule;
use crate::validate::structure::{Part, Start};
use crate::validate::subject::Subject;
use alloc::vec::Vec;

/// Runs T1, unless it is `known` already in which face each component lies. Returns that: nil for a component that lies in none.
pub(crate) fn check(
    subject: Subject<'_>,
    components: &Components,
    known: Option<Vec<u32>>,
    list_budget: usize,
    findings: &mut Findings,
) -> Result<Vec<u32>, Halt> {
    if let Some(why) = containment_unchecked(subject, findings) {
        findings.not_checked(Rule::T1, why);
        return Ok(Vec::new());
    }
    let count = components.all.len();
    if let Some(known) = known {
        findings.checked(Rule::T1, count as u64);
        return Ok(known);
    }
    let mut lies_in = column(count as u32, NIL)?;
    let mut outside: Vec<Option<Record>> = column(count as u32, None)?;
    let mut budget = list_budget;
    for f in subject.faces() {
        let listed = subject.view.inner_count(f).min(budget);
        budget -= listed;
        for i in 0..listed {
            let (start, record) = inner(subject, f, i);
            let (Some(c), Some(second)) = (subject.component_of_start(components, start), record) else { continue };
            if let Some(first) = outside[c] {
                let vertex = components.all[c].vertex as usize;
                findings.add(Violation::TwoOutsides { vertex, first, second })?;
            } else {
                (outside[c], lies_in[c]) = (record, f as u32);
            }
        }
    }
    findings.checked(Rule::T1, count as u64);
    // A component in the unbounded face has no inner boundary component if that face has no record.
    if subject.has(Part::UnboundedFace) {
        for (component, outside) in components.all.iter().zip(&outside) {
            if outside.is_none() && !component.open {
                findings.add(Violation::NoOutside { vertex: component.vertex as usize })?;
            }
        }
    }
    Ok(lies_in)
}

/// Returns the start of the inner boundary component at this position, and the record by which a report names it.
fn inner(subject: Subject<'_>, f: usize, i: usize) -> (Option<Start>, Option<Record>) {
    if subject.has(Part::BoundaryComponents) {
        let b = subject.extent.boundaries.existing(subject.view.inner(f, i));
        return (b.and_then(|b| subject.view.boundary_start(b)), b.map(Record::Boundary));
    }
    let start = subject.view.inner_start(f, i);
    let record = start.map(|start| match start {
        Start::HalfEdge(h) => Record::HalfEdge(h),
        Start::Vertex(v) => Record::Vertex(v),
    });
    (start, record)
}
