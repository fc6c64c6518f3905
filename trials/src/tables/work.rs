//! The work of `tables`.

use super::formulas;
use crate::run::Estimate;

/// The work of `tables`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct TablesWork {
    /// The largest number of half-edges.
    pub half_edges: usize,
}

impl TablesWork {
    /// Returns the approximate number of judged tables; `u128::MAX` for more than it can hold.
    #[must_use]
    pub fn estimate(&self) -> Estimate {
        let n = self.half_edges as u128;
        // The last two jobs contain nearly all of them.
        let paired = formulas::pairings(n / 2).saturating_mul(n.saturating_pow(u32::try_from(n).unwrap_or(u32::MAX)));
        Estimate { amount: paired.saturating_mul(2).saturating_add(5_000_000), unit: "tables", per_second: 500_000 }
    }
}
