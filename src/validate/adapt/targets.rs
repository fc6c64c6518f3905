//! An adapter for structures whose half-edges store their target.

use super::cycles::{entry, filled, inverse, live, nils};
use crate::validate::structure::{Link, View};
use alloc::vec::Vec;
use core::fmt;

/// A structure whose half-edges store their target; origins are derived.
///
/// The origin of a half-edge is the target of its twin: `origin(h) = target(twin(h))`. So L3, which compares
/// `origin(next(h))` with `origin(twin(h))`, compares
///
/// ```text
///   target(twin(next(h))) = target(h)
/// ```
/// which are two stored facts: all half-edges that arrive at a vertex name it. (Deriving along `next`, for example copying
/// a target to the origin of the next half-edge, would compare a fact with itself.) V1 compares `target(twin(leaving(v)))`
/// with `v`. If the structure stores a half-edge that *arrives* at the vertex, let `leaving` answer its twin (or, without
/// a twin, its next): V1 then checks the target of the stored half-edge.
///
/// A half-edge without twin, at an open boundary, starts where the previous boundary half-edge ends, which is found by
/// walking around the vertex, by `twin∘prev`, to the last half-edge without twin. So each stored target is the origin of
/// exactly one half-edge, and every target is read. If the walk fails, R1, L1 or L2 is broken.
///
/// A violation about the origin of a half-edge concerns the target of the half-edge returned by
/// [`origin_from`](Self::origin_from).
///
/// ```
/// use twinedge::validate::adapt::Targets;
/// use twinedge::validate::{Collect, Expectation, Link, Parts, Rule, View, validate};
///
/// /// A triangle, both of its sides. Half-edges `h` and `h ^ 1` are twins.
/// struct Triangle {
///     target: [usize; 6],
/// }
///
/// impl View for Triangle {
///     fn parts(&self) -> Parts { Parts::NONE }
///     fn vertex_slots(&self) -> usize { 3 }
///     fn half_edge_slots(&self) -> usize { 6 }
///     fn origin(&self, _: usize) -> Link { None }
///     fn twin(&self, h: usize) -> Link { Some(h ^ 1) }
///     fn next(&self, h: usize) -> Link { Some([2, 5, 4, 1, 0, 3][h]) }
/// }
///
/// let judge = |triangle: &Triangle| {
///     let view = Targets::of(triangle, |h| Some(triangle.target[h])).unwrap();
///     validate(&view, &Expectation::plane(), Collect::All)
/// };
/// assert!(judge(&Triangle { target: [1, 0, 2, 1, 0, 2] }).is_valid());
/// let report = judge(&Triangle { target: [1, 0, 2, 2, 0, 2] });
/// assert_eq!(report.broken_rules().collect::<Vec<_>>(), [Rule::L3]);
/// ```
#[derive(Clone)]
pub struct Targets<V, F> {
    view: V,
    target: F,
    /// By half-edge: the half-edge whose target is its origin.
    from: Vec<u32>,
}

/// Omits the function that returns targets.
impl<V: fmt::Debug, F> fmt::Debug for Targets<V, F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Targets").field("view", &self.view).field("from", &self.from).finish_non_exhaustive()
    }
}

impl<V: View, F: Fn(usize) -> Link> Targets<V, F> {
    /// Wraps the structure; `target` returns the target of a half-edge. The structure's own `origin` is never called. O(n)
    /// time; 4 bytes per half-edge, and 5 more temporarily. `None` if memory runs out, or if the structure claims more
    /// than `u32::MAX - 1` half-edges.
    #[must_use]
    pub fn of(view: V, target: F) -> Option<Self> {
        let before = inverse(&view, V::next)?;
        let slots = before.len();
        let (mut from, mut passed) = (nils(slots)?, filled(slots, false)?);
        for h in live(&view, slots) {
            let found = match view.twin(h) {
                Some(t) => Some(t).filter(|t| *t < slots && view.is_half_edge(*t)),
                None => around(&view, &before, h, &mut passed),
            };
            from[h] = found.map_or(before[h], |found| found as u32);
        }
        Some(Self { view, target, from })
    }

    /// Returns the half-edge whose target is the origin of this one; `None` if there is none. O(1).
    #[must_use]
    pub fn origin_from(&self, half_edge: usize) -> Link {
        entry(&self.from, half_edge)
    }
}

/// Walks around the origin of a half-edge without twin to the half-edge without twin that arrives there. Stops at
/// half-edges that another walk has passed, so all walks together are O(n).
fn around<V: View>(view: &V, before: &[u32], start: usize, passed: &mut [bool]) -> Link {
    let mut h = start;
    loop {
        let arriving = entry(before, h)?;
        if core::mem::replace(&mut passed[arriving], true) {
            return None;
        }
        match view.twin(arriving) {
            None => return Some(arriving),
            Some(twin) => h = twin,
        }
    }
}

impl<V: View, F: Fn(usize) -> Link> View for Targets<V, F> {
    crate::delegate_view!(|this| &this.view; except origin);

    fn origin(&self, half_edge: usize) -> Link {
        (self.target)(self.origin_from(half_edge)?)
    }
}
