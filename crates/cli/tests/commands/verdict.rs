//! The verdict of `twinedge audit`, the judged bytes, and the ids of findings.

use crate::support::{data, json as run, twinedge_reading};
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::io::Write as _;
use std::process::{Command, Stdio};

fn audited(arguments: &[&str], input: &str) -> (Option<i32>, Value) {
    let arguments = [&["audit", "-", "--format", "json"], arguments].concat();
    let output = twinedge_reading(&arguments, input.as_bytes());
    (output.status.code(), serde_json::from_slice(&output.stdout).unwrap())
}

/// Returns the ids of all listed findings.
fn ids(found: &Value) -> BTreeSet<String> {
    let listed = [&found["violations"], &found["coverage"]["findings"]].map(|list| list.as_array().unwrap());
    listed.into_iter().flatten().map(|one| one["id"].as_str().unwrap().to_owned()).collect()
}

#[test]
fn a_verdict_says_what_was_judged() {
    let (status, found) = audited(&[], "POLYGON((0 0,1 0,0 1,0 0))\n");
    assert_eq!((status, &found["verdict"], &found["valid"]), (Some(0), &json!("valid"), &json!(true)));
    assert_eq!((&found["first"], found.get("unknown")), (&Value::Null, None));
    // Computed by `sha256sum`.
    let digest = "2cbf33d79f9a1427072bdfe4c486247d76aa40fd3299c0ebf020ca7ba0936674";
    assert_eq!(found["judged"], json!({"sha256": digest, "bytes": 27}));
    assert_eq!(found["version"], env!("CARGO_PKG_VERSION"));
    assert_eq!(found["options"], json!({}));
    let path = data("world-110m-crossing.geojson");
    let (status, found) = run(&["audit", &path, "--format", "json", "--coverage", "--gap-width", "0.5"]);
    assert_eq!((status, &found["verdict"], &found["valid"]), (Some(1), &json!("invalid"), &json!(false)));
    assert_eq!(found["judged"]["bytes"], std::fs::metadata(&path).unwrap().len());
    assert_eq!(found["options"], json!({"coverage": true, "gap_width": 0.5}));
    // Crossings follow from findings of the coverage.
    let causes: Vec<&Value> = found["coverage"]["findings"]
        .as_array()
        .unwrap()
        .iter()
        .filter(|one| one.get("follows_from").is_none())
        .collect();
    assert_eq!(found["first"]["id"], causes[0]["id"]);
    assert!(found["violations"].as_array().unwrap().iter().all(|one| one["follows_from"].is_string()));
}

#[test]
fn what_was_not_judged_in_time_is_not_valid() {
    let mut late = Command::new(env!("CARGO_BIN_EXE_twinedge"))
        .args(["audit", "-", "--format", "json", "--timeout", "0.2"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    // Nothing is written, so the input does not end.
    let kept = late.stdin.take();
    let output = late.wait_with_output().unwrap();
    drop(kept);
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!((output.status.code(), &found["verdict"], &found["valid"]), (Some(1), &json!("unknown"), &json!(false)));
    assert_eq!(found["unknown"], json!(["time was up after 0.2 s"]));
    assert_eq!((&found["counts"], &found["judged"]), (&Value::Null, &Value::Null));
}

#[test]
fn an_audit_in_time_is_as_without_a_limit() {
    let text = "POLYGON((0 0,1 0,0 1,0 0))\n";
    let [mut with, mut without] = [&["--timeout", "600"][..], &[]].map(|arguments| audited(arguments, text).1);
    for found in [&mut with, &mut without] {
        found["elapsed_ms"] = Value::Null;
    }
    assert_eq!(with, without);
}

#[test]
fn ids_are_the_same_in_any_order_of_the_features() {
    let text = std::fs::read_to_string(data("world-110m-crossing.geojson")).unwrap();
    let mut layer: Value = serde_json::from_str(&text).unwrap();
    let in_order = |layer: &Value| {
        let mut file = tempfile::Builder::new().suffix(".geojson").tempfile().unwrap();
        file.write_all(layer.to_string().as_bytes()).unwrap();
        ids(&run(&["audit", file.path().to_str().unwrap(), "--format", "json"]).1)
    };
    let before = in_order(&layer);
    assert_eq!(before.len(), 10);
    layer["features"].as_array_mut().unwrap().reverse();
    assert_eq!(in_order(&layer), before);
    layer["features"].as_array_mut().unwrap().rotate_left(50);
    assert_eq!(in_order(&layer), before);
}

/// A cell is at least 10^17 / 2^50 wide, and edges of 10 are shorter than the next power of two.
const TOO_WIDE: &str =
    "half of the edges are shorter than 16.0000, and the grid that cuts crossing borders has cells of at least 88.8178";

/// Regression: on the finest grid for a coordinate of 10^17 a cell is 128 wide. The squares and their overlap were lost, and C1 was "ok".
#[test]
fn a_coverage_is_not_checked_where_a_coordinate_far_away_makes_the_grid_too_wide() {
    let squares = "POLYGON((0 0,10 0,10 10,0 10,0 0))\nPOLYGON((5 5,15 5,15 15,5 15,5 5))\n";
    let far = format!("{squares}POINT(1e17 0)\n");
    for tiles in [&[][..], &["--tiles", "2"]] {
        let (status, near) = audited(tiles, squares);
        assert_eq!((status, &near["coverage"]["overlaps"]), (Some(1), &json!(1)), "{tiles:?}");
        assert_eq!(near["coverage"].get("not_checked"), None);
        let (status, found) = audited(tiles, &far);
        assert_eq!((status, &found["verdict"]), (Some(1), &json!("invalid")), "{tiles:?}");
        assert_eq!(found["coverage"]["not_checked"], TOO_WIDE);
    }
    // The map on that grid keeps the rules, but it no longer has the squares.
    let (status, near) = audited(&["--coverage", "--snap", "auto"], squares);
    assert_eq!((status, &near["coverage"]["overlaps"]), (Some(1), &json!(1)));
    let (status, found) = audited(&["--coverage", "--snap", "auto"], &far);
    assert_eq!((status, &found["coverage"]["not_checked"]), (Some(1), &json!(TOO_WIDE)));
    // A plane map is not cut.
    let (status, found) = audited(&["--coverage"], "POLYGON((0 0,10 0,10 10,0 10,0 0))\nPOINT(1e17 0)\n");
    assert_eq!((status, found["coverage"].get("not_checked")), (Some(0), None));
}

/// Regression: the vertex named first in the file was reported.
#[test]
fn a_component_with_handles_is_named_by_its_least_vertex_whatever_the_order_of_features() {
    let text = std::fs::read_to_string(data("world-110m-crossing.geojson")).unwrap();
    let mut map: Value = serde_json::from_str(&text).unwrap();
    let genus = |map: &Value| {
        let (_, found) = audited(&[], &map.to_string());
        let all = found["violations"].as_array().unwrap().clone();
        all.into_iter()
            .filter(|one| one["rule"] == "T3")
            .map(|one| (one["at"].clone(), one["id"].clone()))
            .collect::<Vec<_>>()
    };
    let before = genus(&map);
    assert_eq!(before.len(), 1);
    map["features"].as_array_mut().unwrap().reverse();
    assert_eq!(genus(&map), before);
}
