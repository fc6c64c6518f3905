//! Reports on mesh files.

use crate::shared::{CUBE, has};
use crate::support::{broken, json, refused, says, text};
use serde_json::json;

/// The cube with its second face flipped.
fn flipped() -> String {
    CUBE.replace("f 5 6 7 8", "f 8 7 6 5")
}

#[test]
fn people_read_these_lines() {
    let off = "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
    let unused = "OFF 4 1 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n";
    says(CUBE, "--closed", &["OBJ, 8 points, 6 faces", "T3  Euler"]);
    says(off, "--closed --sides 3", &["OFF, 4 points, 4 faces"]);
    let numbers = "\nvertices, faces and corners (half-edges) are counted from 1, as the file counts points\n";
    // The second line of faces is now 8 7 6 5, the third 1 2 6 5.
    let flip = "\nflipped_faces faces 2 and 3 both run from vertex 6 to vertex 5: one of them is flipped\n";
    let sides = "\nM3 face 1 has 4 sides, where 3 are expected\n";
    says(flipped(), "--sides 3", &["T3  Euler", "not valid", numbers, flip, sides]);
    says(unused, "", &["(half-edges) are counted from 0\n", "no face uses vertex 3"]);
    let no_faces = "no_faces there are no faces, so there is no surface";
    says("v 0 0 0\nv 1 0 0\nv 0 1 0\n", "--closed", &["not valid", no_faces]);
    says(NOTCHED, "--no-crossings", &["M10  crossing", "not convex; triangulate them"]);
    for rule_of_the_plane in ["B2  isolated", "T1  outside", "T2  nesting", "T4  bounds"] {
        assert!(!text(CUBE, "").contains(rule_of_the_plane) && !text(flipped(), "").contains(rule_of_the_plane));
    }
    // Four edges, one explanation.
    assert_eq!(text(flipped(), "--explain").matches("flipped_faces: usual cause: ").count(), 1);
}

#[test]
fn a_cube_is_a_closed_mesh_of_genus_0() {
    let found = json(CUBE, "--closed --genus 0 --sides 4");
    let counts = json!({"vertices": 8, "edges": 12, "faces": 6, "borders": 0, "euler_characteristic": 2, "genus": 0});
    has(&found, &json!({"valid": true, "counts": counts}));
    assert_eq!(broken(&found), []);
}

#[test]
fn what_is_expected_and_not_found_is_named() {
    let open = CUBE.strip_suffix("f 4 1 5 8\n").unwrap();
    let found = json(open, "--closed --sides 3");
    assert_eq!((broken(&found), &found["counts"]["borders"]), (vec![("M3", 5), ("M4", 4)], &json!(1)));
    has(&found["violations"][0], &json!({"rule": "M3", "message": "face 1 has 4 sides, where 3 are expected"}));
    // Every option selects the rule of its name.
    let found = json(open, "--borders 2 --genus 1 --components 2 --sides 5 --no-unused-vertices --explain");
    let violations = found["violations"].as_array().unwrap();
    let mut ids: Vec<&str> = violations.iter().map(|violation| violation["rule"].as_str().unwrap()).collect();
    ids.dedup();
    assert_eq!(ids, ["M3", "M5", "M6", "M7"]);
    assert!(violations.iter().all(|violation| violation["cause"].is_string()));
    assert_eq!(found["rules"].as_array().unwrap().len(), 14 + 5);
}

/// Numbers in the JSON count from 0, unlike the messages.
#[test]
fn findings_have_numbers_of_faces_and_explanations_on_request() {
    let finding = json!({"faces": [1, 2], "cause": null});
    let found = json(flipped(), "");
    has(&found, &json!({"messages_count_from": 1, "finding_count": 4}));
    has(&found["findings"][0], &finding);
    assert!(found["findings"][0]["message"].as_str().unwrap().starts_with("faces 2 and "), "{found}");
    let explained = json(flipped(), "--explain");
    let findings = explained["findings"].as_array().unwrap();
    assert!(findings.iter().all(|one| one["cause"].is_string() && one["remedy"].is_string()), "{explained}");
}

#[test]
fn a_malformed_mesh_is_an_error_with_its_place() {
    assert!(refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n", "").contains("line 6"));
    let zero = refused(CUBE.replace("f 5 6 7 8", "f 5 6 7 0"), "");
    assert!(zero.contains("a face lists point 0, but OBJ counts points from 1"), "{zero}");
}

/// A face that is not convex.
const NOTCHED: &str = "v 0 0 0\nv 4 -4 0\nv 1 0 0\nv 4 4 0\nf 1 2 3 4\n";

#[test]
fn the_places_of_points_are_judged_if_asked_for() {
    // A corner of the cube is pulled below its bottom.
    let folded = CUBE.replace("v 1 1 1\n", "v 0.5 0.5 -1\n");
    let found = json(&*folded, "");
    assert_eq!((&found["verdict"], found["rules"].as_array().unwrap().len()), (&json!("valid"), 14));
    let in_two = |line: &str| match line.strip_prefix("f ").map(|face| face.split(' ').collect::<Vec<_>>()) {
        Some(face) => format!("f {0} {1} {2}\nf {0} {2} {3}\n", face[0], face[1], face[2], face[3]),
        None => format!("{line}\n"),
    };
    let found = json(folded.lines().map(in_two).collect::<String>(), "--no-zero-area --no-crossings --outward");
    assert_eq!(broken(&found).iter().map(|(rule, _)| *rule).collect::<Vec<_>>(), ["M10"]);
    has(&found, &json!({"verdict": "invalid", "options": {"space": ["M9", "M10", "M11"]}}));
    assert_eq!(found["findings"][0]["rule"], "M10");
    // A face that is not convex is not judged. Nothing else is found, so the verdict is not `valid`.
    let found = json(NOTCHED, "--no-crossings");
    assert_eq!(found["verdict"], "unknown", "{found}");
    assert_eq!(found["rules"].as_array().unwrap().last().unwrap()["unchecked"], "not_convex");
}
