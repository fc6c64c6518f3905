//! Many random programs, counted by finding.

use crate::entry::Entry;
use crate::judge::Judge;
use crate::program::{Operator, Program};
use crate::run::{Finding, Verdict};
use crate::shrink::shrink;
use std::collections::BTreeMap;
use std::path::PathBuf;

/// The options of a search.
#[derive(Clone, Debug)]
pub struct Search {
    /// The crate.
    pub entry: Entry,
    /// The number of programs.
    pub programs: u64,
    /// The seed of the programs. Equal seeds produce equal programs.
    pub seed: u64,
    /// The maximum number of steps of a program.
    pub steps: usize,
    /// Operators to leave out.
    pub without: Vec<String>,
    /// The program of this package, for the child process.
    pub executable: PathBuf,
}

/// The findings with one cause.
#[derive(Clone, Debug)]
pub struct Found {
    /// The number of programs in which it was the first finding.
    pub programs: u64,
    /// The shortest program.
    pub shortest: Program,
    /// The finding of the shortest program.
    pub finding: Finding,
}

/// The outcome of a search.
#[derive(Clone, Debug, Default)]
pub struct Outcome {
    /// The findings, by [signature](Finding::signature).
    pub found: BTreeMap<String, Found>,
    /// Calls that returned, in programs without findings.
    pub done: usize,
    /// Calls that returned an error, in programs without findings.
    pub refused: usize,
    /// Calls that were not made, in programs without findings.
    pub skipped: usize,
    /// The number of programs without findings.
    pub sound: u64,
}

impl Search {
    /// Runs the programs, and shrinks the first one for each cause.
    ///
    /// # Errors
    /// If no child process can be started.
    pub fn run(&self) -> std::io::Result<Outcome> {
        let mut judge = Judge::new(self.entry, self.executable.clone());
        let weight = |operator: &Operator| {
            let left_out = self.without.iter().any(|name| name == operator.name);
            Operator { weight: if left_out { 0 } else { operator.weight }, ..*operator }
        };
        let operators = self.entry.operators.iter().map(weight).collect::<Vec<_>>();
        let mut outcome = Outcome::default();
        for number in 0..self.programs {
            let program = Program::random(&operators, self.seed, number, self.steps);
            match judge.run(&program)? {
                Verdict::Sound { done, refused, skipped } => {
                    outcome.sound += 1;
                    outcome.done += done;
                    outcome.refused += refused;
                    outcome.skipped += skipped;
                }
                Verdict::Finding(finding) => {
                    let first = Found { programs: 0, shortest: program.clone(), finding: finding.clone() };
                    let found = outcome.found.entry(finding.signature()).or_insert(first);
                    found.programs += 1;
                    if program.0.len() < found.shortest.0.len() {
                        (found.shortest, found.finding) = (program, finding);
                    }
                }
            }
        }
        for (signature, found) in &mut outcome.found {
            found.shortest = shrink(&found.shortest, self.entry.operators, |candidate| {
                Ok::<_, std::io::Error>(match judge.run(candidate)? {
                    Verdict::Finding(finding) if finding.signature() == *signature => {
                        found.finding = finding;
                        true
                    }
                    _ => false,
                })
            })?;
        }
        Ok(outcome)
    }
}
