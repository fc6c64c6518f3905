//! The keys of one kind that a map gave out, in order of creation.

use slotmap::{Key, SecondaryMap};

/// Keys that are there, and keys that are there no more.
#[derive(Clone, Debug)]
pub(super) struct Keys<K: Key> {
    /// All of them.
    all: Vec<K>,
    /// The places in `all` of those that are there.
    places: SecondaryMap<K, usize>,
    /// Of those that are there the number in parts of `all`: that with number i, counted from 1, ends there, and is as long as the lowest
    /// bit of i says (a Fenwick tree).
    counts: Vec<usize>,
    /// Those that are there no more, in the order in which they went.
    pub(super) retired: Vec<K>,
}

const fn lowest_bit(i: usize) -> usize {
    i & i.wrapping_neg()
}

impl<K: Key> Keys<K> {
    pub(super) fn new(keys: impl Iterator<Item = K>) -> Self {
        let mut new = Self { all: Vec::new(), places: SecondaryMap::new(), counts: Vec::new(), retired: Vec::new() };
        for key in keys {
            new.push(key);
        }
        new
    }

    /// The number of those that are there.
    pub(super) fn len(&self) -> usize {
        self.places.len()
    }

    /// Those that are there, in order. O(all).
    pub(super) fn live(&self) -> Vec<K> {
        self.all.iter().copied().filter(|key| self.places.contains_key(*key)).collect()
    }

    /// The `k`-th of those that are there. It starts again where they end. O(log all).
    pub(super) fn nth(&self, k: u32) -> Option<K> {
        let mut left = (k as usize).checked_rem(self.len())?;
        let (mut before, mut step) = (0, self.all.len().checked_ilog2().map_or(0, |log| 1 << log));
        while step > 0 {
            if let Some(count) = self.counts.get(before + step - 1).filter(|count| **count <= left) {
                left -= count;
                before += step;
            }
            step /= 2;
        }
        self.all.get(before).copied()
    }

    /// The other one of a pair that came together.
    pub(super) fn beside(&self, key: K) -> Option<K> {
        self.all.get(self.places.get(key)? ^ 1).copied()
    }

    fn push(&mut self, key: K) {
        let number = self.all.len() + 1;
        let (mut count, mut end) = (1, number - 1);
        while end > number - lowest_bit(number) {
            count += self.counts[end - 1];
            end -= lowest_bit(end);
        }
        self.counts.push(count);
        self.places.insert(key, number - 1);
        self.all.push(key);
    }

    /// Of keys that an edit named those that are gone are retired, in order of creation, and those that are new come last, in order of
    /// their slots. O(k log all) for k keys.
    pub(super) fn update(&mut self, named: Vec<K>, is_there: impl Fn(K) -> bool, slot: impl Fn(K) -> usize) {
        let (there, gone): (Vec<K>, Vec<K>) = named.into_iter().partition(|key| is_there(*key));
        let mut gone: Vec<usize> = gone.into_iter().filter_map(|key| self.places.remove(key)).collect();
        gone.sort_unstable();
        for place in gone {
            self.retired.push(self.all[place]);
            let mut number = place + 1;
            while let Some(count) = self.counts.get_mut(number - 1) {
                *count -= 1;
                number += lowest_bit(number);
            }
        }
        let mut new: Vec<K> = there.into_iter().filter(|key| !self.places.contains_key(*key)).collect();
        new.sort_by_key(|key| slot(*key));
        new.dedup();
        for key in new {
            self.push(key);
        }
    }
}
