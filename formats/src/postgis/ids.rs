//! From ids to slots.

use std::collections::BTreeSet;

/// The ids of a table, and the slot of each.
#[derive(Debug, Default)]
pub(super) struct Ids {
    all: Vec<i64>,
    lookup: Lookup,
    /// Slots of rows whose id an earlier row has.
    repeated: BTreeSet<u32>,
}

#[derive(Debug, Default)]
enum Lookup {
    /// Each id is the one before it and one more.
    #[default]
    Consecutive,
    /// The slot of each id from this one on; nil where there is none.
    Dense(i64, Vec<u32>),
    /// Slots in the order of their ids.
    Sorted(Vec<u32>),
}

/// No slot.
const NIL: u32 = u32::MAX;

/// A table of slots has at most so many entries for each id.
const SPARSEST: u64 = 4;

impl Ids {
    /// O(n) if the ids are few numbers apart, else O(n log n); 8 bytes for each id and up to 16 for its place.
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

    /// The id of a slot.
    pub(super) fn id(&self, slot: usize) -> Option<i64> {
        self.all.get(slot).copied()
    }

    /// The slot of an id. O(1), or O(log n) where ids are far apart.
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

    /// Returns true if the row in this slot has its id for itself, or is the first that has it.
    pub(super) fn is_first(&self, slot: usize) -> bool {
        slot < self.all.len() && (self.repeated.is_empty() || !self.repeated.contains(&(slot as u32)))
    }

    /// The slots of rows whose id an earlier row has.
    pub(super) fn repeated(&self) -> impl Iterator<Item = usize> + '_ {
        self.repeated.iter().map(|slot| *slot as usize)
    }
}
