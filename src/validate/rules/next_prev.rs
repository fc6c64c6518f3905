//! L2 next/prev: `prev(next(h)) = h` and `next(prev(h)) = h`.
//!
//! ```text
//!     prev(h)        h         next(h)
//!   ·─────────►·──────────►·───────────►·
//! ```
//!
//! Without `prev` it says that `next` is a permutation: no two half-edges have the same next.

use crate::validate::columns::NIL;
use crate::validate::findings::Flow;
use crate::validate::rule::Rule;
use crate::validate::run::Run;
use crate::validate::view::View;
use crate::validate::violation::Violation;

/// Checks `prev(next(h)) = h`. Where not every link is live, what dangles is left to R1.
#[inline]
pub(in crate::validate) fn check_next<V: View + ?Sized>(run: &mut Run<'_, V>, h: u32, n: u32, all_live: bool) -> Flow {
    let back = run.prev(n);
    if back == h || back == NIL || !(all_live || run.live_half_edge(back)) {
        return Ok(());
    }
    let (half_edge, next, found) = (h as usize, n as usize, back as usize);
    run.findings.add_in_pass(Violation::PrevOfNext { half_edge, next, found }, Rule::L1)
}

/// Checks `next(prev(h)) = h`.
#[inline]
pub(in crate::validate) fn check_prev<V: View + ?Sized>(run: &mut Run<'_, V>, h: u32, p: u32, all_live: bool) -> Flow {
    let back = run.next(p);
    if back == h || back == NIL || !(all_live || run.live_half_edge(back)) {
        return Ok(());
    }
    let (half_edge, prev, found) = (h as usize, p as usize, back as usize);
    run.findings.add_in_pass(Violation::NextOfPrev { half_edge, prev, found }, Rule::L1)
}

/// Checks, without `prev`, that no half-edge before `h` has the same next, and notes that `h` precedes it.
#[inline]
pub(in crate::validate) fn check_distinct<V: View + ?Sized>(run: &mut Run<'_, V>, h: u32, n: u32) -> Flow {
    let first = core::mem::replace(&mut run.derived_prev[n as usize], h);
    if first == NIL {
        return Ok(());
    }
    let violation = Violation::NextShared { first: first as usize, second: h as usize, next: n as usize };
    run.findings.add_in_pass(violation, Rule::L1)
}
