//! The table of options, and those who read it.

use crate::support::file;
use serde_json::{Map, Value, json};
use twinedge_report::{Options, OptionsError};

fn read(members: &Value) -> Result<Options, OptionsError> {
    Options::from_json(members.as_object().cloned().unwrap_or_default())
}

fn names() -> Vec<String> {
    let all = serde_json::to_value(Options::default()).unwrap();
    all.as_object().into_iter().flat_map(Map::keys).cloned().collect()
}

#[test]
fn names_are_read_in_snake_case_and_in_camel_case() {
    let all = [
        json!({ "gap_width": 2, "accept_gap": [[1, 2]], "no_zero_area": true, "snap": "auto", "parent_column": "a=b" }),
        json!({ "gapWidth": 2, "acceptGaps": [[1, 2]], "noZeroArea": true, "snap": "auto", "parentColumn": "a=b" }),
    ];
    let [snake, camel] = all.map(|members| serde_json::to_value(read(&members).unwrap()).unwrap());
    assert_eq!(snake, camel);
    let given = [("gap_width", json!(2.0)), ("accept_gap", json!([[1.0, 2.0]])), ("no_zero_area", json!(true))];
    for (name, value) in given.into_iter().chain([("snap", json!("auto")), ("parent_column", json!("a=b"))]) {
        assert_eq!(snake[name], value, "{name}");
    }
}

#[test]
fn a_wrong_option_is_named_as_it_was_given() {
    let wrong = [
        (json!({ "gapWith": 1 }), "gapWith: there is no such option"),
        (json!({ "gapwidth": 1 }), "gapwidth: there is no such option"),
        (json!({ "lakeWidth": -1 }), "lakeWidth: a negative number"),
        (json!({ "gap_width": 1, "snap": 0 }), "snap: neither `auto` nor a positive number"),
        (json!({ "snap": "fine" }), "snap: neither `auto` nor a positive number"),
        (json!({ "coverage": 3 }), "coverage: invalid type: integer `3`, expected a boolean"),
        (json!({ "edges": "round" }), "edges: unknown variant `round`, expected `straight` or `geodesic`"),
        (json!({ "parentColumn": "=key" }), "parentColumn: neither COLUMN nor COLUMN=KEY"),
        (json!({ "acceptGaps": [[1]] }), "acceptGaps: invalid length 1, expected an array of length 2"),
    ];
    for (members, message) in wrong {
        assert_eq!(read(&members).unwrap_err().to_string(), message);
    }
}

/// JavaScript and Python pass options on, so nothing but this keeps their lists complete.
#[test]
fn every_option_stands_in_the_types_of_javascript_and_in_the_signature_of_python() {
    let (javascript, python) =
        (file("bindings/web/package/index.d.ts"), file("bindings/python/python/twinedge/_audit.py"));
    let (_, signature) = python.split_once("\ndef audit(").unwrap();
    let (signature, _) = signature.split_once(") -> Report:").unwrap();
    for name in names() {
        let words: Vec<&str> = name.split('_').collect();
        let camel: String = words[1..].iter().map(|word| word[..1].to_uppercase() + &word[1..]).collect();
        let (in_javascript, in_python) = match name.as_str() {
            "accept_gap" => ("acceptGaps".to_owned(), "accept_gaps"),
            "name_from" => ("nameFrom".to_owned(), "name"),
            "no_unused_vertices" => ("noUnusedVertices".to_owned(), "used"),
            "sliver" => ("sliver".to_owned(), "sliver_area"),
            // Three sides, and a layer in memory may be empty.
            "triangles" | "allow_empty" => (words[0].to_owned() + &camel, "sides"),
            name => (words[0].to_owned() + &camel, name),
        };
        assert!(javascript.contains(&format!("  {in_javascript}?: ")), "{in_javascript} in JavaScript");
        assert!(signature.contains(&format!("    {in_python}: ")), "{in_python} in Python");
    }
}
