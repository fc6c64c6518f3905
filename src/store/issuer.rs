//! Issues, checks and retires the keys of one kind of record.

use alloc::vec::Vec;
use core::sync::atomic::{AtomicU32, Ordering};

/// Counts the structures made so far, to tell their keys apart.
static STRUCTURES: AtomicU32 = AtomicU32::new(0);

/// An even number to add to the generations of the keys of one structure, so that the keys of another are stale to it.
///
/// Multiples of the golden ratio lie as far from one another as can be, so the key of another structure passes for one of
/// this only if one of the two slots was used again tens of thousands of times and thousands of structures were made: the
/// first such key was found after 5,473 structures and 41,233 uses of one slot. `SecondaryMap` compares generations by their difference, which an offset does not change.
pub(crate) fn structure_offset() -> u32 {
    STRUCTURES.fetch_add(1, Ordering::Relaxed).wrapping_mul(0x9E37_79B1) << 1
}

/// An empty column with that much capacity. Capacity is best effort: without that much memory, the column grows as it is
/// filled.
pub(super) fn with_room<T>(room: usize) -> Vec<T> {
    let mut column = Vec::new();
    let _ = column.try_reserve_exact(room);
    column
}

/// Issues, checks and retires the slots of one kind of record.
///
/// A slotmap without values: it gives out the keys that [`slotmap`] would, and its free slots are the only other thing that it
/// keeps. A `SlotMap` has no way from a slot to its key, so a column of generations would have to repeat its own.
#[derive(Clone, Debug)]
pub(super) struct Issuer {
    /// Per slot the generation that its key shows, which is odd; one more than the last one if the slot is vacant. Slot 0 is
    /// never used, because slotmap's secondary maps pass over it.
    generations: Vec<u32>,
    /// The vacant slots but slot 0. The one that was retired last is issued first.
    free: Vec<u32>,
    offset: u32,
}

impl Issuer {
    pub(super) fn with_room(room: usize, offset: u32) -> Self {
        let mut generations = with_room(room.saturating_add(1));
        generations.push(0);
        Self { generations, free: Vec::new(), offset }
    }

    /// An issuer with these generations by slot, the live ones odd. None if slot 0 is missing or live.
    #[cfg(feature = "serde")]
    pub(super) fn restored(generations: Vec<u32>, offset: u32) -> Option<Self> {
        let unused = generations.first()? % 2 == 0;
        let free = (1..generations.len()).filter(|slot| generations[*slot] % 2 == 0).map(|slot| slot as u32).collect();
        unused.then_some(Self { generations, free, offset })
    }

    /// By slot, the generations: odd where live.
    pub(super) fn generations(&self) -> &[u32] {
        &self.generations
    }

    /// The number added to the generations that slotmap would show.
    #[cfg(feature = "serde")]
    pub(super) const fn offset(&self) -> u32 {
        self.offset
    }

    /// Issues a key and gives its slot.
    pub(super) fn issue(&mut self) -> u32 {
        if let Some(slot) = self.free.pop() {
            self.generations[slot as usize] |= 1;
            return slot;
        }
        self.generations.push(self.offset.wrapping_add(1));
        self.generations.len() as u32 - 1
    }

    /// Issues so many keys of slots that were never used, in order.
    pub(super) fn issue_many(&mut self, count: usize) {
        let end = self.generations.len() + count;
        self.generations.resize(end, self.offset.wrapping_add(1));
    }

    pub(super) fn retire(&mut self, slot: u32) {
        let shown = &mut self.generations[slot as usize];
        *shown = shown.wrapping_add(1);
        self.free.push(slot);
    }

    /// Returns the slot that is issued next.
    pub(super) fn next(&self) -> u32 {
        self.free.last().copied().unwrap_or(self.generations.len() as u32)
    }

    /// Takes back that the last slot was issued, which was never used before.
    pub(super) fn forget_last(&mut self) {
        self.generations.pop();
    }

    /// Issues the slot after the last one, in a generation.
    pub(super) fn issue_last(&mut self, generation: u32) {
        self.generations.push(generation);
    }

    /// Exchanges the generation of a slot for another, by which it becomes live or vacant, in the opposite order of the calls
    /// that made it what it is.
    pub(super) fn exchange(&mut self, slot: u32, generation: &mut u32) {
        core::mem::swap(&mut self.generations[slot as usize], generation);
        if self.is_live(slot) {
            self.free.pop();
        } else {
            self.free.push(slot);
        }
    }

    /// Gives a slot that has just been issued another generation.
    pub(super) fn set_generation(&mut self, slot: u32, generation: u32) {
        self.generations[slot as usize] = generation;
    }

    /// The generation of a slot: odd if live, even if not.
    #[inline]
    pub(super) fn generation(&self, slot: u32) -> u32 {
        self.generations.get(slot as usize).copied().unwrap_or(0)
    }

    #[inline]
    pub(super) fn is_live(&self, slot: u32) -> bool {
        self.generation(slot) & 1 == 1
    }

    pub(super) fn len(&self) -> usize {
        self.generations.len() - 1 - self.free.len()
    }

    /// One more than the highest slot in use so far.
    pub(super) fn end(&self) -> usize {
        self.generations.len()
    }
}

#[cfg(test)]
mod tests;
