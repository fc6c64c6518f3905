//! Edges as great circles.

use crate::shared::{has, members};
use crate::support::{audited, json, layer, refused, says};
use serde_json::{Value, json};

type Ring<'a> = &'a [[f64; 2]];

/// A layer of polygons of one ring each, with ids f0, f1, …
fn of(rings: &[Ring<'_>]) -> String {
    let feature = |(number, ring): (usize, &Ring<'_>)| {
        let closed: Vec<_> = ring.iter().chain(ring.first()).collect();
        let geometry = json!({"type": "Polygon", "coordinates": [closed]});
        json!({"type": "Feature", "id": format!("f{number}"), "properties": {"name": "a"}, "geometry": geometry})
    };
    let features: Vec<Value> = rings.iter().enumerate().map(feature).collect();
    json!({"type": "FeatureCollection", "features": features}).to_string()
}

/// On the map, its northern border lies at 50 degrees; on the globe, it bulges to 67.2 degrees.
const LONG: Ring<'_> =
    &[[-60.0, 30.0], [-30.0, 30.0], [0.0, 30.0], [30.0, 30.0], [60.0, 30.0], [60.0, 50.0], [-60.0, 50.0]];
const BESIDE: Ring<'_> = &[[-5.0, 60.0], [5.0, 60.0], [5.0, 72.0], [-5.0, 72.0]];

/// Two features of a finding.
fn both() -> Value {
    json!([{"id": "f0"}, {"id": "f1"}])
}

/// <https://github.com/apache/sedona-db/issues/1154>: borders that are plane on the map cross as geographies.
#[test]
fn borders_that_cross_on_the_globe_only_are_found() {
    let layer = of(&[LONG, BESIDE]);
    has(&json(&*layer, "--coverage"), &json!({"verdict": "valid", "options": {"edges": null}}));
    let report = json(layer, "--edges geodesic");
    let crossing = json!({"rule": "G4", "kind": "cross", "features": ["a", "a"]});
    has(
        &report,
        &json!({
            "verdict": "invalid",
            "violations": [crossing, crossing],
            "coverage": {"findings": [{"rule": "C1", "features": both()}], "unit": "metres", "ogc_invalid": null},
            "edges": {"kind": "great circles"},
            "options": {"edges": "geodesic"},
            "first": {"rule": "C1"},
            // The structure has the edges after cutting.
            "counts": {"vertices": 13, "edges": 15},
        }),
    );
    // From 60 to 67.1 degrees, 10 degrees wide: 791 km by 503 km on average.
    let overlap = &report["coverage"]["findings"][0];
    assert!((3.8e11..4.2e11).contains(&overlap["area"].as_f64().unwrap()), "{overlap}");
    for rule in report["rules"].as_array().unwrap() {
        assert_eq!(rule["violations"].as_u64().unwrap() > 0, rule["id"] == "G4", "{rule}");
    }
}

#[test]
fn a_ring_that_crosses_itself_on_the_map_only_is_accepted() {
    let layer = of(&[&[[-60.0, 50.0], [-20.0, 40.0], [0.0, 55.0], [20.0, 40.0], [60.0, 50.0]]]);
    assert_eq!(json(&*layer, "")["verdict"], "invalid");
    assert_eq!(json(layer, "--edges geodesic --coverage")["verdict"], "valid");
}

/// Both have a vertex on the other's side of their common meridian.
#[test]
fn a_contact_on_a_meridian_is_a_mismatch_and_nothing_else() {
    let colorado = [[-109.05, 37.0], [-102.05, 37.0], [-102.05, 41.0], [-109.05, 41.0]];
    let kansas = [[-102.05, 37.0], [-94.6, 37.0], [-94.6, 40.0], [-102.05, 40.0]];
    let report = json(of(&[&colorado, &kansas]), "--edges geodesic");
    let missing = json!([{"at": [-102.05, 40.0], "feature": 0}]);
    let finding = json!({"rule": "C7", "features": both(), "missing": missing});
    has(&report, &json!({"verdict": "invalid", "first": {"rule": "C7"}, "coverage": {"findings": [finding]}}));
    assert_eq!(members(&report["violations"], &["kind", "follows_from"]), json!([["overlap", "C7"], ["touch", "C7"]]));
}

#[test]
fn an_edge_between_antipodes_is_named_and_nothing_is_said_of_the_coverage() {
    let report = json(of(&[&[[0.0, 10.0], [90.0, 0.0], [180.0, -10.0]]]), "--edges geodesic");
    has(&report, &json!({"verdict": "invalid", "violations": [{"rule": "G1", "kind": "antipodal"}]}));
    assert!(report["coverage"]["not_checked"].as_str().unwrap().contains("1 edge between antipodes"));
}

#[test]
fn text_and_layer_have_great_circles() {
    let two = of(&[LONG, BESIDE]);
    let cut = "edges are great circles, cut where they meet";
    says(&*two, "--edges geodesic", &[cut, "C6  OGC validity not checked"]);
    let overlap = &layer(&audited(two, "--edges geodesic"))["features"][0];
    has(overlap, &json!({"properties": {"rule": "C1"}, "geometry": {"type": "Polygon"}}));
    // The drawn arc is curved.
    let ring = overlap["geometry"]["coordinates"][0].as_array().unwrap();
    let top = ring.iter().map(|at| at[1].as_f64().unwrap()).fold(0.0, f64::max);
    assert!(ring.len() > 20 && (67.2..67.3).contains(&top), "{top}");
}

#[test]
fn what_is_about_straight_edges_is_refused() {
    for (words, why) in [
        ("--snap auto", "--edges geodesic and --snap do not go together"),
        ("--geodesic", "--edges geodesic and --geodesic do not go together"),
        ("--tiles 2", "--edges geodesic and --tiles or --memory do not go together"),
        ("--parent-column name", "--edges geodesic and --against or --parent-column do not go together"),
    ] {
        let said = refused(of(&[LONG, BESIDE]), &format!("--edges geodesic {words}"));
        assert!(said.contains(why), "{said}");
    }
    let said = refused(of(&[&[[5e5, 5e6], [6e5, 5e6], [6e5, 6e6]]]), "--edges geodesic");
    assert!(said.contains("--edges geodesic are for longitudes and latitudes"), "{said}");
}

/// A format that declares edges gets a warning if they are judged as straight.
#[test]
fn spherical_edges_that_are_judged_as_straight_are_warned_of() {
    let mut layer: Value = serde_json::from_str(&of(&[LONG, BESIDE])).unwrap();
    layer["edges"] = json!("spherical");
    for words in ["", "--tiles 2"] {
        let report = json(layer.to_string(), words);
        let warning = report["warnings"][0].as_str().unwrap();
        assert!(warning.contains("its edges are spherical, and they were judged as straight"), "{warning}");
        assert_eq!(report["verdict"], "valid");
    }
}
