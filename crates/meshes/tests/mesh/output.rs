//! An audit as text and as JSON.

use crate::support::shapes::{CUBE, TETRAHEDRON, mesh};
use serde_json::{Value, json};
use std::collections::BTreeSet;
use twinedge::validate::{Collect, Rule};
use twinedge_meshes::{HalfEdgeMesh, Kind, audit, read_bytes};

#[test]
fn json_has_the_keys_that_scripts_use() {
    let second = TETRAHEDRON.map(|face| face.map(|v| if v == 0 { 0 } else { v + 3 }));
    let pinched = mesh(8, TETRAHEDRON.into_iter().chain(second));
    let audit = audit(&pinched, &HalfEdgeMesh::expectation().genus(0).no_unused_vertices(), Collect::All);
    let value: Value = serde_json::to_value(&audit).expect("no maps with strange keys");
    assert_eq!(value["valid"], false);
    assert_eq!(
        value["counts"],
        json!({"vertices": 8, "unused_vertices": 1, "edges": 12, "border_edges": 0, "faces": 8, "left_out_faces": 0,
               "triangles": 8, "components": 1, "borders": 0, "euler_characteristic": 3, "genus": null, "orientable": true})
    );
    let violations = value["violations"].as_array().expect("a list");
    assert_eq!(violations.iter().map(|violation| &violation["rule"]).collect::<Vec<_>>(), ["V2", "M1"]);
    assert_eq!(
        violations[1],
        json!({"rule": "M1", "kind": "unused_vertex", "fields": {"vertex": 7}, "records": [{"vertex": 7}],
               "message": "no half-edge leaves vertex 7: no edge and no face uses it"})
    );
    assert_eq!(value["finding_count"], 2);
    assert_eq!(
        value["findings"],
        json!([{"kind": "non_manifold_vertex", "faces": [0, 4], "vertices": [0],
                "message": "2 fans of faces meet at vertex 0 and share no edge there; one face of each: 0, 4"},
               {"kind": "unused_vertex", "faces": [], "vertices": [7], "message": "no face uses vertex 7"}])
    );
    let rules = value["rules"].as_array().expect("a list");
    let ids: Vec<_> = rules.iter().map(|rule| rule["id"].as_str().expect("text")).collect();
    assert_eq!(ids[..4], [Rule::R1.id(), Rule::L1.id(), Rule::L2.id(), Rule::L3.id()]);
    assert_eq!(rules[5], json!({"id": "V2", "violations": 1, "checked": 7, "unchecked": null}));
    assert_eq!(rules[12]["unchecked"], json!({"broken": "V2"}));
    assert_eq!(rules[14], json!({"id": "M1", "violations": 1, "checked": 8, "unchecked": null}));
    assert_eq!(rules[15], json!({"id": "M7", "violations": 0, "checked": 0, "unchecked": {"broken": "V2"}}));
    assert_eq!(rules.len(), 16);
}

#[test]
fn json_says_valid_only_where_the_audit_does() {
    for extra in [None, Some([0, 2, 1])] {
        let audit = audit(&mesh(4, TETRAHEDRON.into_iter().chain(extra)), &HalfEdgeMesh::expectation(), Collect::All);
        // All joints are valid, but one face was left out.
        assert!(audit.report().is_valid());
        assert_eq!(serde_json::to_value(&audit).expect("no maps with strange keys")["valid"], extra.is_none());
    }
}

#[test]
fn text_has_counts_rules_findings_and_the_verdict() {
    let mut faces = CUBE.to_vec();
    let whole = audit(&mesh(8, &faces), &HalfEdgeMesh::expectation().closed(), Collect::All).to_string();
    for line in ["vertices (V)                    8", "Euler characteristic            2", "valid"] {
        assert!(whole.lines().any(|found| found == line), "{line}\n{whole}");
    }
    faces.pop();
    faces.push([0, 1, 2, 3]);
    faces.push([0, 0, 1, 1]);
    let spoilt = audit(&mesh(8, &faces), &HalfEdgeMesh::expectation().closed(), Collect::AtMost(1)).to_string();
    for line in [
        "degenerate_face: face 6 has two different vertices only, 0, 1: it is left out",
        "repeated_face: face 5 has the vertices of face 0, in the opposite order (0, 1, 2, 3): it is left out",
        "M4 closed    BROKEN, 4 violations in 20 half-edges",
        "M4: half-edge 0, from vertex 0 to vertex 3, has no twin: the surface has a border there",
        "not valid",
    ] {
        assert!(spoilt.lines().any(|found| found == line), "{line}\n{spoilt}");
    }
}

#[test]
fn findings_come_first_and_v2_is_told_to_follow_from_them() {
    let mut faces = CUBE.to_vec();
    faces[1].reverse();
    let text = audit(&mesh(8, &faces), &HalfEdgeMesh::expectation(), Collect::All).to_string();
    assert!(text.starts_with("flipped_faces: faces "), "{text}");
    let line =
        |told: &str| text.lines().position(|line| line.starts_with(told)).unwrap_or_else(|| panic!("{told}\n{text}"));
    assert!(line("flipped_faces") < line("vertices (V)") && line("vertices (V)") < line("V2: "), "{text}");
    assert!(line("V2: ") < line("V2 is broken because of the findings above"), "{text}");
    // No border, but four edges where faces meet without being joined.
    assert!(text.lines().any(|line| line == "edges not joined                4"), "{text}");
    // For the validator, half-edges without a twin are at a border; for the counts, they are not.
    let text = audit(&mesh(8, &faces), &HalfEdgeMesh::expectation().closed(), Collect::All).to_string();
    assert!(text.contains("M4 closed    BROKEN, 8 violations in 24 half-edges"), "{text}");
    assert!(
        text.contains("M4 counts the half-edges that could not be joined because of the findings above, too"),
        "{text}"
    );
    // If nothing is broken, nothing follows.
    let whole = audit(&mesh(8, CUBE), &HalfEdgeMesh::expectation(), Collect::All).to_string();
    assert!(whole.starts_with("vertices (V)") && !whole.contains("because"), "{whole}");
}

#[test]
fn components_in_text_are_told_from_those_of_the_validator() {
    // One vertex without faces: a component of the map (T3), but not of the faces.
    let text = audit(&mesh(1, [[0_u32; 3]; 0]), &HalfEdgeMesh::expectation(), Collect::All).to_string();
    assert!(text.contains("components of faces             0") && text.contains("1 component"), "{text}");
}

#[test]
fn every_kind_has_a_cause_and_a_remedy_of_its_own() {
    let texts: BTreeSet<&str> = Kind::ALL.iter().flat_map(|kind| [kind.cause(), kind.remedy()]).collect();
    assert_eq!(texts.len(), 2 * Kind::ALL.len());
}

#[test]
fn every_finding_has_its_sentence() {
    let say = |points, faces: &[&[u32]]| {
        let audit = audit(&mesh(points, faces), &HalfEdgeMesh::expectation(), Collect::All);
        audit.findings().list().iter().map(|finding| finding.to_string()).collect::<Vec<_>>()
    };
    assert_eq!(say(0, &[&[]]), ["face 0 has no vertices: it is left out"]);
    assert_eq!(say(1, &[&[0, 0]]), ["face 0 has one vertex only, 0: it is left out", "no face uses vertex 0"]);
    assert_eq!(
        say(4, &[&[0, 1, 2, 1, 3], &[0, 1, 2], &[1, 2, 0], &[3, 2, 1]]),
        [
            "face 0 passes vertex 1 more than once: it is left out",
            "face 2 has the vertices of face 1, in the same order (1, 2, 0): it is left out",
        ]
    );
    assert_eq!(
        say(4, &[&[0, 1, 2], &[0, 1, 3]]),
        ["faces 0 and 1 both run from vertex 0 to vertex 1: one of them is flipped"]
    );
    let book: Vec<[u32; 3]> = (2..12).map(|v| [0, 1, v]).collect();
    let book: Vec<_> = book.iter().map(|face| &face[..]).collect();
    assert_eq!(say(12, &book), ["the edge between vertices 0 and 1 has 10 faces: 0, 1, 2, 3, 4, 5, 6, 7 and 2 more"]);
}

#[test]
fn kinds_have_stable_names() {
    let names: Vec<_> = Kind::ALL.iter().map(|kind| kind.name()).collect();
    let expected = "no_faces degenerate_face repeated_vertex repeated_face non_manifold_edge flipped_faces \
        non_manifold_vertex unused_vertex zero_area crossing_faces inside_out";
    assert_eq!(names.join(" "), expected);
    assert!(Kind::ALL.iter().all(|kind| kind.is_fault() == (*kind != Kind::UnusedVertex)));
}

#[test]
fn a_file_is_audited_in_three_lines() -> Result<(), Box<dyn std::error::Error>> {
    let file = read_bytes(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n", None)?;
    let audit = audit(&file.mesh, &HalfEdgeMesh::expectation().closed().genus(0), Collect::All);
    assert!(audit.is_valid());
    Ok(())
}
