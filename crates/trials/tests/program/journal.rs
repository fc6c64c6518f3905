//! `replay --map`.

use super::{refused, trials_reading};
use serde_json::Value;

const MONDAY: &str = "twinedge edits 1
insert_ring 0,0 4,0 4,4 0,4
insert_segment 1,0 3,4     # a fence
add_feature
set_features_of f1 0
move_vertex v1 5,0
remove_edge h1
";

fn replay(journal: &str, more: &[&str]) -> (Option<i32>, String) {
    let output = trials_reading(&[&["replay", "--map", "-"], more].concat(), journal.as_bytes());
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
    (output.status.code(), String::from_utf8(output.stdout).unwrap())
}

#[test]
fn a_journal_is_replayed_step_by_step_and_its_json_is_a_journal() {
    let (status, text) = replay(MONDAY, &[]);
    assert_eq!(status, Some(0), "{text}");
    for line in [
        "1. insert_ring 0,0 4,0 4,4 0,4: done",
        "   vertices made 2, edges made 1, edges split 2, faces split 1",
        "5. move_vertex v1 5,0: done",
        "   edges dropped 1, faces merged 1",
        "each edit was done: 6 vertices, 6 edges, 2 faces, 1 feature",
    ] {
        assert!(text.lines().any(|shown| shown == line), "{line}\n{text}");
    }
    let (status, json) = replay(MONDAY, &["--format", "json"]);
    let replayed: Value = serde_json::from_str(&json).unwrap();
    assert_eq!((status, &replayed["ok"], &replayed["vertices"]), (Some(0), &true.into(), &6.into()));
    assert_eq!(replayed["steps"].as_array().unwrap().len(), 6);
    assert_eq!(replay(&json, &["--format", "json"]), (Some(0), json));
}

#[test]
fn an_edit_that_is_not_done_is_told_and_the_others_are_done() {
    let journal =
        "twinedge edits 1\ninsert_segment 0,0 2,2\ninsert_segment 0,2 2,0\nremove_edge !h0\nremove_vertex v0\n";
    let (status, text) = replay(journal, &[]);
    assert_eq!(status, Some(1));
    assert!(text.contains("2. insert_segment 0,2 2,0: refused: it would cross the edge of "), "{text}");
    assert!(text.contains("3. remove_edge !h0: skipped: there is nothing to choose from"), "{text}");
    assert!(text.ends_with("2 of 4 edits were not done: 1 vertex, 0 edges, 1 face, 0 features\n"), "{text}");
    let (status, json) = replay(journal, &["--format", "json"]);
    let replayed: Value = serde_json::from_str(&json).unwrap();
    assert_eq!((status, &replayed["ok"]), (Some(1), &false.into()));
    assert_eq!(replayed["steps"][1]["outcome"], "refused");
}

/// Regression: the number was taken modulo the number of vertices, and numbers from 65,536 on were not vertices.
#[test]
fn a_number_past_the_last_is_told_and_does_not_begin_again() {
    let journal =
        "twinedge edits 1\ninsert_segment 0,0 2,2\nmove_vertex v2 5,5\nremove_vertex v70000\nremove_vertex v1\n";
    let (status, text) = replay(journal, &[]);
    assert_eq!(status, Some(1));
    assert!(text.contains("2. move_vertex v2 5,5: skipped: there is no v2: 2 are there\n"), "{text}");
    assert!(text.contains("3. remove_vertex v70000: skipped: there is no v70000: 2 are there\n"), "{text}");
    assert!(text.ends_with("2 of 4 edits were not done: 1 vertex, 0 edges, 1 face, 0 features\n"), "{text}");
}

#[test]
fn what_is_no_journal_is_refused_with_its_place() {
    for (journal, place) in [
        ("twinedge program 1\n", "line 1, column 1: expected the line `twinedge edits 1`"),
        ("twinedge edits 1\nmove_vertex f0 1,1\n", "line 2, column 13: expected a vertex"),
        (
            r#"{"steps": [{"op": "add_feature"}, {"op": "add_face"}]}"#,
            "step 2: `add_face`: expected the name of an operator",
        ),
        (r#"{"steps": 3}"#, "invalid type: integer `3`, expected a sequence at line 1"),
    ] {
        let output = trials_reading(&["replay", "--map", "-"], journal.as_bytes());
        refused(output, &format!("standard input: {place}"));
    }
}
