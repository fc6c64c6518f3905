//! `twinedge audit`.

use crate::support::{complaint, data, json as run, twinedge, twinedge_reading};
use serde_json::{Value, json};

fn counts(found: &Value) -> [u64; 4] {
    ["vertices", "edges", "components", "faces"].map(|what| found["counts"][what].as_u64().unwrap())
}

/// The number of violations of each broken rule.
fn broken(found: &Value) -> Vec<(&str, u64)> {
    let rules = found["rules"].as_array().unwrap().iter();
    let rules = rules.map(|rule| (rule["id"].as_str().unwrap(), rule["violations"].as_u64().unwrap()));
    rules.filter(|(_, violations)| *violations > 0).collect()
}

/// Returns the keys in alphabetical order.
fn keys(value: &Value) -> Vec<&str> {
    let mut keys: Vec<&str> = value.as_object().unwrap().keys().map(String::as_str).collect();
    keys.sort_unstable();
    keys
}

#[test]
fn the_built_in_map_is_valid() {
    let (status, found) = run(&["audit", "--format", "json"]);
    assert_eq!(status, Some(0));
    assert_eq!(counts(&found), [7_493, 7_655, 125, 288]);
    assert_eq!(found["counts"]["genus"], 0);
    assert_eq!((&found["valid"], broken(&found).len()), (&json!(true), 0));
    assert_eq!(found["violations"], json!([]));
    let text = String::from_utf8(twinedge(&["audit"]).stdout).unwrap();
    assert!(text.contains("7,655") && text.contains("structure valid · coverage: 1 gap, 2 invalid features"), "{text}");
}

#[test]
fn a_larger_map_is_valid() {
    let (status, found) = run(&["audit", "--format", "json", &data("world-50m.geojson")]);
    assert_eq!(status, Some(0));
    assert_eq!(counts(&found), [75_685, 75_863, 1_438, 1_617]);
}

#[test]
fn machines_get_these_keys() {
    let (_, found) = run(&["audit", "--format", "json", &data("world-110m-crossing.geojson")]);
    assert_eq!(
        keys(&found),
        [
            "bounds",
            "causes",
            "consequences",
            "counts",
            "coverage",
            "elapsed_ms",
            "first",
            "headline",
            "import",
            "input",
            "judged",
            "options",
            "rules",
            "schema",
            "valid",
            "verdict",
            "version",
            "violation_count",
            "violations",
            "warnings"
        ]
    );
    let counted = [
        "accepted_gaps",
        "duplicates",
        "findings",
        "gap_width",
        "gaps",
        "mismatches",
        "near_misses",
        "ogc_invalid",
        "overlaps",
    ];
    assert_eq!(
        keys(&found["coverage"]),
        [&counted[..], &["sliver_area", "slivers", "unit", "verdict", "wider_gaps"]].concat()
    );
    assert_eq!(
        keys(&found["counts"]),
        [
            "borders",
            "components",
            "cycles",
            "edges",
            "faces",
            "genus",
            "half_edges",
            "inner_boundaries",
            "isolated_vertices",
            "outer_boundaries",
            "vertices"
        ]
    );
    for rule in found["rules"].as_array().unwrap() {
        assert_eq!(keys(rule), ["checked", "id", "unchecked", "violations"]);
    }
    for violation in found["violations"].as_array().unwrap() {
        let of_all = ["at", "feature_numbers", "features", "fields", "id", "kind", "message", "records", "rule"];
        let of_some = ["follows_from", "follows_from_id", "sentence"];
        assert_eq!(keys(violation).into_iter().filter(|key| !of_some.contains(key)).collect::<Vec<_>>(), of_all);
    }
}

#[test]
fn two_crossings_are_found_and_named() {
    let file = data("world-110m-crossing.geojson");
    let (status, found) = run(&["audit", "--format", "json", &file]);
    assert_eq!((status, &found["valid"]), (Some(1), &json!(false)));
    let broken = broken(&found);
    assert!(broken.contains(&("G4", 2)) && broken.contains(&("T3", 1)), "{broken:?}");
    assert_eq!(found["counts"]["genus"], 1);
    let crossings = [
        [[23.80524, 8.66648], [24.56845, 8.22980], [23.88804, 8.61908], [24.19404, 8.72910]],
        [[33.96094, 9.58384], [33.97534, 8.68509], [33.82414, 9.48398], [33.96454, 9.46367]],
    ];
    let of_rule = |rule: &'static str| {
        found["violations"].as_array().unwrap().iter().filter(move |violation| violation["rule"] == rule)
    };
    let mut matched = [0, 0];
    for violation in of_rule("G4") {
        let places: Vec<[f64; 2]> = serde_json::from_value(violation["at"].clone()).unwrap();
        for (crossing, matched) in crossings.iter().zip(&mut matched) {
            // Coordinates with five decimal places.
            let names = |corner: &[f64; 2]| {
                places.iter().any(|place| (place[0] - corner[0]).abs() < 6e-6 && (place[1] - corner[1]).abs() < 6e-6)
            };
            *matched += usize::from(crossing.iter().all(names));
        }
        assert!(!violation["features"].as_array().unwrap().is_empty());
    }
    assert_eq!(matched, [1, 1]);
    assert_eq!(of_rule("T3").count(), 1);

    let output = twinedge(&["audit", "--list", "1", &file]);
    assert_eq!(output.status.code(), Some(1));
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.contains("BROKEN") && text.contains("more; see --list"), "{text}");
}

#[test]
fn snapped_the_crossing_map_is_valid_and_what_was_done_is_said() {
    let file = data("world-110m-crossing.geojson");
    let (status, found) = run(&["audit", "--snap", "auto", "--format", "json", &file]);
    assert_eq!((status, &found["valid"]), (Some(0), &json!(true)));
    assert_eq!(counts(&found), [7_493, 7_655, 125, 288]);
    let noding = &found["noding"];
    assert_eq!(
        (&noding["crossings"], &noding["segments_cut"], &noding["points_merged"]),
        (&json!(2), &json!(4), &json!(0))
    );
    let cell = noding["cell"].as_f64().unwrap();
    assert!(noding["largest_move"].as_array().unwrap().iter().all(|moved| moved.as_f64().unwrap() <= cell / 2.0));

    let text = String::from_utf8(twinedge(&["audit", "--snap", "auto", &file]).stdout).unwrap();
    assert!(text.contains("4 segments cut, 2 vertices made at crossings; points moved by at most"), "{text}");
}

#[test]
fn on_a_coarse_grid_the_map_is_smaller_and_valid() {
    let (status, found) = run(&["audit", "--snap", "0.3", "--format", "json"]);
    assert_eq!((status, &found["noding"]["cell"]), (Some(0), &json!(0.3)));
    assert!(counts(&found)[0] < 7_493 && found["noding"]["points_merged"].as_u64().unwrap() > 0);
}

#[test]
fn grids_that_cannot_be_are_refused() {
    for size in ["0", "-1", "NaN", "inf", "fine"] {
        let output = twinedge(&["audit", &format!("--snap={size}")]);
        assert_eq!(output.status.code(), Some(2), "{size}");
        assert!(String::from_utf8(output.stderr).unwrap().contains("neither `auto` nor a positive number"));
    }
    let output = twinedge(&["audit", "--snap", "1e-30"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(complaint(&output).contains("out of reach of the grid: take larger cells"));
}

const TRIANGLE: &[u8] =
    br#"{"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {"name": "A"}, "geometry":
        {"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [0, 1], [0, 0]]]}}]}"#;

#[test]
fn standard_input_is_read_where_the_file_is_a_dash() {
    let output = twinedge_reading(&["audit", "--format", "json", "-"], TRIANGLE);
    assert_eq!(output.status.code(), Some(0));
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!((counts(&found), &found["input"]), ([3, 3, 1, 2], &json!("standard input")));
}

#[test]
fn what_cannot_be_read_is_said_in_one_line() {
    let output = twinedge(&["audit", "no-such-file.geojson"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(complaint(&output).contains("no-such-file.geojson"));

    for (input, place) in [
        (&b"{\n  \"type\": }"[..], "line 2, column 11"),
        (b"{\"type\": \"FeatureCollection\",\n\"features\": [", "line 2, column"),
        (b"", "standard input: the input is empty"),
        (b"\xFF\xFE", "looks like text in UTF-16"),
    ] {
        let output = twinedge_reading(&["audit", "-"], input);
        assert_eq!(output.status.code(), Some(2));
        assert!(output.stdout.is_empty());
        let complaint = complaint(&output);
        assert!(complaint.starts_with("twinedge: standard input: ") && complaint.contains(place), "{complaint}");
    }
    for arguments in [&["audit", "--format", "xml"][..], &["audit", "--list", "-1"], &["audit", "a", "b"], &[]] {
        assert_eq!(twinedge(arguments).status.code(), Some(2), "{arguments:?}");
    }
}

#[test]
fn irregular_rings_are_told() {
    let map = br#"{"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {"name": "Bow"}, "geometry":
        {"type": "Polygon", "coordinates": [[[0, 0], [0, 0], [2, 2], [4, 0], [4, 4], [2, 2], [0, 4], [-1, 4], [0, 4]]]}}]}"#;
    let output = twinedge_reading(&["audit", "--format", "json", "-"], map);
    assert_eq!(output.status.code(), Some(0));
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    let import = &found["import"];
    for (what, count) in [
        ("features", 1),
        ("segments", 9),
        ("repeated_segments", 1),
        ("repeated_points", 1),
        ("open_rings", 1),
        ("degenerate_rings", 0),
        ("rings_wound_wrongly", 0),
        ("self_touching_rings", 1),
        ("spikes", 1),
    ] {
        assert_eq!(import[what], count, "{what}");
    }
    let spike = import["irregularities"].as_array().unwrap().iter().find(|one| one["kind"] == "spike").unwrap();
    let expected =
        json!({"kind": "spike", "at": [-1.0, 4.0], "feature": 0, "name": "Bow", "shape": 0, "ring": 0, "point": 7});
    assert_eq!(*spike, expected);
    let text = String::from_utf8(twinedge_reading(&["audit", "-"], map).stdout).unwrap();
    assert!(text.contains("1 ring touches itself, 1 spike\n"), "{text}");
    let line = "  ring that touches itself at (2, 2): feature 0, shape 0, ring 0, point 5 (Bow)\n";
    assert!(text.contains(line), "{text}");
}

#[test]
fn every_format_of_the_library_is_read() {
    let polygon = b"POLYGON Z ((0 0 5, 1 0 5, 1 1 5, 0 0 5))\nPOINT EMPTY\n";
    let output = twinedge_reading(&["audit", "-"], polygon);
    let text = String::from_utf8(output.stdout).unwrap();
    assert_eq!(output.status.code(), Some(0), "{text}");
    let dropped = "dropped: the dimensions beyond x and y of 4 positions, 1 empty shape";
    assert!(text.lines().any(|line| line == dropped), "{text}");
    let output = twinedge_reading(&["audit", "-", "--format", "json"], polygon);
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!((&found["import"]["with_extra_dimensions"], &found["import"]["dropped_empty"]), (&json!(4), &json!(1)));
    // The message names the unreadable format, and a way to convert it.
    let output = twinedge_reading(&["audit", "-"], b"SQLite format 3\0 and more");
    assert_eq!(output.status.code(), Some(2));
    assert!(complaint(&output).contains("ogr2ogr"), "{}", complaint(&output));
}

#[test]
fn numbers_agree_with_their_nouns() {
    let text = |input: &str| {
        let output = twinedge_reading(&["audit", "-"], input.as_bytes());
        String::from_utf8(output.stdout).unwrap()
    };
    let crossing = text("LINESTRING (0 0, 2 2)\nLINESTRING (0 2, 2 0)\n");
    assert!(
        crossing.contains("BROKEN  1 violation in ") && crossing.contains("not valid: 1 violation; "),
        "{crossing}"
    );
    let spike = text("POLYGON ((0 0, 2 0, 2 2, 3 3, 2 2, 0 2, 0 0))\n");
    assert!(spike.contains("1 spike") && !spike.contains("(s)"), "{spike}");
}

#[test]
fn explanations_are_given_of_maps_and_of_tables() {
    let map = data("world-110m-crossing.geojson");
    let (_, found) = run(&["audit", "--explain", "--format", "json", &map]);
    let violations = found["violations"].as_array().unwrap();
    assert!(
        !violations.is_empty() && violations.iter().all(|one| one["cause"].is_string() && one["remedy"].is_string())
    );

    let table = b"# expect: plane\nV 0 H 0 B 0 F 0\n";
    let output = twinedge_reading(&["audit", "-", "--explain", "--format", "json"], table);
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert!(found["violations"][0]["remedy"].is_string(), "{found}");
    let text = String::from_utf8(twinedge_reading(&["audit", "-", "--explain"], table).stdout).unwrap();
    assert!(text.lines().any(|line| line.starts_with("F1: usual cause: ")), "{text}");
    let text = String::from_utf8(twinedge_reading(&["audit", "-"], table).stdout).unwrap();
    assert!(!text.contains("usual cause"), "{text}");
}

/// Three parcels: the second begins 0.05 inside the first, and the third 0.05 behind the second.
const PARCELS: &str = r#"{"type": "FeatureCollection", "features": [
    {"type": "Feature", "id": "A-1", "properties": {"name": "Meadow"}, "geometry":
        {"type": "Polygon", "coordinates": [[[0, 0], [10, 0], [10, 10], [0, 10], [0, 0]]]}},
    {"type": "Feature", "id": "A-2", "properties": {}, "geometry":
        {"type": "Polygon", "coordinates": [[[9.95, 0], [20, 0], [20, 10], [9.95, 10], [9.95, 0]]]}},
    {"type": "Feature", "id": "A-3", "properties": {}, "geometry":
        {"type": "Polygon", "coordinates": [[[20.05, 0], [30, 0], [30, 10], [20.05, 10], [20.05, 0]]]}}]}"#;

fn audited(arguments: &[&str], input: &str) -> (Option<i32>, Value) {
    let arguments = [&["audit", "-", "--format", "json"], arguments].concat();
    let output = twinedge_reading(&arguments, input.as_bytes());
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
    (output.status.code(), serde_json::from_slice(&output.stdout).unwrap())
}

#[test]
fn overlaps_and_near_misses_are_reported_on_a_map_that_is_not_plane() {
    let (_, found) = audited(&[], PARCELS);
    let coverage = &found["coverage"];
    let counts =
        ["overlaps", "gaps", "near_misses", "slivers", "duplicates", "ogc_invalid"].map(|what| &coverage[what]);
    assert_eq!(counts.map(|count| count.as_u64().unwrap()), [1, 0, 1, 0, 0, 0]);
    let [overlap, miss] = &coverage["findings"].as_array().unwrap()[..] else { panic!("{coverage}") };
    assert_eq!((&overlap["rule"], &overlap["kind"]), (&json!("C1"), &json!("overlap")));
    assert_eq!(
        overlap["features"],
        json!([{"number": 0, "id": "A-1", "name": "Meadow"}, {"number": 1, "id": "A-2", "name": null}])
    );
    let measure = |finding: &Value, what: &str| finding[what].as_f64().unwrap();
    assert!((measure(overlap, "area") - 0.5).abs() < 1e-9 && (measure(overlap, "length") - 20.1).abs() < 1e-9);
    assert!((measure(miss, "width") - 0.05).abs() < 1e-9 && (measure(miss, "length") - 20.0).abs() < 1e-9);

    let text = String::from_utf8(twinedge_reading(&["audit", "-"], PARCELS.as_bytes()).stdout).unwrap();
    assert!(text.contains("\n  C1  overlap      1 overlap\n"), "{text}");
    let worst = "C1 overlap: Meadow (id A-1), id A-2; area 0.5000, width 0.0498, borders of 20.1000; at (9.97";
    assert!(text.contains(worst), "{text}");
}

/// The input of <https://github.com/libgeos/geos/issues/1525>.
const MISMATCH: &str = "POLYGON((1 0,1 1,1 3,4 0,1 0))\nPOLYGON((0 4,1 3,1 0,0 4))\n";

#[test]
fn a_missing_vertex_is_named_and_what_follows_from_it() {
    let (status, found) = audited(&[], MISMATCH);
    assert_eq!((status, broken(&found)), (Some(1), vec![("T3", 1), ("G4", 2)]));
    let follows = found["violations"].as_array().unwrap().iter().map(|one| &one["follows_from"]);
    assert_eq!(follows.collect::<Vec<_>>(), ["C7"; 3]);
    assert_eq!(found["coverage"]["mismatches"], 1);
    let [finding] = &found["coverage"]["findings"].as_array().unwrap()[..] else { panic!("{found}") };
    let has = |key: &str, value: Value| assert_eq!(finding[key], value, "{key}");
    has("rule", json!("C7"));
    has("kind", json!("mismatch"));
    has("features", json!([{"number": 0, "name": null}, {"number": 1, "name": null}]));
    has("at", json!([1.0, 1.0]));
    has("missing", json!([{"at": [1.0, 1.0], "feature": 1}]));
    has("length", json!(3.0));
    assert_eq!((finding.get("area"), finding.get("width")), (None, None));

    let text = String::from_utf8(twinedge_reading(&["audit", "-"], MISMATCH.as_bytes()).stdout).unwrap();
    assert!(text.contains("\n  C7  mismatch     1 mismatch\n"), "{text}");
    assert!(text.contains("C7 mismatch: feature 0, feature 1; 1 vertex missing in feature 1; at (1, 1)\n"), "{text}");
    assert!(text.contains("\n   from which follow 2 violations of G4, 1 violation of T3\n"), "{text}");
    assert!(
        text.contains(
            "\nnot valid: 1 finding, from which 3 others follow · structure not valid · coverage: 1 mismatch;"
        ),
        "{text}"
    );
}

#[test]
fn snapping_does_not_hide_a_missing_vertex() {
    for snap in ["auto", "0.5"] {
        let (status, found) = audited(&["--snap", snap], MISMATCH);
        assert_eq!((status, broken(&found)), (Some(0), vec![]));
        assert_eq!(
            (&found["coverage"]["mismatches"], &found["coverage"]["findings"][0]["snapping"]),
            (&json!(1), &json!("removed"))
        );
        assert_eq!(audited(&["--snap", snap, "--coverage"], MISMATCH).0, Some(1));
    }
}

/// A crossing elsewhere does not follow from the missing vertex.
#[test]
fn a_crossing_beside_a_missing_vertex_does_not_follow_from_it() {
    let crossing = "POLYGON((10 0,14 0,14 4,10 4,10 0))\nPOLYGON((12 2,16 2,16 6,12 6,12 2))\n";
    let (_, found) = audited(&[], &format!("{MISMATCH}{crossing}"));
    let of = |rule: &str, follows: Value| {
        let all = found["violations"].as_array().unwrap().iter().filter(|one| one["rule"] == rule);
        all.filter(|one| one.get("follows_from").cloned().unwrap_or(Value::Null) == follows).count()
    };
    assert_eq!((of("G4", json!("C7")), of("G4", json!("C1"))), (2, 2));
    // The two squares are separate components without a handle.
    assert_eq!((of("T3", json!("G4")), of("T3", json!("C7"))), (1, 0));
}

/// Two lakes with mean widths of 2 and 10 in one parcel, and a strip of 0.25 between two parcels.
const LAKES: &str =
    "POLYGON((0 0,100 0,100 40,0 40,0 0),(10 10,14 10,14 14,10 14,10 10),(50 10,70 10,70 30,50 30,50 10))
POLYGON((100.25 0,120 0,120 40,100.25 40,100.25 0))
";

#[test]
fn a_map_with_accepted_lakes_is_valid() {
    let judged = |options: &[&str]| {
        let (status, found) = audited(&[options, &["--coverage"]].concat(), LAKES);
        let count = |key: &str| found["coverage"][key].as_u64().unwrap();
        (status, count("gaps"), count("near_misses"), count("wider_gaps"), count("accepted_gaps"))
    };
    assert_eq!(judged(&[]), (Some(1), 2, 0, 0, 0));
    // By width, separately from near misses.
    assert_eq!(judged(&["--lake-width", "5"]), (Some(1), 1, 0, 1, 0));
    assert_eq!(judged(&["--lake-width", "1", "--gap-width", "0.1"]), (Some(0), 0, 0, 2, 0));
    assert_eq!(judged(&["--lake-width", "1", "--gap-width", "0.3"]), (Some(1), 0, 1, 2, 0));
    // By place.
    assert_eq!(judged(&["--accept-gap", "12,12", "--gap-width=0.1"]), (Some(0), 0, 0, 1, 1));
    let both = ["--accept-gap", "12,12", "--accept-gap", "60, 20"];
    assert_eq!(judged(&both), (Some(0), 0, 0, 0, 2));
    assert_eq!(judged(&["--accept-gap", "-12,12"]), (Some(1), 2, 0, 0, 0));
    let text = twinedge_reading(&[&["audit", "-"][..], &both].concat(), LAKES.as_bytes());
    let text = String::from_utf8(text.stdout).unwrap();
    assert!(text.contains("C2  gap          ok  2 gaps accepted by place are not listed\n"), "{text}");
    for wrong in ["12", "12,", "a,b", "1,2,3"] {
        assert_eq!(twinedge(&["audit", "--accept-gap", wrong]).status.code(), Some(2), "{wrong}");
    }
}

#[test]
fn findings_make_a_map_invalid_only_if_asked() {
    let gap = PARCELS.replace("9.95", "10").replace("20.05", "20.25");
    let (status, found) = audited(&[], &gap);
    assert_eq!((status, &found["valid"], &found["coverage"]["near_misses"]), (Some(0), &json!(true), &json!(0)));
    let (status, found) = audited(&["--gap-width", "0.3"], &gap);
    assert_eq!((status, &found["valid"], &found["coverage"]["near_misses"]), (Some(0), &json!(true), &json!(1)));
    let (status, found) = audited(&["--gap-width", "0.3", "--coverage"], &gap);
    assert_eq!((status, &found["valid"]), (Some(1), &json!(false)));
    let (status, _) = audited(&["--coverage"], &gap);
    assert_eq!(status, Some(0));
    let (_, found) =
        audited(&["--sliver", "1000"], &PARCELS.replace("[30, 10], [20.05, 10]", "[30, 0.1], [20.05, 0.1]"));
    assert_eq!((&found["coverage"]["slivers"], &found["coverage"]["sliver_area"]), (&json!(1), &json!(1000.0)));
    for wrong in ["0", "-1", "inf", "wide"] {
        assert_eq!(twinedge(&["audit", &format!("--gap-width={wrong}")]).status.code(), Some(2), "{wrong}");
    }
    let mesh = twinedge_reading(&["audit", "-", "--coverage"], b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    assert!(complaint(&mesh).contains("are for maps, and this is a mesh"), "{mesh:?}");
}

#[test]
fn what_snapping_removes_or_makes_is_reported() {
    let (_, found) = audited(&["--snap", "auto"], PARCELS);
    assert_eq!((&found["valid"], &found["coverage"]["overlaps"]), (&json!(true), &json!(1)));
    let (_, found) = audited(&["--snap", "1"], PARCELS);
    let findings = found["coverage"]["findings"].as_array().unwrap();
    let snapping: Vec<(&Value, &Value)> = findings.iter().map(|one| (&one["rule"], &one["snapping"])).collect();
    let removed = json!("removed");
    assert_eq!(snapping, [(&json!("C1"), &removed), (&json!("C3"), &removed)]);
    // On a coarse grid, the mouth of a bay between two parcels closes and creates a gap.
    let bay = "POLYGON ((0 0, 10 0, 10 4, 4 4, 4 8, 6.9 8, 6.9 10, 0 10, 0 0))\n\
               POLYGON ((10 0, 20 0, 20 10, 7.1 10, 7.1 8, 10 8, 10 4, 10 0))\n";
    let (_, found) = audited(&["--snap", "1"], bay);
    let findings = found["coverage"]["findings"].as_array().unwrap();
    let made: Vec<&Value> = findings.iter().filter(|one| one["snapping"] == "made").map(|one| &one["rule"]).collect();
    assert_eq!(made, [&json!("C2")], "{findings:?}");
}

#[test]
fn polygons_that_are_not_valid_are_named_in_the_words_of_the_ogc() {
    let nested = "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 8 1, 8 8, 1 8, 1 1), (2 2, 3 2, 3 3, 2 3, 2 2))\n";
    let (_, found) = audited(&[], nested);
    let finding =
        &found["coverage"]["findings"].as_array().unwrap().iter().find(|one| one["rule"] == "C6").unwrap()["defects"];
    assert_eq!(*finding, json!([{"reason": "Holes are nested", "at": [2.0, 2.0], "shape": 0, "ring": 2}]));
}

#[test]
fn a_file_without_lines_and_polygons_is_refused_with_what_it_has() {
    let none = r#"{"type": "FeatureCollection", "features": []}"#;
    let null = r#"{"type": "Feature", "properties": {}, "geometry": null}"#;
    for (input, what) in [
        (none, "this file has no features"),
        (null, "this file has 1 feature, none with a geometry"),
        ("POINT (1 2)\nMULTIPOINT ((1 2), (3 4))\n", "this file has 2 features with 3 points and nothing else"),
    ] {
        for command in [&["audit", "-"][..], &["query", "-", "faces"], &["draw", "-"]] {
            let output = twinedge_reading(command, input.as_bytes());
            assert_eq!(output.status.code(), Some(2), "{what}");
            assert!(complaint(&output).contains(what), "{}", complaint(&output));
        }
        let output = twinedge_reading(&["audit", "-", "--allow-empty"], input.as_bytes());
        assert_eq!(output.status.code(), Some(0), "{what}");
    }
}

#[test]
fn reference_systems_and_the_antimeridian_are_warned_of() {
    let with = |crs: &str, far: f64| {
        format!(
            r#"{{"type": "FeatureCollection", "crs": {crs}, "features": [{{"type": "Feature", "properties": {{}}, "geometry":
            {{"type": "Polygon", "coordinates": [[[170, 0], [{far}, 0], [{far}, 9], [170, 9], [170, 0]]]}}}}]}}"#
        )
    };
    let warnings = |input: String| audited(&[], &input).1["warnings"].as_array().unwrap().clone();
    let named = |name: &str| format!(r#"{{"type": "name", "properties": {{"name": "{name}"}}}}"#);
    for usual in ["null".to_owned(), named("urn:ogc:def:crs:OGC:1.3:CRS84"), named("EPSG:4326")] {
        assert_eq!(warnings(with(&usual, 179.0)), [] as [Value; 0], "{usual}");
    }
    let other = warnings(with(&named("urn:ogc:def:crs:EPSG::2056"), -170.0));
    assert!(other.len() == 1 && other[0].as_str().unwrap().contains("coordinate reference system"), "{other:?}");
    let across = warnings(with("null", -170.0));
    assert!(across.len() == 1 && across[0].as_str().unwrap().contains("antimeridian"), "{across:?}");
}

#[test]
fn as_many_findings_are_listed_and_explained_as_asked() {
    let text = |arguments: &[&str]| String::from_utf8(twinedge(arguments).stdout).unwrap();
    let few = text(&["audit", "--list", "1", "--explain"]);
    assert!(few.contains("   … and 1 more of C6; see --list\n") && few.matches("\nC6 OGC").count() == 1, "{few}");
    assert!(few.contains("\nC6: usual cause: ") && few.contains("`twinedge clean` makes the polygons anew"), "{few}");
    let crossing = data("world-110m-crossing.geojson");
    let all = text(&["audit", "--list", "100", "--explain", &crossing]);
    assert!(!all.contains("more of C"), "{all}");
    let [c2, c6, g4, t3] = ["\nC2 gap", "\nC6 OGC", "\n   G4 the borders of Sudan", "\n   T3 the component"]
        .map(|what| all.find(what).expect("listed"));
    assert!(c2 < c6 && c6 < g4 && g4 < t3, "{all}");
    assert!(!all.contains("geometry::noding") && !all.contains("Expectation::"), "{all}");
}
