//! 32-bit slot numbers in columns: nil, disjoint sets, the cycles of a permutation.

pub(crate) const NIL: u32 = u32::MAX;

/// Allocates `n` copies of `value`; `None` if memory runs out.
pub(crate) fn column<T: Clone>(n: usize, value: T) -> Option<Vec<T>> {
    let mut column = Vec::new();
    column.try_reserve_exact(n).ok()?;
    column.resize(n, value);
    Some(column)
}

/// Disjoint sets of the numbers below a count; larger numbers are in no set. n calls take O(n α(n)), with the inverse α of
/// Ackermann's function.
pub(crate) struct Sets {
    /// Another member of the same set, or the number itself for the representative of the set.
    towards: Vec<u32>,
    rank: Vec<u8>,
    pub(crate) count: usize,
}

impl Sets {
    /// Creates `count` sets of one number each.
    pub(crate) fn new(count: usize) -> Self {
        Self { towards: (0..count as u32).collect(), rank: alloc::vec![0; count], count }
    }

    /// Creates `count` sets of one number each; `None` if memory runs out.
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
}

/// Returns the cycles of a permutation: for each number its cycle, and for each cycle its smallest number.
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
