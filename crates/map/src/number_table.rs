//! A table that finds the number of an item by its hash. The items are stored elsewhere, in the order of their numbers, so the
//! table stores only a number and some bits of hash for each: as many as the number leaves free.

use core::hash::Hasher;
use rustc_hash::FxHasher;

/// No number of an item: it exceeds three quarters of the slots.
const EMPTY: u32 = u32::MAX;

/// The greatest number of items.
const MOST: usize = 1 << 30;

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

impl NumberTable {
    /// Returns the number of the last slot. Its bits are those of numbers in entries; the others are from the hash.
    const fn last(&self) -> u32 {
        (self.slots.len() as u32).wrapping_sub(1)
    }

    /// Returns the first slot of a hash.
    const fn first(&self, hash: u64) -> u32 {
        (hash >> 32) as u32 & self.last()
    }

    /// Reads the first slots of several hashes, so that memory fetches them together instead of one by one.
    pub(super) fn read_ahead(&self, hashes: &[u64]) {
        let read = |hash: &u64| self.slots.get(self.first(*hash) as usize).copied().unwrap_or(EMPTY);
        core::hint::black_box(hashes.iter().fold(0, |all, hash| all ^ read(hash)));
    }

    /// Returns the number of the item with this hash that `is` accepts; otherwise the free slot where [`fill`](Self::fill) adds
    /// the next item, if there is [room](Self::reserve) for it. O(1), expected.
    pub(super) fn find(&self, hash: u64, is: impl Fn(u32) -> bool) -> Result<u32, usize> {
        let last = self.last();
        let (mut slot, tag) = (self.first(hash), hash as u32 & !last);
        // Ends, since a quarter of the slots stays empty.
        while let Some(entry) = self.slots.get(slot as usize).filter(|entry| **entry != EMPTY) {
            // With other bits of hash, the number is too large.
            let number = entry ^ tag;
            if number <= last && is(number) {
                return Ok(number);
            }
            slot = (slot + 1) & last;
        }
        Err(slot as usize)
    }

    /// Adds the next item, with this hash, in a slot that [`find`](Self::find) returned for it. O(1).
    pub(super) fn fill(&mut self, slot: usize, hash: u64) {
        self.slots[slot] = hash as u32 & !self.last() | self.count;
        self.count += 1;
    }

    /// Makes room for `count` items in total, at most 2^30. If the table grows, `hash_of` is called for all items. O(1) for each,
    /// expected.
    pub(super) fn reserve(&mut self, count: usize, hash_of: impl Fn(u32) -> u64) {
        if count > self.slots.len() / 4 * 3 {
            let known = core::mem::take(&mut self.count);
            // The old table is freed before the new one is allocated.
            self.slots = Vec::new();
            self.slots = vec![EMPTY; (count / 3 * 4 + 4).next_power_of_two()];
            self.add(known, hash_of);
        }
    }

    /// Adds items until there are `count`. `hash_of` is called for the new items, and for all others when the table grows.
    /// Numbers from 2^30 on are never found. O(1) for each, expected.
    pub(super) fn extend(&mut self, count: usize, hash_of: impl Fn(u32) -> u64) {
        let count = count.min(MOST);
        self.reserve(count, &hash_of);
        self.add(count as u32, hash_of);
    }

    fn add(&mut self, count: u32, hash_of: impl Fn(u32) -> u64) {
        for number in self.count..count {
            let hash = hash_of(number);
            if let Err(free) = self.find(hash, |_| false) {
                self.fill(free, hash);
            }
        }
    }
}

#[cfg(test)]
mod tests;
