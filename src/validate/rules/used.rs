//! M1 used: some half-edge leaves every vertex.
//!
//! ```text
//!   ·──────·
//!   │    ╱ │    ·v    no half-edge leaves v
//!   │  ╱   │
//!   ·──────·
//! ```
//!
//! Checked if asked for.

use crate::validate::findings::Flow;
use crate::validate::rule::Rule;
use crate::validate::run::Run;
use crate::validate::view::View;
use crate::validate::violation::Violation;

/// Runs M1, which needs live origins.
pub(in crate::validate) fn check<V: View + ?Sized>(run: &mut Run<'_, V>) -> Flow {
    let broken = if run.map_is_live { None } else { Some(Rule::R1) };
    if run.passes_over(Rule::M1, broken) {
        return Ok(());
    }
    run.findings.checked(Rule::M1, run.counts.vertices as u64);
    if run.counts.isolated_vertices == 0 {
        return Ok(());
    }
    for vertex in 0..run.vertices as usize {
        // The fast path counts no fans: there `leaving` is known to be right.
        let leaves = |v| run.fans.get(v).map_or_else(|| run.view.leaving(v).is_some(), |fan| fan.degree > 0);
        if run.view.is_vertex(vertex) && !leaves(vertex) {
            run.findings.add(Violation::UnusedVertex { vertex })?;
        }
    }
    Ok(())
}
