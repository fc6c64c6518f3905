//! The validators called through a trait object. They are then compiled once per test binary instead of once per structure, which
//! is most of the compile time.

use twinedge::validate::{Collect, Expectation, Report, Rule, View, reference};

pub(crate) fn validate(view: &dyn View, expectation: &Expectation, collect: Collect) -> Report {
    twinedge::validate::validate(view, expectation, collect)
}

/// A whole plane subdivision.
pub(crate) fn validate_plane(view: &dyn View) -> Report {
    validate(view, &Expectation::plane(), Collect::All)
}

pub(crate) fn first_broken_rule(view: &dyn View, expectation: &Expectation) -> Option<Rule> {
    reference::first_broken_rule(view, expectation)
}

pub(crate) fn broken_rules(view: &dyn View, expectation: &Expectation) -> Vec<Rule> {
    reference::broken_rules(view, expectation)
}
