//! One pass over the half-edges, for L1, L2 and L3: each link is read once for all three.

use crate::validate::columns::{NIL, column};
use crate::validate::fast_path::Facts;
use crate::validate::findings::{Findings, Halt};
use crate::validate::report::Unchecked;
use crate::validate::rule::Rule;
use crate::validate::rules::live::Census;
use crate::validate::rules::{next_prev, target, twin};
use crate::validate::structure::Part;
use crate::validate::subject::Subject;
use alloc::vec::Vec;

/// The half-edges in doubt that L1 … L3 and B1 look at. None if they look at all: nothing is settled, or there is no `prev`, and
/// each half-edge may share its next with any other. (The walks around the vertices show that none does.)
fn in_doubt<'f>(subject: Subject<'_>, facts: &'f Facts) -> Option<&'f [u32]> {
    let is_settled = subject.has(Part::Prev) || facts.rotations_hold();
    facts.half_edges.as_ref().filter(|_| is_settled).map(|doubts| &doubts.half_edges[..])
}

/// The live half-edges that L1 … L3 and B1 look at, in order.
pub(crate) fn to_check<'f>(subject: Subject<'f>, facts: &'f Facts) -> impl Iterator<Item = u32> + 'f {
    let in_doubt = in_doubt(subject, facts);
    let all = if in_doubt.is_none() { subject.extent.half_edges.0 } else { 0 };
    let all = (0..all).chain(in_doubt.unwrap_or_default().iter().copied());
    all.filter(move |h| subject.is_live_half_edge(*h))
}

/// The number of live half-edges that they need not look at.
pub(crate) fn checked(subject: Subject<'_>, facts: &Facts) -> u64 {
    let live = facts.half_edges.as_ref().map_or(0, |doubts| doubts.live);
    in_doubt(subject, facts).map_or(0, |in_doubt| live.saturating_sub(in_doubt.len())) as u64
}

/// Runs L1, L2 and L3 on every half-edge whose links are live. Where there is no `prev` and nothing is settled, returns for each half-edge
/// the one before it.
pub(crate) fn check(
    subject: Subject<'_>,
    facts: &Facts,
    census: &Census,
    findings: &mut Findings,
) -> Result<Option<Vec<u32>>, Halt> {
    let has_prev = subject.has(Part::Prev);
    let mut before = Vec::new();
    if !has_prev && in_doubt(subject, facts).is_none() {
        before = column(subject.extent.half_edges.0, NIL)?;
    }
    // If R1 found every link live, a slot in range is live.
    let all_live = census.map_is_live;
    let [mut twins, mut nexts, mut targets] = [checked(subject, facts); 3];
    if let (Some(doubts), Some(in_doubt)) = (&facts.half_edges, in_doubt(subject, facts)) {
        let unpaired = in_doubt.iter().filter(|h| subject.view.twin(**h as usize).is_none()).count();
        let settled_without_twin = (doubts.unpaired.saturating_sub(unpaired) as u64).min(twins);
        twins -= settled_without_twin;
        targets -= settled_without_twin;
    }
    let live = |h: u32| (h != NIL && (all_live || subject.is_live_half_edge(h))).then_some(h);
    let mut pass = findings.pass(Rule::L1);
    for h in to_check(subject, facts) {
        let (twin, next) = (live(subject.twin(h)), live(subject.next(h)));
        if let Some(t) = twin {
            twins += 1;
            twin::check(subject, [h, t], all_live, &mut pass)?;
        }
        if let Some(n) = next {
            nexts += 1;
            if has_prev {
                next_prev::check_next(subject, [h, n], all_live, &mut pass)?;
            } else if !before.is_empty() {
                next_prev::check_distinct([h, n], &mut before, &mut pass)?;
            }
        }
        if let Some(p) = live(if has_prev { subject.prev(h) } else { NIL }) {
            next_prev::check_prev(subject, [h, p], all_live, &mut pass)?;
        }
        if let (Some(t), Some(n)) = (twin, next) {
            targets += u64::from(target::check(subject, h, [t, n], all_live, &mut pass)?);
        }
    }
    pass.end()?;
    for (rule, checked) in [(Rule::L1, twins), (Rule::L2, nexts), (Rule::L3, targets)] {
        findings.checked(rule, checked);
        if !all_live {
            findings.not_checked(rule, Unchecked::Broken(Rule::R1));
        }
    }
    Ok((!before.is_empty()).then_some(before))
}
