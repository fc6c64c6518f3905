//! `twinedge audit --edges geodesic`: edges as great circles.

use crate::support::{complaint, json as run, twinedge};
use serde_json::{Value, json};
use std::fs;
use tempfile::TempDir;

type Ring<'a> = &'a [[f64; 2]];

/// Writes a layer of polygons of one ring each, with a declaration of their edges.
fn layer(folder: &TempDir, name: &str, rings: &[Ring<'_>], edges: Option<&str>) -> String {
    let feature = |(number, ring): (usize, &Ring<'_>)| {
        let closed: Vec<_> = ring.iter().chain(ring.first()).collect();
        let geometry = json!({"type": "Polygon", "coordinates": [closed]});
        json!({"type": "Feature", "id": format!("f{number}"), "properties": {"name": "a"}, "geometry": geometry})
    };
    let features: Vec<Value> = rings.iter().enumerate().map(feature).collect();
    let mut layer = json!({"type": "FeatureCollection", "features": features});
    if let Some(edges) = edges {
        layer["edges"] = json!(edges);
    }
    let path = folder.path().join(name);
    fs::write(&path, layer.to_string()).unwrap();
    path.to_str().unwrap().to_owned()
}

fn audited(layer: &str, options: &[&str]) -> (Option<i32>, Value) {
    run(&[&["audit", layer, "--format", "json"], options].concat())
}

fn violations<'a>(report: &'a Value, key: &str) -> Vec<&'a str> {
    report["violations"].as_array().unwrap().iter().map(|one| one[key].as_str().unwrap_or_default()).collect()
}

/// The rules and features of the coverage's findings.
fn found(report: &Value) -> Vec<(String, Vec<String>)> {
    let ids = |one: &Value| one.as_array().unwrap().iter().map(|one| one["id"].as_str().unwrap().to_owned()).collect();
    let of = |one: &Value| (one["rule"].as_str().unwrap().to_owned(), ids(&one["features"]));
    report["coverage"]["findings"].as_array().unwrap().iter().map(of).collect()
}

/// On the map, its northern border lies at 50 degrees; on the globe, it bulges to 67.2 degrees.
const LONG: Ring<'_> =
    &[[-60.0, 30.0], [-30.0, 30.0], [0.0, 30.0], [30.0, 30.0], [60.0, 30.0], [60.0, 50.0], [-60.0, 50.0]];
const BESIDE: Ring<'_> = &[[-5.0, 60.0], [5.0, 60.0], [5.0, 72.0], [-5.0, 72.0]];

/// <https://github.com/apache/sedona-db/issues/1154>: borders that are plane on the map cross as geographies.
#[test]
fn borders_that_cross_on_the_globe_only_are_found() {
    let folder = TempDir::new().unwrap();
    let file = layer(&folder, "two.geojson", &[LONG, BESIDE], None);
    let (status, straight) = audited(&file, &["--coverage"]);
    assert_eq!((status, &straight["verdict"], &straight["options"]["edges"]), (Some(0), &json!("valid"), &Value::Null));

    let (status, report) = audited(&file, &["--edges", "geodesic"]);
    assert_eq!((status, &report["verdict"]), (Some(1), &json!("invalid")));
    assert_eq!((violations(&report, "rule"), violations(&report, "kind")), (vec!["G4"; 2], vec!["cross"; 2]));
    assert_eq!(report["violations"][0]["features"], json!(["a", "a"]));
    assert_eq!(found(&report), [("C1".to_owned(), vec!["f0".to_owned(), "f1".to_owned()])]);
    let overlap = &report["coverage"]["findings"][0];
    // From 60 to 67.1 degrees, 10 degrees wide: 791 km by 503 km on average.
    assert!((3.8e11..4.2e11).contains(&overlap["area"].as_f64().unwrap()), "{overlap}");
    assert_eq!((&report["coverage"]["unit"], &report["coverage"]["ogc_invalid"]), (&json!("metres"), &Value::Null));
    assert_eq!((&report["edges"]["kind"], &report["options"]["edges"]), (&json!("great circles"), &json!("geodesic")));
    assert_eq!(report["first"]["rule"], json!("C1"));
    // The structure has the edges after cutting.
    assert_eq!([&report["counts"]["vertices"], &report["counts"]["edges"]], [13, 15]);
    for rule in report["rules"].as_array().unwrap() {
        assert_eq!(rule["violations"].as_u64().unwrap() > 0, rule["id"] == "G4", "{rule}");
    }
}

#[test]
fn a_ring_that_crosses_itself_on_the_map_only_is_accepted() {
    let folder = TempDir::new().unwrap();
    let ring = [[-60.0, 50.0], [-20.0, 40.0], [0.0, 55.0], [20.0, 40.0], [60.0, 50.0]];
    let file = layer(&folder, "one.geojson", &[&ring], None);
    assert_eq!(audited(&file, &[]).0, Some(1));
    let (status, report) = audited(&file, &["--edges", "geodesic", "--coverage"]);
    assert_eq!((status, &report["verdict"]), (Some(0), &json!("valid")));
}

/// Both have a vertex on the other's side of their common meridian.
#[test]
fn a_contact_on_a_meridian_is_a_mismatch_and_nothing_else() {
    let folder = TempDir::new().unwrap();
    let colorado = [[-109.05, 37.0], [-102.05, 37.0], [-102.05, 41.0], [-109.05, 41.0]];
    let kansas = [[-102.05, 37.0], [-94.6, 37.0], [-94.6, 40.0], [-102.05, 40.0]];
    let file = layer(&folder, "states.geojson", &[&colorado, &kansas], None);
    let (status, report) = audited(&file, &["--edges", "geodesic"]);
    assert_eq!((status, found(&report)), (Some(1), vec![("C7".to_owned(), vec!["f0".to_owned(), "f1".to_owned()])]));
    assert_eq!(report["coverage"]["findings"][0]["missing"], json!([{"at": [-102.05, 40.0], "feature": 0}]));
    assert_eq!(
        (violations(&report, "kind"), violations(&report, "follows_from")),
        (vec!["overlap", "touch"], vec!["C7", "C7"])
    );
    assert_eq!(report["first"]["rule"], json!("C7"));
}

#[test]
fn an_edge_between_antipodes_is_named_and_nothing_is_said_of_the_coverage() {
    let folder = TempDir::new().unwrap();
    let ring = [[0.0, 10.0], [90.0, 0.0], [180.0, -10.0]];
    let file = layer(&folder, "half.geojson", &[&ring], None);
    let (status, report) = audited(&file, &["--edges", "geodesic"]);
    assert_eq!(
        (status, violations(&report, "rule"), violations(&report, "kind")),
        (Some(1), vec!["G1"], vec!["antipodal"])
    );
    assert!(report["coverage"]["not_checked"].as_str().unwrap().contains("1 edge between antipodes"));
}

#[test]
fn all_forms_of_a_report_have_great_circles() {
    let folder = TempDir::new().unwrap();
    let file = layer(&folder, "two.geojson", &[LONG, BESIDE], None);
    let output = twinedge(&["audit", &file, "--edges", "geodesic"]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.contains("edges are great circles, cut where they meet"), "{text}");
    assert!(text.contains("C6  OGC validity not checked"), "{text}");
    let (_, points) = run(&["audit", &file, "--edges", "geodesic", "--format", "geojson"]);
    let overlap = &points["features"][0];
    assert_eq!((&overlap["properties"]["rule"], &overlap["geometry"]["type"]), (&json!("C1"), &json!("Polygon")));
    // The drawn arc is curved.
    let ring = overlap["geometry"]["coordinates"][0].as_array().unwrap();
    let top = ring.iter().map(|at| at[1].as_f64().unwrap()).fold(0.0, f64::max);
    assert!(ring.len() > 20 && (67.2..67.3).contains(&top), "{top}");
}

#[test]
fn what_is_about_straight_edges_is_refused() {
    let folder = TempDir::new().unwrap();
    let file = layer(&folder, "two.geojson", &[LONG, BESIDE], None);
    for (options, why) in [
        (&["--snap", "auto"][..], "--edges geodesic and --snap do not go together"),
        (&["--geodesic"], "--edges geodesic and --geodesic do not go together"),
        (&["--tiles", "2"], "--edges geodesic and --tiles or --memory do not go together"),
        (&["--against", &file], "--edges geodesic and --against or --parent-column do not go together"),
    ] {
        let said = complaint(&twinedge(&[&["audit", &file, "--edges", "geodesic"], options].concat()));
        assert!(said.contains(why), "{said}");
    }
    let metres = layer(&folder, "metres.geojson", &[&[[5e5, 5e6], [6e5, 5e6], [6e5, 6e6]]], None);
    let said = complaint(&twinedge(&["audit", &metres, "--edges", "geodesic"]));
    assert!(said.contains("--edges geodesic are for longitudes and latitudes"), "{said}");
}

/// `edges: "spherical"` of `GeoParquet` 1.1.
#[test]
fn a_file_that_says_that_its_edges_are_spherical_is_judged_so() {
    let folder = TempDir::new().unwrap();
    let spherical = layer(&folder, "two.geojson", &[LONG, BESIDE], Some("spherical"));
    let parquet = folder.path().join("two.parquet");
    let parquet = parquet.to_str().unwrap();
    assert!(twinedge(&["convert", &spherical, "--id-column", "key", "-o", parquet]).status.success());
    let (status, report) = audited(parquet, &[]);
    assert_eq!((status, violations(&report, "kind")), (Some(1), vec!["cross"; 2]));
    let text = String::from_utf8(twinedge(&["audit", parquet]).stdout).unwrap();
    assert!(text.contains("edges are great circles, as the file says"), "{text}");
    // Tiles take edges as straight, and refuse others.
    let summary = folder.path().join("summary");
    let summary = summary.to_str().unwrap();
    let tile = ["tile", parquet, "--grid", "1x1", "--tile", "0,0", "-o", summary];
    for arguments in [&["audit", parquet, "--tiles", "2"][..], &["audit", parquet, "--memory", "1G"], &tile] {
        let said = complaint(&twinedge(arguments));
        assert!(said.contains("edges are spherical by the file, and straight in tiles: --edges straight"), "{said}");
        assert!(twinedge(&[arguments, &["--edges", "straight"]].concat()).status.success(), "{arguments:?}");
    }
    // Another format that declares geodesic edges gets a warning, and so do requested straight edges.
    for (file, options) in [
        (&*spherical, &[][..]),
        (&*spherical, &["--tiles", "2"]),
        (parquet, &["--edges", "straight"]),
        (parquet, &["--edges", "straight", "--tiles", "2"]),
    ] {
        let (status, report) = audited(file, options);
        assert_eq!(status, Some(0));
        let warning = report["warnings"][0].as_str().unwrap();
        assert!(warning.contains("its edges are spherical, and they were judged as straight"), "{warning}");
    }
}
