//! Findings as a layer, and pages.

use crate::shared::{TOWN, has, members};
use crate::support::{audited, crossing, file, layer, page_data, world};
use serde_json::{Value, json};

fn features(layer: &Value) -> &Vec<Value> {
    layer["features"].as_array().unwrap()
}

/// Returns the positions of a list, which must be at least `least` pairs of numbers.
fn positions(list: &Value, least: usize) -> Vec<[f64; 2]> {
    let list: Vec<[f64; 2]> = serde_json::from_value(list.clone()).unwrap();
    assert!(list.len() >= least && list.iter().flatten().all(|x| x.is_finite()), "{list:?}");
    list
}

/// RFC 7946, 3.1.6: closed, at least four positions; the outer ring counter-clockwise, holes clockwise.
fn check_polygon(rings: &Value) {
    for (n, ring) in rings.as_array().unwrap().iter().enumerate() {
        let ring = positions(ring, 4);
        assert_eq!(ring.first(), ring.last());
        let [x, y] = ring[0];
        let twice = |pair: &[[f64; 2]]| (pair[0][0] - x) * (pair[1][1] - y) - (pair[1][0] - x) * (pair[0][1] - y);
        let area: f64 = ring.windows(2).map(twice).sum();
        assert!(if n == 0 { area > 0.0 } else { area < 0.0 }, "{ring:?}");
    }
}

/// Checks the requirements of RFC 7946 on a layer of findings, and the columns that all features share.
fn checked(input: impl Into<Vec<u8>>, words: &str) -> Value {
    let layer = layer(&audited(input, words));
    assert_eq!(layer["type"], "FeatureCollection");
    let mut columns: Option<Vec<String>> = None;
    for feature in features(&layer) {
        assert_eq!(feature["type"], "Feature");
        let found: Vec<String> = feature["properties"].as_object().unwrap().keys().cloned().collect();
        assert_eq!(*columns.get_or_insert_with(|| found.clone()), found);
        let geometry = &feature["geometry"];
        let coordinates = &geometry["coordinates"];
        match geometry["type"].as_str() {
            None => assert!(geometry.is_null()),
            Some("Point") => drop(positions(&json!([coordinates]), 1)),
            Some("MultiPoint" | "LineString") => drop(positions(coordinates, 2)),
            Some("MultiLineString") => coordinates.as_array().unwrap().iter().for_each(|line| drop(positions(line, 2))),
            Some("Polygon") => check_polygon(coordinates),
            Some("MultiPolygon") => coordinates.as_array().unwrap().iter().for_each(check_polygon),
            Some(other) => panic!("{other}"),
        }
    }
    layer
}

/// Two adjacent squares.
const SQUARES: &str = r#"{"type":"FeatureCollection","features":[
{"type":"Feature","properties":{"name":"a"},"geometry":{"type":"Polygon","coordinates":[[[0,0],[4,0],[4,4],[0,4],[0,0]]]}},
{"type":"Feature","properties":{"name":"b"},"geometry":{"type":"Polygon","coordinates":[[[4,0],[8,0],[8,4],[4,4],[4,0]]]}}]}"#;

#[test]
fn a_map_without_findings_is_a_layer_without_features() {
    let empty = json!({"type": "FeatureCollection", "features": [], "valid": true, "found": 0, "crs": null});
    has(&checked(SQUARES, ""), &empty);
    let system = json!({"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::2056"}});
    let named = SQUARES.replacen('{', &format!(r#"{{"crs":{system},"#), 1);
    has(&checked(named, ""), &json!({"crs": system}));
}

#[test]
fn violations_and_findings_are_points_lines_and_polygons() {
    let found = checked(crossing(), "--explain");
    let all = features(&found);
    let kinds = all.iter().map(|one| json!([one["properties"]["rule"], one["geometry"]["type"]])).collect::<Value>();
    let expected = json!([
        ["C2", "Polygon"],
        // Sudan has two defects, North Korea one.
        ["C6", "MultiPoint"],
        ["C6", "Point"],
        ["C1", "Polygon"],
        ["C1", "Polygon"],
        ["C4", "Polygon"],
        ["C4", "Polygon"],
        ["G4", "MultiLineString"],
        ["G4", "MultiLineString"],
        // The component; its corner is not at fault.
        ["T3", null],
    ]);
    assert_eq!(kinds, expected);
    let crossing = &all[7]["properties"];
    let expected = json!({
        "follows_from": "C6", "follows_from_id": all[1]["properties"]["id"], "records": ["half-edge 4045", "half-edge 4201"],
        "feature_ids": ["729", "140", "728"], "violation": true,
    });
    has(crossing, &expected);
    // The place of the crossing, to a millionth of a degree.
    let at = [&crossing["x"], &crossing["y"]].map(|x| x.as_f64().unwrap());
    assert!((at[0] - 23.888_056).abs() < 1e-6 && (at[1] - 8.619_091).abs() < 1e-6, "{at:?}");
    let overlap = &all[3]["properties"];
    has(overlap, &json!({"unit": "degrees", "violation": false}));
    assert!((overlap["area"].as_f64().unwrap() - 6.521e-4).abs() < 1e-7);
    for one in [crossing, overlap] {
        assert!(one["cause"].is_string() && one["remedy"].is_string());
    }
}

#[test]
fn the_area_of_a_polygon_is_the_one_that_stands_beside_it() {
    let found = checked(file("docs/overlapping.geojson"), "");
    let overlap = features(&found).iter().find(|one| one["properties"]["rule"] == "C1").unwrap();
    let ring = positions(&overlap["geometry"]["coordinates"][0], 5);
    let twice: f64 = ring.windows(2).map(|pair| pair[0][0] * pair[1][1] - pair[1][0] * pair[0][1]).sum();
    assert!((twice / 2.0 - overlap["properties"]["area"].as_f64().unwrap()).abs() < 1e-9);
    // A vertex inside an edge: the place is the vertex.
    let touch = features(&found).iter().find(|one| one["properties"]["kind"] == "touch").unwrap();
    has(touch, &json!({"properties": {"x": 9.5, "y": 0}}));
}

/// A triangle in which the next of e1,1 is another face's half-edge.
const BROKEN: &str = "v1 (0, 0) e1,1\nv2 (4, 0) e2,1\nv3 (0, 4) e3,1\nf1 nil e1,2\nf2 e1,1 nil
e1,1 v1 e1,2 f2 e2,2 e3,1\ne1,2 v2 e1,1 f1 e3,2 e2,2\ne2,1 v2 e2,2 f2 e3,1 e1,1
e2,2 v3 e2,1 f1 e1,2 e3,2\ne3,1 v3 e3,2 f2 e1,1 e2,1\ne3,2 v1 e3,1 f1 e2,2 e1,2\n";

#[test]
fn tables_of_a_textbook_have_their_names() {
    let found = checked(BROKEN, "");
    let link = &features(&found)[0];
    assert_eq!((&link["properties"]["rule"], &link["properties"]["records"][0]), (&json!("L2"), &json!("e1,1")));
    assert_eq!(link["geometry"]["coordinates"][0], json!([[0, 0], [4, 0]]));
    // Without coordinates there is no place.
    let bare = ["(0, 0) ", "(4, 0) ", "(0, 4) "].iter().fold(BROKEN.to_owned(), |text, at| text.replace(at, ""));
    let found = checked(bare, "");
    assert!(!features(&found).is_empty());
    assert!(features(&found).iter().all(|one| one["geometry"].is_null() && one["properties"]["x"].is_null()));
}

#[test]
fn coordinates_without_a_reference_system_are_warned_of() {
    let metres = "POLYGON((0 0,900 0,900 900,0 900,0 0))\nPOLYGON((800 0,999 0,999 900,800 900,800 0))\n";
    let (_, warnings) = audited(metres, "").findings().unwrap();
    assert!(warnings.len() == 1 && warnings[0].contains("no coordinate reference system is known"), "{warnings:?}");
}

#[test]
fn what_has_no_place_in_the_plane_is_not_drawn() {
    let mesh = audited("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "");
    let tables = audited("V 0 H 0 B 0 F 0\n", "");
    for error in [mesh.findings().unwrap_err(), tables.findings().unwrap_err(), tables.page().unwrap_err()] {
        assert!(error.to_string().contains(" is not drawn"), "{error}");
    }
}

/// Returns the data of a page, and checks that it needs nothing else.
fn page(input: impl Into<Vec<u8>>, words: &str) -> Value {
    let page = audited(input, words).page().unwrap();
    // Nothing to load, no placeholder left, and no element from the input.
    for foreign in ["http:", "https:", " src=", "@import", "url(", "{data}", "{script}", "{style}", "alert(1)</script>"]
    {
        assert!(!page.contains(foreign), "{foreign}");
    }
    assert!(page.starts_with("<!doctype html>") && page.trim_end().ends_with("</html>"));
    assert!(page.contains("content=\"default-src 'none'; "));
    page_data(&page).unwrap()
}

#[test]
fn a_page_has_the_map_and_what_was_found() {
    let found = page(crossing(), "");
    // The map is not plane: the page fills the faces of the map with its borders cut, at two further crossings.
    let map = json!({"edges": [7651, 7651], "areas": {"edges": [7655, 7655]}});
    has(&found, &json!({"tone": "bad", "map": map}));
    assert_eq!(found["features"].as_array().unwrap().len(), 177);
    // Consequences follow their cause.
    let rules = json!(["C2", "C6", "C1", "C1", "C4", "C4", "G4", "G4", "T3", "C6"]);
    assert_eq!(members(&found["findings"], &["rule"]), rules);
    let crossing = &found["findings"][6];
    let sentence = "the borders of Sudan, Central African Rep. and S. Sudan cross at (23.8881, 8.6191)";
    assert_eq!((&crossing["sentence"], crossing["trace"]["lines"].as_array().unwrap().len()), (&json!(sentence), 2));
    let numbers = crossing["features"].as_array().unwrap().iter();
    let names: Vec<&Value> = numbers.map(|number| &found["features"][number.as_u64().unwrap() as usize][0]).collect();
    assert_eq!(names, ["Sudan", "Central African Rep.", "S. Sudan"]);
    let found = page(world(), "--coverage");
    assert_eq!(found["map"]["areas"], Value::Null);
    assert!(found["findings"].as_array().unwrap().iter().all(|one| one["violation"] == true));
}

#[test]
fn a_page_has_the_mesh_and_what_was_found() {
    // A tetrahedron without its last face, seen along y, the axis of its smallest extent.
    let found = page("OFF\n4 3 0\n0 0 0\n4 0 0\n1 1 0\n0 0 3\n3 0 2 1\n3 0 1 3\n3 1 2 3\n", "--closed");
    assert_eq!(found["map"]["edges"], json!([6, 6]));
    let border = found["findings"].as_array().unwrap().iter().find(|one| one["rule"] == "M4").unwrap();
    let lines = border["trace"]["lines"].as_array().unwrap();
    assert!(lines.iter().flat_map(|line| line.as_array().unwrap()).all(|at| at[0].as_f64() <= Some(4.0)), "{border}");
    assert!(!lines.is_empty() && border["at"].is_array(), "{border}");
}

#[test]
fn a_page_shows_tables_topologies_and_hostile_names() {
    let found = page(BROKEN, "");
    assert_eq!(found["map"]["edges"], json!([3, 3]));
    assert_eq!(found["map"]["names"]["own"]["half_edges"][0], "e1,1");
    let found = page(TOWN, "");
    let edges = found["map"]["names"]["ids"]["edges"].as_array().unwrap().len();
    has(&found, &json!({"findings": [], "tone": "good", "map": {"edges": [edges, edges]}}));
    let name = "</script><script>alert(1)</script>\u{2028}\"'&<!--";
    assert_eq!(page(SQUARES.replace("\"a\"", &json!(name).to_string()), "")["features"][0][0], name);
}
