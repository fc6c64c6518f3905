//! `twinedge corrupt`.

use crate::support::{complaint, json, twinedge};
use serde_json::Value;

fn number(row: &Value, key: &str) -> u64 {
    row[key].as_u64().unwrap_or_else(|| panic!("{key} in {row}"))
}

#[test]
fn every_wrong_field_of_the_maps_of_two_edges_is_caught() {
    let (status, found) = json(&["corrupt", "--edges", "2", "--pairs", "2000", "--seed", "7", "--format", "json"]);
    assert_eq!(status, Some(0));
    assert_eq!(found["ok"], true);
    // All subdivisions of up to 2 edges and 3 vertices, as counted by `prove`: 4 without edges, 8 with one, 36 with two.
    assert_eq!((&found["maps"], &found["maps_found"]), (&48.into(), &48.into()));
    let fields = found["fields"].as_array().unwrap();
    let of_form = |form: &str| -> Vec<&str> {
        fields.iter().filter(|row| row["form"] == form).map(|row| row["field"].as_str().unwrap()).collect()
    };
    // Besides the fields: cells, records, cycles, lists, twins and nexts exchanged, cycles joined and moved, loops halved, entries repeated.
    assert_eq!(of_form("records").len(), 5 + 2 + 3 + 2 + 10);
    assert_eq!(of_form("textbook").len(), 5 + 1 + 2 + 10);
    // Every form has one field, exchanged or not, and unchanged tables.
    assert_eq!(of_form("every").len(), 2 + 11);
    for row in fields.iter().chain([&found["small_pairs"], &found["pairs"]]) {
        assert_eq!(number(row, "missed") + number(row, "false_alarms") + number(row, "other_rule"), 0, "{row}");
        assert_eq!(number(row, "wrong"), number(row, "caught"), "{row}");
        assert!(number(row, "caught") > 0 && number(row, "corruptions") >= number(row, "wrong"), "{row}");
    }
    // A vertex with two half-edges may store either, and a face any half-edge of its cycle.
    let row = |name: &str| fields.iter().find(|row| row["field"] == name).unwrap();
    assert!(number(row("vertex: leaving"), "wrong") < number(row("vertex: leaving"), "corruptions"));
    assert_eq!(number(row("half-edge: twin"), "wrong"), number(row("half-edge: twin"), "corruptions"));
    assert_eq!((number(&found, "hung"), number(&found, "panics")), (0, 0));
    // T4 follows from the earlier rules.
    let first_broken = found["first_broken"].as_array().unwrap();
    let never = |rules: &[Value]| -> Vec<String> {
        let never = rules.iter().filter(|row| row["wrong"] == 0).map(|row| row["rule"].as_str().unwrap().to_owned());
        never.collect()
    };
    assert_eq!(never(first_broken), ["T4"]);
    let expectations = found["expectations"].as_array().unwrap();
    assert_eq!(expectations.len(), 115);
    for row in expectations {
        let rules = row["first_broken"].as_array().unwrap();
        assert!(number(row, "corruptions") > 400 && rules.len() >= 5 && never(rules).is_empty(), "{row}");
    }
    assert_eq!((number(&found["pairs"], "seed"), number(&found["pairs"], "corruptions")), (7, 2000));
}

#[test]
fn the_sample_of_pairs_is_that_of_its_seed() {
    let pairs = |seed: &str| {
        let (_, found) = json(&["corrupt", "--edges", "1", "--pairs", "1500", "--seed", seed, "--format", "json"]);
        ["corruptions", "wrong", "caught"].map(|key| number(&found["pairs"], key))
    };
    assert_eq!(pairs("1"), pairs("1"));
    let output = twinedge(&["corrupt", "--edges", "1", "--pairs", "10"]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.contains("pairs, seed ") && text.contains("sound"), "{text}");
}

#[test]
fn what_would_not_finish_is_refused() {
    let output = twinedge(&["corrupt", "--edges", "8"]);
    assert_eq!(output.status.code(), Some(2));
    let complaint = complaint(&output);
    assert!(complaint.contains("corruptions") && complaint.contains("--force"), "{complaint}");
    for arguments in [&["corrupt", "--edges", "9"][..], &["corrupt", "--seed", "x"], &["corrupt", "--threads", "0"]] {
        assert_eq!(twinedge(arguments).status.code(), Some(2), "{arguments:?}");
    }
}
