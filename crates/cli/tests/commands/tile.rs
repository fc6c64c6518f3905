//! `twinedge tile`, and `twinedge sum` of tiles.

use crate::shared::{FAULTY, has};
use crate::support::{Folder, crossing};
use serde_json::{Value, json};
use twinedge_coverage::tile::Portion;

fn parcels() -> Folder {
    Folder::new(&[("parcels.wkt", FAULTY)])
}

/// Writes the summaries of these tiles, named after the tiles.
pub(crate) fn tiles(folder: &Folder, file: &str, grid: &str, tiles: &[&str]) -> String {
    for tile in tiles {
        let ran = folder.run(&format!("tile {file} --grid {grid} --tile {tile} -o {tile}"));
        assert_eq!((ran.status, &*ran.err), (Some(0), ""));
    }
    tiles.join(" ")
}

/// Asserts that a sum of tiles counts what the audit of the whole does.
#[track_caller]
pub(crate) fn counts_as(sum: &Value, whole: &Value) {
    assert_eq!((&sum["rules"], &sum["verdict"]), (&whole["rules"], &whole["verdict"]));
    for count in
        ["overlaps", "gaps", "near_misses", "slivers", "duplicates", "ogc_invalid", "mismatches", "not_checked", "unit"]
    {
        assert_eq!(sum["coverage"][count], whole["coverage"][count], "{count}");
    }
}

/// The summary in a file, as JSON.
pub(crate) fn as_json(folder: &Folder, file: &str) -> Value {
    serde_json::to_value(Portion::from_bytes(&folder.read(file)).unwrap()).unwrap()
}

/// Writes a summary that was changed as JSON.
pub(crate) fn write_json(folder: &Folder, file: &str, json: Value) {
    folder.write(file, serde_json::from_value::<Portion>(json).unwrap().to_bytes());
}

#[test]
fn the_sum_of_all_tiles_is_the_audit() {
    let far = "POLYGON((0 0,10 0,10 10,0 10,0 0))\nPOLYGON((5 5,15 5,15 15,5 15,5 5))\nPOINT(1e17 0)\n";
    let folder = Folder::new(&[("parcels.wkt", FAULTY), ("far.wkt", far)]);
    for (file, grid, at) in [
        ("parcels.wkt", "3x2", &["1", "3", "5", "0", "2", "4"][..]),
        (&crossing(), "2x1", &["0", "1"]),
        // Regression: the sum did not know how to cut borders, because a summary did not record how short edges are. The line cuts both squares.
        ("far.wkt", "2x1 --box 0,0,16,16", &["0", "1"]),
        ("parcels.wkt", "1x1", &["0"]),
    ] {
        let files = tiles(&folder, file, grid, at);
        let (status, sum) = folder.json(&format!("sum --format json {files}"));
        let (of_whole, whole) = folder.json(&format!("audit {file} --format json"));
        counts_as(&sum, &whole);
        assert_eq!(status, of_whole);
        if !grid.contains("--box") {
            assert_eq!(sum["counts"], whole["counts"]);
        }
    }
    let (status, sum) = folder.json("sum 0 --coverage --format json");
    let (_, whole) = folder.json("audit parcels.wkt --coverage --format json");
    has(&sum, &json!({"violation_count": whole["violation_count"], "first": {"rule": whole["first"]["rule"]}}));
    assert_eq!(status, Some(1));
}

#[test]
fn sums_are_made_in_steps_and_name_what_is_missing() {
    let folder = parcels();
    tiles(&folder, "parcels.wkt", "3x2", &["1", "3", "5", "0", "2", "4"]);
    folder.write("empty", "");
    // With the same bytes in any order.
    folder.ok("sum --merge first 1 3 5 0");
    folder.ok("sum --merge again 0 5 3 1");
    assert!(folder.read("first") == folder.read("again"));
    assert_eq!(folder.ok("sum --merge second 2 4"), "");
    let [mut of_parts, mut sum] =
        ["second first", "0 3 1 4 2 5"].map(|files| folder.json(&format!("sum --format json {files}")).1);
    for one in [&mut of_parts, &mut sum] {
        one["elapsed_ms"] = Value::Null;
    }
    assert_eq!(of_parts, sum);
    let before = folder.read("first");
    std::fs::create_dir(folder.path("below")).unwrap();
    folder.transcript(
        "
sum 3 5 0 2 4 => 2 1 tile is missing: 1
sum 2 4 => 2 4 tiles are missing: 0, 1, 3 and 5
sum parcels.wkt => 2 these bytes are not a summary of tiles
sum empty => 2 these bytes are not a summary of tiles
sum 1 1 => 2 1: tile 1 is in 1, too
sum first --merge below/../first => 2 this is the input, and is not overwritten
sum first --coverage --merge x => 2 cannot be used with ++ --coverage
",
    );
    assert!(folder.read("first") == before);
}

#[test]
fn what_tiles_do_not_take_is_refused() {
    let folder = parcels();
    folder.write("degrees.wkt", "POLYGON((0 0,1 0,1 1,0 1,0 0))");
    let swiss = json!({"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::2056"}});
    let square = json!({"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]]]});
    let feature = json!({"type": "Feature", "properties": {}, "geometry": square});
    folder
        .write("metres.geojson", json!({"type": "FeatureCollection", "crs": swiss, "features": [feature]}).to_string());
    folder.transcript(
        "
tile parcels.wkt --grid 2x2 --tile 4 -o x => 2 the grid has no tile 4
tile parcels.wkt --grid 2x2 --tile 1 -o x --snap auto => 2 a tile takes edges as they are
tile parcels.wkt --grid 2x2 --tile 1 -o x --coverage => 2 unexpected argument '--coverage'
tile parcels.wkt --grid 1x1 --tile 0 -o x --box nan,0,inf,3 => 2 the lower left corner
tile parcels.wkt --grid 1x1 --tile 0 -o x --box 0,0,inf,3 => 2 the lower left corner
tile parcels.wkt --grid 1x1 --tile 0 -o x --box 4,0,0,3 => 2 the lower left corner
tile parcels.wkt --grid 1x1 --tile 0 -o x --box 0,3,4,3 => 2 the lower left corner
# Summaries that are not of one map.
tile parcels.wkt --grid 1x1 --tile 0 -o first => 0
tile parcels.wkt --grid 1x1 --tile 0 -o sliver --sliver 2 => 0
sum first sliver => 2 sliver: tile 0 is in first, too
tile parcels.wkt --grid 2x1 --tile 0 -o first => 0
tile parcels.wkt --grid 2x1 --tile 1 -o sliver --sliver 2 => 0
tile parcels.wkt --grid 2x1 --tile 1 -o box --box 0,0,9,9 => 0
tile parcels.wkt --grid 2x1 --tile 1 -o named --source 2026-11 => 0
sum first sliver => 2 first and sliver: these are not tiles of one map: sliver_area is none for the first and 2 for the second
sum first box => 2 these are not tiles of one map: the grid is 2x1 between (
sum first named => 2 first and named: these are not tiles of one map: sha256 is ++ for the first and none for the second
tile degrees.wkt --grid 2x1 --tile 0 -o degrees --source one => 0
tile metres.geojson --grid 2x1 --tile 1 -o metres --source one => 0
sum degrees metres => 2 crs is none for the first and EPSG:2056 for the second
",
    );
    // The units are those of the audit, which chooses them by the map's location and by the file.
    folder.write("large.wkt", "POLYGON((0 0,1000 0,1000 1,0 1,0 0))");
    for (file, unit) in
        [("degrees.wkt", "degrees"), ("metres.geojson", "metres"), ("large.wkt", "units of the coordinates")]
    {
        tiles(&folder, file, "1x1", &["0"]);
        for line in [&format!("audit {file}"), "sum 0"] {
            has(&folder.json(&format!("{line} --format json")).1, &json!({"coverage": {"unit": unit}}));
        }
    }
}

#[test]
fn a_sum_does_not_take_longer_for_large_numbers_of_features() {
    let folder = parcels();
    tiles(&folder, "parcels.wkt", "1x1", &["0"]);
    let mut saved = as_json(&folder, "0");
    let defects = &mut saved["summary"]["defects"];
    assert_eq!(defects[0][0], 7);
    defects[0][0] = 4_000_000_000_u32.into();
    write_json(&folder, "0", saved);
    let (status, sum) = folder.json("sum 0 --format json");
    let findings = sum["coverage"]["findings"].as_array().unwrap();
    let invalid = findings.iter().find(|one| one["rule"] == "C6").unwrap();
    assert_eq!((status, &invalid["features"][0]["number"]), (Some(0), &4_000_000_000_u32.into()), "{invalid}");
}

#[test]
fn points_alone_are_refused_by_tiles_and_sums_as_by_the_audit() {
    let folder = Folder::new(&[("points.wkt", "POINT(0 1)\nPOINT(1 1)\nPOINT(2 1)\n")]);
    for file in ["points.wkt", "points.fgb", "points.parquet"] {
        if file != "points.wkt" {
            folder.ok(&format!("convert points.wkt -o {file}"));
        }
        folder.transcript(&format!(
            "
audit {file} => 2 this file has 3 features with 3 points and nothing else; --allow-empty accepts it
tile {file} --grid 1x1 --tile 0 -o s => 2 this file has 3 features with 3 points and nothing else; --allow-empty accepts it
tile {file} --grid 1x1 --tile 0 -o s --allow-empty => 0
sum s => 2 these tiles have none; --allow-empty accepts it
"
        ));
        let [of_sum, of_whole] = ["sum s".to_owned(), format!("audit {file}")]
            .map(|line| folder.json(&format!("{line} --allow-empty --format json")));
        assert_eq!((of_sum.0, &of_sum.1["counts"]), (of_whole.0, &of_whole.1["counts"]));
    }
}

/// Regressions: tiles of two invalid files added up to a valid map, and some bytes of a summary could be changed unnoticed.
#[test]
fn tiles_of_two_files_and_damaged_summaries_are_refused() {
    let square = |x: i32| format!("POLYGON(({x} 0,{0} 0,{0} 1,{x} 1,{x} 0))", x + 1);
    let [left, right] = [[0, 0, 1], [0, 1, 1]].map(|at| at.map(square).join("\n"));
    let folder = Folder::new(&[("left.wkt", &left), ("right.wkt", &right)]);
    folder.transcript(
        "
audit left.wkt --coverage => 1
audit right.wkt --coverage => 1
tile left.wkt --grid 2x1 --tile 1 -o one => 0
tile right.wkt --grid 2x1 --tile 0 -o other => 0
sum one other --coverage => 2 one and other: these are not tiles of one map: sha256 is
",
    );
    let mut changed = folder.read("one");
    changed[40] ^= 1;
    folder.write("changed", changed);
    folder.transcript("sum changed => 2 changed: this is damaged: its checksum is wrong");
}

/// Regression: C1 … C5 and C7 were not checked where all contacts lie within one cell of the grid, as if no edges had to be cut.
#[test]
fn edges_that_meet_within_one_cell_are_judged_as_by_the_audit() {
    // The lower sides of both squares are less than a cell apart.
    let touch = "POLYGON((0 0,1 0,1 1,0 1,0 0))\nPOLYGON((1 2.3e-16,2 2.3e-16,2 1.0000000000000002,1 1.0000000000000002,1 2.3e-16))";
    let folder = Folder::new(&[("touch.wkt", touch)]);
    let files = tiles(&folder, "touch.wkt", "2x1", &["0", "1"]);
    let (status, sum) = folder.json(&format!("sum --format json {files}"));
    let (of_whole, whole) = folder.json("audit touch.wkt --format json");
    counts_as(&sum, &whole);
    assert_eq!((status, &sum["judged"]), (of_whole, &whole["judged"]));
    assert_eq!((whole["coverage"]["mismatches"].as_u64(), &whole["coverage"]["not_checked"]), (Some(1), &Value::Null));
}
