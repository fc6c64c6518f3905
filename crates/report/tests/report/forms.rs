//! Reports of the library, and the JSON of audits, conform to `docs/report.schema.json`; all forms of a report have the same findings.

use crate::shared::TOWN;
use crate::support::{Asked, crossing, file, page_data, uncoloured};
use boon::{Compiler, Schemas};
use serde_json::{Value, json, to_value};
use twinedge::validate::{Collect, Expectation, Table, validate};

/// Returns the first violation of the schema.
fn complaint(document: &Value) -> Option<String> {
    let (mut schemas, mut compiler) = (Schemas::new(), Compiler::new());
    let path = format!("{}/../../docs/report.schema.json", env!("CARGO_MANIFEST_DIR"));
    let schema = compiler.compile(&path, &mut schemas).unwrap();
    schemas.validate(document, schema).err().map(|error| error.to_string())
}

#[test]
fn reports_of_the_library_have_the_form() {
    let (mut valid, mut broken) = (0, 0);
    for text in ["V 0 H 0 B 0 F 1 - 0", "V 1 0 - H 1 0 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0", "V 1 0 - H 1 9 - - - - B 0 F 0"]
    {
        let table: Table = text.parse().unwrap();
        for expectation in [Expectation::plane(), Expectation::surface().open().genus(1)] {
            for collect in [Collect::All, Collect::First] {
                let report = validate(&table, &expectation, collect);
                let document = to_value(&report).unwrap();
                assert_eq!(complaint(&document), None, "{document:#}");
                if report.is_valid() { valid += 1 } else { broken += 1 }
            }
        }
    }
    assert!(valid > 0 && broken > 4, "{valid} {broken}");
}

/// Counts zeros with a sign in JSON text.
fn negative_zeros(text: &str) -> usize {
    text.split([' ', ',', '[', ']', '\n']).filter(|word| ["-0", "-0.0"].contains(word)).count()
}

/// Every kind of input in every form: the form of the JSON, and equal findings in all forms.
#[test]
fn all_forms_of_all_audits_have_what_the_page_promises() {
    let tables = file("examples/tables/five_faces.txt").replace("e2,2       V2      e2,1", "e2,2       V2      e3,1");
    let mut arcs: Value = serde_json::from_str(&file("crates/layers/tests/layer/data/south-america.topojson")).unwrap();
    arcs["objects"]["countries"]["geometries"][0]["arcs"][0][0][0] = json!(36);
    let mut town = TOWN.to_vec();
    // The first `mbr`: a box of 93 bytes, one of which belongs to the last ordinate.
    let at = town.windows(4).position(|bytes| bytes == [0, 0, 0, 93]).expect("a box");
    town[at + 93] ^= 1;
    let signed = "LINESTRING (-0.0 0, 2 2)\nLINESTRING (0 2, 2 -0.0)\nLINESTRING (-0.0 0, 0 0, -1 -1)\n";
    let open = "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 1 0 3\n3 1 2 3\n";
    let inside_out = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 3 1\n3 1 3 2\n3 2 3 0\n";
    let audit = |words: &str, input: &[u8]| {
        Asked::new(&format!("{words} --explain --list 1000")).audit("input", input).unwrap()
    };
    let [county, state] = [3, 2].map(|x| format!("POLYGON ((0 0, {x} 0, {x} 2, 0 2, 0 0))"));
    for (of, audited) in [
        ("crossing", audit("", crossing().as_bytes())),
        ("signed", audit("", signed.as_bytes())),
        ("open", audit("--closed", open.as_bytes())),
        ("inside out", audit("--outward", inside_out.as_bytes())),
        ("tables", audit("", tables.as_bytes())),
        ("layers", Asked::new("--explain --list 1000").against(&county, &state).unwrap()),
        ("arcs", audit("--arcs", arcs.to_string().as_bytes())),
        ("town", audit("", &town)),
    ] {
        let json = String::from_utf8(audited.json().unwrap()).unwrap();
        let document: Value = serde_json::from_str(&json).unwrap();
        assert_eq!((complaint(&document), negative_zeros(&json)), (None, 0), "{of}: {json}");
        assert!(!audited.is_valid(), "{of}");
        let lists = [&document["violations"], &document["findings"], &document["coverage"]["findings"]];
        let listed: Vec<&Value> = lists.into_iter().filter_map(Value::as_array).flatten().collect();
        let has_all = |one: &&Value| ["kind", "message", "cause", "remedy"].iter().all(|key| one[key].is_string());
        assert!(!listed.is_empty() && listed.iter().all(has_all), "{of}: {json}");
        let sorted = |mut messages: Vec<String>| {
            messages.sort();
            messages
        };
        // Only the layer and the page show that a finding follows from another one.
        let message = |one: &Value| {
            let words = one["sentence"].as_str().or(one["message"].as_str()).unwrap();
            words.split(", which follows").next().unwrap().to_owned()
        };
        let messages = sorted(listed.iter().map(|one| message(one)).collect());
        let text = uncoloured(&audited.text().unwrap());
        assert!(messages.iter().all(|message| text.contains(message)), "{of}: {text}");
        if audited.mesh().is_none() {
            let (layer, _) = audited.findings().unwrap();
            let layer: Value = serde_json::from_slice(&layer).unwrap();
            let features = layer["features"].as_array().unwrap();
            assert_eq!(sorted(features.iter().map(|one| message(&one["properties"])).collect()), messages, "{of}");
            let page = page_data(&audited.page().unwrap()).unwrap();
            let findings = page["findings"].as_array().unwrap();
            assert_eq!(sorted(findings.iter().map(message).collect()), messages, "{of}");
        }
    }
}

/// The schema rejects something.
#[test]
fn other_documents_do_not_have_the_form() {
    let table: Table = "V 1 0 - H 1 0 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0".parse().unwrap();
    let right = to_value(validate(&table, &Expectation::plane(), Collect::All)).unwrap();
    let changes: [fn(&mut Value); 7] = [
        |d| d["coverage"] = json!({ "findings": [{ "rule": "C1", "kind": "overlap", "features": [], "at": [0, 0] }] }),
        |d| d["schema"] = json!("twinedge-report/2"),
        |d| d["counts"]["edges"] = json!(-1),
        |d| d["rules"][0]["id"] = json!(7),
        |d| d["rules"][4]["unchecked"] = json!({ "because": "L1" }),
        |d| d["violations"][0]["records"] = json!([{ "corner": 0 }]),
        |d| {
            d.as_object_mut().unwrap().remove("valid");
        },
    ];
    for change in changes {
        let mut document = right.clone();
        change(&mut document);
        assert!(complaint(&document).is_some(), "{document}");
    }
}
