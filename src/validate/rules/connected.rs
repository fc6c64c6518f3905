//! M5 connected: there are as many components with an edge as expected.
//!
//! Checked if asked for.

use super::live::Census;
use super::passes_over;
use crate::validate::findings::{Findings, Flow};
use crate::validate::report::Violation;
use crate::validate::rule::Rule;
use crate::validate::subject::Subject;

/// Runs M5. Isolated vertices do not count.
pub(crate) fn check(subject: Subject<'_>, census: &Census, findings: &mut Findings) -> Flow {
    let broken = census.rotations_broken(findings);
    if passes_over(subject, Rule::M5, broken, findings) {
        return Ok(());
    }
    // An isolated vertex is a component without edges.
    let found = findings.counts.components.map(|all| all.saturating_sub(census.isolated_vertices));
    findings.checked(Rule::M5, found.unwrap_or(0) as u64);
    match (found, subject.extent.expect.expected_count(Rule::M5)) {
        (Some(found), Some(expected)) if found != expected => {
            findings.add(Violation::WrongComponents { found, expected })
        }
        _ => Ok(()),
    }
}
