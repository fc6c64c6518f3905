//! `twinedge audit` of mesh files.

use crate::support::{complaint, json, twinedge, twinedge_reading};
use std::fs;

/// The faces of a cube, counted from 1, outward.
const CUBE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n\
    f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

/// Writes a file in a folder of this test. Returns its path.
fn file(name: &str, content: &str) -> String {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR"));
    let path = folder.join(name);
    fs::write(&path, content).unwrap();
    path.display().to_string()
}

#[test]
fn a_cube_is_a_closed_mesh_of_genus_0() {
    let path = file("cube.obj", CUBE);
    let (status, found) = json(&["audit", &path, "--closed", "--genus", "0", "--sides", "4", "--format", "json"]);
    assert_eq!(status, Some(0));
    assert_eq!(found["valid"], true);
    let counts = &found["counts"];
    for (name, count) in [("vertices", 8), ("edges", 12), ("faces", 6), ("borders", 0), ("euler_characteristic", 2)] {
        assert_eq!(counts[name], count, "{name}");
    }
    assert_eq!(counts["genus"], 0);
    assert!(found["rules"].as_array().unwrap().iter().all(|rule| rule["violations"] == 0));
}

#[test]
fn what_is_expected_and_not_found_is_named() {
    let path = file("open.obj", CUBE.strip_suffix("f 4 1 5 8\n").unwrap());
    let (status, found) = json(&["audit", &path, "--closed", "--triangles", "--format", "json"]);
    assert_eq!(status, Some(1));
    assert_eq!(found["counts"]["borders"], 1);
    let broken = found["rules"].as_array().unwrap().iter().filter(|rule| rule["violations"] != 0);
    let broken: Vec<_> =
        broken.map(|rule| (rule["id"].as_str().unwrap(), rule["violations"].as_u64().unwrap())).collect();
    assert_eq!(broken, [("M3", 5), ("M4", 4)]);
    let first = &found["violations"][0];
    assert_eq!((&first["rule"], &first["message"]), (&"M3".into(), &"face 1 has 4 sides, where 3 are expected".into()));
    // Every option selects the rule of its name.
    let options = ["--borders", "2", "--genus", "1", "--components", "2", "--sides", "5", "--no-unused-vertices"];
    let arguments = [&["audit", path.as_str(), "--format", "json", "--explain"][..], &options].concat();
    let (_, found) = json(&arguments);
    let ids = |found: &serde_json::Value| -> Vec<String> {
        let violations = found["violations"].as_array().unwrap().iter();
        let mut ids: Vec<_> = violations.map(|violation| violation["rule"].as_str().unwrap().to_owned()).collect();
        ids.dedup();
        ids
    };
    assert_eq!(ids(&found), ["M3", "M5", "M6", "M7"]);
    assert!(found["violations"].as_array().unwrap().iter().all(|violation| violation["cause"].is_string()));
    assert_eq!(found["rules"].as_array().unwrap().len(), 14 + 5);
}

#[test]
fn a_flipped_face_is_named_in_text() {
    let path = file("flipped.obj", &CUBE.replace("f 5 6 7 8", "f 8 7 6 5"));
    let output = twinedge(&["audit", &path]);
    assert_eq!(output.status.code(), Some(1));
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.contains("flipped"), "{text}");
    assert!(text.contains("not valid"), "{text}");
}

#[test]
fn a_mesh_on_standard_input_is_told_by_its_content() {
    let off = "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
    let output = twinedge_reading(&["audit", "-", "--closed", "--triangles"], off.as_bytes());
    let text = String::from_utf8(output.stdout).unwrap();
    assert_eq!(output.status.code(), Some(0), "{text}");
    assert!(text.contains("OFF, 4 points, 4 faces"), "{text}");
}

#[test]
fn a_malformed_mesh_is_an_error_with_its_line() {
    let path = file("short.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n");
    let words = complaint(&twinedge(&["audit", &path]));
    assert!(words.contains("line 6"), "{words}");
}

#[test]
fn expectations_of_meshes_are_refused_for_maps() {
    let words = complaint(&twinedge(&["audit", "--closed"]));
    assert!(words.contains("no mesh file"), "{words}");
}

/// A cube with one flipped face.
fn flipped(name: &str) -> String {
    file(name, &CUBE.replace("f 5 6 7 8", "f 8 7 6 5"))
}

#[test]
fn explanations_are_given_of_meshes() {
    let path = flipped("explained.obj");
    let text = String::from_utf8(twinedge(&["audit", "--explain", &path]).stdout).unwrap();
    // Four edges, one explanation.
    assert_eq!(text.matches("flipped_faces: usual cause: ").count(), 1, "{text}");
    let (_, found) = json(&["audit", "--explain", "--format", "json", &path]);
    for finding in found["findings"].as_array().unwrap() {
        assert!(finding["cause"].is_string() && finding["remedy"].is_string(), "{finding}");
    }
    assert_eq!(found["finding_count"], 4);
    let (_, found) = json(&["audit", "--format", "json", &path]);
    assert!(found["findings"][0].get("cause").is_none(), "{found}");
}

#[test]
fn messages_about_obj_count_from_1_as_the_file_does() {
    let path = flipped("numbers.obj");
    let text = String::from_utf8(twinedge(&["audit", "--triangles", &path]).stdout).unwrap();
    for told in [
        "vertices, faces and corners (half-edges) are counted from 1, as the file counts points",
        // The second line of faces is now 8 7 6 5, the third 1 2 6 5.
        "flipped_faces faces 2 and 3 both run from vertex 6 to vertex 5: one of them is flipped",
        "M3 face 1 has 4 sides, where 3 are expected",
    ] {
        assert!(text.lines().any(|line| line == told), "{text}");
    }
    // The numbers in the JSON count from 0, unlike the messages.
    let (_, found) = json(&["audit", "--format", "json", &path]);
    let first = &found["findings"][0];
    assert_eq!((&found["messages_count_from"], &first["faces"][0]), (&1.into(), &1.into()));
    assert!(first["message"].as_str().unwrap().starts_with("faces 2 and "), "{first}");
    let off = twinedge_reading(&["audit", "-"], b"OFF 4 1 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n");
    let text = String::from_utf8(off.stdout).unwrap();
    assert!(text.contains("(half-edges) are counted from 0\n") && text.contains("no face uses vertex 3"), "{text}");
    let words = complaint(&twinedge(&["audit", &file("zero.obj", &CUBE.replace("f 5 6 7 8", "f 5 6 7 0"))]));
    assert!(words.contains("a face lists point 0, but OBJ counts points from 1"), "{words}");
}

#[test]
fn a_mesh_without_faces_is_not_valid() {
    let output = twinedge(&["audit", "--closed", &file("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n")]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert_eq!(output.status.code(), Some(1), "{text}");
    assert!(text.contains("no_faces there are no faces, so there is no surface"), "{text}");
}

#[test]
fn rules_of_the_plane_are_not_named_to_who_asks_about_a_mesh() {
    for content in [CUBE.to_owned(), CUBE.replace("f 5 6 7 8", "f 8 7 6 5")] {
        let text = String::from_utf8(twinedge(&["audit", &file("surface.obj", &content)]).stdout).unwrap();
        for rule in ["B2  isolated", "T1  outside", "T2  nesting", "T4  bounds"] {
            assert!(!text.contains(rule), "{text}");
        }
        assert!(text.contains("T3  Euler"), "{text}");
    }
}

#[test]
fn a_mesh_under_another_name_is_told_by_its_content() {
    let output = twinedge(&["audit", &file("cube.mesh", CUBE), "--closed"]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert_eq!(output.status.code(), Some(0), "{text}");
    assert!(text.contains("OBJ, 8 points, 6 faces"), "{text}");
}

#[test]
fn commands_about_maps_say_that_a_mesh_is_one() {
    let path = file("no-map.obj", CUBE);
    for arguments in [&["draw", &path][..], &["query", &path, "faces"]] {
        let output = twinedge(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        let words = complaint(&output);
        assert!(
            words.contains("this is a mesh (OBJ); only `twinedge audit` and `twinedge certify` take meshes"),
            "{words}"
        );
    }
}

#[test]
fn options_that_do_not_apply_are_not_passed_over() {
    let (mesh, table) = (file("snapped.obj", CUBE), file("snapped.txt", "V 0 H 0 B 0 F 0\n"));
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");
    let book = format!("{root}/examples/tables/five_faces.txt");
    let town = format!("{root}/crates/postgis/tests/postgis/data/town.copy");
    for (path, option, told) in [
        (&mesh, &["--snap", "auto"][..], "--snap is for maps, and this is a mesh"),
        (&table, &["--snap", "auto"], "--snap is for maps, and this is a file of tables"),
        (&table, &["--closed"], "is no mesh file"),
        (&table, &["--sliver", "1"], "--geodesic are for maps, and this is a file of tables"),
        (&book, &["--snap", "auto"], "--snap is for maps, and this is a textbook's tables"),
        (&book, &["--genus", "0"], "is no mesh file"),
        (&town, &["--coverage"], "--geodesic are for maps, and this is a topology of PostGIS"),
    ] {
        let output = twinedge(&[&["audit", path][..], option].concat());
        assert_eq!(output.status.code(), Some(2), "{option:?}");
        let words = complaint(&output);
        assert!(words.contains(told), "{words}");
    }
}

#[test]
fn the_places_of_points_are_judged_if_asked_for() {
    // A corner of the cube is pulled below its bottom.
    let folded = file("folded.obj", &CUBE.replace("v 1 1 1\n", "v 0.5 0.5 -1\n"));
    let asked = ["--no-zero-area", "--no-crossings", "--outward"];
    let (status, found) = json(&["audit", &folded, "--format", "json"]);
    assert_eq!((status, found["rules"].as_array().unwrap().len()), (Some(0), 14));
    let triangles = CUBE.replace("f 1 4 3 2\n", "f 1 4 3\nf 1 3 2\n").replace("f 5 6 7 8\n", "f 5 6 7\nf 5 7 8\n");
    let triangles = triangles.replace("f 2 3 7 6\n", "f 2 3 7\nf 2 7 6\n").replace("f 3 4 8 7\n", "f 3 4 8\nf 3 8 7\n");
    let triangles = triangles.replace("f 1 2 6 5\n", "f 1 2 6\nf 1 6 5\n").replace("f 4 1 5 8\n", "f 4 1 5\nf 4 5 8\n");
    let folded = file("folded_triangles.obj", &triangles.replace("v 1 1 1\n", "v 0.5 0.5 -1\n"));
    let (status, found) = json(&[&["audit", &folded, "--format", "json"], &asked[..]].concat());
    let broken = found["rules"].as_array().unwrap().iter().filter(|rule| rule["violations"] != 0);
    let broken: Vec<_> = broken.map(|rule| rule["id"].as_str().unwrap()).collect();
    assert_eq!((status, broken), (Some(1), vec!["M10"]));
    assert_eq!((&found["verdict"], &found["findings"][0]["rule"]), (&"invalid".into(), &"M10".into()));
    assert_eq!(found["options"]["space"], serde_json::json!(["M9", "M10", "M11"]));
    // A face that is not convex is not judged. Nothing else is found, so the verdict is not `valid`.
    let notched = file("notched.obj", "v 0 0 0\nv 4 -4 0\nv 1 0 0\nv 4 4 0\nf 1 2 3 4\n");
    let (status, found) = json(&["audit", &notched, "--no-crossings", "--format", "json"]);
    assert_eq!((status, &found["verdict"]), (Some(1), &"unknown".into()), "{found}");
    assert_eq!(found["rules"].as_array().unwrap().last().unwrap()["unchecked"], "not_convex");
    let text = String::from_utf8(twinedge(&["audit", &notched, "--no-crossings"]).stdout).unwrap();
    assert!(text.contains("M10  crossing") && text.contains("not convex; triangulate them"), "{text}");
}
