//! `twinedge query`.

use crate::shared::{has, members};
use crate::support::{Folder, crossing, root};
use serde_json::{Value, json};
use std::collections::BTreeSet;

/// Two adjacent squares, and a square that touches the first at a corner. The second claims a quarter of the first.
const SQUARES: &str = r#"{"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {"name": "West"}, "geometry":
        {"type": "Polygon", "coordinates": [[[0, 0], [3, 0], [4, 0], [4, 4], [3, 4], [0, 4], [0, 0]]]}},
    {"type": "Feature", "properties": {"name": "East"}, "geometry":
        {"type": "Polygon", "coordinates": [[[3, 0], [4, 0], [7, 0], [7, 4], [4, 4], [3, 4], [3, 0]]]}},
    {"type": "Feature", "properties": {"name": "Corner"}, "geometry":
        {"type": "Polygon", "coordinates": [[[0, 4], [0, 5], [-1, 5], [-1, 4], [0, 4]]]}},
    {"type": "Feature", "properties": {"name": "Twice"}, "geometry": null},
    {"type": "Feature", "properties": {"name": "Twice"}, "geometry": null}]}"#;

/// Two adjacent squares; two features claim the right one.
const CLAIMS: &str = r#"{"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {"name": "A"}, "geometry":
        {"type": "Polygon", "coordinates": [[[0, 0], [2, 0], [2, 2], [0, 2], [0, 0]]]}},
    {"type": "Feature", "properties": {"name": "B"}, "geometry":
        {"type": "Polygon", "coordinates": [[[2, 0], [4, 0], [4, 2], [2, 2], [2, 0]]]}},
    {"type": "Feature", "properties": {"name": "C"}, "geometry":
        {"type": "Polygon", "coordinates": [[[2, 0], [4, 0], [4, 2], [2, 2], [2, 0]]]}}]}"#;

/// Three fields with ids and owners. The first and the second overlap along nine tenths of their border of 10.
const OWNED: &str = r#"{"type": "FeatureCollection", "features": [
    {"type": "Feature", "id": 7, "properties": {"name": "Field", "owner": "Meier", "label": "north"}, "geometry":
        {"type": "Polygon", "coordinates": [[[0, 0], [10, 0], [10, 1], [10, 10], [0, 10], [0, 0]]]}},
    {"type": "Feature", "id": 8, "properties": {"name": "Field", "owner": "Kunz", "label": "south"}, "geometry":
        {"type": "Polygon", "coordinates": [[[10, 0], [20, 0], [20, 10], [10, 10], [9.5, 9], [10, 1], [10, 0]]]}},
    {"type": "Feature", "id": 9, "properties": {"name": "Wood", "owner": "Meier"}, "geometry":
        {"type": "Polygon", "coordinates": [[[20, 0], [30, 0], [30, 10], [20, 10], [20, 0]]]}}]}"#;

const LATTICE: &str = r#"{"type": "Polygon", "coordinates": [[[0, 0], [5, 0], [5, 4], [2, 10], [0, 9], [0, 0]]]}"#;

fn inputs() -> Folder {
    Folder::new(&[
        ("squares", SQUARES),
        ("claims", CLAIMS),
        ("owned", OWNED),
        ("polygon", LATTICE),
        ("beside", &LATTICE.replace("10", "9.5")),
        ("two.wkt", "POLYGON ((0 0, 1 0, 0 1, 0 0))\nPOLYGON ((5 0, 6 0, 5 1, 5 0))\n"),
        ("metres.wkt", "POLYGON ((2600000 1200000, 2600010 1200000, 2600000 1200010, 2600000 1200000))\n"),
        // A degree of longitude on the equator is 111319.491 m long (GeographicLib).
        ("degrees.wkt", "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))\nPOLYGON ((0 0, 0 -1, 1 -1, 1 0, 0 0))\n"),
        (
            "red",
            r#"{"type": "Feature", "properties": {"name": "Red\u001b[31m\nland"}, "geometry":
        {"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [0, 1], [0, 0]]]}}"#,
        ),
    ])
}

#[test]
fn people_read_these_answers_and_errors() {
    let folder = inputs();
    folder.transcript(&format!(
        "
query neighbours Switzerland => 0 Switzerland ++ Austria
query squares neighbours #0 => 0 touches Corner at a vertex only ++ overlap: 1 face(s) of area 4.0000 are claimed by East too
query squares contour East => 0 vertices            6 ++ 16.0000
query squares faces => 0 overlap: West, East ++ unbounded
query claims at 1 1 => 0 face ++ of A
query claims at 3 1 => 0 face ++ of B, C, an overlap
query claims at 2 2 => 0 vertex ++ at (2, 2), a corner of A, B, C
query claims at 2 1 => 0 edge ++ from (2, ++ B, C to its ++ A to its
query two.wkt neighbours #0 => 0
query metres.wkt neighbours #0 => 0 in the units of the coordinates
query route Portugal France => 0 Portugal ++ Spain ++ France ++ 2 borders,
query route Portugal Cuba => 0 no way from Portugal to Cuba across borders
query polygon lattice => 0 A = I + B/2 - 1 + h for every face

query contour Swizerland => 2 no feature has the n ++ did you mean Switzerland
query contour germany => 2 no feature has the n ++ did you mean Germany
query contour #999 => 2 no feature has the n ++ #999
query two.wkt neighbours #99 => 2 no feature has the number #99; there are 2 features, counted from #0
query two.wkt neighbours 'feature 0' => 2 by their numbers, from '#0' to '#1'
query squares neighbours Twice => 2 2 features have the name Twice; ask for one of '#3', '#4'
query owned neighbours Field => 2 2 features have the name Field; ask for one of '#0' (id 7), '#1' (id 8)
query owned contour --where owner=Meier => 2 2 features have owner = Meier; ask for one of '#0' (id 7), '#2' (id 9)
query owned contour --where owner=Nobody => 2 no feature has owner = Nobody
query owned contour --where tenant=Meier => 2 no feature has a value in the column tenant; there are label, name, owner
query owned contour --id 77 => 2 no feature has the id 77
query owned contour --where owner => 2 no COLUMN=VALUE
query owned contour => 2 say which feature
query owned neighbours Wood --all => 2 --all is about all features
query missing.geojson faces => 2 missing.geojson
query => 2 Usage
query neighbours => 2 say which feature
query a b faces => 2 unexpected argument
query contour Fiji --format xml => 2 invalid value 'xml'
query at nan 0 => 2 not in the range
query at 1e300 1 => 2 (1e300, 1.0)
query line 1 1 1 1 => 2 there is no direction
query line 0 0 inf 1 => 2 not in the range
query beside lattice => 2 (2, 9.5) is not a lattice point
query metres.wkt neighbours #0 --geodesic => 2 --edges geodesic are for longitudes and latitudes
query {crossing} neighbours Switzerland => 2 --snap auto cuts them
query {crossing} contour Fiji => 2 --snap auto cuts them
query {crossing} faces => 2 --snap auto cuts them
query {crossing} at 0 0 => 2 --snap auto cuts them
",
        crossing = crossing()
    ));
    assert!(!folder.run("query contour zzzzzz").err.contains("did you mean"));
    assert_eq!(folder.ok("query squares faces").lines().count(), 6);
    assert_eq!(folder.ok("query squares contour East --format wkt"), "POLYGON((3 0,4 0,7 0,7 4,4 4,3 4,3 0))\n");
    // Names cannot command the terminal or break lines.
    let text = folder.ok("query red at 0.25 0.25");
    assert!(text.ends_with("of Red\u{fffd}[31m\u{fffd}land\n"), "{text}");
    let error = folder.run("query red neighbours 'Red\n[31mland'").err;
    assert!(error.contains("did you mean Red\u{fffd}[31m\u{fffd}land?"), "{error}");
}

#[test]
fn machines_get_these_answers() {
    let folder = inputs();
    let ring = json!([[3.0, 0.0], [4.0, 0.0], [7.0, 0.0], [7.0, 4.0], [4.0, 4.0], [3.0, 4.0], [3.0, 0.0]]);
    let face = |kind: &Value| json!({"found": {"kind": "face", "features": kind}});
    let to_china = ["Portugal", "Spain", "France", "Germany", "Poland", "Russia", "China"];
    let pick = json!({"area_doubled": 80, "interior": 30, "boundary": 22, "holes": 0, "pick_holds": true});
    // The end of West, with East beyond it; not the end of East inside West.
    let west = json!({
        "input": "squares", "neighbours": [{"name": "East", "id": 1, "length": 4, "borders": [[[4, 0], [4, 4]]]}],
        "touching": [{"name": "Corner", "id": 2}], "overlaps": [{"name": "East", "id": 1, "faces": 1, "area": 4}],
    });
    for (question, expected) in [
        ("neighbours Switzerland".to_owned(), json!({"feature": "Switzerland", "overlaps": []})),
        ("neighbours Lesotho".to_owned(), json!({"neighbours": [{"name": "South Africa"}]})),
        ("squares neighbours West".to_owned(), west),
        (
            "squares contour East".to_owned(),
            json!({"input": "squares", "feature": "East", "id": 1, "area": 16, "polygons": [{"outer": ring, "holes": []}]}),
        ),
        ("squares faces --sort area --limit 2".to_owned(), json!({"faces": [{"area": 12}, {"area": 12}]})),
        ("at 28.25 -29.5".to_owned(), face(&json!(["Lesotho"]))),
        ("at 24 -29".to_owned(), json!({"point": [24, -29], "found": {"kind": "face", "features": ["South Africa"]}})),
        // The Caspian Sea is a hole in five countries; the Atlantic is not.
        ("at 51 42".to_owned(), json!({"found": {"kind": "face", "unbounded": false, "features": []}})),
        ("at -30 0".to_owned(), json!({"found": {"kind": "face", "unbounded": true, "features": []}})),
        ("route Portugal China".to_owned(), json!({"route": to_china})),
        ("route Portugal Australia".to_owned(), json!({"route": null, "length": null})),
        ("polygon lattice".to_owned(), json!({"faces": [pick], "ok": true})),
        ("owned neighbours --id 7".to_owned(), json!({"neighbours": [{"length": 10}]})),
        ("owned neighbours --id 9".to_owned(), json!({"id": 2})),
        ("owned neighbours --where owner=Kunz".to_owned(), json!({"id": 1})),
        ("owned neighbours --name-from label south".to_owned(), json!({"id": 1})),
        ("owned neighbours Wood".to_owned(), json!({"id": 2})),
        ("owned neighbours --all --sort overlap --limit 1".to_owned(), json!({"pairs": [{"overlap": 2.25}]})),
        ("owned coverage --rule C5".to_owned(), json!({"coverage": {"findings": []}})),
        // A map that is not plane has a coverage as well.
        (format!("{} coverage", crossing()), json!({"coverage": {"overlaps": 2}})),
        ("degrees.wkt neighbours #0 --geodesic".to_owned(), json!({"unit": "metres"})),
    ] {
        let (status, answer) = folder.json(&format!("query {question} --format json"));
        assert_eq!(status, Some(0), "{question}");
        has(&answer, &expected);
    }
    let ask = |question: &str| folder.json(&format!("query {question} --format json")).1;
    for of in ["", &root("crates/cli/data/world-110m.geojson")] {
        let neighbours = members(&ask(&format!("{of} neighbours Switzerland"))["neighbours"], &["name"]);
        let names: BTreeSet<&str> = neighbours.as_array().unwrap().iter().map(|name| name.as_str().unwrap()).collect();
        assert_eq!(names, BTreeSet::from(["Austria", "France", "Germany", "Italy"]));
    }
    let length = ask("degrees.wkt neighbours #0 --geodesic")["neighbours"][0]["length"].as_f64().unwrap();
    assert!((length - 111_319.491).abs() < 1e-3, "{length}");
    let shortest = ask("route Portugal China --by length")["length"].as_f64();
    assert!(shortest < ask("route Portugal China")["length"].as_f64());
    let holes = ask("contour 'South Africa'")["polygons"][0]["holes"].as_array().unwrap().len();
    assert_eq!(holes, 1);
    let cut = ask(&format!("--snap auto {} neighbours 'S. Sudan'", crossing()));
    assert!(members(&cut["neighbours"], &["name"]).as_array().unwrap().contains(&json!("Ethiopia")));
    let (_, geojson) = folder.json("query squares contour East --format geojson");
    let geometry = json!({"type": "Polygon", "coordinates": [ring]});
    has(&geojson, &json!({"features": [{"geometry": geometry, "properties": {"name": "East"}}]}));
}

#[test]
fn faces_are_listed_with_what_bounds_them() {
    let (_, found) = inputs().json("query squares faces --format json");
    let faces = found["faces"].as_array().unwrap();
    assert_eq!(faces.len(), 5);
    let of = |features: Value| faces.iter().find(|face| face["features"] == features).unwrap();
    let (both, west) = (of(json!(["West", "East"])), of(json!(["West"])));
    has(both, &json!({"overlap": true, "area": 4, "edges": 4}));
    has(west, &json!({"overlap": false, "area": 12, "holes": 0}));
    assert!(west["neighbours"].as_array().unwrap().contains(&both["id"]));
    has(of(json!([])), &json!({"unbounded": true, "area": null, "holes": 1}));
}

#[test]
fn a_line_meets_faces_edges_and_vertices_in_order() {
    let folder = inputs();
    let met = |question: &str| {
        let (_, answer) = folder.json(&format!("query claims line {question} --format json"));
        let step = |step: &Value| {
            let along = if step["along"] == json!(true) { "along " } else { "" };
            let features: Vec<&str> =
                step["features"].as_array().unwrap().iter().map(|one| one.as_str().unwrap()).collect();
            format!("{along}{} {}", step["kind"].as_str().unwrap(), features.concat())
        };
        answer["met"].as_array().unwrap().iter().map(step).collect::<Vec<_>>()
    };
    let through = ["face ", "edge A", "face A", "edge ABC", "face BC", "edge BC", "face "];
    assert_eq!(met("-1 1 5 1"), through);
    assert_eq!(met("-1 1 3 1"), through[..5]);
    assert_eq!(met("1 1 3 1 --extent ray"), through[2..]);
    assert_eq!(met("1 1 3 1 --extent line"), through);
    assert_eq!(met("-1 0 2 0"), ["face ", "vertex A", "along edge A", "vertex ABC"]);
}

#[test]
fn pairs_and_findings_are_tables() {
    let folder = inputs();
    let rows = |question: &str| folder.ok(&format!("query owned {question} --format csv"));
    assert_eq!(
        rows("neighbours --all"),
        "number,id,name,other_number,other_id,other_name,length,shared,lines,overlap\n\
         0,7,Field,1,8,Field,10.0,1.0,1,2.25\n1,8,Field,2,9,Wood,10.0,10.0,1,0.0\n"
    );
    let coverage = rows("coverage");
    let begins = "rule,kind,features,area,width,length,x,y\nC1,overlap,7;8,2.25,";
    assert!(coverage.starts_with(begins) && coverage.lines().count() == 2, "{coverage}");
}
