//! The components, joined edge by edge.

use super::extent::{Extent, Slots};
use super::rotations::Rotations;
use crate::validate::columns::{NIL, column};
use crate::validate::view::View;
use alloc::vec::Vec;

/// The number of the component of each vertex, and the first vertex of each component.
pub(super) struct Joined {
    pub(super) of: Vec<u32>,
    pub(super) first: Vec<u32>,
}

/// Joins vertices until so few components are left, or every edge is used.
///
/// First each vertex joins its neighbour with the smallest number. Numbers fall along these steps, so they end, and where
/// neighbours have close numbers they end at one vertex of each component. What is left is joined edge by edge.
#[inline(never)]
pub(super) fn join<V: View + ?Sized>(view: &V, extent: Extent, around: Rotations, fewest: usize) -> Option<Joined> {
    let mut of = around.nearest;
    let mut first = Vec::new();
    first.try_reserve_exact(around.counted.roots).ok()?;
    for v in 0..of.len() {
        let nearest = of[v] as usize;
        if nearest == v {
            of[v] = first.len() as u32;
            first.push(v as u32);
        } else if nearest < v {
            of[v] = of[nearest];
        }
    }
    if first.len() > fewest {
        let mut sets = Sets::new(first.len() as u32)?;
        for h in extent.half_edges.all() {
            if sets.count == fewest {
                break;
            }
            if !view.is_half_edge(h) {
                continue;
            }
            // Without twin the edge ends where the next one starts.
            let t = match view.twin(h) {
                Some(t) if t < h => continue,
                Some(t) => extent.half_edges.existing(Some(t))?,
                None => extent.half_edges.existing(view.next(h))?,
            };
            sets.join(*of.get(view.origin(h)?)?, *of.get(view.origin(t)?)?)?;
        }
        first = sets.number(&mut of, &first)?;
    }
    Some(Joined { of, first })
}

/// Disjoint sets of numbers, joined by rank.
struct Sets {
    parent: Vec<u32>,
    rank: Vec<u8>,
    count: usize,
}

impl Sets {
    /// Sets of one number each; none if there is no memory for them.
    fn new(count: u32) -> Option<Self> {
        let mut parent = Slots(count).nils()?;
        for (i, parent) in parent.iter_mut().enumerate() {
            *parent = i as u32;
        }
        Some(Self { parent, rank: column(count, 0).ok()?, count: count as usize })
    }

    /// The number that stands for the set of `i`. Every second step on the way is shortened.
    fn find(&mut self, mut i: u32) -> Option<u32> {
        loop {
            let parent = *self.parent.get(i as usize)?;
            if parent == i {
                return Some(i);
            }
            let next = *self.parent.get(parent as usize)?;
            self.parent[i as usize] = next;
            i = next;
        }
    }

    /// Joins two sets, the one of lower rank to the other.
    fn join(&mut self, i: u32, j: u32) -> Option<()> {
        let (i, j) = (self.find(i)?, self.find(j)?);
        if i != j {
            let (low, high) = if self.rank[i as usize] < self.rank[j as usize] { (i, j) } else { (j, i) };
            self.rank[high as usize] += u8::from(self.rank[low as usize] == self.rank[high as usize]);
            self.parent[low as usize] = high;
            self.count -= 1;
        }
        Some(())
    }

    /// Numbers the sets in order of their first elements, puts these numbers in the place of those of the elements, and
    /// returns the first vertex of each set.
    fn number(mut self, of: &mut [u32], first: &[u32]) -> Option<Vec<u32>> {
        self.rank = Vec::new();
        let mut numbers = Slots(first.len() as u32).nils()?;
        let mut firsts = Vec::new();
        firsts.try_reserve_exact(self.count).ok()?;
        for (i, first) in first.iter().enumerate() {
            let root = self.find(i as u32)? as usize;
            if numbers[root] == NIL {
                numbers[root] = firsts.len() as u32;
                firsts.push(*first);
            }
            numbers[i] = numbers[root];
        }
        for of in of.iter_mut().filter(|of| **of != NIL) {
            *of = *numbers.get(*of as usize)?;
        }
        Some(firsts)
    }
}
