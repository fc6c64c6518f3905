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

use crate::validate::columns::column;
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
    let mut used = column(run.vertices, false)?;
    for h in (0..run.half_edges).filter(|h| run.live_half_edge(*h)) {
        if let Some(used) = used.get_mut(run.origin(h) as usize) {
            *used = true;
        }
    }
    for (vertex, used) in used.into_iter().enumerate() {
        if !used && run.view.is_vertex(vertex) {
            run.findings.add(Violation::UnusedVertex { vertex })?;
        }
    }
    Ok(())
}
