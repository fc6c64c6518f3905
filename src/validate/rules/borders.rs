//! M6 borders: there are as many border loops as expected.
//!
//! ```text
//!   ┌─────────────┐
//!   │   ┌─────┐   │
//!   │   │     │   │    an annulus: two border loops
//!   │   └─────┘   │
//!   └─────────────┘
//! ```
//!
//! Checked if asked for.

use crate::validate::findings::Flow;
use crate::validate::rule::Rule;
use crate::validate::run::Run;
use crate::validate::view::View;
use crate::validate::violation::Violation;

/// Runs M6 on the number of border loops, which is known unless a rule that the counting relies on is broken.
pub(in crate::validate) fn check<V: View + ?Sized>(run: &mut Run<'_, V>) -> Flow {
    let broken = run.rotations_broken().or_else(|| run.borders_broken());
    if run.passes_over(Rule::M6, broken) {
        return Ok(());
    }
    run.findings.checked(Rule::M6, run.counts.components.unwrap_or(0) as u64);
    match (run.counts.borders, run.expect.expected_count(Rule::M6)) {
        (Some(found), Some(expected)) if found != expected => {
            run.findings.add(Violation::WrongBorders { found, expected })
        }
        _ => Ok(()),
    }
}
