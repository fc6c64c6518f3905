//! A set of slots.

use crate::validate::subject::Slots;
use alloc::vec::Vec;

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
