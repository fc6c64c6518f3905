//! A table that finds the number of a thing by its hash. The things stand elsewhere, in the order of their numbers, so that a number and two bits
//! of its hash are all that is kept of each.

use core::hash::Hasher;
use rustc_hash::FxHasher;

const EMPTY: u32 = u32::MAX;

/// Numbers are less than this: the bits above are of the hash.
const MOST: u32 = 1 << 30;

/// The numbers of things from 0 on.
#[derive(Clone, Debug, Default)]
pub(super) struct NumberTable {
    slots: Vec<u32>,
    count: u32,
}

/// A hash of two numbers, of which the upper bits are as good as the lower ones.
pub(super) fn hash([a, b]: [u64; 2]) -> u64 {
    let mut hasher = FxHasher::default();
    hasher.write_u64(a);
    hasher.write_u64(b);
    let hash = hasher.finish();
    (hash ^ hash >> 32).wrapping_mul(0x9e37_79b9_7f4a_7c15)
}

/// The bits of a hash that are kept beside a number.
const fn tag(hash: u64) -> u32 {
    // The fourth would make an empty slot of the last number.
    (hash % 3) as u32 * MOST
}

impl NumberTable {
    /// The slots from the one to which a hash leads.
    fn way(&self, hash: u64) -> impl Iterator<Item = usize> + use<> {
        let last = self.slots.len().wrapping_sub(1);
        let first = (hash >> 32) as usize;
        (0..self.slots.len()).map(move |step| (first + step) & last)
    }

    /// Reads the slots to which hashes lead, so that memory fetches them together, and not each when it is asked for.
    pub(super) fn read_ahead(&self, hashes: impl Iterator<Item = u64>) {
        let slots = hashes.filter_map(|hash| self.way(hash).next());
        core::hint::black_box(slots.fold(0, |all, slot| all ^ self.slots[slot]));
    }

    /// The number of the thing with this hash that `is` accepts. O(1), expected.
    pub(super) fn find(&self, hash: u64, is: impl Fn(u32) -> bool) -> Option<u32> {
        let entries = self.way(hash).map(|slot| self.slots[slot]).take_while(|entry| *entry != EMPTY);
        let mut alike = entries.filter(|entry| entry & !(MOST - 1) == tag(hash)).map(|entry| entry & (MOST - 1));
        alike.find(|number| is(*number))
    }

    /// Gives numbers to things that have none, up to this many. `hash_of` is asked for their hashes, and for those of all others when the
    /// table grows. Numbers from 2^30 on are not found. O(1) for each, expected.
    pub(super) fn extend(&mut self, count: usize, hash_of: impl Fn(u32) -> u64) {
        let count = count.min(MOST as usize) as u32;
        if count as usize > self.slots.len() / 4 * 3 {
            // The old table goes before there is a new one.
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
