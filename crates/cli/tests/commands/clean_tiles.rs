//! `clean --tiles` and `clean --memory`: the same output and report as without tiles, the remaining findings, and refused options.

use crate::support::{complaint, json as run_json, scratch_folder, twinedge};
use serde_json::{Value, json};
use std::fs;
use std::path::Path;

/// Rows of squares of 10, in a collection with a box. One square reaches half a unit into its right neighbour, far from a slit between two others.
fn squares(folder: &Path) -> (String, String) {
    let square = |i: usize| {
        let (x, y) = ((i % 8) as f64 * 10.0, (i / 8) as f64 * 10.0);
        let right = match i {
            9 => x + 10.5,
            52 => x + 9.9,
            _ => x + 10.0,
        };
        let ring = json!([[[x, y], [right, y], [right, y + 10.0], [x, y + 10.0], [x, y]]]);
        json!({"type": "Feature", "id": i, "properties": {"lot": format!("L{i}")}, "geometry": {"type": "Polygon", "coordinates": ring}})
    };
    let all: Vec<String> = (0..64).map(|i| square(i).to_string()).collect();
    let text = format!(
        "{{\"type\": \"FeatureCollection\", \"bbox\": [0, 0, 80, 80],\n\"features\": [\n{}\n]}}\n",
        all.join(",\n")
    );
    let path = folder.join("squares.geojson").display().to_string();
    fs::write(&path, &text).unwrap();
    (path, text)
}

#[test]
fn the_program_cleans_by_tiles_in_memory_and_on_disk_as_it_does_the_whole() {
    let folder = scratch_folder("clean_tiles");
    let (path, _) = squares(&folder);
    let run = |arguments: &[&str]| {
        let out = folder.join("out.geojson").display().to_string();
        let all =
            [&["clean", &path, "-o", &out, "--format", "json", "--sliver", "1.5", "--name-from", "lot"], arguments]
                .concat();
        let (status, report) = run_json(&all);
        (status, report, fs::read_to_string(&out).unwrap())
    };
    let (status, whole, text) = run(&[]);
    assert_eq!((status, &whole["changes"].as_array().unwrap().len()), (Some(0), &2));
    let ways = [(["--tiles", "1"], 1), (["--tiles", "3"], 3), (["--memory", "1G"], 1), (["--memory", "300K"], 2)];
    for (way, columns) in ways {
        let (status, mut report, by_tiles) = run(&way);
        assert_eq!((status, by_tiles == text), (Some(0), true), "{way:?}");
        let members = report.as_object_mut().unwrap();
        let tiles = members.remove("tiles").unwrap();
        assert_eq!((&tiles["neighbourhoods"], &tiles["not_cleaned"]), (&json!(2), &json!([])), "{way:?}");
        assert_eq!(tiles["columns"], json!(columns), "{way:?}");
        let mut whole = whole.clone();
        for one in [members, whole.as_object_mut().unwrap()] {
            drop(one.remove("elapsed_ms"));
            one["added_vertices"].as_array_mut().unwrap().sort_by_key(ToString::to_string);
            for change in one["changes"].as_array_mut().unwrap() {
                let rounded = ["area", "width"].map(|name| (change[name].as_f64().unwrap() * 1e9).round());
                change["area"] = json!(rounded);
                change["width"] = Value::Null;
            }
        }
        assert_eq!(report, whole, "{way:?}");
    }
}

#[test]
fn a_neighbourhood_that_does_not_fit_stays_as_it_is_and_is_said() {
    let folder = scratch_folder("clean_tiles_left");
    let (path, text) = squares(&folder);
    let out = folder.join("out.geojson").display().to_string();
    let made = ["clean", &path, "-o", &out, "--memory", "1K", "--sliver", "1.5", "--format", "json"];
    let (status, report) = run_json(&made);
    assert_eq!((status, fs::read_to_string(&out).unwrap() == text), (Some(1), true));
    let left: Vec<(&Value, &Value)> = report["tiles"]["not_cleaned"]
        .as_array()
        .unwrap()
        .iter()
        .map(|one| (&one["features"][0]["number"], &one["vertices"]))
        .collect();
    // The squares that meet the box around the faulty ones: 16 for each fault.
    assert_eq!(left, [(&json!(1), &json!(80)), (&json!(44), &json!(80))]);
    let findings = report["left"]["findings"].as_array().unwrap();
    let rules: Vec<&Value> = findings.iter().map(|one| &one["rule"]).collect();
    assert_eq!(rules, [vec!["C1", "C2"], vec!["C7"; 6]].concat());
    assert_eq!(report["clean"], json!(false));
    let text = String::from_utf8(twinedge(&made[..made.len() - 2]).stdout).unwrap();
    assert!(
        text.contains("not cleaned: 6 features between (10, 0) and (30, 30): the neighbourhood has 80 vertices\n"),
        "{text}"
    );
}

#[test]
fn what_tiles_cannot_do_is_refused_before_anything_is_written() {
    let folder = scratch_folder("clean_tiles_refused");
    let (path, _) = squares(&folder);
    let [out, wkt] = ["out.geojson", "out.wkt"].map(|name| folder.join(name).display().to_string());
    assert_eq!(twinedge(&["convert", &path, "-o", &wkt, "--lossy"]).status.code(), Some(0));
    let refused = |arguments: &[&str]| {
        let output = twinedge(&[&["clean", "--tiles", "2"], arguments].concat());
        assert_eq!((output.status.code(), Path::new(&out).exists()), (Some(2), false), "{arguments:?}");
        complaint(&output)
    };
    assert!(refused(&[&wkt, "-o", &out]).contains("only files of GeoJSON and newline-delimited GeoJSON"));
    assert!(refused(&["-", "-o", &out]).contains("and not standard input"));
    assert!(refused(&[&path, "-o", &out, "--to", "geojsonl"]).contains("in the format of the input, which is GeoJSON"));
    assert!(refused(&[&path, "-o", &out, "--gap-width", "auto"]).contains("looks at all gaps at once"));
    assert!(refused(&[&path, "-o", &path]).contains("is not overwritten"));
    assert!(
        refused(&[&path, "-o", &out, "--name-from", "owner"])
            .contains("no feature has a value in the column owner; there are lot")
    );
    let points = folder.join("points.geojson");
    fs::write(&points, r#"{"type":"Point","coordinates":[1,2]}"#).unwrap();
    assert!(refused(&[&points.display().to_string(), "-o", &out]).contains("there is no polygon to clean"));
}
