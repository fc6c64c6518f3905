//! L3 target: `origin(next(h)) = origin(twin(h))`.
//!
//! ```text
//!        h          next(h)
//!   ·──────────►v────────────►·     both start at v, the target of h
//!   ·◄──────────v
//!      twin(h)
//! ```

use crate::validate::columns::NIL;
use crate::validate::findings::{Flow, Halt};
use crate::validate::rule::Rule;
use crate::validate::run::Run;
use crate::validate::view::View;
use crate::validate::violation::Violation;

/// Checks one half-edge with its twin and its next, and returns whether both have a live origin.
#[inline]
pub(in crate::validate) fn check<V: View + ?Sized>(
    run: &mut Run<'_, V>,
    h: u32,
    [t, n]: [u32; 2],
    all_live: bool,
) -> Result<bool, Halt> {
    let (target, found) = (run.origin(t), run.origin(n));
    if target == NIL || found == NIL || !(all_live || run.live_vertex(target) && run.live_vertex(found)) {
        return Ok(false);
    }
    if target != found {
        mismatch(run, h, n, target, found)?;
    }
    Ok(true)
}

#[cold]
fn mismatch<V: View + ?Sized>(run: &mut Run<'_, V>, h: u32, n: u32, target: u32, found: u32) -> Flow {
    let [half_edge, next, target, found] = [h, n, target, found].map(|i| i as usize);
    run.findings.add_in_pass(Violation::Target { half_edge, next, target, found }, Rule::L1)
}
