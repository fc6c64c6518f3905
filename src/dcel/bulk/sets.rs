//! Disjoint sets of numbers.

use alloc::vec;
use alloc::vec::Vec;

/// Disjoint sets of the numbers below some number, joined by rank.
pub(super) struct Sets {
    parent: Vec<u32>,
    rank: Vec<u8>,
}

impl Sets {
    /// Sets of one number each.
    pub(super) fn new(count: usize) -> Self {
        Self { parent: (0..count as u32).collect(), rank: vec![0; count] }
    }

    /// The number that stands for the set of `i`. Every second step on the way is shortened.
    pub(super) fn find(&mut self, mut i: u32) -> u32 {
        loop {
            let parent = self.parent[i as usize];
            let next = self.parent[parent as usize];
            if parent == next {
                return parent;
            }
            self.parent[i as usize] = next;
            i = next;
        }
    }

    /// Joins two sets, the one of lower rank to the other.
    pub(super) fn join(&mut self, i: u32, j: u32) {
        let (i, j) = (self.find(i), self.find(j));
        if i == j {
            return;
        }
        let (low, high) = if self.rank[i as usize] < self.rank[j as usize] { (i, j) } else { (j, i) };
        self.rank[high as usize] += u8::from(self.rank[low as usize] == self.rank[high as usize]);
        self.parent[low as usize] = high;
    }
}
