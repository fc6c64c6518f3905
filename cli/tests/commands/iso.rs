//! `twinedge audit --iso 19157`: quality measures for metadata.

use crate::support::{complaint, json as run, twinedge};
use serde_json::{Value, json};
use std::fs;
use tempfile::TempDir;

/// Fields that break C1, C3, C4, C6 and C7 once each, and C2 and C5, which no measure counts.
const FIELDS: &str = "
POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0))
POLYGON ((9 2, 20 2, 20 8, 9 8, 9 2))
POLYGON ((100 0, 110 0, 110 10, 100 10, 100 0))
POLYGON ((110.01 0, 120 0, 120 10, 110.01 10, 110.01 0))
POLYGON ((200 0, 210 0, 210 10, 200 10, 200 0), (203 3, 203 6, 206 6, 206 3, 203 3))
POLYGON ((300 0, 310 0, 310 10, 300 10, 300 0))
POLYGON ((310 0, 320 0, 320 10, 310 10, 310 4, 310 0))
POLYGON ((400 0, 410 0, 410 10, 400 10, 400 0))
POLYGON ((400 0, 410 0, 410 10, 400 10, 400 0))
POLYGON ((500 0, 510 0, 510 10, 505 10, 505 16, 505 10, 500 10, 500 0))
POLYGON ((600 0, 610 10, 610 0, 600 10, 600 0))
POLYGON ((700 0, 710 0, 710 0.001, 700 0.001, 700 0))
";

fn fields(folder: &TempDir) -> String {
    let path = folder.path().join("fields.wkt");
    fs::write(&path, FIELDS.trim_start()).unwrap();
    path.to_str().unwrap().to_owned()
}

fn measured(folder: &TempDir, options: &[&str]) -> (Option<i32>, Value) {
    let (layer, report) = (fields(folder), folder.path().join("quality.json"));
    let output = twinedge(&[&["audit", &layer, "--iso", "19157", "-o", report.to_str().unwrap()], options].concat());
    (output.status.code(), serde_json::from_slice(&fs::read(report).unwrap()).unwrap())
}

/// The ids, names and elements come from ISO 19157:2013, annex D
/// (<https://www.geoapi.org/snapshot/javadoc/org.opengis.geoapi/org/opengis/metadata/quality/>).
#[test]
fn each_measure_counts_what_the_standard_counts() {
    let folder = TempDir::new().unwrap();
    let (status, quality) = measured(&folder, &[]);
    assert_eq!(status, Some(1));
    let brief: Vec<Value> = quality["measures"]
        .as_array()
        .unwrap()
        .iter()
        .map(|one| json!([one["id"], one["name"], one["element"], one["rule"], one["value"]]))
        .collect();
    let (topological, conceptual) = ("DQ_TopologicalConsistency", "DQ_ConceptualConsistency");
    assert_eq!(
        brief,
        [
            json!([11, "number of invalid overlaps of surfaces", conceptual, "C1", 1]),
            json!([21, "number of faulty point-curve connections", topological, "C7", 1]),
            json!([23, "number of missing connections due to undershoots", topological, "C3", 1]),
            json!([25, "number of invalid slivers", topological, "C4", 1]),
            // A ring that turns straight back touches itself.
            json!([26, "number of invalid self-intersect errors", topological, "C6", 2]),
            json!([27, "number of invalid self-overlap errors", topological, "C6", 1]),
        ]
    );
    assert_eq!(quality["standard"], "ISO 19157:2013");
    let names = |of: usize| {
        let parameters = quality["measures"][of]["parameters"].as_array().unwrap();
        parameters.iter().map(|one| one["name"].as_str().unwrap()).collect::<Vec<_>>()
    };
    assert_eq!((names(2), names(3)), (vec!["search distance"], vec!["maximum sliver area size", "thickness quotient"]));
    let without =
        json!([{"rule": "C2", "name": "gap", "findings": 1}, {"rule": "C5", "name": "duplicate", "findings": 1}]);
    assert_eq!(quality["without_measure"], without);
}

#[test]
fn findings_name_the_measure_that_counts_them() {
    let folder = TempDir::new().unwrap();
    let (_, report) = run(&["audit", &fields(&folder), "--snap", "auto", "--format", "json"]);
    let of = |rule: &str| -> Vec<Value> {
        let findings = report["coverage"]["findings"].as_array().unwrap().iter();
        findings.filter(|one| one["rule"] == rule).map(|one| one["iso_19157"].clone()).collect()
    };
    for (rule, measure) in [("C1", 11), ("C3", 23), ("C4", 25), ("C7", 21)] {
        let found = of(rule);
        assert!(!found.is_empty() && found.iter().all(|one| *one == measure), "{rule}: {found:?}");
    }
    // A ring that crosses itself is counted by one measure, and a ring that turns back by another one, which counts features.
    assert!(of("C6").contains(&json!(26)) && of("C2").iter().chain(&of("C5")).all(Value::is_null), "{report}");
}

#[test]
fn what_was_accepted_is_no_error() {
    let folder = TempDir::new().unwrap();
    let list = folder.path().join("accepted.json").to_str().unwrap().to_owned();
    run(&["audit", &fields(&folder), "--accept-all", &list, "--format", "json"]);
    let (_, quality) = measured(&folder, &["--accept", &list]);
    let values: Vec<_> = quality["measures"].as_array().unwrap().iter().map(|one| &one["value"]).collect();
    // A ring that turns back is not a separate finding.
    assert_eq!(values, [0, 0, 0, 0, 0, 1].map(|value| json!(value)).iter().collect::<Vec<_>>());
}

/// Returns the names of all elements in order, if the elements are properly nested.
fn elements(xml: &str) -> Vec<&str> {
    let (mut names, mut open) = (Vec::new(), Vec::new());
    let mut rest = xml.strip_prefix("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n").expect("a declaration");
    while let Some((text, tag)) = rest.split_once('<') {
        assert!(!text.contains('>') && !text.contains('&'), "{text}");
        if let Some(comment) = tag.strip_prefix("!--") {
            let (comment, after) = comment.split_once("-->").expect("it ends");
            assert!(!comment.contains("--"));
            rest = after;
            continue;
        }
        let (tag, after) = tag.split_once('>').expect("it ends");
        rest = after;
        if let Some(name) = tag.strip_prefix('/') {
            assert_eq!(open.pop(), Some(name));
            continue;
        }
        let name = tag.trim_end_matches('/').split(' ').next().unwrap();
        names.push(name);
        if !tag.ends_with('/') {
            open.push(name);
        }
    }
    assert_eq!((open, rest), (vec![], "\n"));
    names
}

/// The order of elements follows `gmd/dataQuality.xsd` (ISO/TS 19139:2007): `AbstractDQ_Element_Type` and `DQ_QuantitativeResult_Type`.
#[test]
fn the_xml_has_the_form_of_iso_19139() {
    let folder = TempDir::new().unwrap();
    let output = twinedge(&["audit", &fields(&folder), "--iso", "19157"]);
    assert_eq!(output.status.code(), Some(1), "{}", complaint(&output));
    let xml = String::from_utf8(output.stdout).unwrap();
    let found = elements(&xml);
    let scope = ["gmd:DQ_DataQuality", "gmd:scope", "gmd:DQ_Scope", "gmd:level", "gmd:MD_ScopeCode"];
    assert_eq!(found[..5], scope);
    let text = "gco:CharacterString";
    let reports: Vec<&[&str]> = found[5..].chunks(21).collect();
    assert_eq!(reports.len(), 6);
    for (number, report) in reports.into_iter().enumerate() {
        let element = if number == 0 { "gmd:DQ_ConceptualConsistency" } else { "gmd:DQ_TopologicalConsistency" };
        let expected = [
            "gmd:report",
            element,
            "gmd:nameOfMeasure",
            text,
            "gmd:measureIdentification",
            "gmd:RS_Identifier",
            "gmd:code",
            text,
            "gmd:codeSpace",
            text,
            "gmd:measureDescription",
            text,
            "gmd:evaluationMethodType",
            "gmd:DQ_EvaluationMethodTypeCode",
            "gmd:evaluationMethodDescription",
            text,
            "gmd:result",
            "gmd:DQ_QuantitativeResult",
            "gmd:valueUnit",
            "gmd:value",
            "gco:Record",
        ];
        assert_eq!(report, expected);
    }
}

/// Tiles do not count rings that turn straight back, which two of the measures need.
#[test]
fn measures_are_not_taken_from_tiles() {
    let folder = TempDir::new().unwrap();
    let layer = fields(&folder);
    for tiles in [["--tiles", "2"], ["--memory", "1G"]] {
        let output = twinedge(&[&["audit", &layer, "--iso", "19157"], &tiles[..]].concat());
        let text = String::from_utf8(output.stderr).unwrap();
        let conflict = format!("'--iso <STANDARD>' cannot be used with '{}", tiles[0]);
        assert!(output.status.code() == Some(2) && text.contains(&conflict), "{text}");
    }
}
