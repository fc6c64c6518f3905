//! F1 outer: a bounded face has exactly one outer boundary component, a cycle; the one unbounded face has none.
//!
//! ```text
//!   face 2 ── outer ──► component 5, a cycle
//!   face 0 ── outer ──► nil: the unbounded face, and no other
//! ```

use crate::validate::expectation::Part;
use crate::validate::findings::Flow;
use crate::validate::report::Unchecked;
use crate::validate::rule::Rule;
use crate::validate::run::Run;
use crate::validate::view::{Link, Start, View};
use crate::validate::violation::Violation;

/// Runs F1, and counts the outer boundary components.
pub(in crate::validate) fn check<V: View + ?Sized>(run: &mut Run<'_, V>) -> Flow {
    if !run.expect.has(Part::Faces) {
        run.findings.not_checked(Rule::F1, Unchecked::Lacks(Part::Faces));
        return Ok(());
    }
    if let Some(lists) = run.known.lists {
        run.counts.outer_boundaries = lists.outer;
        run.findings.checked(Rule::F1, lists.faces as u64);
        return Ok(());
    }
    let mut unbounded = None;
    let mut checked = 0;
    for f in 0..run.faces as usize {
        if !run.view.is_face(f) {
            continue;
        }
        checked += 1;
        match outer_link(run, f) {
            None if !run.expect.has(Part::UnboundedFace) => run.findings.add(Violation::NoOuter { face: f })?,
            None => match unbounded {
                None => unbounded = Some(f),
                Some(first) => run.findings.add(Violation::SecondUnboundedFace { first, second: f })?,
            },
            Some(b) => {
                run.counts.outer_boundaries += 1;
                if run.expect.has(Part::BoundaryComponents)
                    && b < run.boundaries as usize
                    && run.view.is_boundary(b)
                    && matches!(run.view.boundary_start(b), Some(Start::Vertex(_)))
                {
                    run.findings.add(Violation::OuterIsVertex { face: f, boundary: b })?;
                }
            }
        }
    }
    run.findings.checked(Rule::F1, checked);
    if unbounded.is_none() && run.expect.has(Part::UnboundedFace) {
        run.findings.add(Violation::NoUnboundedFace)?;
    }
    Ok(())
}

/// The outer boundary component, or half-edge, that the face names.
fn outer_link<V: View + ?Sized>(run: &Run<'_, V>, f: usize) -> Link {
    if run.expect.has(Part::BoundaryComponents) { run.view.outer(f) } else { run.view.outer_half_edge(f) }
}
