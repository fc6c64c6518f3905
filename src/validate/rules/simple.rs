//! M2 simple: no edge is a loop, and no two edges join the same vertices.
//!
//! Checked if asked for. The edges are sorted by their smaller end, so that those with the same ends are found in linear time.

use super::live::Census;
use super::passes_over;
use crate::validate::columns::{NIL, column};
use crate::validate::findings::{Findings, Flow};
use crate::validate::report::Violation;
use crate::validate::rule::Rule;
use crate::validate::subject::Subject;

/// Runs M2, unless the walks around the vertices have found that there are neither loops nor parallel edges. Of several edges that
/// join the same vertices, each but the first is reported, together with the first.
pub(crate) fn check(subject: Subject<'_>, census: &Census, is_simple: bool, findings: &mut Findings) -> Flow {
    if passes_over(subject, Rule::M2, census.map_broken(findings), findings) {
        return Ok(());
    }
    findings.checked(Rule::M2, census.edges as u64);
    if is_simple {
        return Ok(());
    }
    let (vertices, half_edges) = (subject.extent.vertices.0, subject.extent.half_edges.0);
    // For each vertex the first edge of which it is the smaller end, and for each half-edge that stands for its edge the next one.
    let mut first = column(vertices, NIL)?;
    let mut next = column(half_edges, NIL)?;
    for h in (0..half_edges).rev().filter(|h| subject.is_live_half_edge(*h)) {
        let twin = subject.twin(h);
        let [smaller, _] = subject.ends(h);
        if twin == NIL || h < twin {
            if let Some(first) = first.get_mut(smaller as usize) {
                next[h as usize] = core::mem::replace(first, h);
            }
        }
    }
    // For each vertex the last edge that was seen to lead there.
    let mut seen = column(vertices, NIL)?;
    for v in 0..vertices {
        let mut h = first[v as usize];
        while h != NIL {
            let (half_edge, [smaller, larger]) = (h as usize, subject.ends(h));
            h = next[half_edge];
            if smaller == larger {
                findings.add(Violation::LoopEdge { half_edge, vertex: v as usize })?;
                continue;
            }
            let Some(last) = seen.get_mut(larger as usize) else { continue };
            if *last != NIL && subject.ends(*last) == [v, larger] {
                let (first, vertices) = (*last as usize, [v as usize, larger as usize]);
                findings.add(Violation::ParallelEdges { first, second: half_edge, vertices })?;
            } else {
                *last = half_edge as u32;
            }
        }
    }
    Ok(())
}
