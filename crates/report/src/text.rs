//! An audit as text.

use crate::coverage::words;
use crate::diagnosis_text::{write, write_explanations, write_more, write_rule};
use crate::report::{AuditReport, CoverageStyle, Note};
use crate::verdict::Verdict;
use crate::words::style::{BAD, DOUBTFUL, GOOD, QUIET};
use crate::words::{counted, grouped, plain};
use std::collections::{BTreeMap, HashMap};
use std::fmt::{Result, Write as _};
use twinedge_coverage::CoverageRule;
use twinedge_diagnosis::Diagnosis;

const SHOWN: usize = 3;

/// Returns the audit for people: causes, each with the number of its consequences.
pub(crate) fn text(report: &AuditReport) -> std::result::Result<String, std::fmt::Error> {
    let CoverageStyle { is_rule, list, decimals } = report.style;
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
    let mut causes = Causes { out: &mut out, follow: report.consequences(), is_listed: list.is_some(), decimals };
    if let Some(coverage) = coverage {
        for (rule, count) in coverage.counts() {
            let of_rule = coverage.findings().iter().filter(|one| one.rule == Some(rule.id()));
            let others = of_rule.clone().filter(|one| !is_cause(one)).count();
            let shown: Vec<&Diagnosis> = of_rule.filter(|one| is_cause(one)).take(list.unwrap_or(SHOWN)).collect();
            shown.iter().try_for_each(|one| causes.write(one))?;
            write_explanations(causes.out, shown.iter().copied())?;
            let more = count - others - shown.len();
            if more > 0 && !shown.is_empty() {
                writeln!(causes.out, "   {QUIET}… and {} more of {}; see --list{QUIET:#}", grouped(more), rule.id())?;
            }
        }
    }
    for (listed, total) in [(&report.findings, report.finding_count), (&report.violations, report.violation_count)] {
        listed.iter().filter(|one| is_cause(one)).try_for_each(|one| causes.write(one))?;
        write_more(causes.out, total, listed.len())?;
        write_explanations(causes.out, listed.iter().filter(|one| is_cause(one)))?;
    }
    report.remarks.iter().chain(&report.advice()).try_for_each(|remark| writeln!(out, "{remark}"))?;
    let verdict = report.sentence();
    // Only the first words are coloured.
    let (words, rest) = verdict.split_at(verdict.find([':', '\u{b7}']).unwrap_or(verdict.len()));
    let style = match report.verdict() {
        Verdict::Valid if rest.starts_with(':') => GOOD,
        Verdict::Valid => DOUBTFUL,
        _ => BAD,
    };
    writeln!(out, "{style}{words}{style:#}{rest} ({:.0} ms)", report.elapsed_ms)?;
    Ok(out)
}

/// Returns true if the diagnosis has no cause and is not accepted.
fn is_cause(one: &Diagnosis) -> bool {
    one.follows_from.is_none() && one.accepted.is_none()
}

struct Causes<'a> {
    out: &'a mut String,
    follow: HashMap<&'a str, Vec<&'a Diagnosis>>,
    /// True to write consequences; otherwise they are only counted.
    is_listed: bool,
    decimals: usize,
}

impl Causes<'_> {
    fn write(&mut self, one: &Diagnosis) -> Result {
        write(self.out, one, self.decimals)?;
        let all = one.id.as_deref().and_then(|id| self.follow.get(id)).map(Vec::as_slice).unwrap_or_default();
        if all.is_empty() {
            return Ok(());
        }
        writeln!(self.out, "   {QUIET}from which follow {}{QUIET:#}", by_rule(all))?;
        for one in all.iter().filter(|_| self.is_listed) {
            let mut lines = String::new();
            write(&mut lines, one, self.decimals)?;
            lines.lines().try_for_each(|line| writeln!(self.out, "   {line}"))?;
        }
        Ok(())
    }
}

/// The numbers of diagnoses of each rule, in words.
fn by_rule(all: &[&Diagnosis]) -> String {
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    for one in all {
        *counts.entry(one.rule.unwrap_or_default()).or_default() += 1;
    }
    let of_coverage = |id: &str| CoverageRule::ALL.into_iter().find(|rule| rule.id() == id);
    let words = counts.into_iter().map(|(id, count)| match of_coverage(id) {
        Some(rule) => words(rule, count),
        None => format!("{} of {id}", counted(count, "violation")),
    });
    words.collect::<Vec<_>>().join(", ")
}
