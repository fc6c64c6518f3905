//! The cycles of `next`, which must be a permutation.

use super::marks::Marks;
use crate::validate::structure::View;
use crate::validate::subject::Extent;
use alloc::vec::Vec;

#[inline(never)]
pub(super) fn count<V: View + ?Sized>(view: &V, extent: Extent) -> Option<usize> {
    let mut cycles = 0;
    // Most cycles are short. Following their links is enough to recognise them, without marks.
    let mut long = Marks::default();
    for h in extent.half_edges.all().filter(|h| view.is_half_edge(*h)) {
        let [is_short, is_first] = short(view, extent, h)?;
        if is_short {
            cycles += usize::from(is_first);
        } else {
            long.make_room(extent.half_edges)?;
            long.mark(h)?;
        }
    }
    let mut from = 0;
    while let Some(h) = long.first_from(from) {
        cycles += 1;
        along(view, extent, h, |h| long.clear(h))?;
        from = h;
    }
    Some(cycles)
}

/// Returns whether the cycle of a half-edge has at most four half-edges, and whether this one has the smallest number.
#[inline]
fn short<V: View + ?Sized>(view: &V, extent: Extent, first: usize) -> Option<[bool; 2]> {
    let next = |h| extent.half_edges.existing(view.next(h));
    let second = next(first)?;
    let third = next(second)?;
    let fourth = next(third)?;
    if fourth == first {
        return Some([true, first <= second.min(third)]);
    }
    Some([next(fourth)? == first, first <= second.min(third).min(fourth)])
}

/// Counts the cycles whose half-edges name nothing, and returns a vertex of each. Each of their half-edges must have a twin, or it
/// bounds nothing.
#[cold]
#[inline(never)]
pub(super) fn unnamed<V: View + ?Sized>(view: &V, extent: Extent) -> Option<Vec<u32>> {
    let mut passed = Marks::default();
    let mut found = Vec::new();
    for start in extent.half_edges.all().filter(|h| view.is_half_edge(*h)) {
        if extent.name(view, start).is_some() || passed.has(start) {
            continue;
        }
        passed.make_room(extent.half_edges)?;
        along(view, extent, start, |h| passed.mark(h).filter(|()| view.twin(h).is_some()))?;
        found.try_reserve(1).ok()?;
        found.push(view.origin(start)? as u32);
    }
    Some(found)
}

/// Walks along one cycle. `visit` must refuse a half-edge that was visited before.
#[inline]
pub(super) fn along<V: View + ?Sized>(
    view: &V,
    extent: Extent,
    start: usize,
    mut visit: impl FnMut(usize) -> Option<()>,
) -> Option<()> {
    let mut h = start;
    loop {
        visit(h)?;
        h = extent.half_edges.existing(view.next(h))?;
        if h == start {
            return Some(());
        }
    }
}
