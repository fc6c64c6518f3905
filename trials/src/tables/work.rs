//! The work of `tables`.

use super::formulas;
use crate::run::Estimate;

/// The work of `tables`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct TablesWork {
    /// The greatest number of half-edges.
    pub half_edges: usize,
}

impl TablesWork {
    /// About how many tables are judged; `u128::MAX` where that is more than it can hold.
    #[must_use]
    pub fn estimate(&self) -> Estimate {
        let n = self.half_edges as u128;
        // Nearly all of them are those of the last two jobs.
        let paired = formulas::pairings(n / 2).saturating_mul(n.saturating_pow(u32::try_from(n).unwrap_or(u32::MAX)));
        Estimate { amount: paired.saturating_mul(2).saturating_add(5_000_000), unit: "tables", per_second: 500_000 }
    }
}
