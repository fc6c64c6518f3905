//! The outcome of `sample`.

use super::work::SampleWork;
use crate::corrupt::RuleRow;
use crate::rows::{INTERRUPTED, add_findings, add_rows};
use crate::shard::Shard;
use crate::sum::Outcome;

/// The outcome of [`sample()`](crate::sample()).
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct SampleOutcome {
    /// The work.
    pub work: SampleWork,
    /// The part of it.
    pub shard: Shard,
    /// The number of judged tables.
    pub judged: u64,
    /// The number of valid ones, by the reference.
    pub right: u64,
    /// For each rule, the number of tables that break it first, by the reference.
    pub first_broken: Vec<RuleRow>,
    /// The number of differences between the validator and the reference.
    pub disagreements: u64,
    /// The first disagreements. All are counted.
    pub findings: Vec<String>,
    /// True if the run was stopped early.
    pub interrupted: bool,
}

impl Outcome for SampleOutcome {
    type Work = SampleWork;

    fn work(&self) -> SampleWork {
        self.work
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
        if self.disagreements > 0 {
            reasons.push(format!("disagreements: {}", self.disagreements));
            reasons.extend(self.findings.iter().cloned());
        }
        reasons
    }

    fn absorb(&mut self, other: &Self) {
        self.judged += other.judged;
        self.right += other.right;
        add_rows(&mut self.first_broken, &other.first_broken);
        self.disagreements += other.disagreements;
        add_findings(&mut self.findings, &other.findings);
    }

    fn complete(&mut self) {
        self.shard = Shard::WHOLE;
    }
}
