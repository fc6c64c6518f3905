//! L1 twin: `twin(twin(h)) = h` and `twin(h) ≠ h`.

use crate::validate::columns::NIL;
use crate::validate::findings::{Flow, Pass};
use crate::validate::report::Violation;
use crate::validate::subject::Subject;

/// Checks one half-edge and its twin. Where not every link is live, what dangles is left to R1.
pub(crate) fn check(subject: Subject<'_>, [h, t]: [u32; 2], all_live: bool, pass: &mut Pass<'_>) -> Flow {
    let (half_edge, twin) = (h as usize, t as usize);
    if t == h {
        return pass.add(Violation::TwinIsSelf { half_edge });
    }
    let back = subject.twin(t);
    let found = if back == NIL {
        // At an open boundary nil is a legal link, but not for a half-edge that is named as a twin.
        if subject.view.twin(twin).is_some() || !subject.is_open() {
            return Ok(());
        }
        None
    } else if back == h || !(all_live || subject.is_live_half_edge(back)) {
        return Ok(());
    } else {
        Some(back as usize)
    };
    pass.add(Violation::TwinNotMutual { half_edge, twin, found })
}
