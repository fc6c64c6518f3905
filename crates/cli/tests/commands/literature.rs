//! `twinedge decompose`, `voronoi`, `query … route`, `query … lattice`, `draw --tables` and `audit` of tables.

use crate::support::{complaint, json as run, twinedge, twinedge_reading};
use serde_json::{Value, json};
use std::path::PathBuf;

fn example(name: &str) -> String {
    format!("{}/../../examples/tables/{name}", env!("CARGO_MANIFEST_DIR"))
}

fn scratch(name: &str) -> PathBuf {
    std::env::temp_dir().join(format!("twinedge-{}-{name}", std::process::id()))
}

fn answer(arguments: &[&str], input: &str) -> Value {
    let output = twinedge_reading(arguments, input.as_bytes());
    assert_eq!((output.status.code(), String::from_utf8_lossy(&output.stderr).as_ref()), (Some(0), ""));
    serde_json::from_slice(&output.stdout).unwrap()
}

/// The letter L, and a square with a hole.
const LETTERS: &str = r#"{"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {"name": "L"}, "geometry":
        {"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 2], [3, 2], [3, 3], [0, 3], [0, 0]]]}},
    {"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates":
        [[[10, 0], [13, 0], [13, 3], [10, 3], [10, 0]], [[11, 1], [11, 2], [12, 2], [12, 1], [11, 1]]]}}]}"#;

#[test]
fn features_fall_into_convex_pieces() {
    let found = answer(&["decompose", "-", "--format", "json"], LETTERS);
    let l = json!({"feature": 0, "name": "L", "triangles": 4, "diagonals": 3, "removed": 2, "pieces": 2, "reflex": 1});
    assert_eq!((&found["features"][0], &found["ok"]), (&l, &json!(true)));
    let o = &found["features"][1];
    assert_eq!(
        (&o["triangles"], &o["diagonals"], &o["reflex"], &o["name"]),
        (&json!(8), &json!(8), &json!(4), &Value::Null)
    );
    assert_eq!(o["pieces"].as_u64().unwrap(), 8 - o["removed"].as_u64().unwrap());
    let one = answer(&["decompose", "-", "--feature", "L", "--format", "json"], LETTERS);
    assert_eq!(one["features"], json!([l]));

    let pieces = answer(&["decompose", "-", "--format", "geojson"], LETTERS);
    let pieces = pieces["features"].as_array().unwrap();
    assert_eq!(pieces.iter().filter(|piece| piece["properties"] == json!({"feature": 0, "name": "L"})).count(), 2);
    let area = |piece: &Value| {
        let ring: Vec<[f64; 2]> = serde_json::from_value(piece["geometry"]["coordinates"][0].clone()).unwrap();
        assert_eq!(ring.first(), ring.last());
        ring.windows(2).map(|w| w[0][0] * w[1][1] - w[1][0] * w[0][1]).sum::<f64>() / 2.0
    };
    assert!((pieces.iter().map(area).sum::<f64>() - (5.0 + 8.0)).abs() < 1e-12);

    let text = String::from_utf8(twinedge_reading(&["decompose", "-"], LETTERS.as_bytes()).stdout).unwrap();
    assert!(text.contains("feature 1") && text.contains("pieces"), "{text}");
}

#[test]
fn the_built_in_map_is_decomposed_and_its_steps_are_drawn() {
    let (status, found) = run(&["decompose", "--format", "json"]);
    assert_eq!((status, found["features"].as_array().unwrap().len()), (Some(0), 177));
    let file = scratch("steps.svg");
    let output = twinedge(&["decompose", "--feature", "Switzerland", "--steps", file.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(0));
    let picture = std::fs::read_to_string(&file).unwrap();
    std::fs::remove_file(&file).unwrap();
    let (_, alone) = run(&["decompose", "--feature", "Switzerland", "--format", "json"]);
    let row = &alone["features"][0];
    assert_eq!(picture.matches("hidden").count() as u64, row["removed"].as_u64().unwrap());
    assert_eq!(picture.matches("orange").count() as u64, row["diagonals"].as_u64().unwrap());
    let output = twinedge(&["decompose", "--steps", file.to_str().unwrap()]);
    assert!(output.status.code() == Some(2) && complaint(&output).contains("too many") && !file.exists());
}

#[test]
fn what_cannot_be_decomposed_is_said() {
    let output = twinedge(&["decompose", "--feature", "Atlantis"]);
    assert!(output.status.code() == Some(2) && complaint(&output).contains("Atlantis"));
    let crossing = r#"{"type": "LineString", "coordinates": [[0, 0], [2, 2], [2, 0], [0, 2]]}"#;
    let output = twinedge_reading(&["decompose", "-"], crossing.as_bytes());
    assert!(output.status.code() == Some(2) && complaint(&output).contains("--snap"));
}

#[test]
fn ways_lead_across_borders() {
    let (_, found) = run(&["query", "route", "Portugal", "China", "--format", "json"]);
    let way = json!(["Portugal", "Spain", "France", "Germany", "Poland", "Russia", "China"]);
    assert_eq!(found["route"], way);
    let (_, shortest) = run(&["query", "route", "Portugal", "China", "--by", "length", "--format", "json"]);
    assert!(shortest["length"].as_f64().unwrap() < found["length"].as_f64().unwrap());
    let (status, none) = run(&["query", "route", "Portugal", "Australia", "--format", "json"]);
    assert_eq!((status, &none["route"], &none["length"]), (Some(0), &Value::Null, &Value::Null));
    let text = String::from_utf8(twinedge(&["query", "route", "Portugal", "France"]).stdout).unwrap();
    assert!(text.starts_with("Portugal\nSpain\nFrance\n\n2 borders, "), "{text}");
    let text = String::from_utf8(twinedge(&["query", "route", "Portugal", "Cuba"]).stdout).unwrap();
    assert_eq!(text, "no way from Portugal to Cuba across borders\n");
}

#[test]
fn lattice_points_are_counted() {
    let polygon = r#"{"type": "Polygon", "coordinates": [[[0, 0], [5, 0], [5, 4], [2, 10], [0, 9], [0, 0]]]}"#;
    let found = answer(&["query", "-", "lattice", "--format", "json"], polygon);
    let mut face = found["faces"][0].clone();
    assert!(face.as_object_mut().unwrap().remove("face").unwrap().is_u64());
    assert_eq!(face, json!({"area_doubled": 80, "interior": 30, "boundary": 22, "holes": 0, "pick_holds": true}));
    assert_eq!(found["ok"], json!(true));
    let text = String::from_utf8(twinedge_reading(&["query", "-", "lattice"], polygon.as_bytes()).stdout).unwrap();
    assert!(text.contains("A = I + B/2 - 1 + h for every face"), "{text}");
    let output = twinedge_reading(&["query", "-", "lattice"], polygon.replace("10", "9.5").as_bytes());
    assert!(output.status.code() == Some(2));
    assert!(complaint(&output).contains("(2, 9.5) is not a lattice point"));
}

/// Five places; the last two are equal.
const PLACES: &str = r#"{"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {"name": "A", "beds": 3}, "geometry": {"type": "Point", "coordinates": [0, 0]}},
    {"type": "Feature", "properties": {"name": "B"}, "geometry": {"type": "Point", "coordinates": [4, 0, 17]}},
    {"type": "Feature", "properties": null, "geometry": {"type": "MultiPoint", "coordinates": [[0, 4], [4, 4]]}},
    {"type": "Feature", "properties": {"name": "E"}, "geometry": {"type": "Point", "coordinates": [4, 4]}}]}"#;

#[test]
fn points_have_cells() {
    let found = answer(&["voronoi", "-"], PLACES);
    let cells = found["features"].as_array().unwrap();
    let properties: Vec<&Value> = cells.iter().map(|cell| &cell["properties"]).collect();
    assert_eq!(
        properties,
        [
            &json!({"name": "A", "beds": 3, "site": 0}),
            &json!({"name": "B", "site": 1}),
            &json!({"site": 2}),
            &json!({"site": 3})
        ]
    );
    assert_eq!(found["bbox"], json!([-0.4, -0.4, 4.4, 4.4]));
    let found = answer(&["voronoi", "-", "--bounds", "-1", "-2", "5", "6"], PLACES);
    assert_eq!(found["bbox"], json!([-1.0, -2.0, 5.0, 6.0]));
    let ring = &found["features"][0]["geometry"]["coordinates"][0];
    assert_eq!(ring.as_array().unwrap().len(), 5);

    let found = answer(&["voronoi", "-", "--delaunay"], PLACES);
    assert_eq!(found["features"].as_array().unwrap().len(), 2);
    assert_eq!(found["features"][0]["properties"]["sites"].as_array().unwrap().len(), 3);

    for ending in ["svg", "geojson"] {
        let file = scratch(&format!("cells.{ending}"));
        let output = twinedge_reading(&["voronoi", "-", "-o", file.to_str().unwrap()], PLACES.as_bytes());
        let text = String::from_utf8(output.stdout).unwrap();
        assert_eq!(text, "standard input: 5 points, 4 cells in the box from (-0.4, -0.4) to (4.4, 4.4)\n");
        let written = std::fs::read_to_string(&file).unwrap();
        std::fs::remove_file(&file).unwrap();
        assert!(written.contains(if ending == "svg" { "<svg" } else { "FeatureCollection" }));
    }
}

#[test]
fn points_that_are_too_close_share_a_cell_on_request() {
    // Four adjacent doubles: no three numbers lie between them.
    let text = "POINT(5 0)\nPOINT(1 0)\nPOINT(1.0000000000000002 0)\nPOINT(1.0000000000000004 0)\nPOINT(1.0000000000000007 0)\n";
    let refused = twinedge_reading(&["voronoi", "-"], text.as_bytes());
    assert_eq!(refused.status.code(), Some(2));
    let said = complaint(&refused);
    assert!(said.contains("too close to each other") && said.contains("--merge-close"), "{said}");
    let output = twinedge_reading(&["voronoi", "-", "--merge-close"], text.as_bytes());
    let shared = "3 points too close to others for a cell of their own: site 2 that of 1, 3 that of 1, 4 that of 1";
    assert_eq!(String::from_utf8(output.stderr).unwrap(), format!("standard input: {shared}\n"));
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    let properties: Vec<&Value> =
        found["features"].as_array().unwrap().iter().map(|cell| &cell["properties"]).collect();
    assert_eq!(properties, [&json!({"site": 0}), &json!({"site": 1, "merged": [2, 3, 4]})]);
    let file = scratch("shared.geojson");
    let output = twinedge_reading(&["voronoi", "-", "--merge-close", "-o", file.to_str().unwrap()], text.as_bytes());
    std::fs::remove_file(&file).unwrap();
    assert!(String::from_utf8(output.stdout).unwrap().ends_with(&format!("; {shared}\n")));
}

#[test]
fn cells_are_made_of_points_in_any_format() {
    let text = "POINT(0 0)\nPOINT EMPTY\nMULTIPOINT((4 0),(0 4))\n";
    let topology = r#"{"type": "Topology", "arcs": [], "objects": {"a": {"type": "GeometryCollection", "geometries": [
        {"type": "Point", "coordinates": [0, 0]}, {"type": null}, {"type": "MultiPoint", "coordinates": [[4, 0], [0, 4]]}]}}}"#;
    let found = answer(&["voronoi", "-"], text);
    assert_eq!(found["features"].as_array().unwrap().len(), 3);
    assert_eq!(answer(&["voronoi", "-"], topology), found);
}

#[test]
fn what_has_no_cells_is_said() {
    let said = |arguments: &[&str], input: &str| {
        let output = twinedge_reading(arguments, input.as_bytes());
        assert_eq!(output.status.code(), Some(2));
        complaint(&output)
    };
    assert!(said(&["voronoi", "-"], LETTERS).contains("feature 0: its geometry is no point but Polygon"));
    assert!(said(&["voronoi", "-"], "{").contains("line 1"));
    assert!(said(&["voronoi", "-"], "[]").contains("not GeoJSON"));
    assert!(
        said(&["voronoi", "-"], "POINT(0 0)\nLINESTRING(0 0,1 1)\n")
            .contains("feature 1: its geometry is no point but LineString")
    );
    assert!(said(&["voronoi", "-"], r#"{"type": "MultiPoint", "coordinates": []}"#).contains("there is no site"));
    assert!(said(&["voronoi", "-"], &PLACES.replace("[0, 0]", "[0]")).contains("position"));
    let outside = said(&["voronoi", "-", "--bounds", "1", "1", "5", "5"], PLACES);
    assert!(outside.contains("site 0 at (0, 0) lies outside the bounds"), "{outside}");
    assert!(said(&["voronoi", "-", "--bounds", "1", "1", "0", "5"], PLACES).contains("lower left"));
    assert!(said(&["voronoi", "/no/such/file"], "").contains("/no/such/file"));
}

#[test]
fn tables_of_a_textbook_are_audited_by_their_names() {
    for (file, counts) in [
        ("dangling_edge.txt", json!({"vertices": 4, "edges": 4, "half_edges": 8, "faces": 2, "components": 1})),
        ("five_faces.txt", json!({"vertices": 6, "edges": 9, "half_edges": 18, "faces": 5, "components": 1})),
    ] {
        let (status, found) = run(&["audit", &example(file), "--format", "json"]);
        assert_eq!((status, &found["valid"], &found["counts"]), (Some(0), &json!(true), &counts));
    }
    let right = std::fs::read_to_string(example("five_faces.txt")).unwrap();
    let wrong = right.replace("e2,2       V2      e2,1", "e2,2       V2      e3,1");
    let output = twinedge_reading(&["audit", "-", "--format", "json"], wrong.as_bytes());
    assert_eq!(output.status.code(), Some(1));
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    let first = &found["violations"][0];
    assert!(first["rule"] == "L1" && first["message"].as_str().unwrap().contains("e2,2"), "{first}");
    let text = String::from_utf8(twinedge_reading(&["audit", "-"], wrong.as_bytes()).stdout).unwrap();
    assert!(text.contains("L1  twin       BROKEN") && text.contains("not valid"), "{text}");

    let unknown = right.replace("e2,2       V2      e2,1", "e2,2       V2      e7,3");
    let output = twinedge_reading(&["audit", "-"], unknown.as_bytes());
    assert_eq!(output.status.code(), Some(2));
    assert!(complaint(&output).contains("there is no half-edge `e7,3`"));
}

#[test]
fn tables_are_written_and_audited() {
    let output = twinedge_reading(&["draw", "-", "--tables"], LETTERS.as_bytes());
    assert_eq!(output.status.code(), Some(0));
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.starts_with("Vertex  Coordinates  IncidentEdge\n"), "{text}");
    let (found, rules) = (answer(&["audit", "-", "--format", "json"], &text), 18);
    assert_eq!((&found["valid"], found["rules"].as_array().unwrap().len() >= rules), (&json!(true), true));
    // A vertex moved across its edges.
    let moved = text.replace("(1, 2)", "(20, 2)");
    let output = twinedge_reading(&["audit", "-", "--format", "json"], moved.as_bytes());
    assert_eq!(output.status.code(), Some(1));
}
