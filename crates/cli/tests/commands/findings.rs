//! `twinedge audit --format geojson`, and the destination of reports.

use crate::support::{complaint, data, scratch_folder, twinedge, twinedge_reading};
use serde_json::{Value, json};

fn layer(arguments: &[&str], input: &[u8]) -> (Option<i32>, Value) {
    let output = twinedge_reading(&[&["audit", "--format", "geojson"], arguments].concat(), input);
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
    (output.status.code(), serde_json::from_slice(&output.stdout).unwrap())
}

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

/// Checks the requirements of RFC 7946 on a collection, and the columns that all features share.
fn check_layer(layer: &Value) {
    assert_eq!(layer["type"], "FeatureCollection");
    let mut columns: Option<Vec<String>> = None;
    for feature in features(layer) {
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
}

fn kinds(layer: &Value) -> Vec<[&str; 2]> {
    features(layer)
        .iter()
        .map(|feature| {
            [&feature["properties"]["rule"], &feature["geometry"]["type"]].map(|one| one.as_str().unwrap_or("none"))
        })
        .collect()
}

/// Two adjacent squares.
const SQUARES: &str = r#"{"type":"FeatureCollection","features":[
{"type":"Feature","properties":{"name":"a"},"geometry":{"type":"Polygon","coordinates":[[[0,0],[4,0],[4,4],[0,4],[0,0]]]}},
{"type":"Feature","properties":{"name":"b"},"geometry":{"type":"Polygon","coordinates":[[[4,0],[8,0],[8,4],[4,4],[4,0]]]}}]}"#;

#[test]
fn a_map_without_findings_is_a_layer_without_features() {
    let (status, found) = layer(&["-"], SQUARES.as_bytes());
    assert_eq!(status, Some(0));
    assert_eq!((&found["type"], &found["features"]), (&json!("FeatureCollection"), &json!([])));
    assert_eq!((&found["valid"], &found["found"]), (&json!(true), &json!(0)));
    assert_eq!(found.get("crs"), None);
}

#[test]
fn violations_and_findings_are_points_lines_and_polygons() {
    let (status, found) = layer(&[&data("world-110m-crossing.geojson"), "--explain"], b"");
    assert_eq!(status, Some(1));
    check_layer(&found);
    let expected = [
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
        ["T3", "none"],
    ];
    assert_eq!(kinds(&found), expected);
    let crossing = &features(&found)[7]["properties"];
    assert_eq!(crossing["follows_from"], "C6");
    assert_eq!(crossing["follows_from_id"], features(&found)[1]["properties"]["id"]);
    assert_eq!(crossing["records"], json!(["half-edge 4045", "half-edge 4201"]));
    assert_eq!(crossing["feature_ids"], json!(["729", "140", "728"]));
    assert_eq!(crossing["violation"], true);
    assert!(crossing["cause"].is_string() && crossing["remedy"].is_string());
    // The place of the crossing, to a millionth of a degree.
    let at = [&crossing["x"], &crossing["y"]].map(|x| x.as_f64().unwrap());
    assert!((at[0] - 23.888_056).abs() < 1e-6 && (at[1] - 8.619_091).abs() < 1e-6, "{at:?}");
    let overlap = &features(&found)[3]["properties"];
    assert_eq!(
        (&overlap["unit"], &overlap["violation"], overlap["cause"].is_string()),
        (&json!("degrees"), &json!(false), true)
    );
    assert!((overlap["area"].as_f64().unwrap() - 6.521e-4).abs() < 1e-7);
}

#[test]
fn the_area_of_a_polygon_is_the_one_that_stands_beside_it() {
    let (status, found) = layer(&[concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/overlapping.geojson")], b"");
    assert_eq!(status, Some(1));
    check_layer(&found);
    let overlap = features(&found).iter().find(|one| one["properties"]["rule"] == "C1").unwrap();
    let ring = positions(&overlap["geometry"]["coordinates"][0], 5);
    let twice: f64 = ring.windows(2).map(|pair| pair[0][0] * pair[1][1] - pair[1][0] * pair[0][1]).sum();
    assert!((twice / 2.0 - overlap["properties"]["area"].as_f64().unwrap()).abs() < 1e-9);
    // A vertex inside an edge: the place is the vertex.
    let touch = features(&found).iter().find(|one| one["properties"]["kind"] == "touch").unwrap();
    assert_eq!((&touch["properties"]["x"], &touch["properties"]["y"]), (&json!(9.5), &json!(0.0)));
}

#[test]
fn a_reference_system_of_the_input_is_that_of_the_layer() {
    let named =
        SQUARES.replacen('{', r#"{"crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::2056"}},"#, 1);
    let (_, found) = layer(&["-"], named.as_bytes());
    assert_eq!(found["crs"]["properties"]["name"], "urn:ogc:def:crs:EPSG::2056");
}

/// A triangle in which the next of e1,1 is another face's half-edge.
const BROKEN: &str = "v1 (0, 0) e1,1\nv2 (4, 0) e2,1\nv3 (0, 4) e3,1\nf1 nil e1,2\nf2 e1,1 nil
e1,1 v1 e1,2 f2 e2,2 e3,1\ne1,2 v2 e1,1 f1 e3,2 e2,2\ne2,1 v2 e2,2 f2 e3,1 e1,1
e2,2 v3 e2,1 f1 e1,2 e3,2\ne3,1 v3 e3,2 f2 e1,1 e2,1\ne3,2 v1 e3,1 f1 e2,2 e1,2\n";

#[test]
fn tables_of_a_textbook_have_their_names() {
    let (status, found) = layer(&["-"], BROKEN.as_bytes());
    assert_eq!(status, Some(1));
    check_layer(&found);
    let link = &features(&found)[0];
    assert_eq!((&link["properties"]["rule"], &link["properties"]["records"][0]), (&json!("L2"), &json!("e1,1")));
    assert_eq!(link["geometry"]["coordinates"][0], json!([[0, 0], [4, 0]]));
    // Without coordinates there is no place.
    let bare = ["(0, 0) ", "(4, 0) ", "(0, 4) "].iter().fold(BROKEN.to_owned(), |text, at| text.replace(at, ""));
    let (status, found) = layer(&["-"], bare.as_bytes());
    assert_eq!(status, Some(1));
    check_layer(&found);
    assert!(features(&found).iter().all(|one| one["geometry"].is_null() && one["properties"]["x"].is_null()));
}

#[test]
fn the_extension_of_the_output_says_the_format() {
    let folder = scratch_folder("audit_output");
    let input = folder.join("squares.geojson");
    std::fs::write(&input, SQUARES).unwrap();
    let input = input.to_str().unwrap();
    for (name, begins) in [
        ("a.geojson", "{\"type\":\"FeatureCollection\""),
        ("a.html", "<!doctype html>"),
        ("a.json", "{\n  \"input\""),
        ("a.txt", input),
    ] {
        let path = folder.join(name);
        let output = twinedge(&["audit", input, "-o", path.to_str().unwrap()]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let written = std::fs::read_to_string(&path).unwrap();
        assert!(written.starts_with(begins) && !written.contains('\u{1b}'), "{name}: {written}");
    }
    let path = folder.join("b.html");
    let output = twinedge(&["audit", input, "-o", path.to_str().unwrap(), "--format", "geojson"]);
    let said = String::from_utf8(output.stdout).unwrap();
    assert!(said.ends_with(&format!("0 findings written to {}\n", path.display())), "{said}");
    assert!(std::fs::read_to_string(&path).unwrap().starts_with("{\"type\""));
    // The input stays unchanged.
    let output = twinedge(&["audit", input, "-o", input]);
    assert_eq!(output.status.code(), Some(2));
    assert!(complaint(&output).contains("this is the input"));
    assert_eq!(std::fs::read_to_string(input).unwrap(), SQUARES);
}

#[test]
fn what_has_no_place_in_the_plane_is_refused() {
    let [mesh, tables] = ["OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "V 0 H 0 B 0 F 0\n"];
    for (input, what, formats) in
        [(mesh, "a mesh", &["geojson"][..]), (tables, "a file of tables", &["geojson", "html"])]
    {
        for format in formats {
            let output = twinedge_reading(&["audit", "-", "--format", format], input.as_bytes());
            assert_eq!((output.status.code(), output.stdout.len()), (Some(2), 0));
            assert!(complaint(&output).contains(&format!("this is {what}")));
        }
    }
}

/// Returns the data of a page.
fn page(arguments: &[&str], input: &[u8]) -> (Option<i32>, Value) {
    let output = twinedge_reading(&[&["audit", "--format", "html"], arguments].concat(), input);
    let page = String::from_utf8(output.stdout).unwrap();
    // Nothing to load, no placeholder left, and no element from the input.
    for foreign in ["http:", "https:", " src=", "@import", "url(", "{data}", "{script}", "{style}", "alert(1)</script>"]
    {
        assert!(!page.contains(foreign), "{foreign}");
    }
    assert!(page.starts_with("<!doctype html>") && page.trim_end().ends_with("</html>"));
    assert!(page.contains("content=\"default-src 'none'; "));
    let (_, data) = page.split_once("<script id=\"data\" type=\"application/json\">").unwrap();
    let (data, _) = data.split_once("</script>").unwrap();
    (output.status.code(), serde_json::from_str(data).unwrap())
}

#[test]
fn a_page_has_the_map_and_what_was_found() {
    let (status, found) = page(&[&data("world-110m-crossing.geojson")], b"");
    assert_eq!(status, Some(1));
    assert_eq!((&found["tone"], found["findings"].as_array().unwrap().len()), (&json!("bad"), 10));
    assert_eq!(found["map"]["edges"], json!([7651, 7651]));
    // The map is not plane: the page fills the faces of the map with its borders cut, at two further crossings.
    assert_eq!(found["map"]["areas"]["edges"], json!([7655, 7655]));
    assert_eq!(found["features"].as_array().unwrap().len(), 177);
    // Consequences follow their cause.
    let rules: Vec<&str> =
        found["findings"].as_array().unwrap().iter().map(|one| one["rule"].as_str().unwrap()).collect();
    assert_eq!(rules, ["C2", "C6", "C1", "C1", "C4", "C4", "G4", "G4", "T3", "C6"]);
    let crossing = &found["findings"][6];
    assert_eq!(
        crossing["sentence"],
        "the borders of Sudan, Central African Rep. and S. Sudan cross at (23.8881, 8.6191)"
    );
    assert_eq!(crossing["trace"]["lines"].as_array().unwrap().len(), 2);
    let names: Vec<&str> = crossing["features"]
        .as_array()
        .unwrap()
        .iter()
        .map(|number| found["features"][number.as_u64().unwrap() as usize][0].as_str().unwrap())
        .collect();
    assert_eq!(names, ["Sudan", "Central African Rep.", "S. Sudan"]);
    let (status, found) = page(&["--coverage"], b"");
    assert_eq!((status, &found["map"]["areas"]), (Some(1), &json!(null)));
    assert!(found["findings"].as_array().unwrap().iter().all(|one| one["violation"] == true));
}

#[test]
fn a_page_has_the_mesh_and_what_was_found() {
    // A tetrahedron without its last face, seen along y, the axis of its smallest extent.
    let open = b"OFF\n4 3 0\n0 0 0\n4 0 0\n1 1 0\n0 0 3\n3 0 2 1\n3 0 1 3\n3 1 2 3\n";
    let (status, found) = page(&["-", "--closed"], open);
    assert_eq!((status, &found["map"]["edges"]), (Some(1), &json!([6, 6])));
    let border = found["findings"].as_array().unwrap().iter().find(|one| one["rule"] == "M4").unwrap();
    let lines = border["trace"]["lines"].as_array().unwrap();
    assert!(lines.iter().flat_map(|line| line.as_array().unwrap()).all(|at| at[0].as_f64() <= Some(4.0)), "{border}");
    assert!(!lines.is_empty() && border["at"].is_array(), "{border}");
}

#[test]
fn hostile_names_stay_texts() {
    let name = "</script><script>alert(1)</script>\u{2028}\"'&<!--";
    let squares = SQUARES.replace("\"a\"", &json!(name).to_string());
    let (status, found) = page(&["-"], squares.as_bytes());
    assert_eq!((status, &found["features"][0][0]), (Some(0), &json!(name)));
}

#[test]
fn a_page_shows_tables_and_topologies() {
    let (status, found) = page(&["-"], BROKEN.as_bytes());
    assert_eq!((status, &found["map"]["edges"]), (Some(1), &json!([3, 3])));
    assert_eq!(found["map"]["names"]["own"]["half_edges"][0], "e1,1");
    let town = include_bytes!("../../../postgis/tests/postgis/data/town.copy");
    let (status, found) = page(&["-"], town);
    assert_eq!((status, &found["findings"], &found["tone"]), (Some(0), &json!([]), &json!("good")));
    let edges = found["map"]["names"]["ids"]["edges"].as_array().unwrap().len();
    assert_eq!(found["map"]["edges"], json!([edges, edges]));
}
