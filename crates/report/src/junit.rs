//! A report as `JUnit` XML, which servers of continuous integration show: a test case for each rule.

use crate::diagnosis_text::full_message;
use crate::report::AuditReport;
use crate::verdict::Verdict;
use crate::words::{counted, escaped, plain};
use std::fmt::Write as _;
use twinedge_diagnosis::{Diagnosis, FeatureName};

enum Outcome {
    Passed,
    Failed(String),
    /// The reason why the test case was not run.
    Skipped(String),
    /// The reason why the outcome is unknown.
    Error(String),
}

/// Returns the report. A rule fails if it makes the input invalid; an unknown verdict is an error.
///
/// # Errors
/// Never: writing to a string does not fail.
pub(crate) fn junit(report: &AuditReport) -> Result<String, std::fmt::Error> {
    let cases = cases(report);
    let count = |is: fn(&Outcome) -> bool| cases.iter().filter(|(_, outcome)| is(outcome)).count();
    let failures = count(|outcome| matches!(outcome, Outcome::Failed(_)));
    let skipped = count(|outcome| matches!(outcome, Outcome::Skipped(_)));
    let errors = count(|outcome| matches!(outcome, Outcome::Error(_)));
    let (tests, time) = (cases.len(), report.elapsed_ms / 1000.0);
    let name = escaped(&report.input);
    let mut out = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    writeln!(out, "<testsuites tests=\"{tests}\" failures=\"{failures}\" errors=\"{errors}\" time=\"{time:.3}\">")?;
    writeln!(
        out,
        "  <testsuite name=\"{name}\" tests=\"{tests}\" failures=\"{failures}\" errors=\"{errors}\" skipped=\"{skipped}\" time=\"{time:.3}\">"
    )?;
    for (case, outcome) in &cases {
        write!(out, "    <testcase classname=\"twinedge\" name=\"{}\" time=\"0\"", escaped(case))?;
        match outcome {
            Outcome::Passed => writeln!(out, "/>")?,
            Outcome::Skipped(why) => writeln!(out, "><skipped message=\"{}\"/></testcase>", escaped(why))?,
            Outcome::Error(why) => {
                writeln!(out, "><error type=\"unknown\" message=\"{}\"/></testcase>", escaped(why))?;
            }
            Outcome::Failed(lines) => {
                let first = lines.lines().next().unwrap_or_default();
                let [first, lines] = [first, lines].map(escaped);
                writeln!(out, "><failure type=\"violation\" message=\"{first}\">{lines}</failure></testcase>")?;
            }
        }
    }
    out.push_str("  </testsuite>\n</testsuites>\n");
    Ok(out)
}

fn cases(report: &AuditReport) -> Vec<(String, Outcome)> {
    let lines = |of: &dyn Fn(&Diagnosis) -> bool| {
        let told = report.listed().filter(|one| of(one) && one.accepted.is_none());
        told.map(line).collect::<Vec<_>>().join("\n")
    };
    let is_rule = report.style.is_rule;
    // Consequences of a finding whose test case fails do not fail another case.
    let failed = |id: &str, count: u64| {
        let of_rule = || report.listed().filter(|one| one.rule == Some(id) && one.accepted.is_none());
        let follows = |one: &Diagnosis| one.follows_from.filter(|_| is_rule);
        let listed = of_rule().count() as u64;
        match of_rule().find_map(follows) {
            Some(source) if listed == count && of_rule().all(|one| follows(one).is_some()) => Outcome::Skipped(
                format!("{}, as {source} and others are broken", counted(count as usize, "consequence")),
            ),
            _ if listed == 0 => Outcome::Failed(counted(count as usize, "finding")),
            _ => Outcome::Failed(lines(&|one| one.rule == Some(id) && follows(one).is_none())),
        }
    };
    let own = report.rules.iter().filter(|rule| rule.applies()).map(|rule| {
        let outcome = match (rule.violations, rule.not_checked()) {
            (0, None) => Outcome::Passed,
            (0, Some(why)) => Outcome::Skipped(why),
            (n, _) => failed(rule.id, n),
        };
        (format!("{} {}", rule.id, rule.name), outcome)
    });
    let of_coverage = report.coverage.iter().filter(|_| is_rule).flat_map(|coverage| {
        coverage.counts().map(|(rule, count)| {
            let outcome = match (count - coverage.accepted(rule), coverage.why_not(rule)) {
                (_, Some(why)) => Outcome::Skipped(why.to_owned()),
                (0, _) => Outcome::Passed,
                (n, _) => failed(rule.id(), n as u64),
            };
            (rule.to_string(), outcome)
        })
    });
    let mut all: Vec<_> = own.chain(of_coverage).collect();
    let of_faces = lines(&|one| one.rule.is_none() && one.is_violation);
    if report.finding_count > 0 && !of_faces.is_empty() {
        all.push(("faces".to_owned(), Outcome::Failed(of_faces)));
    }
    if report.verdict() == Verdict::Unknown {
        all.push(("verdict".to_owned(), Outcome::Error(report.sentence())));
    }
    all
}

fn line(one: &Diagnosis) -> String {
    let features: Vec<String> = one.features.iter().flatten().map(FeatureName::title).collect();
    let who = if features.is_empty() { String::new() } else { format!(" ({})", features.join(", ")) };
    let place = one.look.map_or_else(String::new, |[x, y]| format!(", at {x}, {y}"));
    let id = one.id.as_deref().unwrap_or_default();
    plain(&format!("{id}{who}: {}{place}", full_message(one)))
}

#[cfg(test)]
mod tests {
    use super::{AuditReport, Diagnosis, junit};

    #[test]
    fn findings_of_a_mesh_are_a_case() {
        let of = |is_violation| {
            let findings = vec![Diagnosis { is_violation, message: "it is flat".to_owned(), ..Diagnosis::default() }];
            junit(&AuditReport { valid: true, findings, finding_count: 1, ..AuditReport::new("a") })
                .expect("it is a string")
        };
        let text = of(true);
        assert!(text.contains("tests=\"1\" failures=\"1\"") && text.contains("name=\"faces\""), "{text}");
        assert!(of(false).contains("tests=\"0\" failures=\"0\""), "{}", of(false));
    }

    #[test]
    fn a_verdict_that_is_not_known_is_an_error() {
        let report = AuditReport { doubts: vec!["time was up <\u{1}>".to_owned()], ..AuditReport::new("a\"b") };
        let text = junit(&report).expect("it is a string");
        assert!(text.contains("<testsuite name=\"a&quot;b\" tests=\"1\" failures=\"0\" errors=\"1\""), "{text}");
        let why = "unknown: nothing wrong was found, and time was up &lt;\u{fffd}&gt;";
        assert!(text.contains(&format!("<error type=\"unknown\" message=\"{why}\"/>")), "{text}");
    }
}
