//! `twinedge decompose` and `twinedge voronoi`.

use crate::shared::{has, members};
use crate::support::Folder;
use serde_json::{Value, json};

/// The letter L, and a square with a hole.
const LETTERS: &str = r#"{"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {"name": "L"}, "geometry":
        {"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 2], [3, 2], [3, 3], [0, 3], [0, 0]]]}},
    {"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates":
        [[[10, 0], [13, 0], [13, 3], [10, 3], [10, 0]], [[11, 1], [11, 2], [12, 2], [12, 1], [11, 1]]]}}]}"#;

/// Five places; the last two are equal.
const PLACES: &str = r#"{"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {"name": "A", "beds": 3}, "geometry": {"type": "Point", "coordinates": [0, 0]}},
    {"type": "Feature", "properties": {"name": "B"}, "geometry": {"type": "Point", "coordinates": [4, 0, 17]}},
    {"type": "Feature", "properties": null, "geometry": {"type": "MultiPoint", "coordinates": [[0, 4], [4, 4]]}},
    {"type": "Feature", "properties": {"name": "E"}, "geometry": {"type": "Point", "coordinates": [4, 4]}}]}"#;

/// Four adjacent doubles: no three numbers lie between them.
const CLOSE: &str =
    "POINT(5 0)\nPOINT(1 0)\nPOINT(1.0000000000000002 0)\nPOINT(1.0000000000000004 0)\nPOINT(1.0000000000000007 0)\n";

fn inputs() -> Folder {
    Folder::new(&[
        ("letters", LETTERS),
        ("places", PLACES),
        ("close.wkt", CLOSE),
        ("bow", r#"{"type": "LineString", "coordinates": [[0, 0], [2, 2], [2, 0], [0, 2]]}"#),
        ("brace", "{"),
        ("list", "[]"),
        ("mixed.wkt", "POINT(0 0)\nLINESTRING(0 0,1 1)\n"),
        ("none", r#"{"type": "MultiPoint", "coordinates": []}"#),
        ("short", &PLACES.replace("[0, 0]", "[0]")),
        ("some.wkt", "POINT(0 0)\nPOINT EMPTY\nMULTIPOINT((4 0),(0 4))\n"),
        (
            "some.topojson",
            r#"{"type": "Topology", "arcs": [], "objects": {"a": {"type": "GeometryCollection", "geometries": [
            {"type": "Point", "coordinates": [0, 0]}, {"type": null}, {"type": "MultiPoint", "coordinates": [[4, 0], [0, 4]]}]}}}"#,
        ),
    ])
}

#[test]
fn what_is_said_and_what_is_refused() {
    let folder = inputs();
    folder.transcript(
        "
decompose letters => 0 feature 1 ++ pieces
decompose --feature Atlantis => 2 Atlantis
decompose bow => 2 --snap
decompose --steps steps.svg => 2 too many
voronoi places -o cells.svg => 0 places: 5 points, 4 cells in the box from (-0.4, -0.4) to (4.4, 4.4)
voronoi places -o cells.geojson => 0 places: 5 points, 4 cells in the box from (-0.4, -0.4) to (4.4, 4.4)
voronoi letters => 2 feature 0: its geometry is no point but Polygon
voronoi brace => 2 line 1
voronoi list => 2 not GeoJSON
voronoi mixed.wkt => 2 feature 1: its geometry is no point but LineString
voronoi none => 2 there is no site
voronoi short => 2 position
voronoi places --bounds 1 1 5 5 => 2 site 0 at (0, 0) lies outside the bounds
voronoi places --bounds 1 1 0 5 => 2 lower left
voronoi missing => 2 missing
voronoi close.wkt => 2 too close to each other ++ --merge-close
voronoi close.wkt --merge-close -o shared.geojson => 0 ; 3 points too close to others for a cell of their own: site 2 that of 1, 3 that of 1, 4 that of 1
",
    );
    assert!(!folder.path("steps.svg").exists());
}

#[test]
fn features_fall_into_convex_pieces() {
    let folder = inputs();
    let (_, found) = folder.json("decompose letters --format json");
    let l = json!({"feature": 0, "name": "L", "triangles": 4, "diagonals": 3, "removed": 2, "pieces": 2, "reflex": 1});
    let o = json!({"triangles": 8, "diagonals": 8, "reflex": 4, "name": null});
    has(&found, &json!({"features": [l, o], "ok": true}));
    let o = &found["features"][1];
    assert_eq!(o["pieces"].as_u64().unwrap(), 8 - o["removed"].as_u64().unwrap());
    assert_eq!(folder.json("decompose letters --feature L --format json").1["features"], json!([l]));

    let (_, pieces) = folder.json("decompose letters --format geojson");
    let pieces = pieces["features"].as_array().unwrap();
    assert_eq!(pieces.iter().filter(|piece| piece["properties"] == json!({"feature": 0, "name": "L"})).count(), 2);
    let area = |piece: &Value| {
        let ring: Vec<[f64; 2]> = serde_json::from_value(piece["geometry"]["coordinates"][0].clone()).unwrap();
        assert_eq!(ring.first(), ring.last());
        ring.windows(2).map(|w| w[0][0] * w[1][1] - w[1][0] * w[0][1]).sum::<f64>() / 2.0
    };
    assert!((pieces.iter().map(area).sum::<f64>() - (5.0 + 8.0)).abs() < 1e-12);
}

#[test]
fn the_built_in_map_is_decomposed_and_its_steps_are_drawn() {
    let folder = inputs();
    let (_, found) = folder.json("decompose --format json");
    assert_eq!(found["features"].as_array().unwrap().len(), 177);
    folder.ok("decompose --feature Switzerland --steps steps.svg");
    let (_, alone) = folder.json("decompose --feature Switzerland --format json");
    let picture = folder.text("steps.svg");
    for (what, key) in [("hidden", "removed"), ("orange", "diagonals")] {
        assert_eq!(json!(picture.matches(what).count()), alone["features"][0][key]);
    }
}

#[test]
fn points_have_cells() {
    let folder = inputs();
    let (_, found) = folder.json("voronoi places");
    let properties = json!([{"name": "A", "beds": 3, "site": 0}, {"name": "B", "site": 1}, {"site": 2}, {"site": 3}]);
    assert_eq!(members(&found["features"], &["properties"]), properties);
    assert_eq!(found["bbox"], json!([-0.4, -0.4, 4.4, 4.4]));
    let (_, found) = folder.json("voronoi places --bounds -1 -2 5 6");
    assert_eq!(found["bbox"], json!([-1.0, -2.0, 5.0, 6.0]));
    assert_eq!(found["features"][0]["geometry"]["coordinates"][0].as_array().unwrap().len(), 5);
    let (_, found) = folder.json("voronoi places --delaunay");
    assert_eq!(found["features"].as_array().unwrap().len(), 2);
    assert_eq!(found["features"][0]["properties"]["sites"].as_array().unwrap().len(), 3);
    for (name, begins) in [("cells.svg", "<svg"), ("cells.geojson", "{")] {
        folder.ok(&format!("voronoi places -o {name}"));
        assert!(folder.text(name).starts_with(begins), "{name}");
    }
    // Points of any format.
    let (_, found) = folder.json("voronoi some.wkt");
    assert_eq!((found["features"].as_array().unwrap().len(), &found), (3, &folder.json("voronoi some.topojson").1));
    // Points that are too close share a cell on request.
    let ran = folder.run("voronoi close.wkt --merge-close");
    let shared = "3 points too close to others for a cell of their own: site 2 that of 1, 3 that of 1, 4 that of 1";
    assert_eq!(ran.err, format!("close.wkt: {shared}\n"));
    let found: Value = serde_json::from_str(&ran.out).unwrap();
    assert_eq!(members(&found["features"], &["properties"]), json!([{"site": 0}, {"site": 1, "merged": [2, 3, 4]}]));
}
