//! Random tables, valid or invalid.
//!
//! Beyond all small tables, these are maps of several components with nesting, vacant rows and records in random order. They come
//! from random programs, and from random rotation systems with random containment. The latter may have handles (T3), components
//! nested in themselves (T2), no outside or two (T1), and two merged vertices (V2), which programs never make. Most of them are
//! then damaged, usually with unchanged counts: two cells, two records, two cycles or the lists of two faces are exchanged.
//!
//! Each rule except T4 is often the first broken one. T4 follows from the others.

mod damage;
mod outcome;
mod rotations;
mod subdivision;
mod work;

pub use outcome::SampleOutcome;
pub use work::SampleWork;

use crate::corrupt::RuleRow;
use crate::rows::add_findings;
use crate::run::Run;
use crate::verdict::{Checker, in_words};
use std::collections::BTreeMap;
use twinedge::validate::reference::first_broken_rule;
use twinedge::validate::{Expectation, Rule, Table};

/// Judges random tables by a validator and by the reference. O(1) for each table: it has at most about 40 edges.
///
/// The tables are always the same for the same seed, on any number of threads, in any order.
///
/// # Panics
/// If the checker panics.
///
/// # Examples
/// ```
/// use twinedge_trials::sample::SampleWork;
/// use twinedge_trials::{Outcome, Run, Validator, sample};
/// let outcome = sample(SampleWork { tables: 2_000, seed: 1 }, &Validator, &Run::default()).into_result()?;
/// assert!(outcome.right > 100 && outcome.right < outcome.judged);
/// # Ok::<(), twinedge_trials::Failed>(())
/// ```
pub fn sample(work: SampleWork, checker: &dyn Checker, run: &Run<'_>) -> SampleOutcome {
    let pieces: Vec<usize> = run.part().numbers(work.pieces() as usize).collect();
    let found = run.each("tables", pieces.len(), Judgement::default, |judged, position| {
        for table in work.piece(pieces[position] as u64) {
            if run.is_stopped() {
                return;
            }
            judged.compare(&table, checker);
        }
    });
    let mut all = Judgement::default();
    for judged in &found {
        all.add(judged);
    }
    let rules = Rule::ALL.iter().filter(|rule| !rule.is_geometric() && !rule.is_optional());
    SampleOutcome {
        work,
        shard: run.part(),
        judged: all.tables,
        right: all.right,
        first_broken: rules.map(|rule| RuleRow { rule: *rule, wrong: all.count(*rule) }).collect(),
        disagreements: all.disagreements,
        findings: all.findings,
        interrupted: run.is_stopped(),
    }
}

#[derive(Default)]
struct Judgement {
    tables: u64,
    right: u64,
    first_broken: BTreeMap<Rule, u64>,
    disagreements: u64,
    findings: Vec<String>,
}

impl Judgement {
    fn compare(&mut self, table: &Table, checker: &dyn Checker) {
        let expectation = Expectation::plane();
        let verdict = checker.check(table, &expectation);
        let reference = first_broken_rule(table, &expectation);
        self.tables += 1;
        match reference {
            Some(rule) => *self.first_broken.entry(rule).or_default() += 1,
            None => self.right += 1,
        }
        if !verdict.agrees(reference) {
            self.disagreements += 1;
            let finding = format!("{verdict} to the validator, {} to the reference:\n{table}", in_words(reference));
            add_findings(&mut self.findings, &[finding]);
        }
        checker.checked(table, &expectation, verdict);
    }

    fn count(&self, rule: Rule) -> u64 {
        self.first_broken.get(&rule).copied().unwrap_or(0)
    }

    fn add(&mut self, other: &Self) {
        self.tables += other.tables;
        self.right += other.right;
        for (rule, count) in &other.first_broken {
            *self.first_broken.entry(*rule).or_default() += count;
        }
        self.disagreements += other.disagreements;
        add_findings(&mut self.findings, &other.findings);
    }
}
