//! Both validators judge a structure alike.

use crate::support::erased::validate;
use std::fmt::Debug;
use twinedge::validate::reference::{Disagreement, compare, compare_first};
use twinedge::validate::{Collect, Expectation, Report, Rule, View};

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
    agreed(compare::<dyn View>(view, &expectation), view, expectation)
}

/// Asserts agreement on the first broken rule only, for very many structures.
pub(crate) fn agree_on_first<V: View + Debug>(view: &V, expectation: Expectation) -> Option<Rule> {
    agreed(compare_first::<dyn View>(view, &expectation), view, expectation)
}
