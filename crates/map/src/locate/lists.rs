//! Lists of numbers, one behind the other in one vector.

/// Some lists of numbers, each ascending.
pub(super) struct Lists {
    /// The start of each list, and the end of the last one.
    starts: Vec<usize>,
    items: Vec<u32>,
}

impl Lists {
    /// So many lists. Each number, from 0 on, comes with the first and the last of those lists in which it is to be.
    pub(super) fn new(lists: usize, ranges: impl Iterator<Item = [u32; 2]> + Clone) -> Self {
        let mut starts = vec![0; lists + 1];
        for [first, last] in ranges.clone() {
            for list in first..=last {
                starts[list as usize + 1] += 1;
            }
        }
        for list in 0..lists {
            starts[list + 1] += starts[list];
        }
        let mut next = starts.clone();
        let mut items = vec![0; starts[lists]];
        for (item, [first, last]) in (0..).zip(ranges) {
            for list in first..=last {
                let place = &mut next[list as usize];
                items[*place] = item;
                *place += 1;
            }
        }
        Self { starts, items }
    }

    /// One of the lists.
    pub(super) fn list(&self, list: usize) -> &[u32] {
        &self.items[self.starts[list]..self.starts[list + 1]]
    }
}
