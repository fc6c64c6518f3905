//! From ids to slots.

use std::collections::BTreeSet;

#[derive(Debug, Default)]
pub(super) struct Ids {
    all: Vec<i64>,
    lookup: Lookup,
    /// Slots of rows that repeat the id of an earlier row.
    repeated: BTreeSet<u32>,
}

#[derive(Debug, Default)]
enum Lookup {
    /// Each id is one more than the id before it.
    #[default]
    Consecutive,
    /// The slot of each id from this one on; nil for an absent id.
    Dense(i64, Vec<u32>),
    /// Slots in the order of their ids.
    Sorted(Vec<u32>),
}

const NIL: u32 = u32::MAX;

/// The largest number of entries per id in a table of slots.
const SPARSEST: u64 = 4;

impl Ids {
    /// O(n) if the ids are dense, else O(n log n); 8 bytes for each id and up to 16 for its slot.
    pub(super) fn of(mut ids: Vec<i64>) -> Self {
        ids.shrink_to_fit();
        let is_next = |pair: &[i64]| pair[0].checked_add(1) == Some(pair[1]);
        let mut repeated = BTreeSet::new();
        let lookup = match (ids.iter().min(), ids.iter().max()) {
            (Some(min), Some(max)) if !ids.windows(2).all(is_next) => {
                let width = max.abs_diff(*min);
                if width < SPARSEST * ids.len() as u64 {
                    let mut slots = vec![NIL; width as usize + 1];
                    for (slot, id) in (0..).zip(&ids) {
                        match &mut slots[id.abs_diff(*min) as usize] {
                            free if *free == NIL => *free = slot,
                            _ => drop(repeated.insert(slot)),
                        }
                    }
                    Lookup::Dense(*min, slots)
                } else {
                    let mut sorted: Vec<u32> = (0..ids.len() as u32).collect();
                    sorted.sort_by_key(|slot| ids[*slot as usize]);
                    let same = |pair: &&[u32]| ids[pair[0] as usize] == ids[pair[1] as usize];
                    repeated.extend(sorted.windows(2).filter(same).map(|pair| pair[1]));
                    Lookup::Sorted(sorted)
                }
            }
            _ => Lookup::Consecutive,
        };
        Self { all: ids, lookup, repeated }
    }

    pub(super) fn len(&self) -> usize {
        self.all.len()
    }

    pub(super) fn id(&self, slot: usize) -> Option<i64> {
        self.all.get(slot).copied()
    }

    /// Returns the slot of an id. O(1), or O(log n) if ids are sparse.
    pub(super) fn slot(&self, id: i64) -> Option<u32> {
        match &self.lookup {
            Lookup::Consecutive => {
                let slot = id.checked_sub(*self.all.first()?)?;
                u32::try_from(slot).ok().filter(|slot| (*slot as usize) < self.all.len())
            }
            Lookup::Dense(min, slots) => {
                let at = usize::try_from(id.checked_sub(*min)?).ok()?;
                slots.get(at).copied().filter(|slot| *slot != NIL)
            }
            Lookup::Sorted(sorted) => {
                let slot = *sorted.get(sorted.partition_point(|slot| self.all[*slot as usize] < id))?;
                (self.all[slot as usize] == id).then_some(slot)
            }
        }
    }

    /// Returns true if the row in this slot is the only or first one with its id.
    pub(super) fn is_first(&self, slot: usize) -> bool {
        slot < self.all.len() && (self.repeated.is_empty() || !self.repeated.contains(&(slot as u32)))
    }

    /// Returns the slots of rows that repeat the id of an earlier row.
    pub(super) fn repeated(&self) -> impl Iterator<Item = usize> + '_ {
        self.repeated.iter().map(|slot| *slot as usize)
    }
}
