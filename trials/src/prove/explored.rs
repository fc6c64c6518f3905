//! Counts that are kept while maps are explored.

use super::outcome::Finding;
use crate::rows::{MOST_FINDINGS, add_findings};
use std::collections::{BTreeMap, BTreeSet};
use twinedge::program::{Op, Program};

pub(super) type Size = (usize, usize);

#[derive(Clone, Debug, Default)]
pub(super) struct Tally {
    /// Distinct maps, by their canonical form.
    pub(super) maps: u64,
    pub(super) applied: u64,
    pub(super) refused: u64,
    /// Distinct maps when no face is distinguished as the outside. Of connected maps only.
    pub(super) sensed: u64,
    pub(super) rooted: u64,
    pub(super) violations: u64,
}

impl Tally {
    pub(super) const fn add(&mut self, other: &Self) {
        self.maps += other.maps;
        self.applied += other.applied;
        self.refused += other.refused;
        self.sensed += other.sensed;
        self.rooted += other.rooted;
        self.violations += other.violations;
    }
}

#[derive(Debug, Default)]
pub(super) struct Exploration {
    pub(super) tallies: BTreeMap<Size, Tally>,
    /// The operators that were refused as unsupported.
    pub(super) unsupported: BTreeSet<&'static str>,
    pub(super) findings: Vec<Finding>,
}

impl Exploration {
    pub(super) fn tally(&mut self, size: Size) -> &mut Tally {
        self.tallies.entry(size).or_default()
    }

    /// Counts a fault on a map of this size, made by a program, with an operator or without.
    pub(super) fn note(&mut self, size: Size, program: &Program, op: Option<Op>, message: String) {
        self.tally(size).violations += 1;
        if self.findings.len() < MOST_FINDINGS {
            let program = program.0.iter().copied().chain(op).collect::<Program>();
            let operator = op.map(|op| op.to_string());
            self.findings.push(Finding { program: program.to_string(), operator, message });
        }
    }

    pub(super) fn add(&mut self, other: Self) {
        for (size, tally) in other.tallies {
            self.tally(size).add(&tally);
        }
        self.unsupported.extend(other.unsupported);
        add_findings(&mut self.findings, &other.findings);
    }
}
