//! `twinedge query`.

use crate::support::{complaint, data, json as run, twinedge, twinedge_reading};
use serde_json::{Value, json};
use std::collections::BTreeSet;

fn names(found: &Value) -> BTreeSet<&str> {
    found.as_array().unwrap().iter().map(|one| one["name"].as_str().unwrap()).collect()
}

/// Two adjacent squares, and a square that touches the first at a corner. The second claims a quarter of the first.
const SQUARES: &[u8] = br#"{"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {"name": "West"}, "geometry":
        {"type": "Polygon", "coordinates": [[[0, 0], [3, 0], [4, 0], [4, 4], [3, 4], [0, 4], [0, 0]]]}},
    {"type": "Feature", "properties": {"name": "East"}, "geometry":
        {"type": "Polygon", "coordinates": [[[3, 0], [4, 0], [7, 0], [7, 4], [4, 4], [3, 4], [3, 0]]]}},
    {"type": "Feature", "properties": {"name": "Corner"}, "geometry":
        {"type": "Polygon", "coordinates": [[[0, 4], [0, 5], [-1, 5], [-1, 4], [0, 4]]]}},
    {"type": "Feature", "properties": {"name": "Twice"}, "geometry": null},
    {"type": "Feature", "properties": {"name": "Twice"}, "geometry": null}]}"#;

fn ask(arguments: &[&str]) -> Value {
    let output = twinedge_reading(arguments, SQUARES);
    assert_eq!((output.status.code(), String::from_utf8_lossy(&output.stderr).as_ref()), (Some(0), ""));
    serde_json::from_slice(&output.stdout).unwrap()
}

#[test]
fn switzerland_has_four_neighbours_in_the_built_in_map() {
    let (status, found) = run(&["query", "neighbours", "Switzerland", "--format", "json"]);
    assert_eq!(status, Some(0));
    assert_eq!(names(&found["neighbours"]), BTreeSet::from(["Austria", "France", "Germany", "Italy"]));
    assert_eq!((&found["feature"], &found["overlaps"]), (&json!("Switzerland"), &json!([])));
    let text = String::from_utf8(twinedge(&["query", "neighbours", "Switzerland"]).stdout).unwrap();
    assert!(text.starts_with("Switzerland\n") && text.contains("  Austria "), "{text}");

    let file = format!("{}/data/world-110m.geojson", env!("CARGO_MANIFEST_DIR"));
    let (_, same) = run(&["query", &file, "neighbours", "Switzerland", "--format", "json"]);
    assert_eq!(same["neighbours"], found["neighbours"]);
    let (_, lesotho) = run(&["query", &file, "neighbours", "Lesotho", "--format", "json"]);
    assert_eq!(names(&lesotho["neighbours"]), BTreeSet::from(["South Africa"]));
}

#[test]
fn neighbours_tell_borders_corners_and_overlaps_apart() {
    let found = ask(&["query", "-", "neighbours", "West", "--format", "json"]);
    assert_eq!(found["input"], "standard input");
    // The end of West, with East beyond it; not the end of East inside West.
    let expected = json!([{"name": "East", "id": 1, "length": 4.0, "borders": [[[4.0, 0.0], [4.0, 4.0]]]}]);
    assert_eq!(found["neighbours"], expected);
    assert_eq!(found["touching"], json!([{"name": "Corner", "id": 2}]));
    assert_eq!(found["overlaps"], json!([{"name": "East", "id": 1, "faces": 1, "area": 4.0}]));

    let output = twinedge_reading(&["query", "-", "neighbours", "#0"], SQUARES);
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.contains("touches Corner at a vertex only"), "{text}");
    assert!(text.contains("overlap: 1 face(s) of area 4.0000 are claimed by East too"), "{text}");
}

#[test]
fn a_contour_is_written_in_every_format() {
    let text = |format: &str| {
        let output = twinedge_reading(&["query", "-", "contour", "East", "--format", format], SQUARES);
        assert_eq!(output.status.code(), Some(0));
        String::from_utf8(output.stdout).unwrap()
    };
    assert_eq!(text("wkt"), "POLYGON((3 0,4 0,7 0,7 4,4 4,3 4,3 0))\n");
    let geojson: Value = serde_json::from_str(&text("geojson")).unwrap();
    let ring = json!([[3.0, 0.0], [4.0, 0.0], [7.0, 0.0], [7.0, 4.0], [4.0, 4.0], [3.0, 4.0], [3.0, 0.0]]);
    assert_eq!(geojson["features"][0]["geometry"], json!({"type": "Polygon", "coordinates": [ring]}));
    assert_eq!(geojson["features"][0]["properties"], json!({"name": "East"}));
    let found: Value = serde_json::from_str(&text("json")).unwrap();
    let polygon = json!({"outer": ring, "holes": []});
    let expected = json!({"input": "standard input", "feature": "East", "id": 1, "area": 16.0, "polygons": [polygon]});
    assert_eq!(found, expected);
    let summary = text("text");
    assert!(summary.contains("vertices            6") && summary.contains("16.0000"), "{summary}");
}

#[test]
fn the_contour_of_south_africa_has_a_hole() {
    let (_, found) = run(&["query", "contour", "South Africa", "--format", "json"]);
    let holes = |polygon: &Value| polygon["holes"].as_array().unwrap().len();
    assert_eq!(found["polygons"].as_array().unwrap().iter().map(holes).collect::<Vec<_>>(), [1]);
}

#[test]
fn faces_are_listed_with_what_bounds_them() {
    let found = ask(&["query", "-", "faces", "--format", "json"]);
    let faces = found["faces"].as_array().unwrap();
    assert_eq!(faces.len(), 5);
    let of = |features: Value| faces.iter().find(|face| face["features"] == features).unwrap();
    let both = of(json!(["West", "East"]));
    assert_eq!((&both["overlap"], &both["area"], &both["edges"]), (&json!(true), &json!(4.0), &json!(4)));
    let west = of(json!(["West"]));
    assert_eq!((&west["overlap"], &west["area"], &west["holes"]), (&json!(false), &json!(12.0), &json!(0)));
    assert!(west["neighbours"].as_array().unwrap().contains(&both["id"]));
    let unbounded = of(json!([]));
    assert_eq!(
        (&unbounded["unbounded"], &unbounded["area"], &unbounded["holes"]),
        (&json!(true), &json!(null), &json!(1))
    );

    let text = String::from_utf8(twinedge_reading(&["query", "-", "faces"], SQUARES).stdout).unwrap();
    assert!(text.contains("overlap: West, East") && text.contains("unbounded"), "{text}");
    assert_eq!(text.lines().count(), 6);
}

#[test]
fn an_unknown_name_gets_suggestions() {
    for (name, hint) in
        [("Swizerland", "did you mean Switzerland"), ("germany", "did you mean Germany"), ("#999", "#999")]
    {
        let output = twinedge(&["query", "contour", name]);
        assert_eq!(output.status.code(), Some(2), "{name}");
        assert!(output.stdout.is_empty());
        let complaint = complaint(&output);
        assert!(complaint.contains("no feature has the n") && complaint.contains(hint), "{complaint}");
    }
    assert!(!complaint(&twinedge(&["query", "contour", "zzzzzz"])).contains("did you mean"));
    let output = twinedge_reading(&["query", "-", "neighbours", "Twice"], SQUARES);
    assert_eq!(output.status.code(), Some(2));
    assert!(complaint(&output).contains("2 features have the name Twice; ask for one of '#3', '#4'"));
    let output = twinedge(&["query", "no-such-file.geojson", "faces"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(complaint(&output).contains("no-such-file.geojson"));
    for arguments in [
        &["query"][..],
        &["query", "neighbours"],
        &["query", "a", "b", "faces"],
        &["query", "contour", "Fiji", "--format", "xml"],
    ] {
        assert_eq!(twinedge(arguments).status.code(), Some(2), "{arguments:?}");
    }
}

#[test]
fn a_map_that_is_not_plane_is_asked_nothing_until_it_is_snapped() {
    let file = data("world-110m-crossing.geojson");
    for question in [&["neighbours", "Switzerland"][..], &["contour", "Fiji"], &["faces"], &["at", "0", "0"]] {
        let output = twinedge(&[&["query", &file], question].concat());
        assert_eq!((output.status.code(), output.stdout.len()), (Some(2), 0));
        assert!(complaint(&output).contains("--snap auto cuts them"));
    }
    let (status, found) = run(&["query", "--snap", "auto", &file, "neighbours", "S. Sudan", "--format", "json"]);
    assert_eq!(status, Some(0));
    assert!(names(&found["neighbours"]).contains("Ethiopia"));
}

#[test]
fn features_without_names_are_asked_for_by_number() {
    let nameless: &[u8] = br#"{"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [0, 1], [0, 0]]]}"#;
    let output = twinedge_reading(&["query", "-", "neighbours", "feature 0"], nameless);
    assert_eq!(output.status.code(), Some(2));
    assert!(complaint(&output).contains("by their numbers, from '#0' to '#0'"));
    assert_eq!(twinedge_reading(&["query", "-", "neighbours", "#0"], nameless).status.code(), Some(0));
}

/// Returns the answer at a point of the built-in map.
fn at(x: &str, y: &str) -> Value {
    let (status, answer) = run(&["query", "at", x, y, "--format", "json"]);
    assert_eq!(status, Some(0));
    assert_eq!(answer["point"], json!([x.parse::<f64>().unwrap(), y.parse::<f64>().unwrap()]));
    answer["found"].clone()
}

#[test]
fn points_lie_in_the_countries_where_they_should() {
    for (x, y, country) in [("28.25", "-29.5", "Lesotho"), ("24", "-29", "South Africa")] {
        let found = at(x, y);
        assert_eq!((&found["kind"], &found["features"]), (&json!("face"), &json!([country])));
    }
    // The Caspian Sea is a hole in five countries; the Atlantic is not.
    for (x, y, unbounded) in [("51", "42", false), ("-30", "0", true)] {
        let found = at(x, y);
        assert_eq!((&found["kind"], &found["unbounded"]), (&json!("face"), &json!(unbounded)));
        assert_eq!(found["features"], json!([]));
    }
}

/// Two adjacent squares; two features claim the right one.
const CLAIMS: &[u8] = br#"{"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {"name": "A"}, "geometry":
        {"type": "Polygon", "coordinates": [[[0, 0], [2, 0], [2, 2], [0, 2], [0, 0]]]}},
    {"type": "Feature", "properties": {"name": "B"}, "geometry":
        {"type": "Polygon", "coordinates": [[[2, 0], [4, 0], [4, 2], [2, 2], [2, 0]]]}},
    {"type": "Feature", "properties": {"name": "C"}, "geometry":
        {"type": "Polygon", "coordinates": [[[2, 0], [4, 0], [4, 2], [2, 2], [2, 0]]]}}]}"#;

fn ask_of_claims(question: &[&str]) -> (Option<i32>, String) {
    let output = twinedge_reading(&[&["query", "-"], question].concat(), CLAIMS);
    (output.status.code(), String::from_utf8(output.stdout).unwrap())
}

#[test]
fn points_on_edges_and_vertices_and_in_overlaps_are_told_apart() {
    let said = |x, y| {
        let (status, said) = ask_of_claims(&["at", x, y]);
        assert_eq!(status, Some(0));
        // Drops the numbers of records, which are internal.
        said.split(' ')
            .filter(|word| !word.starts_with(['f', 'h', 'v']) || word.len() > 3)
            .collect::<Vec<_>>()
            .join(" ")
    };
    assert_eq!(said("1", "1"), "face of A\n");
    assert_eq!(said("3", "1"), "face of B, C, an overlap\n");
    assert_eq!(said("2", "2"), "vertex at (2, 2), a corner of A, B, C\n");
    let edge = said("2", "1");
    assert!(edge.starts_with("edge from (2, ") && edge.contains("B, C to its") && edge.contains("A to its"), "{edge}");
}

#[test]
fn a_line_meets_faces_edges_and_vertices_in_order() {
    let met = |question: &[&str]| {
        let (status, answer) = ask_of_claims(&[question, &["--format", "json"]].concat());
        assert_eq!(status, Some(0));
        let answer: Value = serde_json::from_str(&answer).unwrap();
        let step = |step: &Value| {
            let along = if step["along"] == json!(true) { "along " } else { "" };
            format!("{along}{} {}", step["kind"].as_str().unwrap(), step["features"])
        };
        answer["met"].as_array().unwrap().iter().map(step).collect::<Vec<_>>()
    };
    let through = [
        "face []",
        r#"edge ["A"]"#,
        r#"face ["A"]"#,
        r#"edge ["A","B","C"]"#,
        r#"face ["B","C"]"#,
        r#"edge ["B","C"]"#,
        "face []",
    ];
    assert_eq!(met(&["line", "-1", "1", "5", "1"]), through);
    assert_eq!(met(&["line", "-1", "1", "3", "1"]), through[..5]);
    assert_eq!(met(&["line", "1", "1", "3", "1", "--extent", "ray"]), through[2..]);
    assert_eq!(met(&["line", "1", "1", "3", "1", "--extent", "line"]), through);
    assert_eq!(
        met(&["line", "-1", "0", "2", "0"]),
        ["face []", r#"vertex ["A"]"#, r#"along edge ["A"]"#, r#"vertex ["A","B","C"]"#]
    );
}

#[test]
fn points_and_lines_that_cannot_be_are_refused() {
    for (question, why) in [
        (&["at", "nan", "0"][..], "not in the range"),
        (&["line", "1", "1", "1", "1"], "there is no direction"),
        (&["line", "0", "0", "inf", "1"], "not in the range"),
    ] {
        let output = twinedge(&[&["query"], question].concat());
        assert_eq!(output.status.code(), Some(2));
        assert!(complaint(&output).contains(why), "{question:?}");
    }
}

#[test]
fn names_cannot_command_the_terminal_or_break_lines() {
    let map = br#"{"type": "Feature", "properties": {"name": "Red\u001b[31m\nland"}, "geometry":
        {"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [0, 1], [0, 0]]]}}"#;
    let output = twinedge_reading(&["query", "-", "at", "0.25", "0.25"], map);
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.ends_with("of Red\u{fffd}[31m\u{fffd}land\n"), "{text}");
    let output = twinedge_reading(&["query", "-", "neighbours", "Red\n[31mland"], map);
    assert!(complaint(&output).contains("did you mean Red\u{fffd}[31m\u{fffd}land?"));
}

#[test]
fn numbers_out_of_range_are_said_briefly() {
    let output = twinedge(&["query", "at", "1e300", "1"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(complaint(&output).contains("(1e300, 1.0)"));
}

#[test]
fn a_number_without_feature_is_told_how_many_there_are() {
    let map = b"POLYGON ((0 0, 1 0, 0 1, 0 0))\nPOLYGON ((5 0, 6 0, 5 1, 5 0))\n";
    let words = complaint(&twinedge_reading(&["query", "-", "neighbours", "#99"], map));
    assert!(words.contains("no feature has the number #99; there are 2 features, counted from #0"), "{words}");
}

/// Three fields with ids and owners. The first and the second overlap along nine tenths of their border of 10.
const OWNED: &[u8] = br#"{"type": "FeatureCollection", "features": [
    {"type": "Feature", "id": 7, "properties": {"name": "Field", "owner": "Meier", "label": "north"}, "geometry":
        {"type": "Polygon", "coordinates": [[[0, 0], [10, 0], [10, 1], [10, 10], [0, 10], [0, 0]]]}},
    {"type": "Feature", "id": 8, "properties": {"name": "Field", "owner": "Kunz", "label": "south"}, "geometry":
        {"type": "Polygon", "coordinates": [[[10, 0], [20, 0], [20, 10], [10, 10], [9.5, 9], [10, 1], [10, 0]]]}},
    {"type": "Feature", "id": 9, "properties": {"name": "Wood", "owner": "Meier"}, "geometry":
        {"type": "Polygon", "coordinates": [[[20, 0], [30, 0], [30, 10], [20, 10], [20, 0]]]}}]}"#;

fn ask_owned(arguments: &[&str]) -> (Option<i32>, String) {
    let output = twinedge_reading(&[&["query", "-"], arguments].concat(), OWNED);
    let text = if output.status.success() { output.stdout } else { output.stderr };
    (output.status.code(), String::from_utf8(text).unwrap())
}

#[test]
fn the_border_of_features_that_overlap_is_counted_once() {
    let (status, text) = ask_owned(&["neighbours", "--id", "7", "--format", "json"]);
    let found: Value = serde_json::from_str(&text).unwrap();
    assert_eq!((status, &found["neighbours"][0]["length"]), (Some(0), &json!(10.0)));
    let (_, table) = ask_owned(&["neighbours", "--all", "--format", "csv"]);
    let rows: Vec<&str> = table.lines().collect();
    assert_eq!(rows[0], "number,id,name,other_number,other_id,other_name,length,shared,lines,overlap");
    assert_eq!(rows[1..], ["0,7,Field,1,8,Field,10.0,1.0,1,2.25", "1,8,Field,2,9,Wood,10.0,10.0,1,0.0"]);
    let (_, sorted) = ask_owned(&["neighbours", "--all", "--sort", "overlap", "--limit", "1", "--format", "json"]);
    let sorted: Value = serde_json::from_str(&sorted).unwrap();
    assert_eq!((&sorted["pairs"][0]["overlap"], sorted["pairs"].as_array().unwrap().len()), (&json!(2.25), 1));
}

#[test]
fn features_are_found_by_id_by_column_and_by_another_name() {
    for (arguments, id) in [
        (&["neighbours", "--where", "owner=Kunz"][..], 1),
        (&["neighbours", "--id", "9"], 2),
        (&["neighbours", "--name-from", "label", "south"], 1),
        (&["neighbours", "Wood"], 2),
    ] {
        let (status, text) = ask_owned(&[arguments, &["--format", "json"]].concat());
        assert_eq!(status, Some(0), "{text}");
        assert_eq!(serde_json::from_str::<Value>(&text).unwrap()["id"], id, "{arguments:?}");
    }
    for (arguments, why) in [
        (&["neighbours", "Field"][..], "2 features have the name Field; ask for one of '#0' (id 7), '#1' (id 8)"),
        (
            &["contour", "--where", "owner=Meier"],
            "2 features have owner = Meier; ask for one of '#0' (id 7), '#2' (id 9)",
        ),
        (&["contour", "--where", "owner=Nobody"], "no feature has owner = Nobody"),
        (
            &["contour", "--where", "tenant=Meier"],
            "no feature has a value in the column tenant; there are label, name, owner",
        ),
        (&["contour", "--id", "77"], "no feature has the id 77"),
        (&["contour", "--where", "owner"], "no COLUMN=VALUE"),
        (&["contour"], "say which feature"),
        (&["neighbours", "Wood", "--all"], "--all is about all features"),
    ] {
        let (status, text) = ask_owned(arguments);
        assert_eq!(status, Some(2), "{arguments:?}");
        assert!(text.contains(why), "{text}");
    }
}

#[test]
fn the_coverage_is_a_table() {
    let (_, table) = ask_owned(&["coverage", "--format", "csv"]);
    let rows: Vec<&str> = table.lines().collect();
    assert_eq!((rows[0], rows.len()), ("rule,kind,features,area,width,length,x,y", 2));
    assert!(rows[1].starts_with("C1,overlap,7;8,2.25,"), "{}", rows[1]);
    let (_, none) = ask_owned(&["coverage", "--rule", "C5", "--format", "json"]);
    assert_eq!(serde_json::from_str::<Value>(&none).unwrap()["coverage"]["findings"], json!([]));
    // A map that is not plane has a coverage as well.
    let (status, found) = run(&["query", &data("world-110m-crossing.geojson"), "coverage", "--format", "json"]);
    assert_eq!((status, &found["coverage"]["overlaps"]), (Some(0), &json!(2)));
}

#[test]
fn thin_strips_have_no_negative_area_along_the_earth() {
    let text = b"POLYGON((0 59,10 59,10 60,0 60,0 59))\nPOLYGON((0 60,5 60.01,10 60,10 61,0 61,0 60))\n";
    let expected = 310_809_178.0;
    for command in [&["query", "-", "coverage", "--geodesic"][..], &["audit", "-", "--geodesic", "--gap-width", "0.1"]]
    {
        let output = twinedge_reading(&[command, &["--format", "json"]].concat(), text);
        let found: Value = serde_json::from_slice(&output.stdout).unwrap();
        let coverage = &found["coverage"];
        let area = coverage["findings"][0]["area"].as_f64().unwrap();
        assert!((area / expected - 1.0).abs() < 1e-6, "{area}");
        assert_eq!((&coverage["gaps"], &coverage["unit"]), (&Value::from(1), &Value::from("metres")));
    }
    let text =
        String::from_utf8(twinedge_reading(&["audit", "-", "--geodesic", "--gap-width", "0.1"], text).stdout).unwrap();
    assert!(text.contains("C3  near miss    ok  up to a width of 0.1000 degrees"), "{text}");
    let mesh = twinedge_reading(&["audit", "-", "--geodesic"], b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    assert!(complaint(&mesh).contains("--geodesic are for maps, and this is a mesh"), "{mesh:?}");
}

#[test]
fn lengths_along_the_earth_are_in_metres() {
    // A degree of longitude on the equator is 111319.491 m long (GeographicLib).
    let degrees = b"POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))\nPOLYGON ((0 0, 0 -1, 1 -1, 1 0, 0 0))\n";
    let output = twinedge_reading(&["query", "-", "neighbours", "#0", "--geodesic", "--format", "json"], degrees);
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    let length = found["neighbours"][0]["length"].as_f64().unwrap();
    assert!((length - 111_319.491).abs() < 1e-3, "{length}");
    assert_eq!(found["unit"], "metres");
    let metres = b"POLYGON ((2600000 1200000, 2600010 1200000, 2600000 1200010, 2600000 1200000))\n";
    let output = twinedge_reading(&["query", "-", "neighbours", "#0", "--geodesic"], metres);
    assert_eq!(output.status.code(), Some(2));
    assert!(complaint(&output).contains("--edges geodesic are for longitudes and latitudes"));
    let output = twinedge_reading(&["query", "-", "neighbours", "#0"], metres);
    assert!(String::from_utf8(output.stdout).unwrap().contains("in the units of the coordinates"));
}

#[test]
fn faces_can_be_sorted_and_cut() {
    let found = ask(&["query", "-", "faces", "--sort", "area", "--limit", "2", "--format", "json"]);
    let areas: Vec<f64> =
        found["faces"].as_array().unwrap().iter().map(|face| face["area"].as_f64().unwrap()).collect();
    assert_eq!(areas, [12.0, 12.0]);
}
