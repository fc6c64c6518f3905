//! The work of `prove`.

use crate::published;
use crate::run::Estimate;

/// The work of `prove`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ProveWork {
    /// The largest number of edges of a connected map.
    pub edges: usize,
}

impl ProveWork {
    /// Returns the approximate number of operators that are tried; `u128::MAX` for more than it can hold.
    #[must_use]
    pub fn estimate(&self) -> Estimate {
        // Nine tenths of the maps have the largest number of edges. Each has 2n corners, so 4n² pairs of them, for `connect` on
        // both sides and for `split_vertex`, plus the same number of invalid ones.
        let mut maps = 0_u128;
        for n in 0..=self.edges {
            maps = maps.saturating_add(published::plane(n));
            if maps == u128::MAX {
                break;
            }
        }
        let edges = self.edges as u128;
        let amount = maps.saturating_mul(edges.saturating_mul(edges).saturating_mul(24));
        Estimate { amount, unit: "operators to try", per_second: 1_000_000 }
    }

    /// Returns the bounds of subdivisions, connected or not: there are many more of them for the same number of edges.
    pub(super) const fn nested(self) -> (usize, usize) {
        let edges = if self.edges > 4 { 4 } else { self.edges.saturating_sub(1) };
        (edges, edges + 2)
    }
}
