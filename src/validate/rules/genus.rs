//! M7 genus: the genera of the components add up to the genus expected.
//!
//! ```text
//!      ______
//!    ╱  ____  ╲
//!   │  ╲____╱  │    a torus: genus 1
//!    ╲ ______ ╱
//! ```
//!
//! Checked if asked for.

use crate::validate::findings::Flow;
use crate::validate::rule::Rule;
use crate::validate::run::Run;
use crate::validate::view::View;
use crate::validate::violation::Violation;

/// Runs M7 on the sum that T3 has made.
pub(in crate::validate) fn check<V: View + ?Sized>(run: &mut Run<'_, V>) -> Flow {
    let broken = run.rotations_broken().or_else(|| run.findings.broken(&[Rule::T3]));
    if run.passes_over(Rule::M7, broken) {
        return Ok(());
    }
    run.findings.checked(Rule::M7, run.counts.components.unwrap_or(0) as u64);
    match (run.counts.genus, run.expect.expected_count(Rule::M7)) {
        (Some(found), Some(expected)) if found != expected => {
            run.findings.add(Violation::WrongGenus { found, expected })
        }
        _ => Ok(()),
    }
}
