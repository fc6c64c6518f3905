//! An audit as text.

use crate::diagnosis_text::{write, write_explanations, write_more, write_rule};
use crate::report::{AuditReport, CoverageStyle, Note};
use crate::verdict::Verdict;
use crate::words::plain;
use crate::words::style::{BAD, GOOD, QUIET};
use std::fmt::Write as _;

/// The audit for people.
pub(crate) fn text(report: &AuditReport) -> Result<String, std::fmt::Error> {
    let CoverageStyle { is_rule, worst, decimals } = report.style;
    let mut out = String::new();
    writeln!(out, "{}", plain(&report.input))?;
    for note in &report.notes {
        match note {
            Note::Plain(note) | Note::Detail(note) => writeln!(out, "{QUIET}{note}{QUIET:#}")?,
            Note::Warning(warning) => writeln!(out, "{BAD}warning{BAD:#}: {warning}")?,
        }
    }
    out.push('\n');
    for (what, count) in &report.counts {
        writeln!(out, "  {what:38} {count:>12}")?;
    }
    out.push('\n');
    report.rules.iter().filter(|rule| rule.applies()).try_for_each(|rule| write_rule(&mut out, rule))?;
    let coverage = report.coverage.as_ref().filter(|coverage| coverage.has_polygons());
    if let Some(coverage) = coverage {
        out.push('\n');
        coverage.write_rules(&mut out, is_rule)?;
    }
    out.push('\n');
    for (listed, total) in [(&report.findings, report.finding_count), (&report.violations, report.violation_count)] {
        for one in listed.iter().filter(|one| one.follows_from.is_none() && one.accepted.is_none()) {
            write(&mut out, one, decimals)?;
        }
        write_more(&mut out, total, listed.len())?;
        write_explanations(&mut out, listed)?;
    }
    if let Some(coverage) = coverage {
        coverage.write_worst(&mut out, worst, decimals)?;
    }
    for one in report.violations.iter().filter(|one| one.follows_from.is_some()) {
        write(&mut out, one, decimals)?;
    }
    report.remarks.iter().try_for_each(|remark| writeln!(out, "{remark}"))?;
    // The first word is coloured.
    let verdict = report.sentence();
    let (word, rest) = verdict.split_once(':').unwrap_or((&verdict, ""));
    let style = if report.verdict() == Verdict::Valid { GOOD } else { BAD };
    writeln!(out, "{style}{word}{style:#}:{rest} ({:.0} ms)", report.elapsed_ms)?;
    Ok(out)
}
