//! What the validator says of a table, in the form in which the reference answers.

use twinedge::validate::{Collect, Expectation, Rule, Table, validate};

/// Whether the validator takes the table for right, and the first rule that it finds broken.
pub(crate) fn judgement(table: &Table, expectation: Expectation) -> (bool, Option<Rule>) {
    // To stop at the first violation would not do: of rules that are run together it need not be the first one's.
    let report = validate(table, &expectation, Collect::AtMost(0));
    let first = report.outcomes().find(|(_, outcome)| outcome.violations > 0).map(|(rule, _)| rule);
    (report.is_valid(), first)
}

/// A judgement in words.
pub(crate) fn in_words(broken: Option<Rule>) -> String {
    broken.map_or_else(|| "right".to_owned(), |rule| format!("wrong by {rule}"))
}
