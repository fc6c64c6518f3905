//! The cycles of `next`, which must be a permutation, the border loops made of missing twins, and the set of slots that marks both.

use super::rotations::Starts;
use crate::numbers::NIL;
use crate::validate::structure::View;
use crate::validate::subject::{Extent, Slots};
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

/// Returns a vertex of each border loop. At a vertex of the border, a half-edge without twin that ends there is followed by the
/// one that leaves it.
pub(super) fn border_loops<V: View + ?Sized>(view: &V, extent: Extent, starts: &mut Starts) -> Option<Vec<u32>> {
    let mut into = core::mem::take(&mut starts.into);
    let mut loops = Vec::new();
    for v in 0..into.len().min(extent.vertices.count()) {
        let mut h = core::mem::replace(&mut into[v], NIL);
        if h == NIL {
            continue;
        }
        loops.try_reserve(1).ok()?;
        loops.push(v as u32);
        while h != NIL {
            let before = view.origin(h as usize)?;
            h = core::mem::replace(into.get_mut(before)?, NIL);
        }
    }
    Some(loops)
}

/// A set of slots, stored as bits.
#[derive(Default)]
pub(super) struct Marks(Vec<u64>);

impl Marks {
    /// Allocates room for `slots`, if there is none yet; `None` if memory runs out.
    pub(super) fn make_room(&mut self, slots: Slots) -> Option<()> {
        if self.0.is_empty() {
            let words = slots.count().div_ceil(64);
            self.0.try_reserve_exact(words).ok()?;
            self.0.resize(words, 0);
        }
        Some(())
    }

    #[inline]
    pub(super) fn has(&self, slot: usize) -> bool {
        self.0.get(slot / 64).is_some_and(|word| word >> (slot % 64) & 1 == 1)
    }

    /// Marks the slot; `None` if it is marked already, or out of range.
    #[inline]
    pub(super) fn mark(&mut self, slot: usize) -> Option<()> {
        let word = self.0.get_mut(slot / 64)?;
        let bit = bit(slot);
        let is_new = *word & bit == 0;
        *word |= bit;
        is_new.then_some(())
    }

    /// Removes the slot from the set; `None` if it is not in it.
    #[inline]
    pub(super) fn clear(&mut self, slot: usize) -> Option<()> {
        let word = self.0.get_mut(slot / 64)?;
        let bit = bit(slot);
        let was_marked = *word & bit != 0;
        *word &= !bit;
        was_marked.then_some(())
    }

    /// Returns the first slot of the set in the word of this slot or after it.
    pub(super) fn first_from(&self, slot: usize) -> Option<usize> {
        let words = self.0.get(slot / 64..)?;
        let (i, word) = words.iter().enumerate().find(|(_, word)| **word != 0)?;
        Some((slot / 64 + i) * 64 + word.trailing_zeros() as usize)
    }
}

fn bit(slot: usize) -> u64 {
    1 << (slot % 64)
}
