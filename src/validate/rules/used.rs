//! M1 used: some half-edge leaves every vertex.
//!
//! Checked if asked for.

use super::live::Census;
use super::passes_over;
use crate::validate::columns::column;
use crate::validate::findings::{Findings, Flow};
use crate::validate::report::Violation;
use crate::validate::rule::Rule;
use crate::validate::subject::Subject;

/// Runs M1, which needs live origins.
pub(crate) fn check(subject: Subject<'_>, census: &Census, findings: &mut Findings) -> Flow {
    if passes_over(subject, Rule::M1, census.links_broken(), findings) {
        return Ok(());
    }
    findings.checked(Rule::M1, census.vertices as u64);
    if census.isolated_vertices == 0 {
        return Ok(());
    }
    let mut used = column(subject.extent.vertices.0, false)?;
    for h in subject.half_edges() {
        if let Some(used) = used.get_mut(subject.origin(h) as usize) {
            *used = true;
        }
    }
    subject.vertices().filter(|v| !used[*v]).try_for_each(|vertex| findings.add(Violation::UnusedVertex { vertex }))
}
