//! `twinedge tile`, `twinedge sum` of tiles, and `twinedge audit --tiles`.

use crate::support::{complaint, data, json, scratch_folder, twinedge};
use serde_json::Value;

/// A layer of parcels with a gap, an overlap, a sliver, a duplicate and a polygon with a spike, each cut by lines between tiles.
const PARCELS: &str = r#"{"type": "FeatureCollection", "features": [
{"type": "Feature", "properties": {"name": "west"}, "geometry": {"type": "Polygon", "coordinates": [[[0,0],[4,0],[3,2],[4,4],[0,4],[0,0]]]}},
{"type": "Feature", "properties": {"name": "east"}, "geometry": {"type": "Polygon", "coordinates": [[[4,0],[8,0],[8,4],[4,4],[5,2],[4,0]]]}},
{"type": "Feature", "properties": {"name": "north"}, "geometry": {"type": "Polygon", "coordinates": [[[0,4],[4,4],[8,4],[8,8],[4,8],[0,8],[0,4]]]}},
{"type": "Feature", "properties": {"name": "twin"}, "geometry": {"type": "Polygon", "coordinates": [[[4,4],[8,4],[8,8],[4,8],[4,4]]]}},
{"type": "Feature", "properties": {"name": "strip"}, "geometry": {"type": "Polygon", "coordinates": [[[8,0],[8.0001,0],[8.0001,8],[8,8],[8,4],[8,0]]]}},
{"type": "Feature", "properties": {"name": "one"}, "geometry": {"type": "Polygon", "coordinates": [[[10,3],[12,3],[12,5],[10,5],[10,3]]]}},
{"type": "Feature", "properties": {"name": "same"}, "geometry": {"type": "Polygon", "coordinates": [[[10,3],[12,3],[12,5],[10,5],[10,3]]]}},
{"type": "Feature", "properties": {"name": "touching"}, "geometry": {"type": "Polygon", "coordinates": [[[13,3],[15,3],[14,4],[15,5],[13,5],[14,4],[13,3]]]}}
]}"#;

/// Two fields whose common border has a vertex only in the west, on the line between two tiles.
const UNMATCHED: &str = r#"{"type": "FeatureCollection", "features": [
{"type": "Feature", "properties": {"name": "west"}, "geometry": {"type": "Polygon", "coordinates": [[[0,0],[2,0],[2,2],[2,4],[0,4],[0,0]]]}},
{"type": "Feature", "properties": {"name": "east"}, "geometry": {"type": "Polygon", "coordinates": [[[2,0],[4,0],[4,4],[2,4],[2,0]]]}}
]}"#;

fn parcels(folder: &str) -> (std::path::PathBuf, String) {
    let folder = scratch_folder(folder);
    let file = folder.join("parcels.geojson");
    std::fs::write(&file, PARCELS).unwrap();
    (folder, file.to_str().unwrap().to_owned())
}

/// Removes the parts specific to tiles and the names of records, which have no numbers in tiles. Sorts findings, and rounds measures.
fn compared(mut value: Value) -> Value {
    let object = value.as_object_mut().unwrap();
    // Without shapes, no finding is known to follow from another.
    for key in ["elapsed_ms", "tiles", "headline", "causes", "consequences", "first"] {
        object.remove(key);
    }
    round(&mut value);
    if let Some(findings) = value.pointer_mut("/coverage/findings").and_then(Value::as_array_mut) {
        for finding in &mut *findings {
            let finding = finding.as_object_mut().unwrap();
            finding.remove("follows_from");
            finding.remove("follows_from_id");
        }
        findings.sort_by_key(ToString::to_string);
    }
    for violation in value["violations"].as_array_mut().unwrap() {
        let violation = violation.as_object_mut().unwrap();
        for key in ["message", "records", "follows_from", "follows_from_id"] {
            violation.remove(key);
        }
        let is_clash = violation["rule"] == "G4";
        if is_clash {
            violation.remove("fields");
            let at = violation["at"].as_array_mut().unwrap();
            at.sort_by_key(ToString::to_string);
        } else {
            // A component is named by any of its vertices.
            violation.remove("at");
            violation.remove("features");
            violation.remove("feature_numbers");
            violation["fields"].as_object_mut().unwrap().remove("vertex");
        }
    }
    value["violations"].as_array_mut().unwrap().sort_by_key(ToString::to_string);
    value
}

/// Rounds numbers to nine digits.
fn round(value: &mut Value) {
    match value {
        Value::Number(number) if number.is_f64() => {
            let rounded: f64 = format!("{:.9e}", number.as_f64().unwrap()).parse().unwrap();
            *value = rounded.into();
        }
        Value::Array(items) => items.iter_mut().for_each(round),
        Value::Object(members) => members.values_mut().for_each(round),
        _ => {}
    }
}

#[test]
fn an_audit_by_tiles_is_that_of_the_whole() {
    let (_, file) = parcels("tiles-audit");
    for arguments in
        [&[][..], &["--coverage"], &["--gap-width", "0.4", "--sliver", "0.1"], &["--explain", "--list", "2"]]
    {
        let whole = json(&[&["audit", &file, "--format", "json"], arguments].concat());
        for tiles in ["1", "2", "5"] {
            let (status, value) = json(&[&["audit", &file, "--format", "json", "--tiles", tiles], arguments].concat());
            assert_eq!(value["tiles"]["columns"].to_string(), tiles);
            assert_eq!((status, compared(value)), (whole.0, compared(whole.1.clone())), "{arguments:?} {tiles}");
        }
    }
    let (_, value) = json(&["audit", &file, "--format", "json"]);
    for count in ["overlaps", "gaps", "slivers", "duplicates", "ogc_invalid"] {
        assert!(value["coverage"][count].as_u64() > Some(0), "{count}: {}", value["coverage"]);
    }
}

#[test]
fn an_audit_within_memory_is_that_of_the_whole() {
    let (_, file) = parcels("tiles-memory");
    for (file, sizes) in [(file, ["1G", "32K"]), (data("world-110m-crossing.geojson"), ["64M", "1"])] {
        let whole = json(&["audit", &file, "--format", "json"]);
        let mut columns = Vec::new();
        for size in sizes {
            let (status, value) = json(&["audit", &file, "--format", "json", "--memory", size]);
            columns.push(value["tiles"]["columns"].as_u64().unwrap());
            assert_eq!((status, compared(value)), (whole.0, compared(whole.1.clone())), "{file} {size}");
        }
        assert!(columns[0] < columns[1], "{columns:?}");
    }
}

#[test]
fn the_built_in_world_by_tiles_is_that_of_the_whole() {
    let whole = json(&["audit", "--format", "json"]);
    let by_tiles = json(&["audit", "--format", "json", "--tiles", "5"]);
    assert_eq!((by_tiles.0, compared(by_tiles.1)), (whole.0, compared(whole.1)));
}

#[test]
fn the_sum_of_all_tiles_is_the_audit() {
    let (folder, file) = parcels("tiles-sum");
    let mut files = Vec::new();
    for (column, row) in [(1, 0), (0, 1), (2, 1), (0, 0), (2, 0), (1, 1)] {
        let name = folder.join(format!("{column}-{row}.summary")).to_str().unwrap().to_owned();
        let tile = format!("{column},{row}");
        let output = twinedge(&["tile", &file, "--grid", "3x2", "--tile", &tile, "-o", &name]);
        assert_eq!((output.status.code(), output.stderr), (Some(0), Vec::new()));
        files.push(name);
    }
    let files: Vec<&str> = files.iter().map(String::as_str).collect();
    let (status, sum) = json(&[&["sum", "--format", "json"], &files[..]].concat());
    let (_, whole) = json(&["audit", &file, "--format", "json"]);
    assert_eq!(status, Some(0));
    assert_eq!(sum["counts"], whole["counts"]);
    assert_eq!(sum["rules"], whole["rules"]);
    for key in ["overlaps", "gaps", "near_misses", "slivers", "duplicates", "ogc_invalid"] {
        assert_eq!(sum["coverage"][key], whole["coverage"][key], "{key}");
    }
    // In steps, and with the same bytes in any order.
    let part = |name: &str, files: &[&str]| {
        let path = folder.join(name).to_str().unwrap().to_owned();
        let output = twinedge(&[&["sum", "-o", &path], files].concat());
        assert_eq!((output.status.code(), output.stdout), (Some(0), Vec::new()));
        path
    };
    let (first, second) = (part("first", &files[..4]), part("second", &files[4..]));
    let again: Vec<&str> = files[..4].iter().rev().copied().collect();
    assert_eq!(std::fs::read(&first).unwrap(), std::fs::read(part("again", &again)).unwrap());
    let (_, of_parts) = json(&["sum", "--format", "json", &second, &first]);
    assert_eq!(compared(of_parts), compared(sum));
    let missing = twinedge(&[&["sum"], &files[1..]].concat());
    assert_eq!(missing.status.code(), Some(2));
    assert!(complaint(&missing).contains("1 tile is missing: (1,0)"));
    let missing = twinedge(&[&["sum"], &files[4..]].concat());
    assert!(complaint(&missing).contains("4 tiles are missing: (0,0), (1,0), (0,1) and (2,1)"));
    let other = twinedge(&["sum", &file]);
    assert!(other.status.code() == Some(2) && complaint(&other).contains("not a summary of a tile"));
    let empty = folder.join("empty").to_str().unwrap().to_owned();
    std::fs::write(&empty, "").unwrap();
    assert!(complaint(&twinedge(&["sum", &empty])).contains("not a summary of a tile: EOF"));
    let twice = twinedge(&["sum", files[0], files[0]]);
    let told = complaint(&twice);
    assert!(told.contains(&format!("{0}: tile 1,0 is in {0}, too", files[0])), "{told}");
}

#[test]
fn a_map_whose_borders_cross_by_tiles_is_that_of_the_whole() {
    let folder = scratch_folder("tiles-crossing");
    let unmatched = folder.join("unmatched.geojson").to_str().unwrap().to_owned();
    std::fs::write(&unmatched, UNMATCHED).unwrap();
    for file in [data("world-110m-crossing.geojson"), unmatched] {
        for arguments in [&[][..], &["--coverage", "--explain"]] {
            let (status, whole) = json(&[&["audit", &file, "--format", "json"], arguments].concat());
            assert_eq!(status, Some(1));
            for tiles in ["1", "3"] {
                let (by_tiles, value) =
                    json(&[&["audit", &file, "--format", "json", "--tiles", tiles], arguments].concat());
                assert_eq!(
                    (by_tiles, compared(value)),
                    (status, compared(whole.clone())),
                    "{file} {arguments:?} {tiles}"
                );
            }
        }
    }
}

#[test]
fn the_sum_of_tiles_whose_borders_cross_has_the_findings_of_the_whole() {
    let folder = scratch_folder("tiles-sum-crossing");
    let file = data("world-110m-crossing.geojson");
    let tile = |column: u32| {
        let name = folder.join(format!("{column}.summary")).to_str().unwrap().to_owned();
        let output = twinedge(&["tile", &file, "--grid", "2x1", "--tile", &format!("{column},0"), "-o", &name]);
        assert_eq!((output.status.code(), output.stderr), (Some(0), Vec::new()));
        name
    };
    let (status, sum) = json(&["sum", "--format", "json", &tile(0), &tile(1)]);
    let (_, whole) = json(&["audit", &file, "--format", "json"]);
    assert_eq!((status, &sum["rules"]), (Some(1), &whole["rules"]));
    for key in ["overlaps", "gaps", "near_misses", "slivers", "duplicates", "ogc_invalid", "mismatches", "not_checked"]
    {
        assert_eq!(sum["coverage"][key], whole["coverage"][key], "{key}");
    }
}

/// Regression: the sum did not know how to cut borders, because a summary did not record how short edges are.
#[test]
fn the_sum_of_tiles_says_as_the_audit_that_the_grid_for_cuts_is_too_wide() {
    let folder = scratch_folder("tiles-sum-far");
    let file = folder.join("far.wkt");
    let squares = "POLYGON((0 0,10 0,10 10,0 10,0 0))\nPOLYGON((5 5,15 5,15 15,5 15,5 5))\n";
    std::fs::write(&file, format!("{squares}POINT(1e17 0)\n")).unwrap();
    let file = file.to_str().unwrap();
    let tile = |column: u32| {
        let name = folder.join(format!("{column}.summary")).to_str().unwrap().to_owned();
        let tile = format!("{column},0");
        // The line between the tiles cuts both squares.
        let box_of = ["--grid", "2x1", "--box", "0,0,16,16"];
        let output = twinedge(&[&["tile", file, "--tile", &tile, "-o", &name], &box_of[..]].concat());
        assert_eq!((output.status.code(), output.stderr), (Some(0), Vec::new()));
        name
    };
    let (status, sum) = json(&["sum", "--format", "json", &tile(0), &tile(1)]);
    let (of_whole, whole) = json(&["audit", file, "--format", "json"]);
    assert_eq!((status, of_whole), (Some(1), Some(1)));
    assert!(whole["coverage"]["not_checked"].as_str().unwrap().contains("cells of at least 88.8178"));
    assert_eq!(sum["coverage"]["not_checked"], whole["coverage"]["not_checked"]);
}

#[test]
fn what_tiles_do_not_take_is_refused() {
    let (_, file) = parcels("tiles-refused");
    for (arguments, expected) in [
        (&["audit", "--tiles", "2", "--snap", "auto"][..], "--snap and --tiles do not go together"),
        (&["audit", "--tiles", "2", "--format", "html"], "the format html and --tiles do not go together"),
        (&["audit", "--tiles", "2", "--geodesic"], "--geodesic and --tiles do not go together"),
        (&["audit", "--memory", "2G", "--geodesic"], "--geodesic and --memory do not go together"),
        (&["tile", "--grid", "2x2", "--tile", "2,0", "-o", "x"], "the grid has no tile 2,0"),
        (&["tile", "--grid", "2x2", "--tile", "1,0", "-o", "x", "--snap", "auto"], "a tile takes edges as they are"),
        (&["sum", "--coverage", "-o", "x"], "'--coverage' cannot be used with '--output"),
        (&["tile", "--grid", "2x2", "--tile", "1,0", "-o", "x", "--coverage"], "unexpected argument '--coverage'"),
    ] {
        let output = twinedge(&[arguments, &[&file]].concat());
        assert_eq!(output.status.code(), Some(2));
        let text = String::from_utf8(output.stderr).unwrap();
        assert!(text.contains(expected), "{text}");
    }
}

/// Writes the summary of the only tile of a grid.
fn only_tile(file: &str, summary: &std::path::Path, more: &[&str]) -> String {
    let name = summary.to_str().unwrap().to_owned();
    let output = twinedge(&[&["tile", file, "--grid", "1x1", "--tile", "0,0", "-o", &name], more].concat());
    assert_eq!((output.status.code(), output.stderr), (Some(0), Vec::new()));
    name
}

#[test]
fn a_sum_with_findings_fails_if_they_are_to_count() {
    let (folder, file) = parcels("tiles-coverage");
    let summary = only_tile(&file, &folder.join("0-0.summary"), &[]);
    assert_eq!(twinedge(&["sum", &summary]).status.code(), Some(0));
    let (status, sum) = json(&["sum", "--coverage", "--format", "json", &summary]);
    let (of_whole, whole) = json(&["audit", "--coverage", "--format", "json", &file]);
    assert_eq!((status, of_whole), (Some(1), Some(1)));
    assert_eq!(sum["violation_count"], whole["violation_count"]);
    assert_eq!(sum["first"]["rule"], whole["first"]["rule"]);
}

#[test]
fn a_sum_does_not_overwrite_a_summary() {
    let (folder, file) = parcels("tiles-overwrite");
    let summary = only_tile(&file, &folder.join("0-0.summary"), &[]);
    let before = std::fs::read(&summary).unwrap();
    let by_another_path = folder.join("..").join("tiles-overwrite").join("0-0.summary");
    let output = twinedge(&["sum", &summary, "-o", by_another_path.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(2));
    assert!(complaint(&output).contains("this is the input, and is not overwritten"));
    assert!(std::fs::read(&summary).unwrap() == before);
}

#[test]
fn a_box_that_is_none_is_refused() {
    let (folder, file) = parcels("tiles-box");
    let summary = folder.join("x").to_str().unwrap().to_owned();
    for corners in ["nan,0,inf,3", "0,0,inf,3", "4,0,0,3", "0,3,4,3"] {
        let output = twinedge(&["tile", &file, "--grid", "1x1", "--tile", "0,0", "--box", corners, "-o", &summary]);
        let told = String::from_utf8(output.stderr).unwrap();
        assert!(output.status.code() == Some(2) && told.contains("the lower left corner"), "{corners}: {told}");
    }
}

#[test]
fn summaries_that_do_not_go_together_are_named() {
    let (folder, file) = parcels("tiles-apart");
    let first = only_tile(&file, &folder.join("first"), &[]);
    for (more, key) in [(["--sliver", "2"], "sliver_area is 2.0, but null"), (["--box", "0,0,9,9"], "is [")] {
        let second = only_tile(&file, &folder.join("second"), &more);
        let told = complaint(&twinedge(&["sum", &first, &second]));
        let in_words = [format!("{second}: "), key.to_owned(), format!("in {first}")];
        assert!(in_words.iter().all(|words| told.contains(words)), "{told}");
    }
}

#[test]
fn a_sum_does_not_take_longer_for_large_numbers_of_features() {
    let (folder, file) = parcels("tiles-numbers");
    let summary = only_tile(&file, &folder.join("0-0.summary"), &[]);
    let mut saved: Value = serde_json::from_slice(&std::fs::read(&summary).unwrap()).unwrap();
    let defects = &mut saved["summary"]["defects"];
    assert_eq!(defects[0][0], 7);
    defects[0][0] = 4_000_000_000_u32.into();
    std::fs::write(&summary, saved.to_string()).unwrap();
    let (status, sum) = json(&["sum", "--format", "json", &summary]);
    let findings = sum["coverage"]["findings"].as_array().unwrap();
    let invalid = findings.iter().find(|one| one["rule"] == "C6").unwrap();
    assert_eq!((status, &invalid["features"][0]["number"]), (Some(0), &4_000_000_000_u32.into()), "{invalid}");
}

#[test]
fn a_large_feature_is_not_given_to_many_tiles_for_nothing() {
    // An outline of 800 vertices around 256 squares: every grid has a tile with the whole outline.
    let corner = |i: u32| f64::from(i % 200) / 10.0 - 2.0;
    let outline: Vec<[f64; 2]> = (0..800)
        .map(|i| match i / 200 {
            0 => [corner(i), -2.0],
            1 => [18.0, corner(i)],
            2 => [16.0 - corner(i), 18.0],
            _ => [-2.0, 16.0 - corner(i)],
        })
        .chain([[-2.0, -2.0]])
        .collect();
    let squares = (0..256).map(|i| {
        let [x, y] = [i % 16, i / 16].map(f64::from);
        vec![[x, y], [x + 0.9, y], [x + 0.9, y + 0.9], [x, y + 0.9], [x, y]]
    });
    let polygon = |ring| serde_json::json!({"type": "Polygon", "coordinates": [ring]});
    let shapes: Vec<Value> = squares.chain([outline]).map(polygon).collect();
    let file = scratch_folder("tiles-outline").join("outline.geojson");
    let feature = |geometry| serde_json::json!({"type": "Feature", "properties": {}, "geometry": geometry});
    let features: Vec<Value> = shapes.into_iter().map(feature).collect();
    let text = serde_json::json!({"type": "FeatureCollection", "features": features}).to_string();
    std::fs::write(&file, text).unwrap();
    let (_, value) = json(&["audit", file.to_str().unwrap(), "--format", "json", "--memory", "1"]);
    assert_eq!(value["tiles"]["columns"], 4);
}

/// The units are the same as in the audit, which chooses them by the map's location and by the file.
#[test]
fn a_sum_has_the_units_of_the_audit() {
    let folder = scratch_folder("tiles-units");
    let of = |crs: Option<&str>, by: f64| {
        let ring = [[0.0, 0.0], [by, 0.0], [by, 1.0], [0.0, 1.0], [0.0, 0.0]];
        let feature = serde_json::json!({"type": "Feature", "properties": {},
            "geometry": {"type": "Polygon", "coordinates": [ring]}});
        let mut layer = serde_json::json!({"type": "FeatureCollection", "features": [feature]});
        if let Some(crs) = crs {
            layer["crs"] = serde_json::json!({"type": "name", "properties": {"name": crs}});
        }
        let file = folder.join(format!("{by}-{}.geojson", crs.is_some())).to_str().unwrap().to_owned();
        std::fs::write(&file, layer.to_string()).unwrap();
        file
    };
    let mut summaries = Vec::new();
    for (file, expected) in [
        (of(None, 1.0), "degrees"),
        (of(None, 1000.0), "units of the coordinates"),
        (of(Some("urn:ogc:def:crs:EPSG::2056"), 1.0), "metres"),
    ] {
        let (_, whole) = json(&["audit", &file, "--format", "json"]);
        let summary = only_tile(&file, &folder.join(format!("{}.summary", summaries.len())), &[]);
        let (_, sum) = json(&["sum", &summary, "--format", "json"]);
        assert_eq!((&whole["coverage"]["unit"], &sum["coverage"]["unit"]), (&expected.into(), &expected.into()));
        summaries.push(summary);
    }
    let told = complaint(&twinedge(&["sum", &summaries[0], &summaries[2]]));
    assert!(told.contains("crs is \"EPSG:2056\", but null"), "{told}");
}

#[test]
fn points_alone_are_refused_by_tiles_and_sums_as_by_the_audit() {
    let folder = scratch_folder("tiles-points");
    let mut features = Vec::new();
    for x in 0..3 {
        features.push(serde_json::json!({"type": "Feature", "properties": {}, "geometry": {"type": "Point", "coordinates": [x, 1]}}));
    }
    let text = folder.join("points.geojson").to_str().unwrap().to_owned();
    std::fs::write(&text, serde_json::json!({"type": "FeatureCollection", "features": features}).to_string()).unwrap();
    let mut files = vec![text.clone()];
    for name in ["points.fgb", "points.parquet"] {
        let file = folder.join(name).to_str().unwrap().to_owned();
        assert!(twinedge(&["convert", &text, "-o", &file]).status.success());
        files.push(file);
    }
    let summary = folder.join("summary").to_str().unwrap().to_owned();
    for file in &files {
        let tile = ["tile", file, "--grid", "1x1", "--tile", "0,0", "-o", &summary];
        let refused = |arguments: &[&str]| complaint(&twinedge(arguments)).split_once(": ").unwrap().1.to_owned();
        let said = refused(&["audit", file]);
        assert!(said.contains("this file has 3 features with 3 points and nothing else"), "{said}");
        assert_eq!(refused(&tile), said);
        assert!(twinedge(&[&tile[..], &["--allow-empty"]].concat()).status.success());
        let said = complaint(&twinedge(&["sum", &summary]));
        assert!(said.contains("these tiles have none; --allow-empty accepts it"), "{said}");
        let (status, sum) = json(&["sum", &summary, "--allow-empty", "--format", "json"]);
        let (of_whole, whole) = json(&["audit", file, "--allow-empty", "--format", "json"]);
        assert_eq!((status, &sum["counts"]), (of_whole, &whole["counts"]));
    }
}

#[test]
fn findings_of_tiles_are_a_layer_of_places() {
    let (_, file) = parcels("tiles-layer");
    let layer = |more: &[&str]| {
        let (_, layer) = json(&[&["audit", &file, "--coverage", "--format", "geojson"], more].concat());
        let features = layer["features"].as_array().unwrap().iter();
        let key = |one: &Value| ["rule", "message", "x", "y"].map(|key| one["properties"][key].to_string());
        let mut found: Vec<_> = features.clone().map(key).collect();
        found.sort();
        (found, features.map(|one| one["geometry"]["type"].as_str().unwrap().to_owned()).collect::<Vec<_>>())
    };
    let ((whole, shapes), (by_tiles, points)) = (layer(&[]), layer(&["--tiles", "2"]));
    assert!(whole.len() > 4 && shapes.contains(&"Polygon".to_owned()), "{shapes:?}");
    assert_eq!(by_tiles, whole);
    assert!(points.iter().all(|kind| kind.ends_with("Point")), "{points:?}");
}
