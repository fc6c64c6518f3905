//! Reports on maps: the structure, snapping, irregular rings, warnings, and the ids of findings.

use crate::shared::{has, members};
use crate::support::{broken, crossing, file, json, refused, says, text, world};
use serde_json::{Value, json};
use std::collections::BTreeSet;

#[test]
fn the_worlds_have_these_counts() {
    let counts = json!({"vertices": 7_493, "edges": 7_655, "components": 125, "faces": 288, "genus": 0});
    let large = json!({"vertices": 75_685, "edges": 75_863, "components": 1_438, "faces": 1_617});
    let cut = json!({"crossings": 2, "segments_cut": 4, "points_merged": 0});
    for (input, words, expected) in [
        (world(), "", json!({"verdict": "valid", "valid": true, "counts": counts, "violations": []})),
        (file("tests/data/world-50m.geojson"), "", json!({"verdict": "valid", "counts": large})),
        (crossing(), "", json!({"verdict": "invalid", "valid": false, "counts": {"genus": 1}})),
        (crossing(), "--snap auto", json!({"verdict": "valid", "counts": counts, "noding": cut})),
        (world(), "--snap 0.3", json!({"verdict": "valid", "noding": {"cell": 0.3}})),
    ] {
        let found = json(input, words);
        has(&found, &expected);
        if words.is_empty() {
            continue;
        }
        let noding = &found["noding"];
        let cell = noding["cell"].as_f64().unwrap();
        assert!(noding["largest_move"].as_array().unwrap().iter().all(|moved| moved.as_f64().unwrap() <= cell / 2.0));
        let is_smaller = found["counts"]["vertices"].as_u64() < Some(7_493);
        assert_eq!((is_smaller, noding["points_merged"].as_u64() > Some(0)), (cell > 0.1, cell > 0.1), "{noding}");
    }
    assert!(refused(world(), "--snap 1e-30").contains("out of reach of the grid: take larger cells"));
}

#[test]
fn people_read_these_lines() {
    says(world(), "", &["7,655", "structure valid · coverage: 1 gap, 2 invalid features"]);
    says(crossing(), "--list 1", &["BROKEN", "more; see --list"]);
    says(crossing(), "--snap auto", &["4 segments cut, 2 vertices made at crossings; points moved by at most"]);
    says(DROPPED, "", &["\ndropped: the dimensions beyond x and y of 4 positions, 1 empty shape\n"]);
    // Numbers agree with their nouns.
    let crossing_lines = "LINESTRING (0 0, 2 2)\nLINESTRING (0 2, 2 0)\n";
    says(crossing_lines, "", &["BROKEN  1 violation in ", "not valid: 1 violation; "]);
    let spike = "POLYGON ((0 0, 2 0, 2 2, 3 3, 2 2, 0 2, 0 0))\n";
    says(spike, "", &["1 spike"]);
    assert!(!text(spike, "").contains("(s)"));
    let bow = "  ring that touches itself at (2, 2): feature 0, shape 0, ring 0, point 5 (Bow)\n";
    says(IRREGULAR, "", &["1 ring touches itself, 1 spike\n", bow]);
    says("POLYGON((0 0,1 0,1 1))", "--coverage", &["Ring is not closed: a gap of 1.4142"]);
    let column = "the features have no names: --name-from owner takes them from a column\n";
    says(NAMELESS, "", &[column, "warning: 1 feature without geometry: feature 1\n"]);
    let advice = "`twinedge clean` makes the polygons anew";
    says(world(), "--list 1 --explain", &["   … and 1 more of C6; see --list\n", "\nC6: usual cause: ", advice]);
    assert_eq!(text(world(), "--list 1").matches("\nC6 OGC").count(), 1);
    let all = text(crossing(), "--list 100 --explain");
    let [c2, c6, g4, t3] = ["\nC2 gap", "\nC6 OGC", "\n   G4 the borders of Sudan", "\n   T3 the component"]
        .map(|what| all.find(what).expect("listed"));
    assert!(c2 < c6 && c6 < g4 && g4 < t3, "{all}");
    for internal in ["more of C", "geometry::noding", "Expectation::"] {
        assert!(!all.contains(internal), "{all}");
    }
}

const DROPPED: &str = "POLYGON Z ((0 0 5, 1 0 5, 1 1 5, 0 0 5))\nPOINT EMPTY\n";

/// A triangle with an owner, and a feature without geometry.
const NAMELESS: &str = r#"{"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {"owner": "Meier"}, "geometry": {"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 1], [0, 0]]]}},
    {"type": "Feature", "properties": {"owner": "Kunz"}, "geometry": null}]}"#;

/// Returns the keys in alphabetical order.
fn keys(value: &Value) -> String {
    let mut keys: Vec<&str> = value.as_object().unwrap().keys().map(String::as_str).collect();
    keys.sort_unstable();
    keys.join(" ")
}

#[test]
fn machines_get_these_keys() {
    let found = json(crossing(), "");
    let all = "bounds causes consequences counts coverage elapsed_ms first headline import input judged options rules schema valid verdict version \
               violation_count violations warnings";
    assert_eq!(keys(&found), all);
    let counts = "accepted_gaps duplicates findings gap_width gaps mismatches near_misses ogc_invalid overlaps sliver_area slivers unit verdict wider_gaps";
    assert_eq!(keys(&found["coverage"]), counts);
    let counts = "borders components cycles edges faces genus half_edges inner_boundaries isolated_vertices outer_boundaries vertices";
    assert_eq!(keys(&found["counts"]), counts);
    for rule in found["rules"].as_array().unwrap() {
        assert_eq!(keys(rule), "checked id unchecked violations");
    }
    for violation in found["violations"].as_array().unwrap() {
        let mut always = violation.clone();
        for sometimes in ["follows_from", "follows_from_id", "sentence"] {
            always.as_object_mut().unwrap().remove(sometimes);
        }
        assert_eq!(keys(&always), "at feature_numbers features fields id kind message records rule");
    }
}

#[test]
fn two_crossings_are_found_and_named() {
    let found = json(crossing(), "--explain");
    let broken = broken(&found);
    assert!(broken.contains(&("G4", 2)) && broken.contains(&("T3", 1)), "{broken:?}");
    let crossings = [
        [[23.80524, 8.66648], [24.56845, 8.22980], [23.88804, 8.61908], [24.19404, 8.72910]],
        [[33.96094, 9.58384], [33.97534, 8.68509], [33.82414, 9.48398], [33.96454, 9.46367]],
    ];
    let violations = found["violations"].as_array().unwrap();
    let mut matched = [0, 0];
    for violation in violations.iter().filter(|one| one["rule"] == "G4") {
        let places: Vec<[f64; 2]> = serde_json::from_value(violation["at"].clone()).unwrap();
        for (crossing, matched) in crossings.iter().zip(&mut matched) {
            // Coordinates with five decimal places.
            let names = |corner: &[f64; 2]| {
                places.iter().any(|place| (place[0] - corner[0]).abs() < 6e-6 && (place[1] - corner[1]).abs() < 6e-6)
            };
            *matched += usize::from(crossing.iter().all(names));
        }
        assert!(!violation["features"].as_array().unwrap().is_empty());
    }
    assert_eq!(matched, [1, 1]);
    assert_eq!(violations.iter().filter(|one| one["rule"] == "T3").count(), 1);
    assert!(violations.iter().all(|one| one["cause"].is_string() && one["remedy"].is_string()));
}

/// A ring with a repeated point, a contact with itself and a spike, that is not closed.
const IRREGULAR: &str = r#"{"type": "Feature", "properties": {"name": "Bow"}, "geometry":
    {"type": "Polygon", "coordinates": [[[0, 0], [0, 0], [2, 2], [4, 0], [4, 4], [2, 2], [0, 4], [-1, 4], [0, 4]]]}}"#;

#[test]
fn irregular_rings_and_dropped_parts_are_counted() {
    let found = json(IRREGULAR, "");
    has(
        &found["import"],
        &json!({
            "features": 1, "segments": 9, "repeated_segments": 1, "repeated_points": 1, "open_rings": 1, "degenerate_rings": 0,
            "rings_wound_wrongly": 0, "self_touching_rings": 1, "spikes": 1,
        }),
    );
    let spike =
        found["import"]["irregularities"].as_array().unwrap().iter().find(|one| one["kind"] == "spike").unwrap();
    let expected =
        json!({"kind": "spike", "at": [-1.0, 4.0], "feature": 0, "name": "Bow", "shape": 0, "ring": 0, "point": 7});
    assert_eq!(*spike, expected);
    let found = json(DROPPED, "");
    has(&found["import"], &json!({"with_extra_dimensions": 4, "dropped_empty": 1}));
    // An open ring is invalid.
    assert_eq!(json(r#"{"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1]]]}"#, "--coverage")["verdict"], "invalid");
}

/// GeoJSON prescribes the orientation of rings; well-known text doesn't.
#[test]
fn rings_are_judged_by_the_rule_of_their_format() {
    let clockwise = r#"{"type":"Polygon","coordinates":[[[0,0],[0,1],[1,1],[1,0],[0,0]]]}"#;
    for (input, wrong) in [(clockwise, 1), ("POLYGON((0 0,0 1,1 1,1 0,0 0))", 0)] {
        let import = &json(input, "")["import"];
        assert_eq!(import["rings_wound_wrongly"], wrong);
        assert_eq!(import["irregularities"].as_array().unwrap().len(), wrong);
    }
}

#[test]
fn a_file_without_lines_and_polygons_is_refused_with_what_it_has() {
    for (input, what) in [
        (r#"{"type": "FeatureCollection", "features": []}"#, "this file has no features"),
        (r#"{"type": "Feature", "properties": {}, "geometry": null}"#, "this file has 1 feature, none with a geometry"),
        ("POINT (1 2)\nMULTIPOINT ((1 2), (3 4))\n", "this file has 2 features with 3 points and nothing else"),
    ] {
        let said = refused(input, "");
        assert!(said.contains(what), "{said}");
        assert_eq!(json(input, "--allow-empty")["verdict"], "valid", "{what}");
    }
}

#[test]
fn reference_systems_and_the_antimeridian_are_warned_of() {
    let warnings = |crs: Value, far: f64| {
        let ring = [[170.0, 0.0], [far, 0.0], [far, 9.0], [170.0, 9.0], [170.0, 0.0]];
        let feature =
            json!({"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates": [ring]}});
        let layer = json!({"type": "FeatureCollection", "crs": crs, "features": [feature]});
        json(layer.to_string(), "")["warnings"].as_array().unwrap().clone()
    };
    let named = |name: &str| json!({"type": "name", "properties": {"name": name}});
    for usual in [Value::Null, named("urn:ogc:def:crs:OGC:1.3:CRS84"), named("EPSG:4326")] {
        assert_eq!(warnings(usual.clone(), 179.0), [] as [Value; 0], "{usual}");
    }
    for (crs, what) in
        [(named("urn:ogc:def:crs:EPSG::2056"), "coordinate reference system"), (Value::Null, "antimeridian")]
    {
        let found = warnings(crs, -170.0);
        assert!(found.len() == 1 && found[0].as_str().unwrap().contains(what), "{found:?}");
    }
}

/// In the Swiss reference system, in millimetres: no coordinate is a double on a grid of powers of two.
#[test]
fn a_layer_in_millimetres_is_on_a_grid_of_millimetres() {
    let parcels = "POLYGON((2600000.123 1200000.001,2600010.457 1200000.333,2600010.999 1200010.777,2600000.123 1200000.001))\n\
                   POLYGON((2600010.457 1200000.333,2600020.813 1200001.219,2600010.999 1200010.777,2600010.457 1200000.333))\n";
    has(&json(parcels, "--snap 0.001"), &json!({"noding": {"cell": 0.001, "largest_move": [0, 0]}}));
    says(parcels, "--snap 0.001", &["snapped to a grid of 0.001: 0 segments cut"]);
}

#[test]
fn lengths_along_the_earth_are_in_metres() {
    let strips = "POLYGON((0 59,10 59,10 60,0 60,0 59))\nPOLYGON((0 60,5 60.01,10 60,10 61,0 61,0 60))\n";
    let coverage = &json(strips, "--geodesic --gap-width 0.1")["coverage"];
    has(coverage, &json!({"gaps": 1, "unit": "metres"}));
    // A thin strip has no negative area.
    let area = coverage["findings"][0]["area"].as_f64().unwrap();
    assert!((area / 310_809_178.0 - 1.0).abs() < 1e-6, "{area}");
    says(strips, "--geodesic --gap-width 0.1", &["C3  near miss    ok  up to a width of 0.1000 degrees"]);
}

/// Ids and names do not depend on the order of the features. (A component with handles had been named by its first vertex in the file.)
#[test]
fn findings_are_the_same_in_any_order_of_the_features() {
    let mut layer: Value = serde_json::from_str(&crossing()).unwrap();
    let found = |layer: &Value| {
        let found = json(layer.to_string(), "");
        let lists = [&found["violations"], &found["coverage"]["findings"]].map(|list| members(list, &["id"]));
        let ids = lists.iter().flat_map(|list| list.as_array().unwrap());
        let ids: BTreeSet<String> = ids.map(ToString::to_string).collect();
        let mut genus = found["violations"].as_array().unwrap().clone();
        genus.retain(|one| one["rule"] == "T3");
        (ids, members(&genus.into(), &["at", "id"]))
    };
    let before = found(&layer);
    assert_eq!((before.0.len(), before.1.as_array().unwrap().len()), (10, 1));
    layer["features"].as_array_mut().unwrap().reverse();
    assert_eq!(found(&layer), before);
    layer["features"].as_array_mut().unwrap().rotate_left(50);
    assert_eq!(found(&layer), before);
}
