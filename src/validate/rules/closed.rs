//! M4 closed: every half-edge has a twin and bounds a face.
//!
//! ```text
//!   ·───►───·
//!   │  f   ╱     the half-edge of f has no twin, or its twin bounds no face
//!   │    ╱
//!   ·──·
//! ```
//!
//! Checked if asked for.

use crate::validate::expectation::Part;
use crate::validate::findings::Flow;
use crate::validate::record::Field;
use crate::validate::rule::Rule;
use crate::validate::run::Run;
use crate::validate::view::View;
use crate::validate::violation::Violation;

/// Runs M4, which needs live links.
pub(in crate::validate) fn check<V: View + ?Sized>(run: &mut Run<'_, V>) -> Flow {
    let broken = if run.map_is_live { None } else { Some(Rule::R1) };
    if run.passes_over(Rule::M4, broken) {
        return Ok(());
    }
    run.findings.checked(Rule::M4, run.counts.half_edges as u64);
    // R1 has shown that nothing is missing.
    if !run.expect.is_open() {
        return Ok(());
    }
    let face = if run.expect.has(Part::BoundaryComponents) { Field::Boundary } else { Field::Face };
    for h in 0..run.half_edges {
        let half_edge = h as usize;
        if !run.live_half_edge(h) {
            continue;
        }
        let lacks = if run.view.twin(half_edge).is_none() {
            Field::Twin
        } else if run.lacks_face(half_edge) {
            face
        } else {
            continue;
        };
        let vertices = [run.origin(h) as usize, run.target(h) as usize];
        run.findings.add(Violation::OnBorder { half_edge, vertices, lacks })?;
    }
    Ok(())
}
