//! M6 borders: there are as many border loops as expected.
//!
//! Checked if asked for.

use super::live::Census;
use super::{borders_broken, passes_over};
use crate::validate::findings::{Findings, Flow};
use crate::validate::report::Violation;
use crate::validate::rule::Rule;
use crate::validate::subject::Subject;

/// Runs M6 on the number of border loops, which is known unless a rule that the counting relies on is broken.
pub(crate) fn check(subject: Subject<'_>, census: &Census, findings: &mut Findings) -> Flow {
    let broken = census.rotations_broken(findings).or_else(|| borders_broken(subject, findings));
    if passes_over(subject, Rule::M6, broken, findings) {
        return Ok(());
    }
    let found = findings.counts.borders;
    findings.checked(Rule::M6, findings.counts.components.unwrap_or(0) as u64);
    match (found, subject.extent.expect.expected_count(Rule::M6)) {
        (Some(found), Some(expected)) if found != expected => findings.add(Violation::WrongBorders { found, expected }),
        _ => Ok(()),
    }
}
