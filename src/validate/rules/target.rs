//! L3 target: `origin(next(h)) = origin(twin(h))`.

use crate::validate::columns::NIL;
use crate::validate::findings::{Halt, Pass};
use crate::validate::report::Violation;
use crate::validate::subject::Subject;

/// Checks one half-edge with its twin and its next, and returns whether both have a live origin.
pub(crate) fn check(
    subject: Subject<'_>,
    h: u32,
    [t, n]: [u32; 2],
    all_live: bool,
    pass: &mut Pass<'_>,
) -> Result<bool, Halt> {
    let (target, found) = (subject.origin(t), subject.origin(n));
    let are_live = || all_live || subject.is_live_vertex(target) && subject.is_live_vertex(found);
    if target == NIL || found == NIL || !are_live() {
        return Ok(false);
    }
    if target != found {
        let [half_edge, next, target, found] = [h, n, target, found].map(|i| i as usize);
        pass.add(Violation::Target { half_edge, next, target, found })?;
    }
    Ok(true)
}
