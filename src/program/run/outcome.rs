//! The outcome of one operator of a program.

use crate::program::subject::Refusal;

/// The outcome of one operator of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum StepOutcome {
    /// The subject did it.
    Applied,
    /// The subject refused.
    Refused(Refusal),
    /// The subject was not called, because there is nothing (no half-edge, no stale handle, …) to choose from.
    Skipped,
}

impl core::fmt::Display for StepOutcome {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Applied => f.write_str("applied"),
            Self::Refused(refusal) => write!(f, "refused: {refusal}"),
            Self::Skipped => f.write_str("skipped: nothing to choose from"),
        }
    }
}
