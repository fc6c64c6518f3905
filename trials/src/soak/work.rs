//! The work of `soak`.

use crate::random::Random;
use twinedge::program::{FacePick, Op, Program};

/// The work of `soak`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SoakWork {
    /// The number of programs.
    pub programs: u32,
    /// The number of operators of each.
    pub steps: u32,
    /// The seed of the programs.
    pub seed: u64,
}

impl SoakWork {
    /// Returns the program with this number. Always the same for the same seed and number of steps.
    #[must_use]
    pub fn program(&self, number: u32) -> Program {
        // Without a vertex, most operators have nothing to choose from.
        let first = Op::AddIsolatedVertex { face: FacePick::Unbounded };
        let mut bytes = Random::new(self.seed, number.into()).bytes();
        let ops = std::iter::from_fn(|| Op::from_bytes(&mut bytes));
        std::iter::once(first).chain(ops).take(self.steps as usize).collect()
    }
}
