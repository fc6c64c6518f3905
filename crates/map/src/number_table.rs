//! A table that finds the number of an item by its hash. The items are stored elsewhere, in the order of their numbers, so the
//! table stores only a number and two bits of hash for each.

use core::hash::Hasher;
use rustc_hash::FxHasher;

const EMPTY: u32 = u32::MAX;

/// Numbers are less than this: the bits above hold part of the hash.
const MOST: u32 = 1 << 30;

/// The numbers of items from 0 on.
#[derive(Clone, Debug, Default)]
pub(super) struct NumberTable {
    slots: Vec<u32>,
    count: u32,
}

/// Hashes two numbers. The upper bits are as good as the lower ones.
pub(super) fn hash([a, b]: [u64; 2]) -> u64 {
    let mut hasher = FxHasher::default();
    hasher.write_u64(a);
    hasher.write_u64(b);
    let hash = hasher.finish();
    (hash ^ hash >> 32).wrapping_mul(0x9e37_79b9_7f4a_7c15)
}

/// Returns the bits of a hash that are stored with a number.
const fn tag(hash: u64) -> u32 {
    // A fourth value would make the last number look like an empty slot.
    (hash % 3) as u32 * MOST
}

impl NumberTable {
    /// Returns the slots, starting at the slot of a hash.
    fn way(&self, hash: u64) -> impl Iterator<Item = usize> + use<> {
        let last = self.slots.len().wrapping_sub(1);
        let first = (hash >> 32) as usize;
        (0..self.slots.len()).map(move |step| (first + step) & last)
    }

    /// Reads the first slots of several hashes, so that memory fetches them together instead of one by one.
    pub(super) fn read_ahead(&self, hashes: impl Iterator<Item = u64>) {
        let slots = hashes.filter_map(|hash| self.way(hash).next());
        core::hint::black_box(slots.fold(0, |all, slot| all ^ self.slots[slot]));
    }

    /// Returns the number of the item with this hash that `is` accepts. O(1), expected.
    pub(super) fn find(&self, hash: u64, is: impl Fn(u32) -> bool) -> Option<u32> {
        let entries = self.way(hash).map(|slot| self.slots[slot]).take_while(|entry| *entry != EMPTY);
        let mut alike = entries.filter(|entry| entry & !(MOST - 1) == tag(hash)).map(|entry| entry & (MOST - 1));
        alike.find(|number| is(*number))
    }

    /// Adds items until there are `count`. `hash_of` is called for the new items, and for all others when the table grows.
    /// Numbers from 2^30 on are never found. O(1) for each, expected.
    pub(super) fn extend(&mut self, count: usize, hash_of: impl Fn(u32) -> u64) {
        let count = count.min(MOST as usize) as u32;
        if count as usize > self.slots.len() / 4 * 3 {
            // The old table is freed before the new one is allocated.
            self.slots = Vec::new();
            self.slots = vec![EMPTY; (count as usize / 3 * 4 + 4).next_power_of_two()];
            self.count = 0;
        }
        for number in self.count..count {
            let hash = hash_of(number);
            if let Some(free) = self.way(hash).find(|slot| self.slots[*slot] == EMPTY) {
                self.slots[free] = tag(hash) | number;
            }
        }
        self.count = self.count.max(count);
    }
}

#[cfg(test)]
mod tests;
