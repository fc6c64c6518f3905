//! The arcs of TopoJSON, judged as shared: valid arcs pass, and each fault is named.

use serde_json::{Value, json};
use twinedge::validate::{Record, View};
use twinedge_layers::topojson::{TopologyAudit, audit, read};
use twinedge_layers::{Cause, ReadError};

const SOUTH_AMERICA: &str = include_str!("data/south-america.topojson");

/// Two adjacent squares, and a third one in a hole of the first.
fn squares() -> Value {
    json!({
        "type": "Topology",
        "arcs": [
            [[6, 0], [6, 6]],
            [[6, 6], [0, 6], [0, 0], [6, 0]],
            [[6, 0], [10, 0], [10, 6], [6, 6]],
            [[2, 2], [4, 2], [4, 4], [2, 4], [2, 2]],
        ],
        "objects": {"map": {"type": "GeometryCollection", "geometries": [
            {"type": "Polygon", "id": "P", "arcs": [[0, 1], [-4]]},
            {"type": "MultiPolygon", "id": "Q", "arcs": [[[3]]]},
            {"type": "Polygon", "id": 7, "properties": {"name": "R"}, "arcs": [[2, -1]]},
        ]}},
    })
}

fn audited(file: &Value) -> TopologyAudit {
    audit(&read(&mut file.to_string().as_bytes(), Some("map"), 100).unwrap(), 100)
}

/// Returns the map with one value changed.
fn with(pointer: &str, value: Value) -> Value {
    let mut file = squares();
    *file.pointer_mut(pointer).unwrap() = value;
    file
}

/// Returns the kinds and messages of all violations.
fn found(file: &Value) -> Vec<(&'static str, String)> {
    let audit = audited(file);
    assert_eq!(audit.is_valid(), audit.violation_count() == 0, "{audit}");
    audit.violations().iter().map(|one| (one.kind.name(), one.message.clone())).collect()
}

fn kinds(file: &Value) -> Vec<&'static str> {
    found(file).into_iter().map(|(kind, _)| kind).collect()
}

const P: &str = "/objects/map/geometries/0/arcs";
const Q: &str = "/objects/map/geometries/1/arcs";
const R: &str = "/objects/map/geometries/2/arcs";

#[test]
fn what_is_right_is_valid_whichever_way_rings_are_wound() {
    let audit = audited(&squares());
    assert!(audit.is_valid(), "{audit}");
    let counts = audit.counts();
    // Ends at (6, 0), (6, 6) and (2, 2); V − E + F = 3 − 4 + 4 = 1 + C, the outside included.
    assert_eq!((counts.nodes, counts.edges, counts.faces, counts.components), (3, 4, 3, Some(2)));
    assert_eq!(counts.bends, 2 + 2 + 3);
    for (pointer, reversed) in [(P, json!([[-2, -1], [-4]])), (P, json!([[0, 1], [3]])), (R, json!([[0, -3]]))] {
        assert!(audited(&with(pointer, reversed)).is_valid());
    }
    // An unfilled hole is a gap, which is not a fault of the arcs.
    assert_eq!(kinds(&with(Q, json!([]))), [""; 0]);
}

#[test]
fn half_edges_are_arcs_and_backwards_their_complements() {
    let topology = read(&mut squares().to_string().as_bytes(), None, 100).unwrap();
    let name = |link: Option<usize>, of: fn(usize) -> Record| topology.name(of(link.unwrap()));
    assert_eq!(name(topology.next(0), Record::HalfEdge), "1");
    assert_eq!(name(topology.next(1), Record::HalfEdge), "2");
    assert_eq!(name(topology.next(4), Record::HalfEdge), "~0");
    assert_eq!(name(topology.face(1), Record::Face), "feature 2 of map (R)");
    assert_eq!(name(topology.face(7), Record::Face), "feature 0 of map (P)");
    assert_eq!(name(topology.origin(0), Record::Vertex), "(6, 0)");
}

/// The counts are as for a topology of PostGIS: 13 countries in 15 polygons on 3 islands. 37 arcs with 565 bends are the borders; V − E + F = 25 − 37
/// + 16 = 1 + 3.
#[test]
fn what_geo2topo_wrote_is_valid() {
    let audit = audit(&read(&mut SOUTH_AMERICA.as_bytes(), None, 100).unwrap(), 100);
    assert!(audit.is_valid(), "{audit}");
    let counts = audit.counts();
    assert_eq!((counts.nodes, counts.edges, counts.faces), (25, 37, 15));
    assert_eq!((counts.components, counts.bends), (Some(3), 565));
}

#[test]
fn each_fault_is_named() {
    let short = |file: Value, kind: &str, what: &str| {
        let found = found(&file);
        assert!(found.iter().any(|(k, message)| *k == kind && message.contains(what)), "{kind}, {what}: {found:?}");
    };
    short(with(Q, json!([[[9]]])), "no_such_arc", "feature 1 of map (Q) has the index 9, and there are 4 arcs");
    short(with(Q, json!([[[-9]]])), "no_such_arc", "the index -9");
    short(
        with(P, json!([[0, -2]])),
        "not_joined",
        "in feature 0 of map (P), arc 0 ends at (6.0, 6.0), and arc -2 after it begins at (6.0, 0.0)",
    );
    short(
        with(R, json!([[2]])),
        "not_closed",
        "ring 0 of feature 2 of map (R) begins at (6.0, 0.0) and ends at (6.0, 6.0)",
    );
    short(with(P, json!([[0, 1], [0, -1]])), "ring_without_area", "ring 1 of feature 0 of map (P) encloses nothing");
    short(with(P, json!([[0, 1], []])), "ring_without_area", "has no arcs");
    short(
        with(Q, json!([[[0, 1]]])),
        "same_side",
        "arc 1 has feature 0 of map (P) and feature 1 of map (Q), polygon 0 on the same side",
    );
    short(with(P, json!([[0, 1]])), "unlisted", "lies in face feature 0 of map (P), which does not list it");
}

#[test]
fn an_arc_that_is_used_forth_and_back_is_named() {
    let mut file = with(P, json!([[0, 4, -5, 1], [-4]]));
    file["arcs"].as_array_mut().unwrap().push(json!([[6, 6], [5, 5]]));
    assert_eq!(found(&file), [("both_sides", "arc 4 has feature 0 of map (P) on both sides".to_owned())]);
}

#[test]
fn arcs_that_nobody_uses_and_arcs_without_length_are_named() {
    let mut file = squares();
    file["arcs"].as_array_mut().unwrap().extend([json!([[20, 20], [21, 20]]), json!([[30, 30], [30, 30]]), json!([])]);
    let of_lines = json!({"type": "MultiLineString", "arcs": [[5]]});
    file["objects"]["lines"] = of_lines;
    assert_eq!(kinds(&file), ["arc_without_length", "arc_without_length", "unused_arc", "unused_arc"]);
}

#[test]
fn arcs_that_meet_elsewhere_than_at_their_ends_are_named() {
    // The hole reaches over the border; touches it; a second arc lies on the border.
    for (ring, kind) in [
        (json!([[2, 2], [8, 2], [4, 4], [2, 4], [2, 2]]), "segments_cross"),
        (json!([[2, 2], [6, 3], [4, 4], [2, 4], [2, 2]]), "bend_in_segment"),
        (json!([[2, 2], [6, 2], [6, 4], [2, 4], [2, 2]]), "segments_overlap"),
    ] {
        let found = kinds(&with("/arcs/3", ring));
        assert!(found.contains(&kind), "{kind}: {found:?}");
    }
}

#[test]
fn polygons_that_overlap_without_sharing_a_side_are_named() {
    // A loop at a corner of R, inside R, with another polygon in it.
    let mut file = squares();
    file["arcs"].as_array_mut().unwrap().push(json!([[6, 0], [8, 1], [8, 2], [6, 0]]));
    file["objects"]["map"]["geometries"].as_array_mut().unwrap().push(json!({"type": "Polygon", "arcs": [[4]]}));
    let found = kinds(&file);
    assert!(!found.is_empty() && found.iter().all(|kind| *kind == "face_changes"), "{found:?}");
    // A hole outside of its polygon, and filled there.
    let found = kinds(&with("/arcs/3", json!([[22, 2], [24, 2], [24, 4], [22, 4], [22, 2]])));
    assert!(found.contains(&"wrong_face"), "{found:?}");
}

#[test]
fn where_ends_do_not_join_faces_are_not_judged_and_arcs_are() {
    let mut file = with(R, json!([[2]]));
    file["arcs"][3] = json!([[2, 2], [8, 2], [4, 4], [2, 4], [2, 2]]);
    let audit = audited(&file);
    let rule = |id: &str| audit.rules().iter().find(|rule| rule.id == id).unwrap();
    assert!(rule("G4").violations > 0);
    assert_eq!(rule("B1").unchecked.map(|why| why.to_string()).as_deref(), Some("needs A1, which is broken"));
}

/// Collects the JSON pointers of all numbers in nested lists.
fn indices(value: &Value, path: &str, places: &mut Vec<String>) {
    for (i, item) in value.as_array().into_iter().flatten().enumerate() {
        let path = format!("{path}/{i}");
        if item.is_number() { places.push(path) } else { indices(item, &path, places) }
    }
}

/// Each of the 61 indices of a real map is set to every sixth of the others.
#[test]
fn every_wrong_index_is_found() {
    let file: Value = serde_json::from_str(SOUTH_AMERICA).unwrap();
    let geometries = "/objects/countries/geometries";
    let mut places = Vec::new();
    for (i, one) in file.pointer(geometries).unwrap().as_array().unwrap().iter().enumerate() {
        indices(&one["arcs"], &format!("{geometries}/{i}/arcs"), &mut places);
    }
    assert_eq!(places.len(), 61);
    let (mut wrong, mut missed) = (0, Vec::new());
    for place in places {
        let right = file.pointer(&place).unwrap().as_i64().unwrap();
        for index in (-37..37).step_by(6).filter(|index| *index != right) {
            let mut file = file.clone();
            *file.pointer_mut(&place).unwrap() = index.into();
            let topology = read(&mut file.to_string().as_bytes(), None, 1).unwrap();
            wrong += 1;
            if audit(&topology, 1).is_valid() {
                missed.push((place.clone(), right, index));
            }
        }
    }
    // The only ring of the Falkland Islands is the same ring when reversed.
    let same = ("/objects/countries/geometries/2/arcs/0/0".to_owned(), 12, -13);
    // 10 of the 61 are among the 13 tried values.
    assert_eq!((wrong, missed), (61 * 13 - 10, vec![same]));
}

#[test]
fn what_is_no_topology_is_an_error() {
    let read = |text: &str| read(&mut text.as_bytes(), None, 10);
    assert!(matches!(read("{"), Err(ReadError::Content { cause: Cause::Truncated(_), .. })));
    assert!(matches!(read(r#"{"type":"Topology","arcs":[],"objects":{}}"#), Err(ReadError::Layers { .. })));
    for geometry in
        ["{}", "7", r#"{"type":"Polygon"}"#, r#"{"type":"Polygon","arcs":[0]}"#, r#"{"type":"Polygon","arcs":[["0"]]}"#]
    {
        let text = format!(r#"{{"type":"Topology","arcs":[],"objects":{{"a":{geometry}}}}}"#);
        assert!(matches!(read(&text), Err(ReadError::Content { .. })), "{geometry}");
    }
    // A long arc that is repeated is traversed once.
    let arc = vec!["[0,0],[1,0],[1,1]"; 20_000].join(",");
    let indices = vec!["0,-1"; 50_000].join(",");
    let text = format!(
        r#"{{"type":"Topology","arcs":[[{arc}]],"objects":{{"a":{{"type":"Polygon","arcs":[[{indices}]]}}}}}}"#
    );
    assert_eq!(audit(&read(&text).unwrap(), 1).violations().len(), 1);
}

#[test]
fn a_polygon_that_is_in_the_object_twice_breaks_a2_alone() {
    let mut file = squares();
    let geometries = file["objects"]["map"]["geometries"].as_array_mut().unwrap();
    let again = geometries[0].clone();
    geometries.push(again);
    let found = kinds(&file);
    assert!(!found.is_empty() && found.iter().all(|kind| *kind == "same_side"), "{found:?}");
}
