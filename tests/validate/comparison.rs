//! The comparison of both validators finds and identifies differences.

use crate::support::nested::{PLANE, nested};
use crate::support::tables::{half_edge, vertex};
use std::cell::Cell;
use twinedge::delegate_view;
use twinedge::validate::reference::broken_rules;
use twinedge::validate::{Collect, Link, Rule, Table, View, validate};
use twinedge_trials::opinions::{Disagreement, compare, compare_first, disagreement};

/// A table whose twins are correct a number of times, and then nil.
struct Forgetful<'a>(&'a Table, Cell<usize>);

impl View for Forgetful<'_> {
    delegate_view!(|this| this.0; except twin);

    fn twin(&self, half_edge: usize) -> Link {
        let left = self.1.get().checked_sub(1)?;
        self.1.set(left);
        self.0.twin(half_edge)
    }
}

#[test]
fn a_structure_that_changes_between_the_validators_is_a_difference() {
    let table = nested();
    // The fast path asks for each of the 12 twins twice.
    let forgetful = || Forgetful(&table, Cell::new(24));
    let expected = Disagreement::FirstBrokenRule { fast: None, reference: Some(Rule::R1) };
    assert_eq!(compare(&forgetful(), &PLANE), Err(expected));
    assert_eq!(compare_first(&forgetful(), &PLANE), Err(expected));
    assert_eq!(expected.to_string(), "the first broken rule is none by the fast validator, R1 by the reference");
}

#[test]
fn a_later_rule_on_which_they_differ_is_named() {
    let mut table = nested();
    vertex(&mut table, 0).leaving = Some(2);
    half_edge(&mut table, 0).twin = Some(3);
    let report = validate(&table, &PLANE, Collect::All);
    let broken = broken_rules(&table, &PLANE);
    assert_eq!(disagreement(&report, &broken), None);
    assert!(broken.contains(&Rule::V1), "{broken:?}");
    let without = |rule| broken.iter().copied().filter(|r| *r != rule).collect::<Vec<_>>();
    let difference = disagreement(&report, &without(Rule::V1)).unwrap();
    assert_eq!(difference, Disagreement::LaterRule { rule: Rule::V1, fast: true });
    assert_eq!(difference.to_string(), "V1 is broken by the fast validator, but not by the reference");
    let with_more = [&broken[..], &[Rule::F1]].concat();
    let difference = disagreement(&report, &with_more).unwrap();
    assert_eq!(difference, Disagreement::LaterRule { rule: Rule::F1, fast: false });
    // A rule that the fast validator does not check is not compared.
    assert_eq!(disagreement(&report, &without(Rule::V2)), None);
}

#[test]
fn references_and_boxes_of_views_are_judged_as_the_views() {
    let mut table = nested();
    half_edge(&mut table, 0).twin = Some(0);
    let report = validate(&table, &PLANE, Collect::All);
    let by_reference: &dyn View = &table;
    assert_eq!(validate(&by_reference, &PLANE, Collect::All), report);
    let boxed: Box<dyn View> = Box::new(table.clone());
    assert_eq!(validate(&boxed, &PLANE, Collect::All), report);
    assert_eq!(Table::copy_of(&boxed), Some(table));
}
