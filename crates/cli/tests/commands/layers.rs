//! `convert` and `clean`; outputs are written completely and never over the input.

use crate::support::{complaint, json as run_json, scratch_folder, twinedge, twinedge_reading};
use serde_json::{Value, json};
use std::fs;
use std::path::Path;

/// Three parcels: the second begins half a unit inside the first, and a narrow gap separates both from the third.
const PARCELS: &str = r#"{"type":"FeatureCollection",
"source":"survey",
"features":[
{"type":"Feature","id":"A-1","properties":{"owner":"Meier","since":"2020-01-31"},"geometry":{"type":"Polygon","coordinates":[[[0,0],[10,0],[10,10],[0,10],[0,0]]]}},
{"type":"Feature","id":"A-2","properties":{"owner":"Müller"},"geometry":{"type":"Polygon","coordinates":[[[9.5,0],[20,0],[20,10],[9.5,10],[9.5,0]]]}},
{"type":"Feature","id":"A-3","properties":{"owner":"Huber"},"geometry":{"type":"Polygon","coordinates":[[[0,10],[10,10.05],[20,10],[20,20],[0,20],[0,10]]]}}
]}
"#;

fn parcels(folder: &Path) -> String {
    let path = folder.join("parcels.geojson");
    fs::write(&path, PARCELS).unwrap();
    path.display().to_string()
}

fn in_folder(folder: &Path, name: &str) -> String {
    folder.join(name).display().to_string()
}

fn status(arguments: &[&str]) -> Option<i32> {
    twinedge(arguments).status.code()
}

#[test]
fn an_auditor_finds_and_mends_what_is_wrong_with_a_shapefile() {
    let folder = scratch_folder("auditor");
    let [shp, clean, again] = ["parcels.shp", "clean.shp", "again.shp"].map(|name| in_folder(&folder, name));
    assert_eq!(status(&["convert", &parcels(&folder), "-o", &shp, "--lossy"]), Some(0));

    let (code, found) = run_json(&["audit", "--coverage", "--snap", "auto", "--format", "json", &shp]);
    assert_eq!((code, &found["coverage"]["overlaps"], &found["coverage"]["gaps"]), (Some(1), &json!(1), &json!(1)));

    let (code, done) = run_json(&["clean", &shp, "-o", &clean, "--gap-width", "0.1", "--format", "json"]);
    assert_eq!((code, &done["clean"], &done["features"]), (Some(0), &json!(true), &json!(3)));
    let kinds: Vec<&Value> = done["changes"].as_array().unwrap().iter().map(|change| &change["kind"]).collect();
    assert_eq!(kinds, ["overlap", "gap"]);

    assert_eq!(status(&["audit", "--coverage", &clean]), Some(0));
    let text = String::from_utf8(twinedge(&["convert", &clean, "-o", "-", "--to", "geojson"]).stdout).unwrap();
    assert!(text.contains(r#""owner":"Müller","since":null"#) && text.contains(r#""since":"2020-01-31""#), "{text}");

    // A second run changes nothing.
    assert_eq!(status(&["clean", &clean, "-o", &again, "--gap-width", "0.1"]), Some(0));
    for extension in ["shp", "shx", "dbf", "cpg"] {
        let [one, two] = [&clean, &again].map(|path| fs::read(Path::new(path).with_extension(extension)).unwrap());
        assert!(one == two, "{extension}");
    }
}

#[test]
fn a_dry_run_writes_nothing_and_a_report_names_features() {
    let folder = scratch_folder("dry_run");
    let output = twinedge(&["clean", &parcels(&folder), "--dry-run"]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.contains("overlap of A-1, A-2 to A-2: area 5.0000, width 0.4762"), "{text}");
    assert_eq!(fs::read_dir(&folder).unwrap().count(), 1);
    assert!(complaint(&twinedge(&["clean", &parcels(&folder)])).contains("--dry-run"));
}

#[test]
fn a_layer_on_standard_output_stands_there_alone() {
    let output = twinedge_reading(&["clean", "-", "-o", "-", "--gap-width", "0.1"], PARCELS.as_bytes());
    let report = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.code() == Some(0) && report.contains("overlap of A-1, A-2 to A-2"), "{report}");
    let layer: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!((&layer["source"], &layer["features"][0]["id"]), (&json!("survey"), &json!("A-1")));
}

#[test]
fn what_a_format_cannot_hold_is_refused_and_said() {
    let folder = scratch_folder("lossy");
    let (input, output) = (parcels(&folder), in_folder(&folder, "parcels.shp"));
    let refused = complaint(&twinedge(&["convert", &input, "-o", &output]));
    assert!(refused.contains("the ids of 3 features") && refused.contains("foreign members (source)"), "{refused}");
    assert!(!Path::new(&output).exists());
    let warned = twinedge(&["convert", &input, "-o", &output, "--lossy"]);
    let text = String::from_utf8(warned.stderr).unwrap();
    assert!(text.lines().all(|line| line.starts_with("warning: Shapefile does not hold ")), "{text}");
    assert!(complaint(&twinedge(&["convert", &input, "-o", "parcels.xyz"])).contains("--to"));
}

#[test]
fn ids_are_kept_in_a_column_where_there_is_no_room_for_them() {
    let folder = scratch_folder("id_column");
    let input = in_folder(&folder, "lakes.geojson");
    fs::write(&input, PARCELS.replace("\"source\":\"survey\",\n", "")).unwrap();
    for name in ["lakes.shp", "lakes.gpkg", "lakes.fgb"] {
        let output = in_folder(&folder, name);
        let refused = complaint(&twinedge(&["convert", &input, "-o", &output]));
        assert!(refused.contains("the ids of 3 features") && refused.contains("--id-column"), "{refused}");
        assert_eq!(status(&["convert", &input, "-o", &output, "--id-column", "parcel"]), Some(0), "{name}");
        let (_, layer) = run_json(&["convert", &output, "-o", "-"]);
        assert_eq!(layer["features"][1]["properties"]["parcel"], json!("A-2"), "{name}");
        let taken = complaint(&twinedge(&["convert", &input, "-o", &output, "--id-column", "owner"]));
        assert!(taken.contains("there is a column owner already"), "{taken}");
    }
}

#[test]
fn cleaning_refuses_what_cannot_be_written_before_it_works() {
    let folder = scratch_folder("refused_early");
    let input = in_folder(&folder, "far.geojson");
    // Cleaning would find the coordinates out of range.
    fs::write(&input, PARCELS.replace("[20,20]", "[1e300,20]")).unwrap();
    assert!(complaint(&twinedge(&["clean", &input, "--dry-run"])).contains("1e300"));
    let refused = complaint(&twinedge(&["clean", &input, "-o", &in_folder(&folder, "far.shp")]));
    assert!(refused.contains("the ids of 3 features"), "{refused}");
}

#[test]
fn the_input_is_not_overwritten_by_any_path() {
    let folder = scratch_folder("overwritten");
    let input = parcels(&folder);
    let link = in_folder(&folder, "link.geojson");
    let roundabout = format!("{}/../overwritten/parcels.geojson", folder.display());
    let hard = in_folder(&folder, "hard.geojson");
    std::fs::hard_link(&input, &hard).unwrap();
    #[cfg(unix)]
    std::os::unix::fs::symlink(&input, &link).unwrap();
    #[cfg(not(unix))]
    std::fs::copy(&input, &link).unwrap();
    let all = if cfg!(unix) { vec![&input, &roundabout, &hard, &link] } else { vec![&input, &roundabout, &hard] };
    for output in all {
        for command in [&["clean"][..], &["convert"], &["draw"], &["decompose", "--snap", "auto"]] {
            let arguments = [command, &[&input, "-o", output]].concat();
            let said = twinedge(&arguments);
            assert_eq!(said.status.code(), Some(2), "{arguments:?}");
            let why =
                if command == ["draw"] { "this command writes .svg, and no .geojson" } else { "this is the input" };
            assert!(String::from_utf8_lossy(&said.stderr).contains(why), "{arguments:?}");
        }
    }
    assert_eq!(fs::read_to_string(&input).unwrap(), PARCELS);
    // Parts of a Shapefile are not overwritten either.
    let shp = in_folder(&folder, "a.shp");
    assert_eq!(status(&["convert", &input, "-o", &shp, "--lossy"]), Some(0));
    for part in ["a.shp", "a.dbf", "a.cpg"] {
        let output = in_folder(&folder, part);
        let said = complaint(&twinedge(&["audit", &shp, "--format", "json", "-o", &output]));
        assert!(said.contains("this is the input"), "{said}");
    }
}

#[test]
fn what_fails_leaves_what_was_there() {
    let folder = scratch_folder("whole");
    let output = in_folder(&folder, "out.shp");
    fs::write(&output, "before").unwrap();
    let mixed = b"POINT(1 2)\nLINESTRING(0 0,1 1)\n";
    let failed = twinedge_reading(&["convert", "-", "-o", &output], mixed);
    assert_eq!(failed.status.code(), Some(2));
    assert_eq!(fs::read_to_string(&output).unwrap(), "before");
    assert_eq!(fs::read_dir(&folder).unwrap().count(), 1);
}

#[test]
fn a_link_is_followed_and_a_device_written_to() {
    let folder = scratch_folder("links");
    let input = parcels(&folder);
    let target = in_folder(&folder, "target.wkt");
    fs::write(&target, "before").unwrap();
    #[cfg(unix)]
    {
        let link = in_folder(&folder, "link.wkt");
        std::os::unix::fs::symlink(&target, &link).unwrap();
        assert_eq!(status(&["convert", &input, "-o", &link, "--lossy"]), Some(0));
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert!(fs::read_to_string(&target).unwrap().starts_with("POLYGON((0 0,"));
        assert_eq!(status(&["draw", &input, "-o", "/dev/null"]), Some(1));
    }
}

#[test]
fn every_command_reads_every_format() {
    let folder = scratch_folder("formats");
    let input = parcels(&folder);
    for name in ["p.geojsonl", "p.gpkg", "p.shp", "p.wkb", "p.wkt"] {
        let path = in_folder(&folder, name);
        assert_eq!(status(&["convert", &input, "-o", &path, "--lossy"]), Some(0), "{name}");
        let (_, found) = run_json(&["audit", "--format", "json", &path]);
        assert_eq!(found["import"]["features"], 3, "{name}");
        assert_eq!(status(&["query", "--snap", "auto", &path, "faces"]), Some(0), "{name}");
    }
    let named = twinedge(&["audit", "--format", "json", "--name-from", "owner", &in_folder(&folder, "p.shp")]);
    assert!(String::from_utf8(named.stdout).unwrap().contains("Müller"));
}

/// Two adjacent unit squares with a common arc, and a town.
const TOPOLOGY: &str = r#"{"type": "Topology",
"arcs": [[[1, 0], [1, 1]], [[1, 1], [0, 1], [0, 0], [1, 0]], [[1, 0], [2, 0], [2, 1], [1, 1]]],
"objects": {
  "squares": {"type": "GeometryCollection", "geometries": [
    {"type": "Polygon", "id": "a", "properties": {"name": "left"}, "arcs": [[0, 1]]},
    {"type": "Polygon", "id": "b", "properties": {"name": "right"}, "arcs": [[2, -1]]}]},
  "town": {"type": "Point", "coordinates": [0.5, 0.5]}}}"#;

#[test]
fn every_command_reads_topojson() {
    let folder = scratch_folder("topojson");
    let [map, clean, drawn, other] =
        ["map.topojson", "clean.geojson", "map.svg", "other.topojson"].map(|name| in_folder(&folder, name));
    fs::write(&map, TOPOLOGY).unwrap();
    let squares = ["--layer", "squares"];
    let (code, found) = run_json(&["audit", &map, "--layer", "squares", "--format", "json"]);
    assert_eq!((code, &found["counts"]["vertices"], &found["counts"]["faces"]), (Some(0), &json!(6), &json!(3)));
    assert_eq!(status(&["clean", &map, squares[0], squares[1], "-o", &clean]), Some(0));
    assert_eq!(status(&["draw", &map, squares[0], squares[1], "-o", &drawn]), Some(0));
    assert!(fs::read_to_string(&drawn).unwrap().contains("left"));
    let text = twinedge(&["query", &map, squares[0], squares[1], "neighbours", "left"]).stdout;
    assert!(String::from_utf8_lossy(&text).contains("right"));
    let text = twinedge(&["convert", &map, squares[0], squares[1], "-o", "-"]).stdout;
    assert!(String::from_utf8_lossy(&text).contains(r#""id":"b","properties":{"name":"right"}"#));

    let said = complaint(&twinedge(&["audit", &map]));
    assert!(said.contains("(--layer): there are squares, town"), "{said}");
    let said = complaint(&twinedge(&["convert", &map, squares[0], squares[1], "-o", &other]));
    assert!(said.contains("TopoJSON is read here, but not written") && !said.contains("--lossy"), "{said}");
    assert!(!Path::new(&other).exists());
}

#[test]
fn arcs_are_judged_as_they_are_shared() {
    let arcs = |text: &str, format: &str| {
        let arguments = ["audit", "--arcs", "--layer", "squares", "--format", format, "-"];
        let output = twinedge_reading(&arguments, text.as_bytes());
        (output.status.code(), String::from_utf8(output.stdout).unwrap())
    };
    let (code, text) = arcs(TOPOLOGY, "text");
    assert!(code == Some(0) && text.contains("arcs of TopoJSON") && text.contains("A2  sides      ok"), "{text}");
    // Both are the left square.
    let wrong = TOPOLOGY.replace("[[2, -1]]", "[[0, 1]]");
    let (code, text) = arcs(&wrong, "json");
    let found: Value = serde_json::from_str(&text).unwrap();
    let message = "arc 0 has feature 0 of squares (left) and feature 1 of squares (right) on the same side";
    assert_eq!((code, &found["violations"][0]["message"]), (Some(1), &json!(message)));
    assert_eq!((&found["violations"][0]["rule"], &found["counts"]["edges"]), (&json!("A2"), &json!(2)));
    for format in ["geojson", "html"] {
        assert!(arcs(&wrong, format).1.contains(message), "{format}");
    }
    let said = |arguments: &[&str]| complaint(&twinedge_reading(arguments, TOPOLOGY.as_bytes()));
    assert!(said(&["audit", "--arcs", "-"]).contains("there are squares, town"));
    assert!(said(&["audit", "--arcs", "--snap", "auto", "-"]).contains("--snap is for maps"));
}

#[test]
fn members_of_geometries_survive_cleaning() {
    let text = PARCELS.replace(
        r#""geometry":{"type":"Polygon""#,
        r#""geometry":{"accuracy":0.1,"bbox":[0,0,99,99],"type":"Polygon""#,
    );
    let output = twinedge_reading(&["clean", "-", "-o", "-", "--gap-width", "0.1"], text.as_bytes());
    let cleaned: Value = serde_json::from_slice(&output.stdout).unwrap();
    for feature in cleaned["features"].as_array().unwrap() {
        assert_eq!(feature["geometry"]["accuracy"], json!(0.1), "{feature}");
    }
    // The box of a changed geometry is computed from the new geometry.
    assert_eq!(cleaned["features"][1]["geometry"]["bbox"][2], json!(20));
    let output = twinedge_reading(&["convert", "-", "-o", "-", "--to", "wkt"], text.as_bytes());
    assert!(complaint(&output).contains("foreign members (source, accuracy)"), "{}", complaint(&output));
}

/// Two parcels with a spindle-shaped gap between them, 10 wide in the middle.
const SPINDLE: &str =
    "POLYGON((0 -20,100 -20,100 0,90 0,50 -5,10 0,0 0,0 -20))\nPOLYGON((0 0,10 0,50 5,90 0,100 0,100 20,0 20,0 0))\n";

#[test]
fn a_gap_that_is_too_wide_is_left_whole_and_said_so() {
    let folder = scratch_folder("spindle");
    let input = in_folder(&folder, "spindle.wkt");
    fs::write(&input, SPINDLE).unwrap();
    let text = |arguments: &[&str]| String::from_utf8(twinedge(arguments).stdout).unwrap();
    let done = text(&["clean", &input, "--dry-run", "--gap-width", "1"]);
    assert!(done.contains("features with another geometry                 0\n"), "{done}");
    assert!(done.contains("left as it is: gap of feature 0, feature 1, area 400.0000, width "), "{done}");
    assert!(done.contains("clean: C1 to C7 hold; 1 gap wider than 1 is left"), "{done}");
    let (_, done) = run_json(&["clean", &input, "--dry-run", "--gap-width", "1", "--format", "json"]);
    assert_eq!((done["wider_gaps"].as_array().map(Vec::len), &done["wider_gaps"][0]["area"]), (Some(1), &json!(400.0)));

    let found = text(&["audit", &input, "--gap-width", "1"]);
    assert!(found.contains("C2  gap          ok  1 gap wider than 1.0000 is not listed\n"), "{found}");
    assert!(found.contains("C3  near miss    ok"), "{found}");
    let (_, found) = run_json(&["audit", &input, "--gap-width", "1", "--format", "json"]);
    assert_eq!((&found["coverage"]["wider_gaps"], &found["coverage"]["near_misses"]), (&json!(1), &json!(0)));

    // Without a width the gap is left and named, together with the width that fills it.
    let left = text(&["clean", &input, "--dry-run"]);
    let width = left.split("--gap-width ").nth(1).and_then(|rest| rest.split(' ').next()).expect("a width").to_owned();
    assert!(left.contains("left: gap of feature 0, feature 1, area 400.0000"), "{left}");
    assert_eq!(status(&["clean", &input, "--dry-run", "--gap-width", &width]), Some(0));
}

#[test]
fn cleaning_leaves_accepted_gaps_and_exits_with_success() {
    let folder = scratch_folder("accepted");
    let input = in_folder(&folder, "spindle.wkt");
    fs::write(&input, SPINDLE).unwrap();
    let done = |options: &[&str]| run_json(&[&["clean", &input, "--dry-run", "--format", "json"], options].concat());
    assert_eq!(done(&[]).0, Some(1));
    for width in [&[][..], &["--gap-width", "100"]] {
        let (status, report) = done(&[&["--accept-gap", "50,0"], width].concat());
        assert_eq!(
            (status, &report["changes"], &report["accepted_gaps"][0]["area"]),
            (Some(0), &json!([]), &json!(400.0))
        );
    }
    assert_eq!(done(&["--lake-width", "1"]).0, Some(0));
    assert_eq!(done(&["--lake-width", "10", "--gap-width", "1"]).0, Some(1));
    let text = String::from_utf8(twinedge(&["clean", &input, "--dry-run", "--accept-gap", "50,0"]).stdout).unwrap();
    assert!(text.contains("accepted: gap of feature 0, feature 1, area 400.0000, width "), "{text}");
}

#[test]
fn cleaning_names_features_by_a_column_and_says_why() {
    let folder = scratch_folder("reasons");
    let input = in_folder(&folder, "copied.geojson");
    let square = "[[[9.5,0],[20,0],[20,10],[9.5,10],[9.5,0]]]";
    let copy = format!(
        r#",{{"type":"Feature","properties":{{"owner":"Copy"}},"geometry":{{"type":"Polygon","coordinates":{square}}}}}
,{{"type":"Feature","properties":{{"owner":"Nowhere"}},"geometry":null}}
]}}"#
    );
    fs::write(&input, PARCELS.replace("\n]}", &copy).replace(r#""id":"#, r#""no":"#)).unwrap();
    let output = twinedge(&["clean", &input, "--dry-run", "--gap-width", "0.1", "--name-from", "owner"]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.contains("warning: Copy has no geometry any more: its place went to "), "{text}");
    assert!(text.contains("Copy: area 105.0000 → 0.0000, points 5 → 0; overlap with "), "{text}");
    assert!(text.contains("gap filled"), "{text}");
    let output = twinedge(&["clean", &input, "--dry-run", "--name-from", "nothing"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(complaint(&output).contains("no feature has a value in the column nothing; there are owner, since"));

    let text = String::from_utf8(twinedge(&["audit", &input]).stdout).unwrap();
    assert!(text.contains("the features have no names: --name-from owner takes them from a column\n"), "{text}");
    assert!(text.contains("warning: 1 feature without geometry: feature 4\n"), "{text}");
}

#[test]
fn rings_are_judged_by_the_rule_of_their_format() {
    let folder = scratch_folder("rings");
    let input = in_folder(&folder, "clockwise.geojson");
    let clockwise = r#"{"type":"Polygon","coordinates":[[[0,0],[0,1],[1,1],[1,0],[0,0]]]}"#;
    fs::write(&input, clockwise).unwrap();
    let wrong = |path: &str| {
        let (_, found) = run_json(&["audit", path, "--format", "json"]);
        (found["import"]["rings_wound_wrongly"].clone(), found["import"]["irregularities"].as_array().unwrap().len())
    };
    assert_eq!(wrong(&input), (json!(1), 1));
    for name in ["rings.shp", "rings.wkt", "rings.gpkg"] {
        let output = in_folder(&folder, name);
        assert_eq!(status(&["convert", &input, "-o", &output, "--lossy"]), Some(0));
        assert_eq!(wrong(&output), (json!(0), 0), "{name}");
    }
}

#[test]
fn an_extension_that_the_command_does_not_write_is_refused() {
    let folder = scratch_folder("extensions");
    let input = parcels(&folder);
    for command in [&["audit"][..], &["draw"], &["decompose"], &["voronoi"]] {
        for name in ["out.gpkg", "out.xyz"] {
            let output = in_folder(&folder, name);
            let said = complaint(&twinedge(&[command, &[&input, "-o", &output]].concat()));
            assert!(said.contains("this command writes ."), "{command:?} {said}");
            assert!(!Path::new(&output).exists());
        }
    }
    // The extension selects the format, and a file has no colours.
    let output = in_folder(&folder, "pieces.json");
    assert_eq!(status(&["decompose", "--snap", "auto", &input, "-o", &output]), Some(0));
    assert!(serde_json::from_str::<serde_json::Value>(&fs::read_to_string(&output).unwrap()).is_ok());
    let output = in_folder(&folder, "pieces.txt");
    assert_eq!(status(&["decompose", "--snap", "auto", &input, "-o", &output]), Some(0));
    let text = fs::read_to_string(&output).unwrap();
    assert!(text.contains("diagonals") && !text.contains('\u{1b}'), "{text:?}");
}

#[test]
fn a_layer_that_is_not_there_is_refused() {
    let folder = scratch_folder("no_such_layer");
    let input = parcels(&folder);
    for command in
        [&["audit"][..], &["draw"], &["clean", "-o", "-"], &["convert", "-o", "-", "--to", "wkt"], &["voronoi"]]
    {
        let said = complaint(&twinedge(&[command, &[&input, "--layer", "roads"]].concat()));
        assert!(said.contains("there is no layer \"roads\""), "{command:?} {said}");
    }
    // The only layer has the name of the file.
    assert_ne!(status(&["audit", &input, "--layer", "parcels"]), Some(2));
    let file = |name: &str, content: &[u8]| {
        fs::write(folder.join(name), content).unwrap();
        in_folder(&folder, name)
    };
    let town = file("town.copy", include_bytes!("../../../postgis/tests/postgis/data/town.copy"));
    let mesh = file("flat.off", b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    let table = file("empty.tables", b"V 0 H 0 B 0 F 1 - 0\n");
    let textbook = file("point.txt", b"v1 nil\nf1 nil nil\n");
    for command in [&["audit", "--postgis", &town][..], &["audit", &mesh], &["audit", &table], &["audit", &textbook]] {
        let said = complaint(&twinedge(&[command, &["--layer", "roads"]].concat()));
        assert!(said.contains("there is no layer \"roads\""), "{command:?} {said}");
    }
    let certificate = in_folder(&folder, "certificate");
    for option in ["--layer", "--snap"] {
        assert_eq!(status(&["certify", "--table", &table, option, "auto", "-o", &certificate]), Some(2), "{option}");
    }
}

#[test]
fn an_open_ring_is_invalid_and_convert_closes_it_and_says_so() {
    for open in ["POLYGON((0 0,1 0,1 1))", r#"{"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1]]]}"#] {
        let output = twinedge_reading(&["audit", "--coverage", "-"], open.as_bytes());
        let text = String::from_utf8(output.stdout).unwrap();
        assert_eq!(output.status.code(), Some(1), "{text}");
        assert!(text.contains("Ring is not closed: a gap of 1.4142"), "{text}");
        let output = twinedge_reading(&["convert", "-", "-o", "-", "--to", "wkt"], open.as_bytes());
        assert_eq!(String::from_utf8(output.stdout).unwrap(), "POLYGON((0 0,1 0,1 1,0 0))\n");
        assert!(String::from_utf8(output.stderr).unwrap().contains("an open ring, which is closed"), "{open}");
    }
}

/// A hole touches the middle of a side of its shell, and a part touches the side of another part: valid for the OGC, GEOS and C6.
#[test]
fn a_touch_that_the_ogc_allows_is_no_fault_and_clean_leaves_it() {
    let text = "POLYGON((0 0,10 0,10 10,0 10,0 0),(0 5,3 4,3 6,0 5))\n\
MULTIPOLYGON(((20 0,30 0,30 10,20 10,20 0)),((30 5,33 4,33 6,30 5)))\n";
    let folder = scratch_folder("touch");
    let [path, clean] = ["touch.wkt", "clean.wkt"].map(|name| in_folder(&folder, name));
    fs::write(&path, text).unwrap();
    for tiles in [&[][..], &["--tiles", "2"]] {
        let (code, found) = run_json(&[&["audit", "--format", "json", &path], tiles].concat());
        assert_eq!((code, &found["valid"]), (Some(0), &json!(true)), "{found}");
        // The holes are gaps, which this test ignores.
        let coverage = &found["coverage"];
        assert_eq!((&coverage["ogc_invalid"], &coverage["mismatches"]), (&json!(0), &json!(0)));
    }
    assert_eq!(status(&["clean", &path, "-o", &clean, "--gap-width", "0.1"]), Some(0));
    assert_eq!(fs::read_to_string(&clean).unwrap(), text);
}

/// Two parcels in the Swiss reference system, in millimetres: no coordinate is a double on a grid of powers of two.
#[test]
fn a_layer_in_millimetres_is_on_a_grid_of_millimetres() {
    let text = "POLYGON((2600000.123 1200000.001,2600010.457 1200000.333,2600010.999 1200010.777,2600000.123 1200000.001))\n\
POLYGON((2600010.457 1200000.333,2600020.813 1200001.219,2600010.999 1200010.777,2600010.457 1200000.333))\n";
    let folder = scratch_folder("millimetres");
    let [path, clean] = ["parcels.wkt", "clean.wkt"].map(|name| in_folder(&folder, name));
    fs::write(&path, text).unwrap();
    assert_eq!(status(&["clean", "--snap", "0.001", &path, "-o", &clean]), Some(0));
    assert_eq!(fs::read_to_string(&clean).unwrap(), text);
    let (_, found) = run_json(&["audit", "--snap", "0.001", "--format", "json", &path]);
    assert_eq!((&found["noding"]["cell"], &found["noding"]["largest_move"]), (&json!(0.001), &json!([0.0, 0.0])));
    let told = String::from_utf8(twinedge(&["audit", "--snap", "0.001", &path]).stdout).unwrap();
    assert!(told.contains("snapped to a grid of 0.001: 0 segments cut"), "{told}");
}

#[test]
fn a_folder_is_named_with_the_way_out() {
    let folder = scratch_folder("folders");
    let gdb = folder.join("cadastre.gdb");
    fs::create_dir_all(&gdb).unwrap();
    let told = |path: &Path| complaint(&twinedge(&["audit", &path.display().to_string()]));
    assert!(told(&gdb).contains("a file geodatabase of Esri") && told(&gdb).contains("ogr2ogr"), "{}", told(&gdb));
    assert!(told(&folder).contains("this is a folder"), "{}", told(&folder));
}
