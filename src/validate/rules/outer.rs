//! F1 outer: a bounded face has exactly one outer boundary component, a cycle; the one unbounded face has none.

use crate::validate::fast_path::Facts;
use crate::validate::findings::{Findings, Flow};
use crate::validate::report::{Unchecked, Violation};
use crate::validate::rule::Rule;
use crate::validate::structure::{Part, Start};
use crate::validate::subject::Subject;

/// Runs F1, and counts the outer boundary components.
pub(crate) fn check(subject: Subject<'_>, facts: &Facts, findings: &mut Findings) -> Flow {
    if !subject.has(Part::Faces) {
        findings.not_checked(Rule::F1, Unchecked::Lacks(Part::Faces));
        return Ok(());
    }
    if let Some(lists) = facts.lists {
        findings.counts.outer_boundaries = lists.outer;
        findings.checked(Rule::F1, lists.faces as u64);
        return Ok(());
    }
    let has_unbounded = subject.has(Part::UnboundedFace);
    let (mut unbounded, mut checked) = (None, 0);
    for face in subject.faces() {
        checked += 1;
        match (subject.outer(face), unbounded) {
            (None, _) if !has_unbounded => findings.add(Violation::NoOuter { face })?,
            (None, None) => unbounded = Some(face),
            (None, Some(first)) => findings.add(Violation::SecondUnboundedFace { first, second: face })?,
            (Some(outer), _) => {
                findings.counts.outer_boundaries += 1;
                let boundary = subject.live_boundary(Some(outer));
                let start = boundary.and_then(|b| subject.view.boundary_start(b));
                if let (Some(boundary), Some(Start::Vertex(_))) = (boundary, start) {
                    findings.add(Violation::OuterIsVertex { face, boundary })?;
                }
            }
        }
    }
    findings.checked(Rule::F1, checked);
    if unbounded.is_none() && has_unbounded {
        findings.add(Violation::NoUnboundedFace)?;
    }
    Ok(())
}
