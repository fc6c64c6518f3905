//! `twinedge postgis`, and `twinedge audit` of the output of `psql`.

use crate::support::{complaint, json, scratch_folder, twinedge, twinedge_reading};

pub(crate) const TOWN: &[u8] = include_bytes!("../../../postgis/tests/postgis/data/town.copy");

/// The town with a wrong `next_left_edge` of edge 1.
pub(crate) fn broken() -> Vec<u8> {
    let mut bytes = TOWN.to_vec();
    // The ids of edge 1: itself, its nodes, and its next edges 3 and −6.
    let row: Vec<u8> =
        [1, 1, 2, 3, 3, -6, 6, 2, 0].iter().flat_map(|id: &i32| [4_i32, *id]).flat_map(i32::to_be_bytes).collect();
    let at = bytes.windows(row.len()).position(|window| window == row).expect("edge 1 is there");
    // Two values of eight bytes precede it, each with its length.
    for column in [3, 4] {
        bytes[at + 8 * column + 7] = 99;
    }
    bytes
}

#[test]
fn the_commands_for_psql_are_printed() {
    let output = twinedge(&["postgis", "--sql", "my \"old\" town"]);
    assert_eq!(output.status.code(), Some(0));
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(
        text.contains(
            "\nBEGIN TRANSACTION ISOLATION LEVEL REPEATABLE READ READ ONLY;\nCOPY \"my \"\"old\"\" town\".node ("
        ),
        "{text}"
    );
    assert_eq!(text.matches("TO STDOUT (FORMAT binary);\n").count(), 3);
    assert!(text.ends_with("COMMIT;\n"));
    assert_eq!(twinedge(&["postgis"]).status.code(), Some(2));
}

#[test]
fn a_right_topology_is_valid() {
    for arguments in [&["audit", "--postgis", "-"][..], &["audit", "-"]] {
        let output = twinedge_reading(arguments, TOWN);
        let text = String::from_utf8(output.stdout).unwrap();
        assert_eq!(output.status.code(), Some(0), "{text}");
        assert!(text.contains("\n  bends                                            16\n"), "{text}");
        assert!(text.contains("\n  P4  cached     ok      36 values\n"), "{text}");
        assert!(text.contains("valid: every rule that applies holds"), "{text}");
    }
}

#[test]
fn what_is_broken_is_named_by_ids_in_text_and_json() {
    let sentence = "next_left_edge of edge 1 is 99, and there is no such edge";
    let output = twinedge_reading(&["audit", "--postgis", "-", "--explain"], &broken());
    let text = String::from_utf8(output.stdout).unwrap();
    assert_eq!(output.status.code(), Some(1), "{text}");
    let rows = "   rows: SELECT * FROM edge_data WHERE edge_id IN (1);";
    let mend = "   mend: UPDATE edge_data SET next_left_edge = 3, abs_next_left_edge = 3 WHERE edge_id = 1;";
    let first = format!("R1 {sentence}\n   at (0, 0) (40, 0)\n{rows}\n{mend}\nR1: usual cause: ");
    assert!(text.contains(&first) && text.contains("`SET search_path TO"), "{text}");
    assert!(text.contains("not valid: 1 violation; 11 rules not checked ("), "{text}");

    let path = format!("{}/broken.copy", env!("CARGO_TARGET_TMPDIR"));
    std::fs::write(&path, broken()).unwrap();
    let (status, found) = json(&["audit", &path, "--format", "json", "--explain"]);
    assert_eq!((status, &found["valid"]), (Some(1), &serde_json::json!(false)));
    let violation = &found["violations"][0];
    assert_eq!((&violation["rule"], &violation["message"]), (&"R1".into(), &sentence.into()));
    assert_eq!(violation["records"], serde_json::json!(["edge +1"]));
    assert!(violation["remedy"].as_str().is_some_and(|remedy| !remedy.is_empty()));
    assert_eq!(violation["sql"]["mend"].as_array().map(Vec::len), Some(1));
    assert!(json(&["audit", &path, "--format", "json"]).1["violations"][0].get("sql").is_none());
    assert_eq!(found["rules"].as_array().unwrap().len(), 5 + 19);
}

#[test]
fn a_layer_of_findings_has_records_and_lines_and_warns_of_its_coordinates() {
    let output = twinedge_reading(&["audit", "--postgis", "-", "--format", "geojson"], &broken());
    let layer: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let found = &layer["features"][0];
    assert_eq!(found["properties"]["records"], serde_json::json!(["edge +1"]));
    assert_eq!(found["geometry"]["type"], "LineString");
    assert!(found["geometry"]["coordinates"].as_array().unwrap().len() >= 2);
    // No coordinate is beyond the poles.
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");

    let folder = scratch_folder("projected");
    let path = folder.join("metres.wkt").display().to_string();
    std::fs::write(&path, "POLYGON((0 0,900 0,900 900,0 900,0 0))\nPOLYGON((800 0,999 0,999 900,800 900,800 0))\n")
        .unwrap();
    let output = twinedge(&["audit", &path, "--format", "geojson"]);
    assert!(complaint(&output).contains("no coordinate reference system is known"), "{}", complaint(&output));
}

#[test]
fn what_psql_could_not_write_is_an_error() {
    let failed = |arguments: &[&str], input: &[u8]| {
        let output = twinedge_reading(arguments, input);
        assert_eq!(output.status.code(), Some(2));
        complaint(&output)
    };
    let audit = ["audit", "--postgis", "-"];
    assert!(failed(&audit, b"").contains("the stream is empty"));
    assert!(failed(&audit, &TOWN[..3000]).contains("table edge_data, row "));
    assert!(failed(&audit, b"{\"type\": \"FeatureCollection\"}").contains("no binary COPY stream begins here, but `{"));
    assert!(
        failed(&["audit", "-", "--snap", "auto"], TOWN)
            .contains("--snap is for maps, and this is a topology of PostGIS")
    );
}
