//! Two opinions on one structure: the fast validator and the reference validator.

use std::fmt::Debug;
use twinedge::validate::reference::{broken_rules, first_broken_rule};
use twinedge::validate::{Collect, Expectation, Report, Rule, Unchecked, View, validate};

/// The rules that the report says are broken.
pub(crate) fn broken(report: &Report) -> Vec<Rule> {
    report.outcomes().filter(|(_, outcome)| outcome.violations > 0).map(|(rule, _)| rule).collect()
}

/// Asserts that both validators judge the structure alike, and returns the first broken rule.
///
/// Alike means: valid for both or for neither; the same first broken rule; and where every link is live, the same
/// verdict on every rule that the fast validator did not decline to check because of another.
pub(crate) fn agree<V: View + Debug>(view: &V, expectation: Expectation) -> Option<Rule> {
    let report = validate(view, &expectation, Collect::All);
    let (fast, slow) = (broken(&report), broken_rules(view, &expectation));
    let shown = || format!("{view:#?}\n{expectation:?}\nreference: {slow:?}\n{report}");
    assert_eq!(report.is_valid(), slow.is_empty(), "{}", shown());
    assert_eq!(fast.first(), slow.first(), "{}", shown());
    if fast.first() != Some(&Rule::R1) {
        for (rule, outcome) in report.outcomes() {
            let declined = matches!(outcome.unchecked, Some(Unchecked::Broken(_)));
            assert!(declined || fast.contains(&rule) == slow.contains(&rule), "{rule}: {}", shown());
        }
    }
    slow.first().copied()
}

/// The same for very many structures: only the first broken rule is compared.
pub(crate) fn agree_on_first<V: View + Debug>(view: &V, expectation: Expectation) -> Option<Rule> {
    let report = validate(view, &expectation, Collect::AtMost(0));
    let fast = report.outcomes().find(|(_, outcome)| outcome.violations > 0).map(|(rule, _)| rule);
    let slow = first_broken_rule(view, &expectation);
    assert_eq!(fast, slow, "{view:#?}\n{expectation:?}\n{report}");
    assert_eq!(report.is_valid(), slow.is_none(), "{view:#?}\n{expectation:?}\n{report}");
    slow
}
