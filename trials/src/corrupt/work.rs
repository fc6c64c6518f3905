//! The work of `corrupt`.

use crate::run::Estimate;

/// The work of `corrupt`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct CorruptWork {
    /// The largest number of edges of a map.
    pub edges: usize,
    /// The number of pairs of corruptions to sample.
    pub pairs: u32,
    /// The seed of the sample.
    pub seed: u64,
}

impl CorruptWork {
    /// Returns the approximate number of judged corruptions.
    #[must_use]
    pub fn estimate(&self) -> Estimate {
        // Approximately a third of 12ⁿ maps.
        let maps = 12_u128.saturating_pow(self.edges as u32).div_ceil(3) + 1;
        let of_each = 200 + 220 * (self.edges * self.edges) as u128;
        let amount = maps.saturating_mul(of_each).saturating_add(self.pairs.into());
        Estimate { amount, unit: "corruptions", per_second: 300_000 }
    }
}
