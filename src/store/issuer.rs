//! One slotmap per kind of record issues, checks and retires its keys.

use super::keys::{key, parts};
use alloc::vec::Vec;
use core::sync::atomic::{AtomicU32, Ordering};
use slotmap::{Key, SlotMap};

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

/// Issues, checks and retires the keys of one kind of record.
///
/// The slotmap decides which slot is next and what its generation is. A column beside it repeats the generations, so that
/// the key of a slot is found with one load.
#[derive(Clone, Debug)]
pub(super) struct Issuer<K: Key> {
    pub(super) slots: SlotMap<K, ()>,
    /// Per slot the generation that its key shows, which is odd; one more than the last one if the slot is vacant.
    pub(super) generations: Vec<u32>,
    pub(super) offset: u32,
}

impl<K: Key> Issuer<K> {
    pub(super) fn with_room(room: usize, offset: u32) -> Self {
        let mut generations = with_room(room.saturating_add(1));
        generations.push(0);
        let mut slots = SlotMap::with_key();
        // Best effort, as for the columns.
        let _ = slots.try_reserve(room);
        Self { slots, generations, offset }
    }

    /// Issues a key and gives its slot.
    pub(super) fn issue(&mut self) -> u32 {
        let (slot, generation) = parts(self.slots.insert(()));
        let shown = generation.wrapping_add(self.offset);
        match self.generations.get_mut(slot as usize) {
            Some(entry) => *entry = shown,
            None => self.generations.push(shown),
        }
        slot
    }

    pub(super) fn retire(&mut self, slot: u32) {
        let shown = &mut self.generations[slot as usize];
        self.slots.remove(key(slot, shown.wrapping_sub(self.offset)));
        *shown = shown.wrapping_add(1);
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
        self.slots.len()
    }

    /// One more than the highest slot in use so far.
    pub(super) fn end(&self) -> usize {
        self.generations.len()
    }
}
