//! `sample`, with a correct validator and with faulty ones.

use std::collections::BTreeSet;
use std::sync::Mutex;
use twinedge::validate::{Expectation, Rule, Table};
use twinedge_trials::sample::{SampleResults, SampleWork};
use twinedge_trials::{Checker, Outcome, Run, Shard, Validator, Verdict, sample};

const WORK: SampleWork = SampleWork { tables: 20_000, seed: 11 };

fn count(outcome: &Outcome<SampleResults>, rule: Rule) -> u64 {
    outcome.first_broken.iter().find(|row| row.rule == rule).unwrap().wrong
}

#[test]
fn every_rule_but_the_last_is_often_the_first_broken_one() {
    let outcome = sample(WORK, &Validator, &Run::default()).into_result().unwrap();
    for rule in Rule::ALL.iter().filter(|rule| !rule.is_geometric() && !rule.is_optional()) {
        let wrong = count(&outcome, *rule);
        // At least one in a thousand. T4 follows from the other rules.
        assert_eq!(wrong >= WORK.tables / 1_000, *rule != Rule::T4, "{rule}: {wrong}");
    }
    assert!(outcome.right > WORK.tables / 10);
    assert_eq!(outcome.right + outcome.first_broken.iter().map(|row| row.wrong).sum::<u64>(), WORK.tables);
}

struct OffByOne;

impl Checker for OffByOne {
    fn check(&self, table: &Table, expectation: &Expectation) -> Verdict {
        let verdict = Validator.check(table, expectation);
        Verdict { broken: verdict.broken.map(|rule| Rule::ALL[rule.index() + 1]), ..verdict }
    }
}

#[test]
fn another_rule_is_a_disagreement() {
    let outcome = sample(WORK, &OffByOne, &Run::default());
    assert_eq!(outcome.disagreements, WORK.tables - outcome.right);
    assert!(outcome.findings[0].contains(" to the validator, wrong by "), "{}", outcome.findings[0]);
    let reasons = outcome.into_result().unwrap_err().to_string();
    assert!(reasons.starts_with("disagreements: "), "{reasons}");
}

/// The validator, which keeps the tables.
#[derive(Default)]
struct Keeper(Mutex<Vec<Table>>);

impl Checker for Keeper {
    fn check(&self, table: &Table, expectation: &Expectation) -> Verdict {
        Validator.check(table, expectation)
    }

    fn checked(&self, table: &Table, _: &Expectation, _: Verdict) {
        self.0.lock().unwrap().push(table.clone());
    }
}

fn tables(seed: u64, run: &Run<'_>) -> Vec<Table> {
    let keeper = Keeper::default();
    sample(SampleWork { tables: 2_500, seed }, &keeper, run);
    keeper.0.into_inner().unwrap()
}

#[test]
fn the_same_seed_makes_the_same_tables() {
    let one_thread = Run::default().threads(1);
    let ours = tables(1, &one_thread);
    assert_eq!(tables(1, &one_thread), ours);
    let texts = |tables: &[Table]| tables.iter().map(Table::to_string).collect::<BTreeSet<String>>();
    assert_eq!(texts(&tables(1, &one_thread.threads(3))), texts(&ours));
    let others = texts(&tables(2, &one_thread));
    let common = texts(&ours).intersection(&others).count();
    assert!(common < others.len() / 2, "{common} of {}", others.len());
    // Whole pieces of 1000.
    assert_eq!(tables(1, &one_thread.shard(Shard::new(2, 3).unwrap())), ours[2_000..]);
}
