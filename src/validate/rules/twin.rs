//! L1 twin: `twin(twin(h)) = h` and `twin(h) ≠ h`.
//!
//! ```text
//!        h
//!   ·────────►·
//!   ·◄────────·
//!     twin(h)
//! ```

use crate::validate::columns::NIL;
use crate::validate::findings::Flow;
use crate::validate::rule::Rule;
use crate::validate::run::Run;
use crate::validate::view::View;
use crate::validate::violation::Violation;

/// Checks one half-edge and its twin. Where not every link is live, what dangles is left to R1.
#[inline]
pub(in crate::validate) fn check<V: View + ?Sized>(run: &mut Run<'_, V>, h: u32, t: u32, all_live: bool) -> Flow {
    if t == h {
        return run.findings.add_in_pass(Violation::TwinIsSelf { half_edge: h as usize }, Rule::L1);
    }
    let back = run.twin(t);
    let found = if back == NIL {
        // At an open boundary nil is a legal link, but not for a half-edge that is named as a twin.
        if run.view.twin(t as usize).is_some() || !run.expect.is_open() {
            return Ok(());
        }
        None
    } else if back == h || !(all_live || run.live_half_edge(back)) {
        return Ok(());
    } else {
        Some(back as usize)
    };
    run.findings.add_in_pass(Violation::TwinNotMutual { half_edge: h as usize, twin: t as usize, found }, Rule::L1)
}
