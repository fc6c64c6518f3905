//! L2 next/prev: `prev(next(h)) = h` and `next(prev(h)) = h`.
//!
//! Without `prev` it says that `next` is a permutation: no two half-edges have the same next.

use crate::validate::columns::NIL;
use crate::validate::findings::{Flow, Pass};
use crate::validate::report::Violation;
use crate::validate::subject::Subject;

/// Checks `prev(next(h)) = h`. Where not every link is live, what dangles is left to R1.
pub(crate) fn check_next(subject: Subject<'_>, [h, n]: [u32; 2], all_live: bool, pass: &mut Pass<'_>) -> Flow {
    let back = subject.prev(n);
    if back == h || back == NIL || !(all_live || subject.is_live_half_edge(back)) {
        return Ok(());
    }
    pass.add(Violation::PrevOfNext { half_edge: h as usize, next: n as usize, found: back as usize })
}

/// Checks `next(prev(h)) = h`.
pub(crate) fn check_prev(subject: Subject<'_>, [h, p]: [u32; 2], all_live: bool, pass: &mut Pass<'_>) -> Flow {
    let back = subject.next(p);
    if back == h || back == NIL || !(all_live || subject.is_live_half_edge(back)) {
        return Ok(());
    }
    pass.add(Violation::NextOfPrev { half_edge: h as usize, prev: p as usize, found: back as usize })
}

/// Checks, without `prev`, that no half-edge before `h` has the same next, and notes that `h` precedes it.
pub(crate) fn check_distinct([h, n]: [u32; 2], before: &mut [u32], pass: &mut Pass<'_>) -> Flow {
    let first = core::mem::replace(&mut before[n as usize], h);
    if first == NIL {
        return Ok(());
    }
    pass.add(Violation::NextShared { first: first as usize, second: h as usize, next: n as usize })
}
