//! `twinedge audit` as a gate: accepted findings, differences, SARIF and `JUnit`.

use crate::support::{complaint, json as run, twinedge};
use boon::{Compiler, Schemas};
use serde_json::{Value, json};
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// Writes three fields in this order: one with a height of 4 and perhaps a lake of this width, one that overlaps it by 1, and a separate one. Returns
/// the path of the file.
fn layer(folder: &TempDir, name: &str, lake: u32, order: [usize; 3]) -> String {
    let square = |x0: u32, y0: u32, x1: u32, y1: u32| [[x0, y0], [x1, y0], [x1, y1], [x0, y1], [x0, y0]];
    let feature = |id: &str, rings: Value| json!({"type": "Feature", "id": id, "properties": {}, "geometry": {"type": "Polygon", "coordinates": rings}});
    let field = square(0, 0, 40, 40);
    let features = [
        feature("field", if lake == 0 { json!([field]) } else { json!([field, square(10, 10, 10 + lake, 14)]) }),
        feature("beside", json!([square(39, 0, 60, 40)])),
        feature("apart", json!([square(100, 0, 120, 40)])),
    ];
    let layer = json!({"type": "FeatureCollection", "features": order.map(|place| features[place].clone())});
    let path = folder.path().join(name);
    fs::write(&path, layer.to_string()).unwrap();
    path.to_str().unwrap().to_owned()
}

/// Arguments for judging a coverage. Borders are cut, so that overlaps do not break G4.
const JUDGED: [&str; 6] = ["--snap", "auto", "--coverage", "--format", "json", "--quiet"];

fn audited(layer: &str, options: &[&str]) -> (Option<i32>, Value) {
    run(&[&["audit", layer], &JUDGED[..], options].concat())
}

fn read(path: &str) -> Value {
    serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap()
}

/// The rules of the listed findings that are accepted, or not accepted.
fn rules(found: &Value, accepted: bool) -> Vec<&str> {
    let all = found["coverage"]["findings"].as_array().unwrap().iter();
    all.filter(|one| one.get("accepted").is_some() == accepted).map(|one| one["rule"].as_str().unwrap()).collect()
}

#[test]
fn what_was_accepted_breaks_nothing_until_it_grows() {
    let folder = TempDir::new().unwrap();
    let list = folder.path().join("accepted.json").to_str().unwrap().to_owned();
    let may = layer(&folder, "may.geojson", 4, [0, 1, 2]);
    let (status, found) = audited(&may, &["--accept-all", &list, "--reason", "a lake, and a quarrel"]);
    assert_eq!((status, rules(&found, false)), (Some(1), vec!["C1", "C2"]));
    let written = read(&list);
    assert_eq!(written["schema"], "twinedge-accepted/1");
    let lake = &written["accepted"][1];
    assert_eq!((&lake["rule"], &lake["features"], &lake["area"]), (&json!("C2"), &json!(["field"]), &json!(16.0)));
    assert_eq!((&lake["reason"], lake["date"].as_str().unwrap().len()), (&json!("a lake, and a quarrel"), 10));

    // The features in another order.
    let again = layer(&folder, "again.geojson", 4, [2, 1, 0]);
    let (status, found) = audited(&again, &["--accept", &list]);
    assert_eq!((status, &found["verdict"], rules(&found, true)), (Some(0), &json!("valid"), vec!["C1", "C2"]));
    assert_eq!(found["accepted"], json!({"count": 2, "grown": [], "gone": []}));
    assert_eq!(found["coverage"]["findings"][1]["accepted"], "a lake, and a quarrel");

    // The lake has grown, and then vanishes.
    let june = layer(&folder, "june.geojson", 5, [0, 1, 2]);
    let (status, found) = audited(&june, &["--accept", &list]);
    assert_eq!((status, rules(&found, true), rules(&found, false)), (Some(1), vec!["C1"], vec!["C2"]));
    assert_eq!(found["accepted"], json!({"count": 1, "grown": [lake["id"]], "gone": []}));
    assert_eq!(found["first"]["id"], lake["id"]);
    let dry = layer(&folder, "dry.geojson", 0, [0, 1, 2]);
    let (_, found) = audited(&dry, &["--accept", &list]);
    assert_eq!((&found["accepted"]["count"], &found["accepted"]["gone"]), (&json!(1), &json!([lake["id"]])));
    // A finding that has shrunk is accepted. A finding that is accepted again keeps its reason, unless it grew.
    let small = layer(&folder, "small.geojson", 3, [0, 1, 2]);
    assert_eq!(audited(&small, &["--accept", &list]).0, Some(0));
    audited(&june, &["--accept", &list, "--accept-all", &list, "--reason", "it has grown"]);
    let reasons = [0, 1].map(|number| read(&list)["accepted"][number]["reason"].clone());
    assert_eq!(reasons, ["a lake, and a quarrel", "it has grown"]);
    assert_eq!(audited(&june, &["--accept", &list]).0, Some(0));
}

#[test]
fn what_follows_from_accepted_findings_is_accepted_with_them() {
    let folder = TempDir::new().unwrap();
    let list = folder.path().join("accepted.json").to_str().unwrap().to_owned();
    let file = layer(&folder, "may.geojson", 4, [0, 1, 2]);
    run(&["audit", &file, "--format", "json", "--accept-all", &list]);
    let (status, found) = run(&["audit", &file, "--format", "json", "--coverage", "--accept", &list]);
    assert_eq!((status, &found["verdict"], &found["accepted"]["count"]), (Some(0), &json!("valid"), &json!(2)));
    assert_eq!(found["headline"], "valid (2 accepted): all else that was checked holds");
    let clashes: Vec<&Value> = found["violations"].as_array().unwrap().iter().map(|one| &one["accepted"]).collect();
    assert_eq!(clashes, vec!["accepted as it is"; clashes.len()]);
    // Without one of the two entries, the clashes may follow from that finding.
    let mut lists = read(&list);
    lists["accepted"].as_array_mut().unwrap().remove(0);
    fs::write(&list, lists.to_string()).unwrap();
    let (status, found) = run(&["audit", &file, "--format", "json", "--accept", &list]);
    assert_eq!((status, &found["verdict"]), (Some(1), &json!("invalid")));
    // Everything that counts is a cause, or follows from a reported cause.
    assert!(found["causes"].as_u64() > Some(0) && found["first"]["id"].is_string(), "{found}");
    let told = |id: &Value| {
        let lists = [&found["violations"], &found["coverage"]["findings"]].map(|list| list.as_array().unwrap());
        lists.into_iter().flatten().any(|one| one["id"] == *id && one.get("accepted").is_none())
    };
    let open = found["violations"].as_array().unwrap().iter().filter(|one| one.get("accepted").is_none());
    assert!(open.filter_map(|one| one.get("follows_from_id")).all(told), "{found}");
}

#[test]
fn a_violation_of_the_structure_that_follows_from_nothing_cannot_be_accepted() {
    let folder = TempDir::new().unwrap();
    let [file, list] = ["lines.wkt", "accepted.json"].map(|name| folder.path().join(name).to_str().unwrap().to_owned());
    fs::write(&file, "LINESTRING(0 0,2 2)\nLINESTRING(0 2,2 0)\n").unwrap();
    run(&["audit", &file, "--format", "json", "--accept-all", &list]);
    let (status, found) = run(&["audit", &file, "--format", "json", "--accept", &list]);
    assert_eq!((status, &found["verdict"], &found["causes"]), (Some(1), &json!("invalid"), &json!(1)));
}

#[test]
fn a_file_that_is_no_list_of_accepted_findings_is_refused() {
    let folder = TempDir::new().unwrap();
    let file = layer(&folder, "may.geojson", 4, [0, 1, 2]);
    let list = folder.path().join("accepted.json");
    for (text, why) in [
        ("[", "no list of accepted findings: EOF while parsing"),
        (r#"{"schema": "x", "accepted": []}"#, "its schema is \"x\""),
        (
            r#"{"schema": "twinedge-accepted/1", "accepted": [{"id": "a"}, {"id": "a"}]}"#,
            "the finding a is accepted twice",
        ),
    ] {
        fs::write(&list, text).unwrap();
        let output = twinedge(&["audit", &file, "--accept", list.to_str().unwrap()]);
        assert_eq!(output.status.code(), Some(2));
        assert!(complaint(&output).contains(why), "{}", complaint(&output));
    }
}

fn report(folder: &TempDir, layer: &str, options: &[&str]) -> String {
    let path = Path::new(layer).with_extension("json").to_str().unwrap().to_owned();
    let output = twinedge(&[&["audit", layer, "-o", &path], &JUDGED[..], options].concat());
    assert!(output.status.code() < Some(2) && folder.path().exists(), "{}", complaint(&output));
    path
}

#[test]
fn a_difference_has_what_is_new_and_gone_and_changed() {
    let folder = TempDir::new().unwrap();
    let of = |name: &str, lake: u32, order: [usize; 3]| report(&folder, &layer(&folder, name, lake, order), &[]);
    let (may, june) = (of("may.geojson", 4, [0, 1, 2]), of("june.geojson", 5, [2, 0, 1]));
    let dry = of("dry.geojson", 0, [0, 1, 2]);
    let lake = read(&may)["coverage"]["findings"][1]["id"].clone();
    let diff = |old: &str, new: &str| run(&["diff", old, new, "--format", "json"]);
    let expected = |new: Value, gone: Value, changed: Value, same: usize| json!({"new": new, "gone": gone, "changed": changed, "same": same});
    assert_eq!(diff(&may, &may), (Some(0), expected(json!([]), json!([]), json!([]), 2)));
    assert_eq!(diff(&may, &june), (Some(0), expected(json!([]), json!([]), json!([lake]), 1)));
    let (status, found) = diff(&may, &dry);
    assert_eq!((status, &found["gone"][0], &found["same"]), (Some(0), &lake, &json!(1)));
    let (status, found) = diff(&dry, &may);
    assert_eq!((status, &found["new"][0], &found["same"]), (Some(1), &lake, &json!(1)));
    let text = String::from_utf8(twinedge(&["diff", &dry, &may]).stdout).unwrap();
    let line = format!("new {} gap: field; area 16.0000", lake.as_str().unwrap());
    assert!(text.contains(&line) && text.contains("1 new, "), "{text}");
}

#[test]
fn reports_that_do_not_say_all_are_not_compared() {
    let folder = TempDir::new().unwrap();
    let file = layer(&folder, "may.geojson", 4, [0, 1, 2]);
    let short = report(&folder, &file, &["--list", "0"]);
    let output = twinedge(&["diff", &short, &short]);
    assert_eq!(output.status.code(), Some(2));
    assert!(complaint(&output).contains("it lists 0 of 2 findings"), "{}", complaint(&output));
    for (text, why) in [
        (r#"{"counts": null}"#, "its audit did not end"),
        ("{}", "it has no counts"),
        (r#"{"counts": {}, "violation_count": 1, "violations": [{}]}"#, "a finding has no id"),
    ] {
        fs::write(&short, text).unwrap();
        let output = twinedge(&["diff", &short, &short]);
        assert_eq!(output.status.code(), Some(2));
        assert!(complaint(&output).contains(why), "{}", complaint(&output));
    }
}

/// The requirements of the schema of SARIF 2.1.0 (OASIS, sections 3.13 to 3.54) on this output: required members, names, and the forms of values.
fn sarif_schema() -> Value {
    let message =
        json!({"type": "object", "required": ["text"], "properties": {"text": {"type": "string", "minLength": 1}}});
    let level = json!({"enum": ["none", "note", "warning", "error"]});
    let artifact = json!({
        "type": "object", "additionalProperties": false, "required": ["location"],
        "properties": {
            "location": {"type": "object", "required": ["uri"], "properties": {"uri": {"type": "string", "format": "uri-reference"}}},
            "length": {"type": "integer", "minimum": 0},
            "hashes": {"type": "object", "additionalProperties": {"type": "string"}},
        },
    });
    let result = json!({
        "type": "object", "additionalProperties": false, "required": ["message"],
        "properties": {
            "ruleId": {"type": "string"}, "ruleIndex": {"type": "integer", "minimum": -1}, "level": level, "message": message,
            "locations": {"type": "array", "uniqueItems": false, "items": {
                "type": "object", "additionalProperties": false,
                "properties": {
                    "physicalLocation": {"type": "object", "additionalProperties": false, "required": ["artifactLocation"], "properties": {
                        "artifactLocation": {"type": "object", "properties": {"uri": {"type": "string", "format": "uri-reference"}, "index": {"type": "integer"}}},
                        "region": {"type": "object", "properties": {"startLine": {"type": "integer", "minimum": 1}}},
                    }},
                    "logicalLocations": {"type": "array", "uniqueItems": true, "items": {"type": "object", "properties": {"name": {"type": "string"}}}},
                },
            }},
            "partialFingerprints": {"type": "object", "additionalProperties": {"type": "string"}},
            "suppressions": {"type": "array", "items": {"type": "object", "required": ["kind"], "properties": {"kind": {"enum": ["inSource", "external"]}, "justification": {"type": "string"}}}},
        },
    });
    let rule = json!({"type": "object", "required": ["id"], "additionalProperties": false, "properties": {"id": {"type": "string"}, "name": {"type": "string"}, "shortDescription": message}});
    let run = json!({
        "type": "object", "required": ["tool"], "additionalProperties": false,
        "properties": {
            "tool": {"type": "object", "required": ["driver"], "properties": {"driver": {
                "type": "object", "required": ["name"], "properties": {"name": {"const": "twinedge"}, "version": {"type": "string"}, "rules": {"type": "array", "uniqueItems": true, "items": rule}},
            }}},
            "artifacts": {"type": "array", "minItems": 1, "uniqueItems": true, "items": artifact},
            "invocations": {"type": "array", "items": {"type": "object", "required": ["executionSuccessful"], "properties": {
                "executionSuccessful": {"type": "boolean"},
                "toolExecutionNotifications": {"type": "array", "items": {"type": "object", "required": ["message"], "properties": {"level": level, "message": message}}},
            }}},
            "results": {"type": "array", "items": result},
            "columnKind": {"enum": ["utf16CodeUnits", "unicodeCodePoints"]},
            "properties": {"type": "object"},
        },
    });
    json!({
        "type": "object", "required": ["version", "runs"], "additionalProperties": false,
        "properties": {"$schema": {"type": "string", "format": "uri"}, "version": {"const": "2.1.0"}, "runs": {"type": "array", "minItems": 1, "items": run}},
    })
}

#[test]
fn sarif_has_its_form_and_all_findings() {
    let folder = TempDir::new().unwrap();
    let list = folder.path().join("accepted.json").to_str().unwrap().to_owned();
    let file = layer(&folder, "a field.geojson", 4, [0, 1, 2]);
    audited(&file, &["--accept-all", &list]);
    let mut lists = read(&list);
    lists["accepted"].as_array_mut().unwrap().remove(0);
    fs::write(&list, lists.to_string()).unwrap();
    let (mut schemas, mut compiler) = (Schemas::new(), Compiler::new());
    compiler.enable_format_assertions();
    compiler.add_resource("urn:sarif", sarif_schema()).unwrap();
    let schema = compiler.compile("urn:sarif", &mut schemas).unwrap();
    let cases = [
        (&["--snap", "auto", "--coverage", "--accept", &list][..], 2, "error"),
        (&["--coverage"], 8, "error"),
        // The crossing of borders follows from the finding.
        (&[], 8, "error"),
    ];
    for (options, count, level) in cases {
        let (_, found) = run(&[&["audit", &file, "--format", "sarif"], options].concat());
        if let Err(why) = schemas.validate(&found, schema) {
            panic!("{options:?}: {why}");
        }
        let run = &found["runs"][0];
        let results = run["results"].as_array().unwrap();
        assert_eq!(results.len(), count, "{options:?}");
        let overlap = results.iter().find(|one| one["ruleId"] == "C1").unwrap();
        assert_eq!(overlap["level"], level, "{options:?}");
        let rules = run["tool"]["driver"]["rules"].as_array().unwrap();
        for one in results {
            assert_eq!(rules[one["ruleIndex"].as_u64().unwrap() as usize]["id"], one["ruleId"]);
        }
        let accepted = results.iter().filter(|one| one.get("suppressions").is_some()).count();
        assert_eq!(accepted, usize::from(count == 2), "{options:?}");
        let uri = overlap["locations"][0]["physicalLocation"]["artifactLocation"]["uri"].as_str().unwrap();
        assert!(uri.starts_with("file:///") && uri.ends_with("/a%20field.geojson"), "{uri}");
    }
}

#[test]
fn junit_has_a_case_for_each_rule() {
    let folder = TempDir::new().unwrap();
    let file = layer(&folder, "a&b.geojson", 4, [0, 1, 2]);
    let written = |options: &[&str]| {
        let output = twinedge(&[&["audit", &file, "--format", "junit"], options].concat());
        String::from_utf8(output.stdout).unwrap()
    };
    let text = written(&["--snap", "auto", "--coverage"]);
    assert!(
        text.starts_with(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites tests=\"26\" failures=\"2\" errors=\"0\""
        ),
        "{text}"
    );
    assert!(text.contains("/a&amp;b.geojson\" tests=\"26\""), "{text}");
    assert_eq!((text.matches("<testcase ").count(), text.matches("<failure ").count()), (26, 2));
    assert!(text.contains("name=\"C1 overlap\" time=\"0\"><failure type=\"violation\" message=\"C1-"), "{text}");
    // An accepted finding is not a failure.
    let list = folder.path().join("accepted.json").to_str().unwrap().to_owned();
    written(&["--snap", "auto", "--accept-all", &list]);
    let text = written(&["--snap", "auto", "--coverage", "--accept", &list]);
    assert_eq!((text.matches("<testcase ").count(), text.matches("<failure ").count()), (26, 0), "{text}");
    // Without cuts G4 fails, and the rules that need it are skipped.
    let text = written(&[]);
    let count = |what: &str| text.matches(what).count();
    assert_eq!((count("<testcase "), count("<failure "), count("<skipped ")), (19, 1, 2), "{text}");
}
