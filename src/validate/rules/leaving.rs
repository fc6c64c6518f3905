//! V1 leaving: the half-edge kept by a vertex leaves that vertex.
//!
//! ```text
//!   vertex 3 ── leaving ──► half-edge 8 ── origin ──► 3
//! ```

use crate::validate::expectation::Part;
use crate::validate::findings::Flow;
use crate::validate::report::Unchecked;
use crate::validate::rule::Rule;
use crate::validate::run::Run;
use crate::validate::view::View;
use crate::validate::violation::Violation;

/// Runs V1. What dangles is left to R1.
pub(in crate::validate) fn check<V: View + ?Sized>(run: &mut Run<'_, V>) -> Flow {
    if !run.expect.has(Part::Leaving) {
        run.findings.not_checked(Rule::V1, Unchecked::Lacks(Part::Leaving));
        return Ok(());
    }
    if let Some(known) = run.known.vertices {
        run.findings.checked(Rule::V1, (known.live - known.isolated) as u64);
        return Ok(());
    }
    let mut checked = 0;
    for v in 0..run.vertices {
        if !run.live_vertex(v) {
            continue;
        }
        let Some(h) = run.view.leaving(v as usize).filter(|h| *h < run.half_edges as usize) else {
            continue;
        };
        if !run.view.is_half_edge(h) {
            continue;
        }
        let origin = run.origin(h as u32);
        if !run.live_vertex(origin) {
            continue;
        }
        checked += 1;
        if origin != v {
            let (vertex, origin) = (v as usize, origin as usize);
            run.findings.add(Violation::NotLeaving { vertex, half_edge: h, origin })?;
        }
    }
    run.findings.checked(Rule::V1, checked);
    Ok(())
}
