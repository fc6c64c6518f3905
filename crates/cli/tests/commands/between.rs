//! `twinedge audit --against` and `--parent-column`: rules between layers.

use crate::support::{complaint, json as run, twinedge};
use serde_json::{Value, json};
use std::fs;
use tempfile::TempDir;

/// A rectangle by least x, least y, greatest x, greatest y.
fn rectangle([x0, y0, x1, y1]: [f64; 4]) -> Value {
    json!({"type": "Polygon", "coordinates": [[[x0, y0], [x1, y0], [x1, y1], [x0, y1], [x0, y0]]]})
}

/// Writes a layer whose features have a name, a value in the column STATE, and a geometry.
fn layer(folder: &TempDir, name: &str, features: &[(&str, Value, Value)]) -> String {
    let feature = |(name, state, geometry): &(&str, Value, Value)| json!({"type": "Feature", "properties": {"name": name, "STATE": state}, "geometry": geometry});
    let layer = json!({"type": "FeatureCollection", "features": features.iter().map(feature).collect::<Vec<_>>()});
    let path = folder.path().join(name);
    fs::write(&path, layer.to_string()).unwrap();
    path.to_str().unwrap().to_owned()
}

/// Two adjacent states of 20 by 20, named in the column STATE.
fn states(folder: &TempDir) -> String {
    let of = |name: &'static str, x: f64| (name, json!(name), rectangle([x, 0.0, x + 20.0, 20.0]));
    layer(folder, "states.geojson", &[of("Iowa", 100.0), of("Ohio", 120.0)])
}

/// Two counties in each state. Cedar has this width and names this state.
fn counties(folder: &TempDir, name: &str, width: f64, state: &str) -> String {
    let of = |name: &'static str, state: &str, x: f64, width: f64| {
        (name, json!(state), rectangle([x, 0.0, x + width, 20.0]))
    };
    let all = [
        of("Adair", "Iowa", 100.0, 10.0),
        of("Cedar", state, 110.0, width),
        of("Darke", "Ohio", 120.0, 10.0),
        of("Erie", "Ohio", 130.0, 10.0),
    ];
    layer(folder, name, &all)
}

fn audited(layer: &str, options: &[&str]) -> (Option<i32>, Value) {
    run(&[&["audit", layer, "--format", "json"], options].concat())
}

/// Rule, kind, features, others.
fn found(report: &Value) -> Vec<[String; 4]> {
    let names = |of: &Value| {
        of.as_array().unwrap().iter().map(|one| one["name"].as_str().unwrap()).collect::<Vec<_>>().join(" ")
    };
    let text = |of: &Value| of.as_str().unwrap().to_owned();
    let of = |one: &Value| [text(&one["rule"]), text(&one["kind"]), names(&one["features"]), names(&one["others"])];
    report["findings"].as_array().unwrap().iter().map(of).collect()
}

#[test]
fn parts_that_make_up_their_parents_are_accepted() {
    let folder = TempDir::new().unwrap();
    let (states, counties) = (states(&folder), counties(&folder, "counties.geojson", 10.0, "Iowa"));
    let (status, report) = audited(&counties, &["--against", &states, "--parent-column", "STATE"]);
    assert_eq!((status, &report["verdict"], found(&report)), (Some(0), &json!("valid"), vec![]), "{report}");
    let rules: Vec<_> =
        report["rules"].as_array().unwrap().iter().filter(|rule| rule["id"].as_str() > Some("X")).collect();
    let brief = |id: &str, checked: u64| json!({"id": id, "checked": checked, "violations": 0, "unchecked": null});
    assert_eq!(rules, [&brief("X1", 4), &brief("X2", 5), &brief("X3", 13), &brief("X4", 4)]);
    assert_eq!(report["against"], json!({"input": states, "features": 2}));
    assert_eq!((&report["options"]["against"], &report["options"]["parent_column"]), (&json!(states), &json!("STATE")));
}

#[test]
fn each_deviation_is_found_with_the_features_of_both_layers_in_all_formats() {
    let folder = TempDir::new().unwrap();
    let states = states(&folder);
    let wrong = counties(&folder, "wrong.geojson", 10.0, "Ohio");
    let options = ["--against", &states, "--parent-column", "STATE"];
    let (status, report) = audited(&wrong, &options);
    let of_parents = [
        ["X4", "outside_parent", "Cedar", "Ohio"].map(str::to_owned),
        ["X4", "parent_not_covered", "", "Iowa"].map(str::to_owned),
    ];
    assert_eq!((status, found(&report)), (Some(1), of_parents.to_vec()));
    let first = &report["findings"][0];
    assert_eq!((&first["area"], &first["length"], &first["at"]), (&json!(200.0), &json!(60.0), &json!([115.0, 10.0])));
    assert_eq!((&report["verdict"], &report["finding_count"]), (&json!("invalid"), &json!(2)));
    let (_, unknown) = audited(&counties(&folder, "unknown.geojson", 10.0, "Utah"), &options);
    assert_eq!(found(&unknown)[1], ["X4", "unknown_parent", "Cedar", ""]);
    assert!(unknown["findings"][1]["message"].as_str().unwrap().starts_with("its parent Utah is not known"));

    // This county ends before the border of the state.
    let narrow = counties(&folder, "narrow.geojson", 9.0, "Iowa");
    let (_, report) = audited(&narrow, &options);
    let rules: Vec<String> = found(&report).into_iter().map(|[rule, kind, ..]| format!("{rule} {kind}")).collect();
    assert_eq!(rules, ["X2 only_there", "X3 no_border", "X3 no_border", "X4 parent_not_covered"]);
    let write = |format: &str| {
        let output = twinedge(&[&["audit", &narrow, "--format", format], &options[..]].concat());
        assert_eq!(output.status.code(), Some(1), "{}", complaint(&output));
        String::from_utf8(output.stdout).unwrap()
    };
    let text = write("text");
    let line = format!(
        "X2 only_there; only Iowa of {states} covers this; area 20.0000, width 0.9524, borders of 42.0000; at (119.5, 10)"
    );
    assert!(text.contains(&line), "{text}");
    assert!(text.contains("\n  X3  border     BROKEN  2 violations in 16 edges\n"), "{text}");
    let sarif: Value = serde_json::from_str(&write("sarif")).unwrap();
    let results = sarif["runs"][0]["results"].as_array().unwrap();
    let of_layers: Vec<_> = results.iter().filter(|one| one["ruleId"].as_str() > Some("X")).collect();
    assert_eq!((of_layers.len(), &of_layers[0]["level"]), (4, &json!("error")));
    let junit = write("junit");
    assert!(
        junit.contains("name=\"X1 within\" time=\"0\"/>") && junit.contains("name=\"X2 cover\" time=\"0\"><failure"),
        "{junit}"
    );
    let layer: Value = serde_json::from_str(&write("geojson")).unwrap();
    let cover = &layer["features"][0];
    assert_eq!((&cover["properties"]["rule"], &cover["properties"]["others"]), (&json!("X2"), &json!(["Iowa"])));
    assert_eq!(cover["geometry"]["type"], "Polygon");
    let page = write("html");
    assert!(page.contains("\"id\":\"X4\"") && page.contains("none of its parts covers this of Iowa"), "{page}");
}

#[test]
fn findings_between_layers_are_accepted_and_compared() {
    let folder = TempDir::new().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let (states, list) = (states(&folder), path("accepted.json"));
    let options = ["--against", &states];
    let narrow = counties(&folder, "narrow.geojson", 9.0, "Iowa");
    audited(&narrow, &[&options[..], &["--accept-all", &list]].concat());
    let (status, report) = audited(&narrow, &[&options[..], &["--accept", &list]].concat());
    assert_eq!((status, &report["accepted"]["count"]), (Some(0), &json!(3)), "{report}");
    let narrower = counties(&folder, "narrower.geojson", 8.0, "Iowa");
    let (status, report) = audited(&narrower, &[&options[..], &["--accept", &list]].concat());
    assert_eq!((status, &report["verdict"]), (Some(1), &json!("invalid")));
    let write = |layer: &str, name: &str| {
        let report = path(name);
        twinedge(&[&["audit", layer, "-o", &report], &options[..]].concat());
        report
    };
    let whole = write(&counties(&folder, "whole.geojson", 10.0, "Iowa"), "whole.json");
    let (status, difference) = run(&["diff", &whole, &write(&narrow, "narrow.json"), "--format", "json"]);
    assert_eq!((status, difference["new"].as_array().unwrap().len()), (Some(1), 3));
}

/// Levels in one file: a county names its state, which has no parent.
#[test]
fn the_layer_by_which_another_one_is_judged_is_known_by_its_bytes() {
    let folder = TempDir::new().unwrap();
    let (states, counties) = (states(&folder), counties(&folder, "counties.geojson", 10.0, "Iowa"));
    let (_, report) = audited(&counties, &["--against", &states]);
    // The file judged by itself.
    let (_, alone) = audited(&states, &[]);
    assert_eq!(report["judged_by"], alone["judged"]);
    assert_ne!(report["judged_by"], report["judged"]);
    assert!(report["judged_by"]["sha256"].is_string() && alone["judged_by"].is_null());
}

#[test]
fn levels_of_one_layer_are_judged_by_the_column_of_their_parents() {
    let folder = TempDir::new().unwrap();
    let of = |name: &'static str, state: Value, x: f64, width: f64| (name, state, rectangle([x, 0.0, x + width, 20.0]));
    let all = |width: f64| {
        [
            of("Iowa", Value::Null, 100.0, 20.0),
            of("Adair", json!("Iowa"), 100.0, 10.0),
            of("Cedar", json!("Iowa"), 110.0, width),
            of("Ohio", json!(""), 120.0, 20.0),
        ]
    };
    let judge = |width: f64, column: &str| {
        let file = layer(&folder, "levels.geojson", &all(width));
        audited(&file, &["--snap", "auto", "--parent-column", column])
    };
    for column in ["STATE", "STATE=name"] {
        let (status, report) = judge(10.0, column);
        assert_eq!((status, found(&report)), (Some(0), vec![]), "{report}");
        let (status, report) = judge(9.0, column);
        assert_eq!(
            (status, found(&report)),
            (Some(1), vec![["X4", "parent_not_covered", "", "Iowa"].map(str::to_owned)])
        );
    }
}

#[test]
fn lines_and_points_are_judged_by_the_areas_of_the_other_layer() {
    let folder = TempDir::new().unwrap();
    let states = states(&folder);
    let point = |x: f64| json!({"type": "Point", "coordinates": [x, 10.0]});
    let places = layer(
        &folder,
        "places.geojson",
        &[("in", json!(1), point(105.0)), ("on", json!(1), point(120.0)), ("out", json!(1), point(90.0))],
    );
    let (status, report) = audited(&places, &["--against", &states]);
    let of = |feature: &str, others: &str| ["X6", "not_inside", feature, others].map(str::to_owned);
    assert_eq!((status, found(&report)), (Some(1), vec![of("on", "Iowa Ohio"), of("out", "")]));
    let line = |y: f64| json!({"type": "LineString", "coordinates": [[120.0, y], [120.0, 20.0]]});
    let borders = layer(&folder, "borders.geojson", &[("short", json!(1), line(5.0)), ("long", json!(1), line(-3.0))]);
    let (_, report) = audited(&borders, &["--against", &states]);
    let last = report["findings"].as_array().unwrap().last().unwrap();
    assert_eq!((&last["rule"], &last["length"], &last["at"]), (&json!("X5"), &json!(3.0), &json!([120.0, -1.5])));
}

/// A part without area lies outside of nothing, but has a place.
#[test]
fn a_point_whose_parent_is_not_known_has_its_place() {
    let folder = TempDir::new().unwrap();
    let post = ("Post", json!("Utah"), json!({"type": "Point", "coordinates": [105.0, 10.0]}));
    let whole = ("Whole", json!("Iowa"), rectangle([100.0, 0.0, 120.0, 20.0]));
    let file = layer(&folder, "parts.geojson", &[post, whole]);
    let (_, report) = audited(&file, &["--against", &states(&folder), "--parent-column", "STATE"]);
    let one = report["findings"].as_array().unwrap().last().unwrap();
    assert_eq!((&one["kind"], &one["at"], one.get("area")), (&json!("unknown_parent"), &json!([105.0, 10.0]), None));
}

/// Borders that coincide within a cell coincide for both layers.
#[test]
fn snapping_applies_to_both_layers() {
    let folder = TempDir::new().unwrap();
    let states = states(&folder);
    let near = counties(&folder, "near.geojson", 9.99, "Iowa");
    assert_eq!(audited(&near, &["--against", &states]).0, Some(1));
    let (status, report) = audited(&near, &["--against", &states, "--snap", "0.25"]);
    assert_eq!((status, found(&report)), (Some(0), vec![]), "{report}");
}

#[test]
fn what_cannot_be_compared_is_refused() {
    let folder = TempDir::new().unwrap();
    let (states, counties) = (states(&folder), counties(&folder, "counties.geojson", 10.0, "Iowa"));
    let places = layer(&folder, "places.geojson", &[("in", json!(1), json!({"type": "Point", "coordinates": [1, 2]}))]);
    let double = layer(
        &folder,
        "double.geojson",
        &[("a", json!("Iowa"), rectangle([0.0, 0.0, 1.0, 1.0])), ("b", json!("Iowa"), rectangle([1.0, 0.0, 2.0, 1.0]))],
    );
    let mesh = folder.path().join("mesh.off");
    fs::write(&mesh, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").unwrap();
    let mesh = mesh.to_str().unwrap();
    for (options, why) in [
        (&[&*counties, "--against", &places][..], "places.geojson: a map is made of lines and polygons"),
        (&[&*counties, "--against", &places, "--allow-empty"][..], "places.geojson has no polygons"),
        (&[&*counties, "--against", "/nowhere.shp"], "/nowhere.shp: No such file"),
        (
            &[&*counties, "--against", &states, "--parent-column", "ST"],
            "no feature has a value in the column ST; there are STATE, name",
        ),
        (
            &[&*counties, "--against", &states, "--parent-column", "STATE=ST"],
            "no feature has a value in the column ST; there are STATE, name",
        ),
        (&[&*counties, "--against", &double, "--parent-column", "STATE"], "two features have the STATE Iowa, by which"),
        (&[&*counties, "--parent-column", "STATE"], "no feature has one of the values of STATE as its name"),
        (&[mesh, "--against", &states], "--against and --parent-column are for maps, and this is"),
    ] {
        let output = twinedge(&[&["audit"], options].concat());
        assert_eq!(output.status.code(), Some(2), "{options:?}: {}", complaint(&output));
        assert!(complaint(&output).contains(why), "{options:?}: {}", complaint(&output));
    }
    for (options, why) in [
        (["--against", &*states, "--tiles", "2"], "cannot be used with '--tiles <N>'"),
        (["--against", &*states, "--parent-column", "=x"], "neither COLUMN nor COLUMN=KEY"),
    ] {
        let output = twinedge(&[&["audit", &counties][..], &options].concat());
        assert_eq!(output.status.code(), Some(2));
        assert!(String::from_utf8_lossy(&output.stderr).contains(why), "{output:?}");
    }
}
