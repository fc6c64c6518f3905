//! An audit as a gate: accepted findings, differences, SARIF and `JUnit`.

use crate::shared::{has, members};
use crate::support::{Asked, parsed};
use boon::{Compiler, Schemas};
use serde_json::{Value, json};
use twinedge_report::{Accepted, Audited, Compared};

/// Three fields in this order: one with a height of 4 and perhaps a lake of this width, one that overlaps it by 1, and a separate one.
fn layer(lake: u32, order: [usize; 3]) -> String {
    let square = |x0: u32, y0: u32, x1: u32, y1: u32| [[x0, y0], [x1, y0], [x1, y1], [x0, y1], [x0, y0]];
    let feature = |id: &str, rings: Value| json!({"type": "Feature", "id": id, "properties": {}, "geometry": {"type": "Polygon", "coordinates": rings}});
    let field = square(0, 0, 40, 40);
    let features = [
        feature("field", if lake == 0 { json!([field]) } else { json!([field, square(10, 10, 10 + lake, 14)]) }),
        feature("beside", json!([square(39, 0, 60, 40)])),
        feature("apart", json!([square(100, 0, 120, 40)])),
    ];
    json!({"type": "FeatureCollection", "features": order.map(|place| features[place].clone())}).to_string()
}

/// Borders are cut, so that overlaps do not break G4.
const JUDGED: &str = "--snap auto --coverage";

/// A list that accepts nothing, with which all findings are listed.
const NOTHING: &[u8] = br#"{"schema": "twinedge-accepted/1", "accepted": []}"#;

fn judged(lake: u32, order: [usize; 3], words: &str, list: &[u8]) -> Audited {
    Asked::new(words).accepting(list).audit("/maps/a & b.geojson", layer(lake, order)).unwrap()
}

/// A list of all findings with this reason. Those of the list before keep theirs.
fn all(audited: &Audited, before: &[u8], reason: &str) -> Vec<u8> {
    audited.accept_all(Some(&Accepted::read(str::from_utf8(before).unwrap()).unwrap()), reason, "2026-01-31").unwrap()
}

fn read(bytes: &[u8]) -> Value {
    serde_json::from_slice(bytes).unwrap()
}

/// The list without its first entry.
fn without_first(list: &[u8]) -> Vec<u8> {
    let mut list = read(list);
    list["accepted"].as_array_mut().unwrap().remove(0);
    list.to_string().into_bytes()
}

/// The rules of the listed findings of the coverage that are accepted, or not accepted.
fn rules(found: &Value, accepted: bool) -> Value {
    let mut all = found["coverage"]["findings"].as_array().unwrap().clone();
    all.retain(|one| one.get("accepted").is_some() == accepted);
    members(&all.into(), &["rule"])
}

#[test]
fn what_was_accepted_breaks_nothing_until_it_grows() {
    let may = judged(4, [0, 1, 2], JUDGED, NOTHING);
    assert_eq!(rules(&parsed(&may), false), json!(["C1", "C2"]));
    let list = all(&may, NOTHING, "a lake, and a quarrel");
    let lake = read(&list)["accepted"][1].clone();
    let written = json!({"rule": "C2", "features": ["field"], "area": 16, "reason": "a lake, and a quarrel", "date": "2026-01-31"});
    has(&lake, &written);
    let id = &lake["id"];
    for (lake, order, expected) in [
        // The features in another order.
        (4, [2, 1, 0], json!({"verdict": "valid", "accepted": {"count": 2, "grown": [], "gone": []}})),
        (
            5,
            [0, 1, 2],
            json!({"verdict": "invalid", "accepted": {"count": 1, "grown": [id], "gone": []}, "first": {"id": id}}),
        ),
        (0, [0, 1, 2], json!({"verdict": "valid", "accepted": {"count": 1, "grown": [], "gone": [id]}})),
        (3, [0, 1, 2], json!({"verdict": "valid", "accepted": {"count": 2, "grown": []}})),
    ] {
        let found = parsed(&judged(lake, order, JUDGED, &list));
        has(&found, &expected);
        let open = if lake == 5 { json!(["C2"]) } else { json!([]) };
        assert_eq!((rules(&found, false), &found["coverage"]["findings"][0]["accepted"]), (open, &written["reason"]));
    }
    // A finding that is accepted again keeps its reason, unless it grew.
    let june = judged(5, [0, 1, 2], JUDGED, &list);
    let again = all(&june, &list, "it has grown");
    assert_eq!(members(&read(&again)["accepted"], &["reason"]), json!(["a lake, and a quarrel", "it has grown"]));
    assert!(judged(5, [0, 1, 2], JUDGED, &again).is_valid());
}

#[test]
fn what_follows_from_accepted_findings_is_accepted_with_them() {
    let list = all(&judged(4, [0, 1, 2], "", NOTHING), NOTHING, "as it is");
    let found = parsed(&judged(4, [0, 1, 2], "--coverage", &list));
    let headline = "valid (2 accepted): all else that was checked holds";
    has(&found, &json!({"verdict": "valid", "accepted": {"count": 2}, "headline": headline}));
    assert!(found["violations"].as_array().unwrap().iter().all(|one| one["accepted"] == "as it is"));
    // Without one of the two entries, the clashes may follow from that finding.
    let found = parsed(&judged(4, [0, 1, 2], "", &without_first(&list)));
    // Everything that counts is a cause, or follows from a reported cause.
    assert!(found["verdict"] == "invalid" && found["causes"].as_u64() > Some(0) && found["first"]["id"].is_string());
    let lists = [&found["violations"], &found["coverage"]["findings"]].map(|list| list.as_array().unwrap());
    let open: Vec<&Value> = lists.into_iter().flatten().filter(|one| one.get("accepted").is_none()).collect();
    let told = |id: &Value| open.iter().any(|one| one["id"] == *id);
    assert!(open.iter().filter_map(|one| one.get("follows_from_id")).all(told), "{found}");
}

#[test]
fn a_violation_of_the_structure_that_follows_from_nothing_cannot_be_accepted() {
    let audit = |list: &[u8]| {
        Asked::new("").accepting(list).audit("lines", "LINESTRING(0 0,2 2)\nLINESTRING(0 2,2 0)\n").unwrap()
    };
    let list = all(&audit(NOTHING), NOTHING, "as it is");
    has(&parsed(&audit(&list)), &json!({"verdict": "invalid", "causes": 1}));
}

#[test]
fn a_file_that_is_no_list_of_accepted_findings_is_refused() {
    for (text, why) in [
        ("[", "no list of accepted findings: EOF while parsing"),
        (r#"{"schema": "x", "accepted": []}"#, "its schema is \"x\""),
        (
            r#"{"schema": "twinedge-accepted/1", "accepted": [{"id": "a"}, {"id": "a"}]}"#,
            "the finding a is accepted twice",
        ),
    ] {
        let error = Accepted::read(text).unwrap_err().to_string();
        assert!(error.contains(why), "{error}");
    }
}

#[test]
fn a_difference_has_what_is_new_and_gone_and_changed() {
    let report = |lake, order| parsed(&judged(lake, order, JUDGED, NOTHING));
    let (may, june, dry) = (report(4, [0, 1, 2]), report(5, [2, 0, 1]), report(0, [0, 1, 2]));
    let lake = &may["coverage"]["findings"][1]["id"];
    for (old, new, expected) in [
        (&may, &may, json!({"new": [], "gone": [], "changed": [], "same": 2})),
        (&may, &june, json!({"new": [], "gone": [], "changed": [lake], "same": 1})),
        (&may, &dry, json!({"new": [], "gone": [lake], "changed": [], "same": 1})),
        (&dry, &may, json!({"new": [lake], "gone": [], "changed": [], "same": 1})),
    ] {
        let [old, new] = [old, new].map(|report| Compared::new(report).unwrap());
        assert_eq!(serde_json::to_value(old.difference(&new)).unwrap(), expected);
    }
}

#[test]
fn reports_that_do_not_say_all_are_not_compared() {
    let short = parsed(&Asked::new("--snap auto --coverage --list 0").audit("may", layer(4, [0, 1, 2])).unwrap());
    for (report, why) in [
        (short, "it lists 0 of 2 findings"),
        (json!({"counts": null}), "its audit did not end"),
        (json!({}), "it has no counts"),
        (json!({"counts": {}, "violation_count": 1, "violations": [{}]}), "a finding has no id"),
    ] {
        let error = Compared::new(&report).unwrap_err().to_string();
        assert!(error.contains(why), "{error}");
    }
}

/// The requirements of the schema of SARIF 2.1.0 (OASIS, sections 3.13 to 3.54) on this output: required members, names, and the forms of values.
const SARIF: &str = r##"{"type": "object", "additionalProperties": false, "required": ["version", "runs"], "properties": {
"$schema": {"type": "string", "format": "uri"}, "version": {"const": "2.1.0"}, "runs": {"type": "array", "minItems": 1, "items": {
  "type": "object", "additionalProperties": false, "required": ["tool"], "properties": {
    "tool": {"type": "object", "required": ["driver"], "properties": {"driver": {"type": "object", "required": ["name"], "properties": {
      "name": {"const": "twinedge"}, "version": {"type": "string"}, "rules": {"type": "array", "uniqueItems": true, "items": {
        "type": "object", "additionalProperties": false, "required": ["id"],
        "properties": {"id": {"type": "string"}, "name": {"type": "string"}, "shortDescription": {"$ref": "#/$defs/message"}}}}}}}},
    "artifacts": {"type": "array", "minItems": 1, "uniqueItems": true, "items": {
      "type": "object", "additionalProperties": false, "required": ["location"], "properties": {
        "location": {"type": "object", "required": ["uri"], "properties": {"uri": {"$ref": "#/$defs/uri"}}},
        "length": {"type": "integer", "minimum": 0}, "hashes": {"type": "object", "additionalProperties": {"type": "string"}}}}},
    "invocations": {"type": "array", "items": {"type": "object", "required": ["executionSuccessful"], "properties": {
      "executionSuccessful": {"type": "boolean"}, "toolExecutionNotifications": {"type": "array", "items": {
        "type": "object", "required": ["message"], "properties": {"level": {"$ref": "#/$defs/level"}, "message": {"$ref": "#/$defs/message"}}}}}}},
    "results": {"type": "array", "items": {"type": "object", "additionalProperties": false, "required": ["message"], "properties": {
      "ruleId": {"type": "string"}, "ruleIndex": {"type": "integer", "minimum": -1}, "level": {"$ref": "#/$defs/level"},
      "message": {"$ref": "#/$defs/message"}, "locations": {"type": "array", "items": {
        "type": "object", "additionalProperties": false, "properties": {
          "physicalLocation": {"type": "object", "additionalProperties": false, "required": ["artifactLocation"], "properties": {
            "artifactLocation": {"type": "object", "properties": {"uri": {"$ref": "#/$defs/uri"}, "index": {"type": "integer"}}},
            "region": {"type": "object", "properties": {"startLine": {"type": "integer", "minimum": 1}}}}},
          "logicalLocations": {"type": "array", "uniqueItems": true, "items": {"type": "object", "properties": {"name": {"type": "string"}}}}}}},
      "partialFingerprints": {"type": "object", "additionalProperties": {"type": "string"}},
      "suppressions": {"type": "array", "items": {"type": "object", "required": ["kind"],
        "properties": {"kind": {"enum": ["inSource", "external"]}, "justification": {"type": "string"}}}}}}},
    "columnKind": {"enum": ["utf16CodeUnits", "unicodeCodePoints"]}, "properties": {"type": "object"}}}}},
"$defs": {
  "message": {"type": "object", "required": ["text"], "properties": {"text": {"type": "string", "minLength": 1}}},
  "level": {"enum": ["none", "note", "warning", "error"]}, "uri": {"type": "string", "format": "uri-reference"}}}"##;

#[test]
fn sarif_has_its_form_and_all_findings() {
    let accepted = without_first(&all(&judged(4, [0, 1, 2], JUDGED, NOTHING), NOTHING, "a quarrel"));
    let (mut schemas, mut compiler) = (Schemas::new(), Compiler::new());
    compiler.enable_format_assertions();
    compiler.add_resource("urn:sarif", read(SARIF.as_bytes())).unwrap();
    let schema = compiler.compile("urn:sarif", &mut schemas).unwrap();
    // Where borders are not cut, their crossings follow from the findings.
    for (words, list, count, level) in [
        (JUDGED, &*accepted, 2, "error"),
        ("--coverage", NOTHING, 8, "error"),
        ("", NOTHING, 8, "error"),
        ("--snap auto", NOTHING, 2, "warning"),
    ] {
        let found = read(&judged(4, [0, 1, 2], words, list).sarif().unwrap());
        if let Err(why) = schemas.validate(&found, schema) {
            panic!("{words}: {why}");
        }
        let run = &found["runs"][0];
        let results = run["results"].as_array().unwrap();
        assert_eq!(results.len(), count, "{words}");
        let overlap = results.iter().find(|one| one["ruleId"] == "C1").unwrap();
        assert_eq!(overlap["level"], level, "{words}");
        let rules = run["tool"]["driver"]["rules"].as_array().unwrap();
        for one in results {
            assert_eq!(rules[one["ruleIndex"].as_u64().unwrap() as usize]["id"], one["ruleId"]);
        }
        let accepted = results.iter().filter(|one| one.get("suppressions").is_some()).count();
        assert_eq!(accepted, usize::from(words == JUDGED), "{words}");
        let uri = &overlap["locations"][0]["physicalLocation"]["artifactLocation"]["uri"];
        assert_eq!(uri, "file:///maps/a%20%26%20b.geojson");
    }
}

#[test]
fn junit_has_a_case_for_each_rule() {
    let accepted = all(&judged(4, [0, 1, 2], "--snap auto", NOTHING), NOTHING, "a quarrel");
    // An accepted finding is not a failure. Without cuts G4 fails, and the rules that need it are skipped.
    for (words, list, expected) in
        [(JUDGED, NOTHING, [26, 2, 0]), (JUDGED, &*accepted, [26, 0, 0]), ("", NOTHING, [19, 1, 2])]
    {
        let text = judged(4, [0, 1, 2], words, list).junit().unwrap();
        let counts = ["<testcase ", "<failure ", "<skipped "].map(|what| text.matches(what).count());
        assert_eq!(counts, expected, "{text}");
        if expected != [26, 2, 0] {
            continue;
        }
        let begins = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites tests=\"26\" failures=\"2\" errors=\"0\"";
        assert!(text.starts_with(begins) && text.contains("/a &amp; b.geojson\" tests=\"26\""), "{text}");
        assert!(text.contains("name=\"C1 overlap\" time=\"0\"><failure type=\"violation\" message=\"C1-"), "{text}");
    }
}
