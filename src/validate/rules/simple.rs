//! M2 simple: no edge is a loop, and no two edges join the same vertices.
//!
//! ```text
//!              e
//!   ┌───┐    ┌───┐
//!   │   v    u   v    the loop starts and ends at v; e and f both join u and v
//!   └───┘    └───┘
//!              f
//! ```
//!
//! Checked if asked for. The edges are sorted by their smaller end, so that those with the same ends are found in linear time.

use crate::validate::columns::{Components, NIL, column};
use crate::validate::findings::Flow;
use crate::validate::rule::Rule;
use crate::validate::run::Run;
use crate::validate::view::View;
use crate::validate::violation::Violation;

/// Runs M2. Of several edges that join the same vertices, each but the first is reported, together with the first.
pub(in crate::validate) fn check<V: View + ?Sized>(run: &mut Run<'_, V>, components: Option<&Components>) -> Flow {
    if run.passes_over(Rule::M2, run.map_broken()) {
        return Ok(());
    }
    run.findings.checked(Rule::M2, run.counts.edges as u64);
    // The walks around the vertices have noticed whether there are any.
    if components.is_some_and(|components| components.simple) {
        return Ok(());
    }
    // Per vertex the first edge of which it is the smaller end, and per half-edge that stands for its edge the next one.
    let mut first = column(run.vertices, NIL)?;
    let mut next = column(run.half_edges, NIL)?;
    for h in (0..run.half_edges).rev().filter(|h| run.live_half_edge(*h)) {
        let twin = run.twin(h);
        let [smaller, _] = run.ends(h);
        if twin == NIL || h < twin {
            if let Some(first) = first.get_mut(smaller as usize) {
                next[h as usize] = core::mem::replace(first, h);
            }
        }
    }
    // Per vertex the last edge that was seen to lead there.
    let mut seen = column(run.vertices, NIL)?;
    for v in 0..run.vertices {
        let mut h = first[v as usize];
        while h != NIL {
            let (half_edge, [smaller, larger]) = (h as usize, run.ends(h));
            h = next[half_edge];
            if smaller == larger {
                run.findings.add(Violation::LoopEdge { half_edge, vertex: v as usize })?;
                continue;
            }
            let Some(last) = seen.get_mut(larger as usize) else { continue };
            if *last != NIL && run.ends(*last) == [v, larger] {
                let (first, vertices) = (*last as usize, [v as usize, larger as usize]);
                run.findings.add(Violation::ParallelEdges { first, second: half_edge, vertices })?;
            } else {
                *last = half_edge as u32;
            }
        }
    }
    Ok(())
}
