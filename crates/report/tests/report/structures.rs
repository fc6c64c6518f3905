//! Reports on files of tables, the tables of a textbook, topologies of PostGIS, and arcs of TopoJSON.

use crate::shared::{TOPOLOGY, TOWN, broken_town, has, members};
use crate::support::{audited, file, json, layer, page_data, refused, says, text};
use serde_json::{Value, json};

/// An isolated vertex in the unbounded face.
const RIGHT: &str = "V 1 - 0 H 0 B 1 0 v0 i0 F 1 - 1 0";

/// The face lists nothing.
const WRONG: &str = "V 1 - 0 H 0 B 1 0 v0 i0 F 1 - 0";

#[test]
fn each_line_is_judged_and_each_verdict_compared() {
    let found = json(format!("# a comment\n\n{RIGHT}\n  {RIGHT} = ok\n"), "");
    has(&found, &json!({"valid": true, "tables": 2, "violations": []}));
    let found = json(format!("{WRONG}\n{WRONG} = F2\n{RIGHT} = R1\n{WRONG} = ok\n"), "");
    has(&found, &json!({"valid": false, "verdicts_differ": 2, "rules": [{"id": "F2", "tables": 3}]}));
    let lines = json!([[1, "F2"], [2, "F2"], [3, "ok"], [4, "F2"], [4, "F2"]]);
    assert_eq!(members(&found["violations"], &["line", "rule"]), lines);
    assert_eq!(found["violations"][2]["message"], "the file says R1");
    let verdict = "not valid: 0 of 2 tables valid, 1 verdict of the file differs";
    let lines = ["line 1  F2 ", "… and 2 more; see --list", "  F2  broken in 2 tables", verdict];
    says(format!("{WRONG}\n{WRONG} = ok\n"), "--list 1", &lines);
}

#[test]
fn a_comment_says_what_tables_are_held_to() {
    // A torus of one face.
    let torus = "P 0 V 1 - - H 4 0 1 2 - - 0 0 3 - - 0 3 1 - - 0 2 0 - - B 0 F 0\n";
    for (tables, valid) in [
        ("V 0 H 2 0 1 0 - - 0 0 1 - - B 0 F 0\n".to_owned(), false),
        (format!("# expect: surface\n{torus}"), true),
        (format!("# expect: surface\n{torus}# expect: plane\n{torus}"), false),
    ] {
        assert_eq!(json(&*tables, "")["valid"], valid, "{tables}");
    }
    let table = "# expect: plane\nV 0 H 0 B 0 F 0\n";
    assert!(json(table, "--explain")["violations"][0]["remedy"].is_string());
    assert!(text(table, "--explain").lines().any(|line| line.starts_with("F1: usual cause: ")));
    assert!(!text(table, "").contains("usual cause"));
}

#[test]
fn inputs_that_are_not_of_their_kind_are_errors() {
    let unknown = file("examples/tables/five_faces.txt").replace("e2,2       V2      e2,1", "e2,2       V2      e7,3");
    for (input, words, told) in [
        (format!("{RIGHT}\nV 1 - zero\n").into_bytes(), "", "line 2: "),
        (format!("{RIGHT} R1\n").into_bytes(), "", "line 1: "),
        (b"# expect: sphere\n".to_vec(), "", "line 1: expected `plane` or `surface`"),
        (
            format!("{RIGHT}\n# expect: plane without arms\n").into_bytes(),
            "",
            "line 2: expected `open` or `asking` in place of `without`",
        ),
        (format!("{RIGHT}\nP 1 arms {RIGHT}\n").into_bytes(), "", "line 2: a part (`prev`,"),
        (b"V 0 H 0 B 0 F 0\n\xFF\n".to_vec(), "", "line 2"),
        (unknown.into_bytes(), "", "there is no half-edge `e7,3`"),
        (Vec::new(), "--postgis", "the stream is empty"),
        (TOWN[..3000].to_vec(), "--postgis", "table edge_data, row "),
        (b"{\"type\": \"FeatureCollection\"}".to_vec(), "--postgis", "no binary COPY stream begins here, but `{"),
        (TOPOLOGY.into(), "--arcs", "there are squares, town"),
    ] {
        let said = refused(input, words);
        assert!(said.contains(told), "{told}\n{said}");
    }
}

#[test]
fn tables_of_a_textbook_are_audited_by_their_names() {
    for (name, counts) in [
        ("dangling_edge.txt", json!({"vertices": 4, "edges": 4, "half_edges": 8, "faces": 2, "components": 1})),
        ("five_faces.txt", json!({"vertices": 6, "edges": 9, "half_edges": 18, "faces": 5, "components": 1})),
    ] {
        let found = json(file(&format!("examples/tables/{name}")), "");
        assert_eq!((&found["valid"], &found["counts"]), (&json!(true), &counts));
    }
    let wrong = file("examples/tables/five_faces.txt").replace("e2,2       V2      e2,1", "e2,2       V2      e3,1");
    let first = &json(&*wrong, "")["violations"][0];
    assert!(first["rule"] == "L1" && first["message"].as_str().unwrap().contains("e2,2"), "{first}");
    says(wrong, "", &["L1  twin       BROKEN", "not valid"]);
}

#[test]
fn a_topology_of_postgis_is_judged_and_named_by_its_ids() {
    let (bends, cached) =
        ("\n  bends                                            16\n", "\n  P4  cached     ok      36 values\n");
    for words in ["--postgis", ""] {
        says(TOWN, words, &[bends, cached, "valid: every rule that applies holds"]);
    }
    let sentence = "next_left_edge of edge 1 is 99, and there is no such edge";
    let rows = "   rows: SELECT * FROM edge_data WHERE edge_id IN (1);";
    let mend = "   mend: UPDATE edge_data SET next_left_edge = 3, abs_next_left_edge = 3 WHERE edge_id = 1;";
    let first = format!("R1 {sentence}\n   at (0, 0) (40, 0)\n{rows}\n{mend}\nR1: usual cause: ");
    let verdict = "not valid: 1 violation; 11 rules not checked (";
    says(broken_town(), "--explain", &[&first, "`SET search_path TO", verdict]);
    let found = json(broken_town(), "--explain");
    let violation = &found["violations"][0];
    has(violation, &json!({"rule": "R1", "message": sentence, "records": ["edge +1"]}));
    assert!(violation["remedy"].as_str().is_some_and(|remedy| !remedy.is_empty()));
    assert_eq!(violation["sql"]["mend"].as_array().map(Vec::len), Some(1));
    assert_eq!((&found["valid"], found["rules"].as_array().unwrap().len()), (&json!(false), 5 + 19));
    assert_eq!(json(broken_town(), "")["violations"][0].get("sql"), None);
    // No coordinate is beyond the poles, so there is no warning.
    let feature = &layer(&audited(broken_town(), ""))["features"][0];
    has(feature, &json!({"properties": {"records": ["edge +1"]}, "geometry": {"type": "LineString"}}));
    assert!(feature["geometry"]["coordinates"].as_array().unwrap().len() >= 2);
}

#[test]
fn arcs_are_judged_as_they_are_shared() {
    let asked = "--arcs --layer squares";
    says(TOPOLOGY, asked, &["arcs of TopoJSON", "A2  sides      ok"]);
    // Both are the left square.
    let wrong = audited(TOPOLOGY.replace("[[2, -1]]", "[[0, 1]]"), asked);
    let message = "arc 0 has feature 0 of squares (left) and feature 1 of squares (right) on the same side";
    let found: Value = serde_json::from_slice(&wrong.json().unwrap()).unwrap();
    has(&found, &json!({"verdict": "invalid", "counts": {"edges": 2}}));
    has(&found["violations"][0], &json!({"rule": "A2", "message": message}));
    assert_eq!(layer(&wrong)["features"][0]["properties"]["message"], message);
    assert!(page_data(&wrong.page().unwrap()).unwrap()["findings"].to_string().contains(message));
}
