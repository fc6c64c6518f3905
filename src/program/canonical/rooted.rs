//! The least code among roots of one connected map.

use super::map::Map;
use crate::slots::NIL;
use alloc::vec::Vec;

/// A search for the root with the least code.
#[derive(Debug, Default)]
pub(super) struct Search {
    /// The number of each half-edge met so far from the root that is being tried.
    numbers: Vec<u32>,
    /// The half-edges in order of their numbers.
    order: Vec<u32>,
    candidate: Vec<u32>,
    least: Vec<u32>,
    ties: usize,
}

impl Search {
    /// Begins a new search, in a map with so many half-edges.
    pub(super) fn begin(&mut self, half_edges: usize) {
        // `offer` resets the numbers that it has set, so all of them are NIL.
        self.numbers.resize(half_edges, NIL);
        self.least.clear();
        self.ties = 0;
    }

    /// The least code so far.
    pub(super) fn least(&self) -> &[u32] {
        &self.least
    }

    /// The number of roots that have that code. They differ by an automorphism, and no automorphism but one keeps any half-edge.
    pub(super) const fn ties(&self) -> usize {
        self.ties
    }

    /// Tries another root of the same component. `note` is what the code is to say of the cycle of a half-edge besides
    /// its length; it must tell itself where it ends.
    pub(super) fn offer<'a>(&mut self, map: &Map, root: u32, note: impl Fn(u32) -> &'a [u32]) {
        self.candidate.clear();
        let smaller = self.write(map, root, note);
        for h in self.order.drain(..) {
            self.numbers[h as usize] = NIL;
        }
        match smaller {
            Some(true) => {
                core::mem::swap(&mut self.candidate, &mut self.least);
                self.ties = 1;
            }
            Some(false) => self.ties += 1,
            None => {}
        }
    }

    /// Tells whether the code is smaller than the least so far, or equal. None, as soon as that is certain, if it is greater.
    fn write<'a>(&mut self, map: &Map, root: u32, note: impl Fn(u32) -> &'a [u32]) -> Option<bool> {
        // The first root has nothing to be compared with.
        let mut smaller = self.least.is_empty();
        self.write_cycle(map, root, &note, &mut smaller)?;
        let mut done = 0;
        while let Some(h) = self.order.get(done).copied() {
            let twin = map.twin[h as usize];
            let number = self.numbers[twin as usize];
            if number == NIL {
                self.push(self.order.len() as u32, &mut smaller)?;
                self.write_cycle(map, twin, &note, &mut smaller)?;
            } else {
                self.push(number, &mut smaller)?;
            }
            done += 1;
        }
        Some(smaller)
    }

    fn write_cycle<'a>(
        &mut self,
        map: &Map,
        first: u32,
        note: &impl Fn(u32) -> &'a [u32],
        smaller: &mut bool,
    ) -> Option<()> {
        let before = self.order.len();
        let mut h = first;
        loop {
            self.numbers[h as usize] = self.order.len() as u32;
            self.order.push(h);
            h = map.next[h as usize];
            if h == first {
                break;
            }
        }
        self.push((self.order.len() - before) as u32, smaller)?;
        note(first).iter().try_for_each(|number| self.push(*number, smaller))
    }

    fn push(&mut self, number: u32, smaller: &mut bool) -> Option<()> {
        if !*smaller {
            match self.least.get(self.candidate.len()) {
                Some(least) if number > *least => return None,
                Some(least) if number == *least => {}
                _ => *smaller = true,
            }
        }
        self.candidate.push(number);
        Some(())
    }
}
