//! `corrupt` and `tables`, with correct validators and with faulty ones.

use super::incomplete::Partial;
use super::{limited, pointers, slots};
use std::sync::atomic::{AtomicU64, Ordering};
use twinedge::validate::{Expectation, Part, Rule, Table};
use twinedge_trials::corrupt::{CorruptResults, CorruptWork, ExpectationRow, Family, Tally, abort};
use twinedge_trials::tables::{TablesResults, TablesWork};
use twinedge_trials::{Checker, Outcome, Run, Structure, StructureError, Validator, Verdict, corrupt, tables};

/// A validator that changes the correct verdict.
struct Wrong(fn(Verdict) -> Verdict);

impl Checker for Wrong {
    fn check(&self, table: &Table, expectation: &Expectation) -> Verdict {
        self.0(Validator.check(table, expectation))
    }
}

const WORK: CorruptWork = CorruptWork { edges: 1, pairs: 1_000, seed: 7 };

fn corrupted(checker: &dyn Checker) -> Outcome<CorruptResults> {
    corrupt(&slots(), WORK, checker, &Run::default(), &abort).unwrap()
}

fn judged(checker: &dyn Checker) -> Outcome<TablesResults> {
    tables(TablesWork { half_edges: 0 }, checker, &Run::default())
}

fn total(outcome: &Outcome<CorruptResults>, count: fn(&Tally) -> u64) -> u64 {
    outcome.fields.iter().map(|row| count(&row.tally)).sum()
}

#[test]
fn the_validator_misses_nothing() {
    let outcome = corrupted(&Validator).into_result().unwrap();
    assert_eq!((outcome.maps, outcome.maps_found, outcome.unusable), (7, 7, 0));
    assert_eq!(total(&outcome, |tally| tally.wrong), total(&outcome, |tally| tally.caught));
    assert!(total(&outcome, |tally| tally.corruptions) > total(&outcome, |tally| tally.wrong));
    assert_eq!(outcome.pairs.tally.corruptions, 1_000);
    let tables = tables(TablesWork { half_edges: 2 }, &Validator, &Run::default()).into_result().unwrap();
    let judged = |free: &str| tables.tables.iter().find(|row| row.free == free).unwrap().judged;
    // Ten links, each to one of two records or nil.
    assert_eq!(judged("origin, twin, next, prev, leaving; nil"), 3_u64.pow(10));
    // An edge or a loop: `next` of two half-edges, for the only way to pair them.
    assert_eq!(judged("next, for all twins; surfaces"), 4);
}

#[test]
fn every_field_and_exchange_of_the_maps_of_two_edges_is_wrong_at_times_and_caught() {
    let work = CorruptWork { edges: 2, pairs: 2_000, seed: 7 };
    let outcome = corrupt(&slots(), work, &Validator, &Run::default(), &abort).unwrap().into_result().unwrap();
    // All subdivisions of up to 2 edges and 3 vertices, as counted by `prove`: 4 without edges, 8 with one, 36 with two.
    assert_eq!((outcome.maps, outcome.maps_found), (48, 48));
    let of_form = |form: Family| outcome.fields.iter().filter(|row| row.form == form).count();
    // Besides the fields: cells, records, cycles, lists, twins and nexts exchanged, cycles joined and moved, loops halved, entries repeated.
    assert_eq!(of_form(Family::Records), 5 + 2 + 3 + 2 + 10);
    assert_eq!(of_form(Family::Textbook), 5 + 1 + 2 + 10);
    // Every form has one field, exchanged or not, and unchanged tables.
    assert_eq!(of_form(Family::Every), 2 + 11);
    let pairs = [&outcome.small_pairs, &outcome.pairs.tally];
    for tally in outcome.fields.iter().map(|row| &row.tally).chain(pairs) {
        assert_eq!((tally.disagreements(), tally.wrong), (0, tally.caught), "{tally:?}");
        assert!(tally.caught > 0 && tally.corruptions >= tally.wrong, "{tally:?}");
    }
    // A vertex with two half-edges may store either, and a face any half-edge of its cycle.
    let tally = |field: &str| &outcome.fields.iter().find(|row| row.field == field).unwrap().tally;
    assert!(tally("vertex: leaving").wrong < tally("vertex: leaving").corruptions);
    assert_eq!(tally("half-edge: twin").wrong, tally("half-edge: twin").corruptions);
    // T4 follows from the earlier rules.
    let never = outcome.first_broken.iter().filter(|row| row.wrong == 0).map(|row| row.rule);
    assert_eq!(never.collect::<Vec<_>>(), [Rule::T4]);
    assert!(outcome.expectations.iter().all(|row| row.corruptions > 400 && row.first_broken.len() >= 5));
    assert_eq!((outcome.pairs.seed, outcome.pairs.tally.corruptions), (7, 2_000));
}

/// Breaking T1, T2 or T3 and no earlier rule takes changes of many fields, which single corruptions never make.
#[test]
fn a_validator_that_is_blind_to_a_late_rule_is_noticed_in_every_form() {
    let blind: [fn(Verdict) -> Verdict; 3] = [
        |verdict| if verdict.broken == Some(Rule::T1) { Verdict { valid: true, broken: None } } else { verdict },
        |verdict| if verdict.broken == Some(Rule::T2) { Verdict { valid: true, broken: None } } else { verdict },
        |verdict| if verdict.broken == Some(Rule::T3) { Verdict { valid: true, broken: None } } else { verdict },
    ];
    let work = CorruptWork { edges: 2, pairs: 0, seed: 0 };
    for blind in blind {
        let outcome = corrupt(&slots(), work, &Wrong(blind), &Run::default(), &abort).unwrap();
        for form in [Family::Records, Family::Textbook, Family::Every] {
            let missed = outcome.fields.iter().filter(|row| row.form == form).map(|row| row.tally.missed).sum::<u64>();
            assert!(missed > 0, "{form:?}");
        }
        assert!(outcome.findings[0].contains("exchanged: "), "{}", outcome.findings[0]);
    }
}

/// Every rule that an expectation checks is the first broken one for some table in its form, except for implied rules.
#[test]
fn every_expectation_sees_every_rule_broken() {
    let work = CorruptWork { edges: 2, pairs: 0, seed: 0 };
    let outcome = corrupt(&slots(), work, &Validator, &Run::default(), &abort).unwrap().into_result().unwrap();
    assert_eq!(outcome.expectations.len(), 115);
    assert_eq!(outcome.never_first_broken().collect::<Vec<_>>(), []);
    let rules = |number: usize| outcome.expectations[number].first_broken.len();
    // The plane with every part: all but T4. The fewest rules checked: R1, L1, L2, L3, V2.
    assert_eq!((rules(0), (0..112).map(rules).min()), (13, Some(5)));
    let asked = |number: usize| {
        let row: &ExpectationRow = &outcome.expectations[number];
        let asked = row.first_broken.iter().filter(|row| row.rule.is_optional());
        (row.expectation.clone(), asked.map(|row| row.rule.id()).collect::<Vec<_>>())
    };
    let surface = "surface, open, without lists of inner boundary components, unbounded face, asking for";
    assert_eq!(asked(112), (format!("{surface} M1, M2, M3, M4, M5, M6, M7"), vec!["M1", "M2", "M3", "M4"]));
    assert_eq!(asked(113), (format!("{surface} M5, M6, M7"), vec!["M5", "M6", "M7"]));
    assert_eq!(asked(114), (format!("{surface} M8"), vec!["M8"]));
    // With one edge there is nothing to nest: this is reported, and no failure.
    let small = corrupted(&Validator);
    assert!(small.never_first_broken().any(|(_, rule)| rule == Rule::T3) && small.is_ok());
    // Without the tables of a rule, it is a failure.
    let mut less = outcome;
    let row = less.expectations[0].first_broken.iter_mut().find(|row| row.rule == Rule::T2).unwrap();
    row.wrong = 0;
    assert!(less.reasons()[0].ends_with("breaks first: 1, as T2 of plane"), "{:?}", less.reasons());
}

#[test]
fn a_validator_that_finds_nothing_misses_all() {
    let blind = Wrong(|_| Verdict { valid: true, broken: None });
    let outcome = corrupted(&blind);
    assert_eq!(total(&outcome, |tally| tally.missed), total(&outcome, |tally| tally.wrong));
    assert!(outcome.findings[0].contains("and the validator takes it for right"), "{}", outcome.findings[0]);
    let reasons = outcome.into_result().unwrap_err().to_string();
    assert!(reasons.contains("no wrong table was caught"), "{reasons}");
    let outcome = judged(&blind);
    assert!(outcome.tables[0].disagreements > 0 && outcome.tables[0].right == outcome.tables[0].all);
    assert!(outcome.findings[0].starts_with("right to the validator, wrong by "), "{}", outcome.findings[0]);
    assert!(!outcome.is_ok());
}

#[test]
fn a_validator_that_finds_fault_with_all_gives_false_alarms() {
    let outcome = corrupted(&Wrong(|_| Verdict { valid: false, broken: Some(Rule::R1) }));
    let right = total(&outcome, |tally| tally.corruptions) - total(&outcome, |tally| tally.wrong);
    assert_eq!(total(&outcome, |tally| tally.false_alarms), right);
    assert!(total(&outcome, |tally| tally.other_rule) > 0 && total(&outcome, |tally| tally.missed) == 0);
    assert!(!outcome.is_ok());
}

#[test]
fn a_validator_that_contradicts_itself_differs() {
    let outcome = judged(&Wrong(|verdict| Verdict { valid: !verdict.valid, ..verdict }));
    assert_eq!(outcome.tables[0].disagreements, outcome.tables[0].all);
}

#[test]
fn a_validator_that_panics_is_reported() {
    let outcome = corrupted(&Wrong(|verdict| if verdict.valid { verdict } else { panic!("planted") }));
    let wrong = total(&outcome, |tally| tally.wrong) + outcome.small_pairs.wrong + outcome.pairs.tally.wrong;
    assert_eq!(outcome.panics, wrong);
    assert!(outcome.findings[0].contains("the validator panics: planted ("), "{}", outcome.findings[0]);
    assert!(outcome.reasons().iter().any(|reason| reason.starts_with("validations that panicked: ")));
}

#[test]
fn a_slow_validation_counts_as_hung() {
    struct Slow(AtomicU64);
    impl Checker for Slow {
        fn check(&self, table: &Table, expectation: &Expectation) -> Verdict {
            // Slow whenever the first table is timed.
            if self.0.fetch_add(1, Ordering::Relaxed) < 3 {
                std::thread::sleep(std::time::Duration::from_millis(1_010));
            }
            Validator.check(table, expectation)
        }
    }
    let work = CorruptWork { edges: 0, pairs: 0, seed: 0 };
    let run = Run::default().threads(1);
    let outcome = corrupt(&slots(), work, &Slow(0.into()), &run, &abort).unwrap();
    assert_eq!(outcome.hung, 1);
    assert!(outcome.findings[0].contains("the validator takes 1.0 s"), "{}", outcome.findings[0]);
}

#[test]
fn each_table_is_shown_once_with_its_verdict() {
    #[derive(Default)]
    struct Counting {
        tables: AtomicU64,
        right: AtomicU64,
    }
    impl Checker for Counting {
        fn check(&self, table: &Table, expectation: &Expectation) -> Verdict {
            Validator.check(table, expectation)
        }
        fn checked(&self, table: &Table, expectation: &Expectation, verdict: Verdict) {
            assert_eq!(Validator.check(table, expectation), verdict);
            self.tables.fetch_add(1, Ordering::Relaxed);
            self.right.fetch_add(verdict.valid.into(), Ordering::Relaxed);
        }
    }
    let counting = Counting::default();
    let outcome = judged(&counting);
    assert_eq!(
        (counting.tables.into_inner(), counting.right.into_inner()),
        (outcome.tables[0].judged, outcome.tables[0].right)
    );
    let counting = Counting::default();
    let outcome = corrupted(&counting);
    let all = total(&outcome, |tally| tally.corruptions) + outcome.small_pairs.corruptions + 1_000;
    assert_eq!(counting.tables.into_inner(), all);
}

#[test]
fn a_structure_without_records_for_boundary_components_has_one_form() {
    let model = pointers();
    let outcome = corrupt(&model, WORK, &Validator, &Run::default(), &abort).unwrap();
    assert!(outcome.is_ok(), "{:?}", outcome.reasons());
    assert!(outcome.fields.iter().all(|row| row.form == Family::Textbook));
    assert_eq!(outcome.maps, 7);
}

#[test]
fn maps_that_the_structure_does_not_make_are_reported() {
    // The first program makes and removes a loop: there is room for that, but not for two vertices.
    let small = Structure::new("small", || limited([1, 1, 2, 2]), Expectation::plane());
    let outcome = corrupt(&small, WORK, &Validator, &Run::default(), &abort).unwrap();
    assert!(outcome.unusable > 0 && outcome.maps > 0, "{outcome:?}");
    assert_eq!(outcome.maps + outcome.unusable, outcome.maps_found);
    assert!(
        outcome.findings[0].contains("should be applied, but is refused: there is no room"),
        "{}",
        outcome.findings[0]
    );
    assert!(!outcome.is_ok());
}

#[test]
fn a_structure_whose_maps_cannot_be_told_apart_is_an_error() {
    let less = Structure::new("less", || Partial::without(Part::Faces), Expectation::plane());
    let error = corrupt(&less, WORK, &Validator, &Run::default(), &abort).unwrap_err();
    assert_eq!(error, StructureError::Lacks(Part::Faces));
}
