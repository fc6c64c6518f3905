//! `clean`: the receiver of gaps, the chosen width, and patches that undo it.

use crate::support::{complaint, json as run_json, scratch_folder, twinedge, twinedge_reading};
use serde_json::{Value, json};
use std::fs;
use std::path::Path;

/// Four parcels around a crack of 0.02 by 10, and a fifth far away, with unusual numbers and spaces. The fourth parcel reaches into the first.
const PARCELS: &str = r#"{"type": "FeatureCollection", "features": [
 {"type": "Feature", "id": "A-1", "properties": {"use": "field", "lot": 1.0}, "geometry": {"type":"Polygon", "coordinates": [[[0,0.0],[10,0],[10,10],[0,10],[0,0.0]]]}},
 {"type": "Feature", "id": "A-2", "properties": {"use": "road"}, "geometry": {"type":"Polygon", "coordinates": [[[10.02,0],[20,0],[20,10],[10.02,10],[10.02,0]]]}},
 {"type": "Feature", "id": "A-3", "properties": {"use": "field"}, "geometry": {"type":"Polygon", "coordinates": [[[0,10],[10,10],[10.02,10],[20,10],[20,20],[0,20],[0,10]]]}},
 {"type": "Feature", "id": "A-4", "properties": {"use": "field"}, "geometry": {"type":"Polygon", "coordinates": [[[0,0],[0,-9],[20,-9],[20,0],[10.02,0],[10,0],[5,1],[0,0]]]}},
 {"type": "Feature", "id": "A-5", "properties": {"use": "wood", "note": "caf\u00e9"}, "geometry": {"type":"Polygon", "coordinates": [[[50,0],[60,0.000],[6e1,10],[50,10],[50,0]]]}}
]}"#;

fn in_folder(folder: &Path, name: &str) -> String {
    folder.join(name).display().to_string()
}

fn parcels(folder: &Path) -> String {
    let path = in_folder(folder, "parcels.geojson");
    fs::write(&path, PARCELS).unwrap();
    path
}

fn status(arguments: &[&str]) -> Option<i32> {
    twinedge(arguments).status.code()
}

#[test]
fn a_patch_says_what_changed_and_gives_the_bytes_of_the_input_back() {
    let folder = scratch_folder("patch_of_text");
    let input = parcels(&folder);
    let [clean, patch, back] =
        ["clean.geojson", "clean.patch.json", "back.geojson"].map(|name| in_folder(&folder, name));
    let made = ["clean", &input, "-o", &clean, "--gap-width", "auto", "--gaps-to", "use=unknown", "--patch", &patch];
    let output = twinedge(&made);
    let report = String::from_utf8(output.stdout).unwrap();
    assert!(output.status.code() == Some(0), "{report}");
    assert!(report.contains("up to the width 0.02, chosen: 1 gap, and none from there to "), "{report}");
    assert!(report.contains("feature 5: area 0.0000 → 0.2000, points 0 → 5; gap filled; made for gaps\n"), "{report}");
    assert!(report.contains(&format!("what takes it back is in {patch}\n")), "{report}");

    // Valid features are equal byte by byte.
    let text = fs::read_to_string(&clean).unwrap();
    for line in PARCELS.lines().filter(|line| ["A-2", "A-3", "A-4", "A-5"].iter().any(|id| line.contains(id))) {
        assert!(text.contains(line.trim_end_matches(',')), "{line}");
    }
    let document: Value = serde_json::from_slice(&fs::read(&patch).unwrap()).unwrap();
    let changes = document["changes"]["text"].as_array().unwrap();
    let of: Vec<[&Value; 2]> = changes.iter().map(|change| [&change["feature"], &change["id"]]).collect();
    assert_eq!(of, [[&json!(0), &json!("A-1")], [&json!(5), &Value::Null]]);
    for change in changes {
        let at = usize::try_from(change["at"].as_u64().unwrap()).unwrap();
        assert!(text[at..].starts_with(change["after"].as_str().unwrap()));
        assert!(PARCELS.contains(change["before"].as_str().unwrap()));
    }

    assert_eq!(status(&["clean", "--undo", &patch, &clean, "-o", &back]), Some(0));
    assert_eq!(fs::read_to_string(&back).unwrap(), PARCELS);
    let output = twinedge_reading(&["clean", "--undo", &patch, "-", "-o", "-"], text.as_bytes());
    assert_eq!(String::from_utf8(output.stdout).unwrap(), PARCELS);

    // Another file or another patch is refused.
    fs::write(&clean, text.replace("A-5", "A-6")).unwrap();
    fs::remove_file(&back).unwrap();
    let refused = complaint(&twinedge(&["clean", "--undo", &patch, &clean, "-o", &back]));
    assert!(refused.contains("the patch belongs to a file of ") && !Path::new(&back).exists(), "{refused}");
    fs::write(&clean, &text).unwrap();
    let other = fs::read_to_string(&patch).unwrap().replace("[[0,0.0]", "[[0,0.5]").replace("[[[0,0.0]", "[[[0,0.5]");
    fs::write(&patch, other).unwrap();
    let refused = complaint(&twinedge(&["clean", "--undo", &patch, &clean, "-o", &back]));
    assert!(refused.contains("does not lead back") && !Path::new(&back).exists(), "{refused}");
}

#[test]
fn a_patch_of_other_formats_gives_the_geometries_back() {
    let folder = scratch_folder("patch_of_geometries");
    let shp = in_folder(&folder, "parcels.shp");
    assert_eq!(status(&["convert", &parcels(&folder), "-o", &shp, "--lossy"]), Some(0));
    let [gpkg, patch, back] = ["clean.gpkg", "patch.json", "back.shp"].map(|name| in_folder(&folder, name));
    let made = ["clean", &shp, "-o", &gpkg, "--gap-width", "0.1", "--gaps-to", "use=unknown", "--patch", &patch];
    assert_eq!(status(&made), Some(0));
    let document: Value = serde_json::from_slice(&fs::read(&patch).unwrap()).unwrap();
    let changes = document["changes"]["geometries"].as_array().unwrap();
    assert_eq!(changes[1]["made"], json!(true));
    assert!(changes[0]["before"].as_str().unwrap().starts_with("POLYGON"), "{document}");
    assert_eq!(status(&["clean", "--undo", &patch, &gpkg, "-o", &back, "--lossy"]), Some(0));
    for extension in ["shp", "dbf"] {
        let [one, two] = [&shp, &back].map(|path| fs::read(Path::new(path).with_extension(extension)).unwrap());
        assert!(one == two, "{extension}");
    }
    let refused = complaint(&twinedge(&["clean", "--undo", &patch, &shp, "-o", &back]));
    assert!(refused.contains("the patch belongs to a file of "), "{refused}");
}

#[test]
fn where_nothing_is_wrong_the_output_is_the_input() {
    let right = format!(r#"{{"type":"FeatureCollection" ,"features":[{}]}}"#, PARCELS.lines().nth(5).unwrap());
    let output = twinedge_reading(&["clean", "-", "-o", "-"], right.as_bytes());
    assert_eq!((String::from_utf8(output.stdout).unwrap(), output.status.code()), (right, Some(0)));
}

/// An object that is a single feature has no room for a second one.
#[test]
fn a_text_that_has_no_room_is_written_anew_and_comes_back() {
    let folder = scratch_folder("patch_of_all");
    let [input, clean, patch, back] =
        ["one.geojson", "clean.geojson", "patch.json", "back.geojson"].map(|name| in_folder(&folder, name));
    let ring = "[[0,0],[9,0],[9,9],[0,9],[0,0]],[[2,2.0],[2,7],[2.01,7],[2.01,2],[2,2]]";
    let one = format!(
        r#"{{"type":"Feature","properties":{{"use":"field"}},"geometry":{{"type":"Polygon","coordinates":[{ring}]}}}}"#
    );
    fs::write(&input, &one).unwrap();
    assert_eq!(status(&["clean", &input, "-o", &clean, "--gaps-to", "use=none", "--patch", &patch]), Some(1));
    let (_, layer) = run_json(&["convert", &clean, "-o", "-"]);
    assert_eq!(layer["features"][1]["properties"], json!({"use": "none"}));
    assert_eq!(status(&["clean", "--undo", &patch, &clean, "-o", &back]), Some(0));
    assert_eq!(fs::read_to_string(&back).unwrap(), one);
}

#[test]
fn options_that_do_not_go_together_are_refused() {
    let folder = scratch_folder("clean_misuse");
    let input = parcels(&folder);
    let clean = in_folder(&folder, "clean.geojson");
    for (arguments, expected) in [
        (&["--gaps-to", "sort=road", "--dry-run"][..], "--gaps-to: there is no column sort"),
        (&["--gaps-to", "lot=x", "--dry-run"], "no feature has \"x\" as its lot"),
        (&["--gaps-to", "road", "--dry-run"], "not of the form COLUMN=VALUE"),
        (&["--gap-width", "wide", "--dry-run"], "neither `auto` nor a positive number"),
        (&["--patch", "p.json", "--dry-run"], "cannot be used with"),
        (&["--undo", "p.json", "-o", "x.geojson", "--snap", "auto"], "cannot be used with"),
        (&["-o", &clean, "--patch", &clean], "this is another file of the same command"),
        (&["-o", &clean, "--patch", &input], "this is another file of the same command"),
        (&["--undo", &input, "-o", &clean], "unknown field"),
    ] {
        let output = twinedge(&[&["clean", &input], arguments].concat());
        let message = String::from_utf8(output.stderr).unwrap();
        assert!(output.status.code() == Some(2) && message.contains(expected), "{arguments:?}: {message}");
    }
    assert_eq!(fs::read_to_string(&input).unwrap(), PARCELS);
}
