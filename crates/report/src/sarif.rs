//! A report as SARIF, which code hosts show.
//!
//! Source: "Static Analysis Results Interchange Format (SARIF) Version 2.1.0", OASIS standard.

use crate::coverage_words::statement;
use crate::diagnosis_text::full_message;
use crate::report::AuditReport;
use crate::verdict::Verdict;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use twinedge_coverage::CoverageRule;
use twinedge_diagnosis::{Diagnosis, FeatureName};

const SCHEMA: &str = "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json";

/// Returns the report. Findings that make the input invalid are errors, consequences are notes, the rest are warnings.
pub(crate) fn sarif(report: &AuditReport) -> Value {
    let rules = rules(report);
    let numbers: BTreeMap<&str, usize> = rules.iter().enumerate().map(|(number, rule)| (rule.0, number)).collect();
    let rule = |(id, name, statement): &(&str, &str, &str)| json!({ "id": id, "name": name, "shortDescription": { "text": statement } });
    let hash = report.judged.as_ref().map(|judged| json!({ "sha-256": judged.sha256 }));
    let mut artifact = json!({ "location": { "uri": uri(&report.input) } });
    if let (Some(hashes), Some(judged)) = (hash, &report.judged) {
        artifact["hashes"] = hashes;
        artifact["length"] = judged.bytes.into();
    }
    let ended = report.verdict() != Verdict::Unknown;
    let notes: Vec<Value> =
        report.unknown().iter().map(|why| json!({ "level": "error", "message": { "text": why } })).collect();
    json!({
        "$schema": SCHEMA,
        "version": "2.1.0",
        "runs": [{
            "tool": { "driver": {
                "name": "twinedge",
                "version": env!("CARGO_PKG_VERSION"),
                "rules": rules.iter().map(rule).collect::<Vec<_>>(),
            } },
            "artifacts": [artifact],
            "invocations": [{ "executionSuccessful": ended, "toolExecutionNotifications": notes }],
            "results": report.listed().map(|one| result(report, one, &numbers)).collect::<Vec<_>>(),
            "columnKind": "unicodeCodePoints",
            "properties": { "verdict": report.verdict(), "options": report.options },
        }],
    })
}

/// Returns id, name and statement of each rule that has a result or could have one.
fn rules(report: &AuditReport) -> Vec<(&'static str, &'static str, &'static str)> {
    let own = report.rules.iter().map(|rule| (rule.id, rule.name, rule.statement));
    let of_coverage = CoverageRule::ALL.iter().map(|rule| (rule.id(), rule.name(), statement(*rule)));
    let mut all: Vec<_> = own.chain(of_coverage.filter(|_| report.coverage.is_some())).collect();
    // Findings of meshes have no rule.
    for one in report.listed().filter(|one| one.rule.is_none()) {
        let kind = one.kind.name();
        if all.iter().all(|(id, ..)| *id != kind) {
            all.push((kind, kind, kind));
        }
    }
    all
}

fn result(report: &AuditReport, one: &Diagnosis, numbers: &BTreeMap<&str, usize>) -> Value {
    let rule = one.rule.unwrap_or(one.kind.name());
    let level = if one.follows_from.is_some() {
        "note"
    } else if one.is_violation {
        "error"
    } else {
        "warning"
    };
    let features: Vec<String> = one.features.iter().flatten().map(FeatureName::title).collect();
    let who = if features.is_empty() { String::new() } else { format!(" ({})", features.join(", ")) };
    let place = one.look.map_or_else(String::new, |[x, y]| format!(", at {x}, {y}"));
    let name = report.name_of_rule(one);
    let message = match &*full_message(one) {
        "" => format!("{name}{who}{place}"),
        message => format!("{name}{who}: {message}{place}"),
    };
    // Viewers that show results next to the lines of a file need a region.
    let location = json!({
        "physicalLocation": {
            "artifactLocation": { "uri": uri(&report.input), "index": 0 },
            "region": { "startLine": one.line.unwrap_or(1).max(1) },
        },
        "logicalLocations": features.iter().map(|feature| json!({ "name": feature })).collect::<Vec<_>>(),
    });
    let mut result = json!({ "ruleId": rule, "level": level, "message": { "text": message }, "locations": [location] });
    if let Some(number) = numbers.get(rule) {
        result["ruleIndex"] = (*number).into();
    }
    if let Some(id) = &one.id {
        result["partialFingerprints"] = json!({ "twinedge/v1": id });
    }
    if let Some(reason) = &one.accepted {
        result["suppressions"] = json!([{ "kind": "external", "justification": reason }]);
    }
    result
}

fn uri(path: &str) -> String {
    let of = |byte: u8| match byte {
        b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'-' | b'.' | b'_' | b'~' | b'/' => char::from(byte).to_string(),
        byte => format!("%{byte:02X}"),
    };
    let escaped: String = path.replace('\\', "/").bytes().map(of).collect();
    if path.starts_with('/') { format!("file://{escaped}") } else { escaped }
}

#[cfg(test)]
mod tests {
    use super::{AuditReport, Diagnosis, Verdict, json, sarif, uri};

    #[test]
    fn what_follows_from_something_else_is_a_note() {
        let one = |follows_from| Diagnosis { is_violation: true, follows_from, ..Diagnosis::default() };
        let violations = vec![one(Some("R1")), one(None)];
        let found = sarif(&AuditReport { violations, violation_count: 2, ..AuditReport::new("a") });
        let levels = [0, 1].map(|number| found["runs"][0]["results"][number]["level"].clone());
        assert_eq!(levels, ["error", "note"]);
        assert_eq!(found["runs"][0]["invocations"][0]["executionSuccessful"], true);
    }

    #[test]
    fn an_audit_that_leaves_the_verdict_open_has_not_run_well() {
        let report = AuditReport { valid: true, doubts: vec!["time was up".to_owned()], ..AuditReport::new("a") };
        assert_eq!(report.verdict(), Verdict::Unknown);
        let run = &sarif(&report)["runs"][0]["invocations"][0];
        assert_eq!(run["executionSuccessful"], false);
        assert_eq!(run["toolExecutionNotifications"][0], json!({"level": "error", "message": {"text": "time was up"}}));
    }

    /// RFC 3986 leaves these characters, and no others, unescaped.
    #[test]
    fn a_path_is_a_reference() {
        assert_eq!(uri("a b/ä#?.shp"), "a%20b/%C3%A4%23%3F.shp");
        assert_eq!(uri("/maps/x-1_2~.json"), "file:///maps/x-1_2~.json");
        assert_eq!(uri("C:\\maps"), "C%3A/maps");
    }
}
