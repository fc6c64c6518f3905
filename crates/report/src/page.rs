//! The page: one file with its style, script and data.
//!
//! A policy in the page forbids loading anything. Text from the input is in a JSON block without `<`, `>` and `&`, and the script inserts it as text.

use crate::accepted::Accepted;
use crate::coverage_words::statement;
use crate::diagnosis_text::message;
use crate::packed::Picture;
use crate::report::{AuditReport, Note};
use crate::trace::has_place;
use crate::verdict::Verdict;
use crate::words::{counted, grouped, plain};
use serde::Serialize;
use std::collections::HashMap;
use std::ffi::OsStr;
use std::fmt::Write as _;
use std::path::Path;
use twinedge_diagnosis::{Diagnosis, Measures, Position, RuleLine, Trace};

const PAGE: &str = include_str!("html/page.html");
const STYLE: &str = include_str!("html/style.css");

/// The scripts in execution order.
const SCRIPTS: [&str; 13] = [
    include_str!("html/unpack.js"),
    include_str!("html/colours.js"),
    include_str!("html/view.js"),
    include_str!("html/faces.js"),
    include_str!("html/half_edges.js"),
    include_str!("html/names.js"),
    include_str!("html/findings.js"),
    include_str!("html/edges.js"),
    include_str!("html/scale_bar.js"),
    include_str!("html/insets.js"),
    include_str!("html/list.js"),
    include_str!("html/accept.js"),
    include_str!("html/main.js"),
];

/// The shape of a finding without a place.
static NOWHERE: Trace = Trace { points: Vec::new(), lines: Vec::new(), polygons: Vec::new() };

#[derive(Serialize)]
struct Data<'a> {
    input: &'a str,
    name: &'a str,
    /// The tone of the headline: `good`, `bad`, or `doubtful` if only the coverage has findings, which are no violations.
    tone: &'static str,
    verdict: &'a str,
    notes: Vec<String>,
    counts: &'a [(&'static str, String)],
    rules: Vec<Rule>,
    unit: Option<&'static str>,
    findings: Vec<Finding<'a>>,
    /// The list of accepted findings that would accept everything.
    acceptable: Accepted,
    total: u64,
    #[serde(flatten)]
    picture: &'a Picture,
}

#[derive(Serialize)]
struct Rule {
    id: &'static str,
    name: &'static str,
    statement: &'static str,
    outcome: String,
    found: u64,
}

#[derive(Serialize)]
struct Finding<'a> {
    id: Option<&'a str>,
    /// The reason for accepting the finding.
    accepted: Option<&'a str>,
    rule: &'static str,
    name: &'static str,
    kind: &'a str,
    message: String,
    sentence: Option<&'a str>,
    /// The list index of the finding's cause, counted from 0.
    follows: Option<usize>,
    violation: bool,
    records: Vec<String>,
    features: Vec<usize>,
    area: Option<f64>,
    width: Option<f64>,
    length: Option<f64>,
    cause: Option<&'static str>,
    remedy: Option<&'static str>,
    at: Option<Position>,
    trace: &'a Trace,
}

impl<'a> Finding<'a> {
    fn new(report: &AuditReport, one: &'a Diagnosis, follows: Option<usize>) -> Self {
        let Measures { area, width, length } = one.measures;
        Self {
            id: one.id.as_deref(),
            accepted: one.accepted.as_deref(),
            rule: one.rule.unwrap_or_default(),
            name: report.name_of_rule(one),
            kind: one.kind.name(),
            message: message(one),
            sentence: one.sentence.as_deref(),
            follows,
            violation: one.is_violation,
            records: one.records.names(),
            features: one.features.iter().flatten().map(|feature| feature.number).collect(),
            area,
            width,
            length,
            cause: one.cause,
            remedy: one.remedy,
            at: one.look.or_else(|| middle_of(&one.trace)).filter(|_| has_place(one)),
            trace: if has_place(one) { &one.trace } else { &NOWHERE },
        }
    }
}

/// The centre of a shape's corners.
fn middle_of(Trace { points, lines, polygons }: &Trace) -> Option<Position> {
    let all: Vec<Position> = polygons.iter().flatten().chain(lines).flatten().chain(points).copied().collect();
    let count = all.len() as f64;
    (!all.is_empty()).then(|| [0, 1].map(|axis| all.iter().map(|at| at[axis] / count).sum()))
}

/// Returns the listed diagnoses: causes, in terms of features first, each followed by its consequences.
fn findings(report: &AuditReport) -> Vec<Finding<'_>> {
    let mut follow: HashMap<&str, Vec<&Diagnosis>> = HashMap::new();
    let (mut causes, mut others) = (Vec::new(), Vec::new());
    for one in report.listed() {
        match (&one.follows_from_id, one.follows_from) {
            (Some(id), _) => follow.entry(id).or_default().push(one),
            (None, Some(_)) => others.push(one),
            (None, None) => causes.push(one),
        }
    }
    let mut found: Vec<Finding<'_>> = Vec::new();
    for one in causes {
        let number = found.len();
        found.push(Finding::new(report, one, None));
        let all = one.id.as_deref().and_then(|id| follow.remove(id)).unwrap_or_default();
        found.extend(all.into_iter().map(|one| Finding::new(report, one, Some(number))));
    }
    found.extend(others.into_iter().map(|one| Finding::new(report, one, None)));
    found
}

/// The rules of the validator and the format, plus C1 … C7 if there are polygons.
fn rules(report: &AuditReport) -> Vec<Rule> {
    let own = report.rules.iter().map(|rule| {
        let checked = format!("{} {}", grouped(rule.checked), rule.unit);
        let outcome = match (rule.violations, rule.not_checked()) {
            (0, None) => format!("holds for {checked}"),
            (0, Some(why)) if rule.is_in_part() => format!("holds for {checked}; {why}"),
            (0, Some(why)) => why,
            (n, _) => format!("{} in {checked}", counted(n as usize, "violation")),
        };
        let RuleLine { id, name, statement, violations: found, .. } = *rule;
        Rule { id, name, statement, outcome, found }
    });
    let of_coverage = report.coverage.iter().filter(|coverage| coverage.has_polygons()).flat_map(|coverage| {
        coverage.counts().map(|(rule, count)| Rule {
            id: rule.id(),
            name: rule.name(),
            statement: statement(rule),
            outcome: coverage.outcome(rule),
            found: count as u64,
        })
    });
    own.chain(of_coverage).collect()
}

fn note(note: &Note) -> Option<String> {
    match note {
        Note::Plain(note) => Some(note.clone()),
        Note::Warning(warning) => Some(format!("Warning: {warning}")),
        Note::Detail(_) => None,
    }
}

fn tone(report: &AuditReport) -> &'static str {
    let is_doubtful = report.coverage.as_ref().is_some_and(|coverage| coverage.outcome_in_words().is_some());
    match report.verdict() {
        Verdict::Valid if is_doubtful => "doubtful",
        Verdict::Valid => "good",
        _ => "bad",
    }
}

pub(crate) fn page(report: &AuditReport, picture: &Picture) -> serde_json::Result<String> {
    let verdict = report.sentence();
    let name = Path::new(&report.input).file_name().and_then(OsStr::to_str).unwrap_or(&report.input);
    let data = Data {
        input: &report.input,
        name,
        tone: tone(report),
        verdict: &verdict,
        notes: report.notes.iter().filter_map(note).collect(),
        counts: &report.counts,
        rules: rules(report),
        unit: report.unit(),
        findings: findings(report),
        acceptable: Accepted::all(report.acceptable(), report.accepted_before.as_ref(), "", ""),
        total: report.total(),
        picture,
    };
    let data = in_script(&serde_json::to_string(&data)?);
    let title = in_element(&plain(name));
    let verdict = in_element(&plain(&verdict));
    let script = SCRIPTS.concat();
    let mut page = String::with_capacity(data.len() + script.len() + 20_000);
    let mut rest = PAGE;
    for (mark, text) in
        [("{title}", &*title), ("{style}", STYLE), ("{verdict}", &*verdict), ("{data}", &*data), ("{script}", &*script)]
    {
        let (before, after) = rest.split_once(mark).unwrap_or((rest, ""));
        page.push_str(before);
        page.push_str(text);
        rest = after;
    }
    page.push_str(rest);
    Ok(page)
}

/// Escapes JSON for a `script` element: outside of texts, JSON has none of these characters.
fn in_script(json: &str) -> String {
    let mut out = String::with_capacity(json.len());
    for c in json.chars() {
        match c {
            '<' | '>' | '&' | '\u{2028}' | '\u{2029}' => {
                // Writing to a string cannot fail.
                let _ = write!(out, "\\u{:04x}", u32::from(c));
            }
            c => out.push(c),
        }
    }
    out
}

/// Escapes text for an element.
fn in_element(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::{Accepted, AuditReport, Diagnosis, Picture, page};
    use serde_json::Value;

    /// The page saves a file for `--accept` that keeps the dates of earlier acceptances.
    #[test]
    fn what_can_be_accepted_is_in_the_page_as_a_list() {
        let list =
            r#"{"schema":"twinedge-accepted/1","accepted":[{"id":"X1-1","reason":"a lake","date":"2026-01-31"}]}"#;
        let known = Accepted::read(list).expect("it is a list");
        let finding = |rule, id: &str| Diagnosis { rule: Some(rule), id: Some(id.to_owned()), ..Diagnosis::default() };
        let findings = vec![finding("X1", "X1-1"), finding("X2", "X2-1"), finding("M9", "M9-1")];
        let mut report = AuditReport { findings, finding_count: 3, ..AuditReport::new("layer") };
        report.settle(Some(&known));
        let page = page(&report, &Picture::default()).expect("it can be written");
        let (_, data) = page.split_once("type=\"application/json\">").expect("the data are there");
        let data: Value = serde_json::from_str(data.split_once("</script>").expect("they end").0).expect("it is JSON");
        let all = Accepted::read(&data["acceptable"].to_string()).expect("it is a list");
        let listed: Vec<[&Value; 3]> = data["acceptable"]["accepted"]
            .as_array()
            .expect("a list")
            .iter()
            .map(|one| [&one["id"], &one["reason"], &one["date"]])
            .collect();
        assert_eq!(listed, [["X1-1", "a lake", "2026-01-31"], ["X2-1", "", ""]]);
        assert_ne!(all, known);
    }

    #[test]
    fn what_comes_from_the_input_ends_no_element() {
        let hostile = "</script><script>alert(1)</script><!--\u{2028}\"'&amp; {data} \u{1b}[31m";
        let report = AuditReport { doubts: vec![hostile.to_owned()], ..AuditReport::new(hostile) };
        let page = page(&report, &Picture::default()).expect("it can be written");
        assert_eq!(page.matches("</script>").count(), 2);
        assert!(!page.contains("alert(1)</script>") && !page.contains("{script}") && !page.contains('\u{1b}'));
        let (_, data) = page.split_once("type=\"application/json\">").expect("the data are there");
        let (data, _) = data.split_once("</script>").expect("they end");
        assert!(!data.contains(['<', '>', '&', '\u{2028}']), "{data}");
        let data: Value = serde_json::from_str(data).expect("it is JSON");
        assert_eq!(data["input"], hostile);
    }
}
