//! M5 connected: there are as many components with an edge as expected.
//!
//! ```text
//!   ·───·     ·───·
//!   │ ╱       │ ╱      two components
//!   ·         ·
//! ```
//!
//! Checked if asked for.

use crate::validate::findings::Flow;
use crate::validate::rule::Rule;
use crate::validate::run::Run;
use crate::validate::view::View;
use crate::validate::violation::Violation;

/// Runs M5. Isolated vertices do not count.
pub(in crate::validate) fn check<V: View + ?Sized>(run: &mut Run<'_, V>) -> Flow {
    if run.passes_over(Rule::M5, run.rotations_broken()) {
        return Ok(());
    }
    // An isolated vertex is a component without edges.
    let found = run.counts.components.map_or(0, |all| all.saturating_sub(run.counts.isolated_vertices));
    run.findings.checked(Rule::M5, found as u64);
    match run.expect.expected_count(Rule::M5) {
        Some(expected) if found != expected => run.findings.add(Violation::WrongComponents { found, expected }),
        _ => Ok(()),
    }
}
