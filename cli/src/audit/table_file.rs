//! Auditing a file of tables, one on each line.

use super::destination::Destination;
use crate::expectation_text::parse;
use crate::output::style::{BAD, GOOD, QUIET};
use crate::output::{Format, counted, grouped, plain};
use crate::status::{Failure, Verdict};
use serde::Serialize;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::io::BufRead;
use std::time::Instant;
use twinedge::validate::{Collect, Expectation, Rule, Table, validate};

/// Whether a file that begins so has tables. Every table begins with `P` or `V`; comments may precede it.
pub(super) fn is_table_file(beginning: &[u8]) -> bool {
    let text = String::from_utf8_lossy(beginning);
    let lines = text.lines().map(str::trim_start).filter(|line| !line.is_empty());
    let mut lines = lines.skip_while(|line| line.starts_with('#') && !line.starts_with(EXPECT));
    lines.next().is_some_and(|line| line.starts_with(EXPECT) || line.starts_with("P ") || line.starts_with("V "))
}

/// Begins a comment that says what the tables below it are held to.
const EXPECT: &str = "# expect:";

/// No line may be longer, in bytes.
const LONGEST_LINE: u64 = 1 << 30;

#[derive(Debug, Default, Serialize)]
struct Audited<'a> {
    input: &'a str,
    valid: bool,
    tables: u64,
    valid_tables: u64,
    /// Tables for which the file has another verdict.
    verdicts_differ: u64,
    /// How many tables break each rule; a table may break several.
    rules: Vec<RuleTables>,
    violations: Vec<TableViolation>,
    elapsed_ms: f64,
    #[serde(skip)]
    violation_count: u64,
    #[serde(skip)]
    explain: bool,
}

#[derive(Debug, Serialize)]
struct RuleTables {
    id: &'static str,
    tables: u64,
}

#[derive(Debug, Serialize)]
struct TableViolation {
    line: u64,
    rule: &'static str,
    message: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    cause: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    remedy: Option<&'static str>,
}

/// Judges each line and prints what was found. At most `list` violations are listed.
pub(super) fn audit(
    name: &str,
    mut input: impl BufRead,
    list: usize,
    explain: bool,
    to: Destination<'_>,
) -> Result<Verdict, Failure> {
    let start = Instant::now();
    let output = to.without_map(name, "a file of tables")?;
    let mut audited = Audited { input: name, explain, ..Audited::default() };
    let mut broken = BTreeMap::new();
    let mut expectation = Expectation::plane();
    let mut line = String::new();
    for number in 1.. {
        line.clear();
        let at = |why: String| Failure(format!("{name}: line {number}: {why}"));
        let read = std::io::Read::take(&mut input, LONGEST_LINE).read_line(&mut line);
        if read.map_err(|error| at(error.to_string()))? == 0 {
            break;
        }
        let text = line.trim();
        if let Some(expect) = text.strip_prefix(EXPECT) {
            expectation = parse(expect).map_err(at)?;
        } else if !text.is_empty() && !text.starts_with('#') {
            audited.judge(number, text, expectation, list, &mut broken).map_err(at)?;
        }
    }
    audited.rules =
        broken.into_iter().map(|(rule, tables): (Rule, u64)| RuleTables { id: rule.id(), tables }).collect();
    audited.valid = audited.valid_tables == audited.tables && audited.verdicts_differ == 0;
    audited.elapsed_ms = start.elapsed().as_secs_f64() * 1000.0;
    match output {
        Format::Text => to.text(&audited.text()?)?,
        Format::Json => to.json(&audited)?,
    }
    Ok(if audited.valid { Verdict::Sound } else { Verdict::Wrong })
}

impl Audited<'_> {
    /// Judges one table, and compares the verdict with the one behind `=`, if there is one.
    fn judge(
        &mut self,
        line: u64,
        text: &str,
        expectation: Expectation,
        list: usize,
        broken: &mut BTreeMap<Rule, u64>,
    ) -> Result<(), String> {
        let (table, stated) = match text.split_once('=') {
            None => (text, None),
            Some((table, stated)) => (table, Some(stated.trim())),
        };
        let table: Table = table.parse().map_err(|error| format!("{error}"))?;
        let report = validate(&table, &expectation, Collect::AtMost(list));
        self.tables += 1;
        self.valid_tables += u64::from(report.is_valid());
        self.violation_count += report.violation_count();
        let mut first = None;
        for (rule, _) in report.outcomes().filter(|(_, outcome)| outcome.violations > 0) {
            first = first.or(Some(rule));
            *broken.entry(rule).or_default() += 1;
        }
        let room = list.saturating_sub(self.violations.len());
        for violation in report.violations().iter().take(room) {
            let (rule, message) = (violation.rule().id(), violation.to_string());
            let cause = self.explain.then(|| violation.cause());
            let remedy = self.explain.then(|| violation.remedy());
            self.violations.push(TableViolation { line, rule, message, cause, remedy });
        }
        let verdict = first.map_or("ok", Rule::id);
        if stated.is_some_and(|stated| stated != verdict) {
            self.verdicts_differ += 1;
            if room > 0 {
                let message = format!("the file says {}", plain(stated.unwrap_or_default()));
                self.violations.push(TableViolation { line, rule: verdict, message, cause: None, remedy: None });
            }
        }
        Ok(())
    }

    fn text(&self) -> Result<String, std::fmt::Error> {
        let mut out = String::new();
        writeln!(out, "{}", self.input)?;
        for TableViolation { line, rule, message, .. } in &self.violations {
            writeln!(out, "{QUIET}line {line}{QUIET:#}  {BAD}{rule}{BAD:#} {message}")?;
        }
        let total = self.violation_count + self.verdicts_differ;
        let more = total.saturating_sub(self.violations.len() as u64);
        if more > 0 {
            writeln!(out, "… and {} more; see --list", grouped(more))?;
        }
        let explained = self.violations.iter().filter_map(|one| Some((one.rule, one.cause?, one.remedy?)));
        for (rule, cause, remedy) in explained.collect::<BTreeSet<_>>() {
            writeln!(out, "{rule}: usual cause: {cause}; remedy: {remedy}")?;
        }
        for RuleTables { id, tables } in &self.rules {
            writeln!(out, "  {id}  broken in {}", counted(*tables as usize, "table"))?;
        }
        let (tables, valid) = (counted(self.tables as usize, "table"), grouped(self.valid_tables));
        let differ = counted(self.verdicts_differ as usize, "verdict");
        let verb = if self.verdicts_differ == 1 { "differs" } else { "differ" };
        let ms = self.elapsed_ms;
        if self.valid {
            writeln!(out, "{GOOD}valid{GOOD:#}: {tables} ({ms:.0} ms)")?;
        } else {
            writeln!(
                out,
                "{BAD}not valid{BAD:#}: {valid} of {tables} valid, {differ} of the file {verb} ({ms:.0} ms)"
            )?;
        }
        Ok(out)
    }
}

#[cfg(test)]
mod tests {
    use super::is_table_file;

    #[test]
    fn files_of_tables_are_told_by_their_beginning() {
        for text in ["V 0 H 0 B 0 F 0", "\n# a comment\n\nV 1 - - H", "# expect: plane\n", "  V 0", "P 0 V 0"] {
            assert!(is_table_file(text.as_bytes()), "{text}");
        }
        for text in ["", "{\"type\":", "# a comment\n{", "VERTEX 3", "\x1e{}", "POINT (1 2)"] {
            assert!(!is_table_file(text.as_bytes()), "{text}");
        }
    }
}
