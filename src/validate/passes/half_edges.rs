//! One pass over the half-edges, for L1, L2 and L3: each link is read once for all three.

use crate::validate::columns::{NIL, column};
use crate::validate::expectation::Part;
use crate::validate::findings::Flow;
use crate::validate::report::Unchecked;
use crate::validate::rule::Rule;
use crate::validate::rules::{next_prev, target, twin};
use crate::validate::run::Run;
use crate::validate::view::View;

/// Runs L1, L2 and L3 on every half-edge whose links are live.
pub(in crate::validate) fn check<V: View + ?Sized>(run: &mut Run<'_, V>) -> Flow {
    let with_prev = run.expect.has(Part::Prev);
    if !with_prev {
        // Without `prev` the walks around the vertices settle L2; otherwise each half-edge may share its next with any other.
        if !run.known.rotations_hold() {
            run.known.half_edges = None;
        }
        if run.known.half_edges.is_none() {
            run.derived_prev = column(run.half_edges, NIL)?;
        }
    }
    // Where R1 found every link live, a slot in range is live.
    let all_live = run.map_is_live;
    let settled = run.beyond_doubt() as u64;
    let [mut twins, mut nexts, mut targets] = [settled; 3];
    if let Some(doubts) = &run.known.half_edges {
        let unpaired = doubts.half_edges.iter().filter(|h| run.view.twin(**h as usize).is_none()).count();
        let settled_without_twin = doubts.unpaired.saturating_sub(unpaired) as u64;
        twins -= settled_without_twin.min(settled);
        targets -= settled_without_twin.min(settled);
    }
    for i in 0..run.in_doubt() {
        let Some(h) = run.doubtful(i) else { continue };
        let twin = Some(run.twin(h)).filter(|t| *t != NIL && (all_live || run.live_half_edge(*t)));
        let next = Some(run.next(h)).filter(|n| *n != NIL && (all_live || run.live_half_edge(*n)));
        if let Some(t) = twin {
            twins += 1;
            twin::check(run, h, t, all_live)?;
        }
        if let Some(n) = next {
            nexts += 1;
            if with_prev {
                next_prev::check_next(run, h, n, all_live)?;
            } else if !run.derived_prev.is_empty() {
                next_prev::check_distinct(run, h, n)?;
            }
        }
        if with_prev {
            let p = run.prev(h);
            if p != NIL && (all_live || run.live_half_edge(p)) {
                next_prev::check_prev(run, h, p, all_live)?;
            }
        }
        if let (Some(t), Some(n)) = (twin, next) {
            targets += u64::from(target::check(run, h, [t, n], all_live)?);
        }
    }
    for (rule, checked) in [(Rule::L1, twins), (Rule::L2, nexts), (Rule::L3, targets)] {
        run.findings.checked(rule, checked);
        if !all_live {
            run.findings.not_checked(rule, Unchecked::Broken(Rule::R1));
        }
    }
    run.findings.end_pass()
}
