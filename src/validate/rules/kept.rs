//! M8 kept: a vertex that some half-edge without twin or face leaves keeps such a one.
//!
//! ```text
//!     f  ╱
//!      ╱      a half-edge from v without face or twin: v keeps such a one,
//!   ──v───    not one of those that bound f
//! ```
//!
//! Checked if asked for.

use crate::validate::columns::{NIL, column};
use crate::validate::expectation::Part;
use crate::validate::findings::Flow;
use crate::validate::report::Unchecked;
use crate::validate::rule::Rule;
use crate::validate::run::Run;
use crate::validate::view::View;
use crate::validate::violation::Violation;

/// Runs M8, which needs live links, and vertices that keep half-edges of their own.
pub(in crate::validate) fn check<V: View + ?Sized>(run: &mut Run<'_, V>) -> Flow {
    let links = if run.map_is_live { None } else { Some(Rule::R1) };
    let broken = links.or_else(|| run.findings.broken(&[Rule::V1]));
    if run.passes_over(Rule::M8, broken) {
        return Ok(());
    }
    if !run.expect.has(Part::Leaving) {
        run.findings.not_checked(Rule::M8, Unchecked::Lacks(Part::Leaving));
        return Ok(());
    }
    run.findings.checked(Rule::M8, run.counts.vertices as u64);
    // R1 has shown that nothing is missing.
    if !run.expect.is_open() {
        return Ok(());
    }
    // Per vertex a half-edge of the border that leaves it.
    let mut border = column(run.vertices, NIL)?;
    for h in (0..run.half_edges).filter(|h| run.live_half_edge(*h)) {
        if on_border(run, h as usize) {
            if let Some(border) = border.get_mut(run.origin(h) as usize) {
                *border = h.min(*border);
            }
        }
    }
    for (vertex, border) in border.into_iter().enumerate() {
        if border == NIL || !run.view.is_vertex(vertex) {
            continue;
        }
        let Some(half_edge) = run.view.leaving(vertex).filter(|h| *h < run.half_edges as usize) else { continue };
        if !on_border(run, half_edge) {
            run.findings.add(Violation::KeptInside { vertex, half_edge, border: border as usize })?;
        }
    }
    Ok(())
}

fn on_border<V: View + ?Sized>(run: &Run<'_, V>, half_edge: usize) -> bool {
    run.view.twin(half_edge).is_none() || run.lacks_face(half_edge)
}
