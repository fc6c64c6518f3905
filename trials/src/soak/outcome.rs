//! The outcome of `soak`.

use super::work::SoakWork;
use crate::rows::{INTERRUPTED, add_rows, rows};
use crate::shard::Shard;
use crate::sum::Outcome;
use twinedge::program::conformance::ConformanceSummary;

/// The outcome of [`soak()`](crate::soak()).
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct SoakOutcome {
    /// The work.
    pub work: SoakWork,
    /// The part of it.
    pub shard: Shard,
    /// The seed of the programs.
    pub seed: u64,
    /// The counts of the programs, by structure.
    pub structures: Vec<SoakRow>,
    /// The first program that failed, made small. Later programs were not run, unless they had already started.
    pub failure: Option<SoakFailure>,
    /// True if the run was stopped early.
    pub interrupted: bool,
}

rows! {
    /// The counts of the programs on one structure.
    #[derive(Clone, Debug, PartialEq, Eq)]
    pub struct SoakRow {
        /// The structure.
        label on: String = "on" 10;
        /// Programs that ran to their end.
        count programs: u64 = "programs" 13;
        /// Programs that were interrupted. Their operators up to that point are counted.
        count cut_short: u64;
        /// Operators that were applied.
        count applied: u64 = "applied" 13;
        /// Operators that were refused, for the same reason as the reference.
        count refused: u64 = "refused" 13;
        /// Operators that found nothing to choose from.
        count skipped: u64 = "skipped" 13;
        /// Operators that the structure had no room for, or does not have.
        count no_room: u64 = "no room" 13;
    }
}

/// A program on which a structure fails, as small as possible.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SoakFailure {
    /// The structure.
    pub on: String,
    /// The number of the program for the seed.
    pub number: u32,
    /// The failure, in one line.
    pub message: String,
    /// The text of the program: [`Program`](twinedge::program::Program) reads it.
    pub program: String,
    /// A regression test, or the program as a Rust expression: see [`Structure::source`](crate::Structure::source).
    pub rust: String,
}

impl SoakRow {
    pub(super) fn of(on: &str) -> Self {
        Self { on: on.to_owned(), programs: 0, cut_short: 0, applied: 0, refused: 0, skipped: 0, no_room: 0 }
    }

    pub(super) fn count(&mut self, summary: &ConformanceSummary) {
        let total = summary.total();
        self.applied += total.applied as u64;
        self.refused += total.refused as u64;
        self.skipped += total.skipped as u64;
        self.no_room += (total.no_room + total.unsupported) as u64;
    }
}

impl Outcome for SoakOutcome {
    type Work = (Vec<String>, SoakWork);

    fn work(&self) -> Self::Work {
        (self.structures.iter().map(|row| row.on.clone()).collect(), self.work)
    }

    fn shard(&self) -> Shard {
        self.shard
    }

    fn is_interrupted(&self) -> bool {
        self.interrupted
    }

    fn reasons(&self) -> Vec<String> {
        let mut reasons = Vec::new();
        if self.interrupted {
            reasons.push(INTERRUPTED.to_owned());
        }
        if self.structures.is_empty() {
            reasons.push("no structure was given, so nothing was compared".to_owned());
        }
        if let Some(SoakFailure { on, number, message, rust, .. }) = &self.failure {
            reasons.push(format!("{on} differs from the reference in program {number}, {message}\n{rust}"));
        }
        reasons
    }

    fn absorb(&mut self, other: &Self) {
        add_rows(&mut self.structures, &other.structures);
        let failures = [self.failure.take(), other.failure.clone()];
        self.failure = failures.into_iter().flatten().min_by_key(|failure| failure.number);
    }

    fn complete(&mut self) {
        self.shard = Shard::WHOLE;
    }
}
