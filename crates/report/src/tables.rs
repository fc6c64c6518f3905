//! Auditing a file of tables, one on each line.

use crate::diagnosis_text::{write, write_explanations, write_more};
use crate::error::Error;
use crate::input::Input;
use crate::options::Options;
use crate::verdict::Verdict;
use crate::words::style::{BAD, GOOD};
use crate::words::{counted, grouped, plain};
use serde::Serialize;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::io::BufRead;
use twinedge::validate::{Collect, Expectation, ParseExpectationError, Rule, Table, validate};
use twinedge_diagnosis::{Diagnosis, Kind, Records};

/// Begins a comment with the expectation for the tables below it.
pub const EXPECT: &str = "# expect:";

/// Returns true if a file with this beginning has tables. Every table begins with `P` or `V`; comments may precede it.
pub(crate) fn is_table_file(beginning: &[u8]) -> bool {
    let text = String::from_utf8_lossy(beginning);
    let lines = text.lines().map(str::trim_start).filter(|line| !line.is_empty());
    let mut lines = lines.skip_while(|line| line.starts_with('#') && !line.starts_with(EXPECT));
    lines.next().is_some_and(|line| line.starts_with(EXPECT) || line.starts_with("P ") || line.starts_with("V "))
}

/// The maximal number of bytes in a line.
const LONGEST_LINE: u64 = 1 << 30;

#[derive(Debug, Default, Serialize)]
pub(crate) struct TablesReport {
    input: String,
    pub(crate) valid: bool,
    verdict: Verdict,
    tables: u64,
    valid_tables: u64,
    /// The number of tables whose verdict in the file differs.
    verdicts_differ: u64,
    /// The number of tables that break each rule; a table may break several rules.
    rules: Vec<RuleTables>,
    violations: Vec<Diagnosis>,
    pub(crate) elapsed_ms: f64,
    #[serde(skip)]
    violation_count: u64,
}

#[derive(Debug, Serialize)]
struct RuleTables {
    id: &'static str,
    tables: u64,
}

pub(crate) fn audit(Input { name, reader: mut input, .. }: Input, asked: &Options) -> Result<TablesReport, Error> {
    let list = asked.most();
    let mut audited = TablesReport { input: name, ..TablesReport::default() };
    let mut broken = BTreeMap::new();
    let mut expectation = Expectation::plane();
    let mut line = String::new();
    for number in 1.. {
        line.clear();
        let at = |message: String| Error::Table { line: number, message };
        let read = std::io::Read::take(&mut input, LONGEST_LINE).read_line(&mut line);
        if read.map_err(|error| at(error.to_string()))? == 0 {
            break;
        }
        let text = line.trim();
        if let Some(expect) = text.strip_prefix(EXPECT) {
            expectation = expect.parse().map_err(|error: ParseExpectationError| at(error.to_string()))?;
        } else if !text.is_empty() && !text.starts_with('#') {
            audited.judge(number, text, expectation, list, &mut broken).map_err(at)?;
        }
    }
    audited.rules =
        broken.into_iter().map(|(rule, tables): (Rule, u64)| RuleTables { id: rule.id(), tables }).collect();
    audited.valid = audited.valid_tables == audited.tables && audited.verdicts_differ == 0;
    audited.verdict = audited.verdict();
    Ok(audited)
}

impl TablesReport {
    /// The verdict. A table with a rule that could not be checked is not valid.
    pub(crate) const fn verdict(&self) -> Verdict {
        if self.valid { Verdict::Valid } else { Verdict::Invalid }
    }

    pub(crate) fn unexplained(self) -> Self {
        Self { violations: self.violations.into_iter().map(Diagnosis::unexplained).collect(), ..self }
    }

    /// Judges one table, and compares its verdict with the verdict after `=`, if there is one.
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
        let listed = report.violations().iter().take(room);
        self.violations.extend(listed.map(|violation| Diagnosis { line: Some(line), ..violation.into() }));
        let verdict = first.map_or("ok", Rule::id);
        if let Some(stated) = stated.filter(|stated| *stated != verdict) {
            self.verdicts_differ += 1;
            if room > 0 {
                self.violations.push(Diagnosis {
                    line: Some(line),
                    rule: Some(verdict),
                    kind: Kind::Named { kind: "verdict_differs" },
                    message: format!("the file says {}", plain(stated)),
                    records: Records::Indices { records: Vec::new() },
                    ..Diagnosis::default()
                });
            }
        }
        Ok(())
    }

    pub(crate) fn text(&self) -> Result<String, std::fmt::Error> {
        let mut out = String::new();
        writeln!(out, "{}", self.input)?;
        self.violations.iter().try_for_each(|one| write(&mut out, one, 0))?;
        write_more(&mut out, self.violation_count + self.verdicts_differ, self.violations.len())?;
        write_explanations(&mut out, &self.violations)?;
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
