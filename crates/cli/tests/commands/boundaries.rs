//! `twinedge audit --boundaries` and `twinedge convert --boundaries`: boundaries of OpenStreetMap.

use crate::support::{complaint, json as run, twinedge};
use pbf::File;
use serde_json::{Value, json};

#[path = "../../../../extras/osm/tests/osm/pbf.rs"]
mod pbf;

/// Two adjacent squares.
fn squares() -> File {
    let mut file = File::default();
    for (id, x, y) in [(1, 0, 0), (2, 1, 0), (3, 1, 1), (4, 0, 1), (5, 2, 0), (6, 2, 1)] {
        file.node(id, x, y);
    }
    file.way(10, &[2, 3]);
    file.way(11, &[3, 4, 1, 2]);
    file.way(12, &[2, 5, 6, 3]);
    file.relation(100, "6", "West", &[(10, "outer"), (11, "outer")]);
    file.relation(200, "6", "East", &[(12, ""), (10, "")]);
    file
}

fn audited(file: &File) -> (Option<i32>, Value) {
    let file = file.written();
    let path = file.path().to_str().unwrap();
    run(&["audit", path, "--boundaries", "admin_level=6", "--coverage", "--format", "json", "--explain"])
}

#[test]
fn relations_and_the_coverage_that_they_make_are_judged() {
    let (status, report) = audited(&squares());
    assert_eq!((status, &report["verdict"], &report["counts"]["faces"]), (Some(0), &json!("valid"), &json!(3)));
    assert_eq!(report["options"]["boundaries"], json!("admin_level=6"));
    let ids: Vec<_> = report["rules"].as_array().unwrap().iter().take(6).map(|rule| rule["id"].clone()).collect();
    assert_eq!(ids, ["O1", "O2", "O3", "O4", "O5", "R1"]);

    let mut file = squares();
    file.relation(300, "6", "West again", &[(10, ""), (11, "")]);
    let (status, report) = audited(&file);
    assert_eq!((status, &report["verdict"], &report["first"]["rule"]), (Some(1), &json!("invalid"), &json!("O4")));
    let finding = &report["findings"][0];
    assert_eq!((&finding["kind"], &finding["records"]), (&json!("same_side"), &json!(["way 10", "way 11"])));
    let message = "West (relation/100) and West again (relation/300) lie on the same side of 2 ways";
    assert_eq!(finding["message"], json!(message));
    let of_coverage = &report["coverage"]["findings"];
    assert_eq!(of_coverage[0]["rule"], json!("C5"), "{of_coverage}");
}

/// A layer without polygons would be refused; here, the reason is a finding.
#[test]
fn relations_without_any_ring_are_invalid() {
    let mut file = squares();
    file.ways.clear();
    let (status, report) = audited(&file);
    assert_eq!((status, &report["verdict"], &report["finding_count"]), (Some(1), &json!("invalid"), &json!(4)));
    assert_eq!(report["first"]["rule"], json!("O1"));
}

#[test]
fn boundaries_are_converted_with_a_warning_of_faults() {
    let convert = |file: &File| {
        let file = file.written();
        let path = file.path().to_str().unwrap().to_owned();
        twinedge(&["convert", &path, "--boundaries", "admin_level", "-o", "-", "--to", "geojson"])
    };
    let output = convert(&squares());
    let layer: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(
        (&layer["features"][1]["id"], &layer["features"][1]["properties"]["name"]),
        (&json!("relation/200"), &json!("East"))
    );
    assert!(output.stderr.is_empty());
    let mut open = squares();
    open.ways.pop();
    let output = convert(&open);
    let warning = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success() && warning.contains("the relations have 2 faults"), "{warning}");
}

#[test]
fn a_file_without_tags_to_look_for_says_how_to_ask() {
    let file = squares().written();
    let path = file.path().to_str().unwrap();
    let refused = |arguments: &[&str], why: &str| {
        let complaint = complaint(&twinedge(&[&["audit"], arguments].concat()));
        assert!(complaint.contains(why), "{complaint}");
    };
    refused(&[path], "--boundaries admin_level=6");
    refused(&[path, "--boundaries", "admin_level=2"], "admin_level=2");
    refused(&["-", "--boundaries", "admin_level=2"], "a file .osm.pbf is needed");
    let misused = twinedge(&["audit", path, "--boundaries", "=2"]);
    assert!(String::from_utf8(misused.stderr).unwrap().contains("KEY=VALUE or KEY"));
}
