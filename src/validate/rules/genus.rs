//! M7 genus: the genera of the components add up to the genus expected.
//!
//! Checked if asked for.

use super::live::Census;
use super::passes_over;
use crate::validate::findings::{Findings, Flow};
use crate::validate::report::Violation;
use crate::validate::rule::Rule;
use crate::validate::subject::Subject;

/// Runs M7 on the sum that T3 has made.
pub(crate) fn check(subject: Subject<'_>, census: &Census, findings: &mut Findings) -> Flow {
    let broken = census.rotations_broken(findings).or_else(|| findings.broken(&[Rule::T3]));
    if passes_over(subject, Rule::M7, broken, findings) {
        return Ok(());
    }
    let found = findings.counts.genus;
    findings.checked(Rule::M7, findings.counts.components.unwrap_or(0) as u64);
    match (found, subject.extent.expect.expected_count(Rule::M7)) {
        (Some(found), Some(expected)) if found != expected => findings.add(Violation::WrongGenus { found, expected }),
        _ => Ok(()),
    }
}
