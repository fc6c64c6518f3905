//! Lists of numbers, stored one after another in one vector.

pub(super) struct Lists {
    /// The start of each list, and the end of the last one.
    starts: Vec<usize>,
    items: Vec<u32>,
}

impl Lists {
    /// Creates `lists` lists. Number i goes into all lists of the i-th range, given by its first and last list.
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

    pub(super) fn list(&self, list: usize) -> &[u32] {
        &self.items[self.starts[list]..self.starts[list + 1]]
    }
}
