//! Both validators judge a structure alike.

use crate::support::erased::validate;
use std::fmt::Debug;
use twinedge::validate::{Collect, Expectation, Report, Rule, Table, View, Violation};
use twinedge_trials::opinions::{Disagreement, compare, compare_first};

/// The rules broken according to the report.
pub(crate) fn broken(report: &Report) -> Vec<Rule> {
    report.broken_rules().collect()
}

fn agreed<V: View + Debug>(
    compared: Result<Option<Rule>, Disagreement>,
    view: &V,
    expectation: Expectation,
) -> Option<Rule> {
    compared.unwrap_or_else(|disagreement| {
        let report = validate(view, &expectation, Collect::All);
        panic!("{disagreement}\n{view:#?}\n{expectation:?}\n{report}");
    })
}

/// Asserts that both validators agree, and returns the first broken rule.
pub(crate) fn agree<V: View + Debug>(view: &V, expectation: Expectation) -> Option<Rule> {
    agreed(compare(view, &expectation), view, expectation)
}

/// Asserts agreement on the first broken rule only, for very many structures.
pub(crate) fn agree_on_first<V: View + Debug>(view: &V, expectation: Expectation) -> Option<Rule> {
    agreed(compare_first(view, &expectation), view, expectation)
}

/// Asserts that these are all violations, of one rule, that the first of them is found first, and that the reference also
/// finds this rule first.
#[track_caller]
pub(crate) fn only(rule: Rule, table: &Table, expectation: Expectation, violations: &[Violation]) {
    let report = validate(table, &expectation, Collect::All);
    assert_eq!(report.violations(), violations, "{report}");
    assert_eq!(broken(&report), [rule], "{report}");
    assert_eq!(agree(table, expectation), Some(rule));
    assert_eq!(validate(table, &expectation, Collect::First).violations(), &violations[..1]);
}
