//! `twinedge tables`.

use crate::support::{complaint, json, twinedge};

#[test]
fn the_tables_of_two_half_edges_are_judged_alike_and_counted() {
    let (status, found) = json(&["tables", "--half-edges", "2", "--format", "json"]);
    assert_eq!(status, Some(0));
    assert_eq!(found["ok"], true);
    let rows = found["tables"].as_array().unwrap();
    for row in rows {
        assert_eq!((&row["disagreements"], &row["done"]), (&0.into(), &true.into()), "{row}");
        assert_eq!(row["right"], row["right_by_formula"], "{row}");
    }
    let judged = |free: &str| rows.iter().find(|row| row["free"] == free).unwrap()["judged"].as_u64();
    // Ten links, each to one of two records or nil.
    assert_eq!(judged("origin, twin, next, prev, leaving; nil"), Some(3_u64.pow(10)));
    // An edge or a loop: `next` of two half-edges, for the only way to pair them.
    assert_eq!(judged("next, for all twins; surfaces"), Some(4));
}

#[test]
fn without_half_edges_there_are_isolated_vertices() {
    let output = twinedge(&["tables", "--half-edges", "0"]);
    assert_eq!(output.status.code(), Some(0));
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.contains("two isolated vertices") && text.contains("agreed"), "{text}");
}

#[test]
fn what_would_not_finish_is_refused() {
    let output = twinedge(&["tables", "--half-edges", "8"]);
    assert_eq!(output.status.code(), Some(2));
    let complaint = complaint(&output);
    assert!(complaint.contains("tables") && complaint.contains("--force"), "{complaint}");
    assert_eq!(twinedge(&["tables", "--half-edges", "-1"]).status.code(), Some(2));
}

#[test]
fn lazy_runs_are_estimated_and_refused_if_they_would_not_finish() {
    let small = ["tables", "--lazy", "--parts", "prev,leaving", "--half-edges", "2"];
    let output = twinedge(&small);
    assert_eq!(output.status.code(), Some(0));
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(said.starts_with("estimated: ") && said.ends_with(" runs, about 0 seconds\n"), "{said}");
    let large =
        ["tables", "--lazy", "--expect", "surface open", "--vertices", "4", "--half-edges", "8", "--format", "json"];
    let output = twinedge(&large);
    assert_eq!(output.status.code(), Some(2));
    let complaint = complaint(&output);
    assert!(complaint.contains(" runs, about ") && complaint.contains("--force"), "{complaint}");
    assert!(complaint.contains(" of them a second on each core"), "{complaint}");
    let refused: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(refused["ok"], false);
}

#[test]
fn certificates_are_judged_lazily() {
    let edge = ["tables", "--lazy", "--certificates", "--parts", "all", "--half-edges", "2", "--faces", "1"];
    let plane = [&edge[..], &["--boundaries", "1", "--expect", "plane"]].concat();
    let output = twinedge(&[&plane[..], &["--format", "json"]].concat());
    assert_eq!(output.status.code(), Some(0));
    let said: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!([&said["accepted"], &said["differences"], &said["ok"]].map(ToString::to_string), ["4", "0", "true"]);
    // Each table with 3 orders of ranks.
    assert_eq!(said["judges"][1]["accepted"], 12);
    let text = String::from_utf8(twinedge(&plane).stdout).unwrap();
    assert!(text.starts_with("Tables: 10^11.5, with labels 10^13.1\n"), "{text}");
    let output = twinedge(&[&edge[..], &["--expect", "plane open"]].concat());
    assert_eq!(output.status.code(), Some(2));
    assert!(complaint(&output).contains("certificates are of the plane"), "{}", complaint(&output));
}
