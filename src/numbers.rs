//! 32-bit slot numbers, as all layers store them in columns: nil, disjoint sets, and the cycles of a permutation.

use alloc::vec::Vec;
#[cfg(feature = "dcel")]
use core::mem;

/// Nil in a column.
pub(crate) const NIL: u32 = u32::MAX;

/// Allocates `n` copies of `value`; `None` if memory runs out.
pub(crate) fn column<T: Clone>(n: usize, value: T) -> Option<Vec<T>> {
    let mut column = Vec::new();
    column.try_reserve_exact(n).ok()?;
    column.resize(n, value);
    Some(column)
}

/// Marks an entry that stores the number of its set instead of a member.
#[cfg(feature = "dcel")]
const NUMBERED: u32 = 1 << 31;

/// Disjoint sets of the numbers below `count`. Larger numbers are in no set. n calls take O(n α(n)), where α is the inverse of
/// Ackermann's function.
pub(crate) struct Sets {
    /// Another member of the same set, or the number itself if it represents the set.
    towards: Vec<u32>,
    rank: Vec<u8>,
    pub(crate) count: usize,
}

impl Sets {
    #[cfg(feature = "dcel")]
    pub(crate) fn new(count: usize) -> Self {
        Self { towards: (0..count as u32).collect(), rank: alloc::vec![0; count], count }
    }

    /// Creates sets of one number each; `None` if memory runs out.
    pub(crate) fn try_new(count: usize) -> Option<Self> {
        let mut towards = Vec::new();
        towards.try_reserve_exact(count).ok()?;
        towards.extend(0..count as u32);
        Some(Self { towards, rank: column(count, 0)?, count })
    }

    /// Returns the representative of the set of `i`, halving the path to it.
    pub(crate) fn find(&mut self, mut i: u32) -> u32 {
        while let Some(next) = self.towards.get(i as usize).copied().filter(|next| *next != i) {
            let after = self.towards[next as usize];
            self.towards[i as usize] = after;
            i = after;
        }
        i
    }

    /// Joins two sets by rank.
    pub(crate) fn join(&mut self, i: u32, j: u32) {
        let (i, j) = (self.find(i), self.find(j));
        let (Some(rank_i), Some(rank_j)) = (self.rank.get(i as usize).copied(), self.rank.get(j as usize).copied())
        else {
            return;
        };
        let (low, high) = if rank_i < rank_j { (i, j) } else { (j, i) };
        self.rank[high as usize] += u8::from(rank_i == rank_j && i != j);
        self.count -= usize::from(low != high);
        self.towards[low as usize] = high;
    }

    /// Returns the number of the set of `i`. Sets are numbered by `count` on first use. After the first call, sets can no longer
    /// be found or joined. Numbers are below 2^31.
    #[cfg(feature = "dcel")]
    pub(crate) fn number(&mut self, i: u32, count: &mut u32) -> u32 {
        let mut at = i as usize;
        let numbered = loop {
            let next = self.towards[at];
            if next & NUMBERED != 0 {
                break next;
            }
            if next as usize == at {
                self.towards[at] = *count | NUMBERED;
                *count += 1;
            } else {
                at = next as usize;
            }
        };
        at = i as usize;
        while self.towards[at] & NUMBERED == 0 {
            at = mem::replace(&mut self.towards[at], numbered) as usize;
        }
        numbered ^ NUMBERED
    }

    /// Returns the number of the set of `i`, which must have been numbered. O(1).
    #[cfg(feature = "dcel")]
    pub(crate) fn known_number(&self, i: u32) -> u32 {
        self.towards[i as usize] ^ NUMBERED
    }

    /// Returns the set number of each number, in the order of first members; `None` if memory runs out.
    pub(crate) fn numbered(mut self) -> Option<Vec<u32>> {
        self.rank = Vec::new();
        let mut count = 0;
        let mut numbers = column(self.towards.len(), NIL)?;
        for i in 0..numbers.len() {
            let first = self.find(i as u32) as usize;
            if numbers[first] == NIL {
                numbers[first] = count;
                count += 1;
            }
            numbers[i] = numbers[first];
        }
        Some(numbers)
    }
}

/// Returns the cycle of each number, and the smallest number of each cycle, of a permutation.
#[cfg(feature = "dcel")]
pub(crate) fn cycles(next: &[u32]) -> (Vec<u32>, Vec<u32>) {
    let mut of = alloc::vec![NIL; next.len()];
    let mut starts = Vec::new();
    for start in 0..next.len() as u32 {
        let mut at = start;
        while of[at as usize] == NIL {
            of[at as usize] = starts.len() as u32;
            at = next[at as usize];
            if at == start {
                starts.push(start);
            }
        }
    }
    (of, starts)
}
