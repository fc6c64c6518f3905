//! Issues, checks and retires the keys of one kind of record.

use alloc::vec::Vec;
use core::sync::atomic::{AtomicU32, Ordering};

/// The number of structures made so far, to distinguish their keys.
static STRUCTURES: AtomicU32 = AtomicU32::new(0);

/// An even offset for the generations of one structure, so that keys of other structures are stale.
///
/// Multiples of the golden ratio are as far apart as possible, so the key of another structure is accepted only after one of
/// the two slots was reused tens of thousands of times and thousands of structures were made: the first such key was found
/// after 5,473 structures and 41,233 uses of one slot. `SecondaryMap` compares generations by their difference, which an
/// offset does not change.
pub(crate) fn structure_offset() -> u32 {
    STRUCTURES.fetch_add(1, Ordering::Relaxed).wrapping_mul(0x9E37_79B1) << 1
}

/// An empty column with this capacity. If memory is short, it has no capacity and grows as it is filled.
pub(super) fn with_room<T>(room: usize) -> Vec<T> {
    let mut column = Vec::new();
    let _ = column.try_reserve_exact(room);
    column
}

/// Issues, checks and retires the slots of one kind of record.
///
/// A slotmap without values: it issues the keys that [`slotmap`] would, and stores only its free slots besides. A `SlotMap`
/// cannot turn a slot into its key, so a column of generations would have to duplicate its own.
#[derive(Clone, Debug)]
pub(super) struct Issuer {
    /// By slot: the odd generation of its key; if vacant, one more than the last generation. Slot 0 is never used, because
    /// slotmap's secondary maps skip it.
    generations: Vec<u32>,
    /// The vacant slots except slot 0. The most recently retired slot is issued first.
    free: Vec<u32>,
    offset: u32,
}

impl Issuer {
    pub(super) fn with_room(room: usize, offset: u32) -> Self {
        let mut generations = with_room(room.saturating_add(1));
        generations.push(0);
        Self { generations, free: Vec::new(), offset }
    }

    /// Restores an issuer with these generations by slot, odd for live slots; `None` if slot 0 is missing or live.
    #[cfg(feature = "serde")]
    pub(super) fn restored(generations: Vec<u32>, offset: u32) -> Option<Self> {
        let unused = generations.first()? % 2 == 0;
        let free = (1..generations.len()).filter(|slot| generations[*slot] % 2 == 0).map(|slot| slot as u32).collect();
        unused.then_some(Self { generations, free, offset })
    }

    /// The generations by slot, odd for live slots.
    pub(super) fn generations(&self) -> &[u32] {
        &self.generations
    }

    #[cfg(feature = "serde")]
    pub(super) const fn offset(&self) -> u32 {
        self.offset
    }

    pub(super) fn issue(&mut self) -> u32 {
        if let Some(slot) = self.free.pop() {
            self.generations[slot as usize] |= 1;
            return slot;
        }
        self.generations.push(self.offset.wrapping_add(1));
        self.generations.len() as u32 - 1
    }

    /// Issues the keys of the next `count` unused slots, in order.
    pub(super) fn issue_many(&mut self, count: usize) {
        let end = self.generations.len() + count;
        self.generations.resize(end, self.offset.wrapping_add(1));
    }

    pub(super) fn retire(&mut self, slot: u32) {
        let shown = &mut self.generations[slot as usize];
        *shown = shown.wrapping_add(1);
        self.free.push(slot);
    }

    pub(super) fn next(&self) -> u32 {
        self.free.last().copied().unwrap_or(self.generations.len() as u32)
    }

    /// The generation that the next slot will have.
    pub(super) fn next_generation(&self) -> u32 {
        self.free.last().map_or(self.offset, |slot| self.generations[*slot as usize]) | 1
    }

    /// Undoes issuing the last slot for the first time.
    pub(super) fn forget_last(&mut self) {
        self.generations.pop();
    }

    pub(super) fn issue_last(&mut self, generation: u32) {
        self.generations.push(generation);
    }

    /// Exchanges the generation of a slot, making it live or vacant. Calls must undo the original calls in reverse order.
    pub(super) fn exchange(&mut self, slot: u32, generation: &mut u32) {
        core::mem::swap(&mut self.generations[slot as usize], generation);
        if self.is_live(slot) {
            self.free.pop();
        } else {
            self.free.push(slot);
        }
    }

    pub(super) fn set_generation(&mut self, slot: u32, generation: u32) {
        self.generations[slot as usize] = generation;
    }

    /// The generation of a slot: odd if live, even otherwise.
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

    pub(super) fn end(&self) -> usize {
        self.generations.len()
    }
}

#[cfg(test)]
mod tests {
    use super::Issuer;
    use crate::store::keys::{VertexKey, parts};
    use quickcheck::quickcheck;
    use slotmap::SlotMap;

    /// Issues a key for each even step, and retires a live key for each odd step, here and in a `SlotMap`.
    fn issues_the_keys_of_slotmap(steps: Vec<u8>) -> bool {
        let (mut map, mut issuer) = (SlotMap::<VertexKey, ()>::with_key(), Issuer::with_room(0, 0));
        let (mut live, mut retired): (Vec<VertexKey>, Vec<VertexKey>) = (Vec::new(), Vec::new());
        steps.into_iter().all(|step| {
            let chosen = usize::from(step / 2).checked_rem(live.len()).filter(|_| step % 2 == 1);
            if let Some(chosen) = chosen {
                let key = live.swap_remove(chosen);
                map.remove(key);
                issuer.retire(parts(key).0);
                retired.push(key);
            } else {
                live.push(map.insert(()));
                issuer.issue();
            }
            let shown = |key: &VertexKey| issuer.generation(parts(*key).0) == parts(*key).1;
            issuer.len() == map.len() && live.iter().all(shown) && !retired.iter().any(shown)
        })
    }

    quickcheck! {
        fn an_issuer_issues_the_keys_of_slotmap(steps: Vec<u8>) -> bool {
            issues_the_keys_of_slotmap(steps)
        }
    }
}
