//! Findings of C1 … C7: counts, measures and places, accepted gaps, snapping, and consequences.

use crate::shared::{has, members};
use crate::support::{broken, json, says};
use serde_json::{Value, json};

/// Three parcels: the second begins 0.05 inside the first, and the third 0.05 behind the second.
const PARCELS: &str = r#"{"type": "FeatureCollection", "features": [
    {"type": "Feature", "id": "A-1", "properties": {"name": "Meadow"}, "geometry":
        {"type": "Polygon", "coordinates": [[[0, 0], [10, 0], [10, 10], [0, 10], [0, 0]]]}},
    {"type": "Feature", "id": "A-2", "properties": {}, "geometry":
        {"type": "Polygon", "coordinates": [[[9.95, 0], [20, 0], [20, 10], [9.95, 10], [9.95, 0]]]}},
    {"type": "Feature", "id": "A-3", "properties": {}, "geometry":
        {"type": "Polygon", "coordinates": [[[20.05, 0], [30, 0], [30, 10], [20.05, 10], [20.05, 0]]]}}]}"#;

/// The input of <https://github.com/libgeos/geos/issues/1525>.
const MISMATCH: &str = "POLYGON((1 0,1 1,1 3,4 0,1 0))\nPOLYGON((0 4,1 3,1 0,0 4))\n";

/// Two parcels with a spindle-shaped gap between them, 10 wide in the middle.
pub(crate) const SPINDLE: &str =
    "POLYGON((0 -20,100 -20,100 0,90 0,50 -5,10 0,0 0,0 -20))\nPOLYGON((0 0,10 0,50 5,90 0,100 0,100 20,0 20,0 0))\n";

#[test]
fn people_read_these_lines() {
    let overlap = "C1 overlap: Meadow (id A-1), id A-2; area 0.5000, width 0.0498, borders of 20.1000; at (9.97";
    says(PARCELS, "", &["\n  C1  overlap      1 overlap\n", overlap]);
    let missing = "C7 mismatch: feature 0, feature 1; 1 vertex missing in feature 1; at (1, 1)\n";
    let follow = "\n   from which follow 2 violations of G4, 1 violation of T3\n";
    let verdict = "\nnot valid: 1 finding, from which 3 others follow · structure not valid · coverage: 1 mismatch;";
    says(MISMATCH, "", &["\n  C7  mismatch     1 mismatch\n", missing, follow, verdict]);
    let accepted = "C2  gap          ok  2 gaps accepted by place are not listed\n";
    says(LAKES, "--coverage --accept-gap 12,12 --accept-gap 60,20", &[accepted]);
    let wider = "C2  gap          ok  1 gap wider than 1.0000 is not listed\n";
    says(SPINDLE, "--gap-width 1", &[wider, "C3  near miss    ok"]);
}

#[test]
fn overlaps_and_near_misses_have_features_and_measures() {
    let coverage = &json(PARCELS, "")["coverage"];
    let counts = json!({"overlaps": 1, "gaps": 0, "near_misses": 1, "slivers": 0, "duplicates": 0, "ogc_invalid": 0});
    has(coverage, &counts);
    let features = json!([{"number": 0, "id": "A-1", "name": "Meadow"}, {"number": 1, "id": "A-2", "name": null}]);
    let kinds = json!([{"rule": "C1", "kind": "overlap", "features": features}, {"rule": "C3"}]);
    has(&coverage["findings"], &kinds);
    let near = |finding: usize, what: &str, expected: f64| {
        let found = coverage["findings"][finding][what].as_f64().unwrap();
        assert!((found - expected).abs() < 1e-9, "{what}: {found}");
    };
    near(0, "area", 0.5);
    near(0, "length", 20.1);
    near(1, "width", 0.05);
    near(1, "length", 20.0);
}

#[test]
fn a_missing_vertex_is_named_and_what_follows_from_it() {
    let found = json(MISMATCH, "");
    assert_eq!(broken(&found), [("T3", 1), ("G4", 2)]);
    assert_eq!(members(&found["violations"], &["follows_from"]), json!(["C7", "C7", "C7"]));
    let finding = json!({
        "rule": "C7", "kind": "mismatch", "features": [{"number": 0, "name": null}, {"number": 1, "name": null}], "at": [1, 1],
        "missing": [{"at": [1, 1], "feature": 1}], "length": 3, "area": null, "width": null,
    });
    has(&found, &json!({"verdict": "invalid", "coverage": {"mismatches": 1, "findings": [finding]}}));
    // Snapping does not hide it.
    for snap in ["auto", "0.5"] {
        let found = json(MISMATCH, &format!("--snap {snap}"));
        assert_eq!(broken(&found), []);
        has(&found, &json!({"verdict": "valid", "coverage": {"mismatches": 1, "findings": [{"snapping": "removed"}]}}));
        assert_eq!(json(MISMATCH, &format!("--coverage --snap {snap}"))["verdict"], "invalid");
    }
}

/// A crossing elsewhere does not follow from the missing vertex.
#[test]
fn a_crossing_beside_a_missing_vertex_does_not_follow_from_it() {
    let crossing = "POLYGON((10 0,14 0,14 4,10 4,10 0))\nPOLYGON((12 2,16 2,16 6,12 6,12 2))\n";
    let found = json(format!("{MISMATCH}{crossing}"), "");
    let pairs = members(&found["violations"], &["rule", "follows_from"]);
    let of = |pair: Value| pairs.as_array().unwrap().iter().filter(|one| **one == pair).count();
    assert_eq!([of(json!(["G4", "C7"])), of(json!(["G4", "C1"]))], [2, 2]);
    // The two squares are separate components without a handle.
    assert_eq!([of(json!(["T3", "G4"])), of(json!(["T3", "C7"]))], [1, 0]);
}

/// Two lakes with mean widths of 2 and 10 in one parcel, and a strip of 0.25 between two parcels.
const LAKES: &str =
    "POLYGON((0 0,100 0,100 40,0 40,0 0),(10 10,14 10,14 14,10 14,10 10),(50 10,70 10,70 30,50 30,50 10))
POLYGON((100.25 0,120 0,120 40,100.25 40,100.25 0))
";

#[test]
fn gaps_are_accepted_by_width_and_by_place() {
    for (words, [gaps, near_misses, wider_gaps, accepted_gaps]) in [
        ("", [2, 0, 0, 0]),
        // By width, separately from near misses.
        ("--lake-width 5", [1, 0, 1, 0]),
        ("--lake-width 1 --gap-width 0.1", [0, 0, 2, 0]),
        ("--lake-width 1 --gap-width 0.3", [0, 1, 2, 0]),
        // By place.
        ("--accept-gap 12,12 --gap-width 0.1", [0, 0, 1, 1]),
        ("--accept-gap 12,12 --accept-gap 60,20", [0, 0, 0, 2]),
        ("--accept-gap -12,12", [2, 0, 0, 0]),
    ] {
        let found = json(LAKES, &format!("--coverage {words}"));
        let counts =
            json!({"gaps": gaps, "near_misses": near_misses, "wider_gaps": wider_gaps, "accepted_gaps": accepted_gaps});
        let verdict = if gaps + near_misses == 0 { "valid" } else { "invalid" };
        has(&found, &json!({"verdict": verdict, "coverage": counts}));
    }
    has(&json(SPINDLE, "--gap-width 1"), &json!({"coverage": {"wider_gaps": 1, "near_misses": 0}}));
}

#[test]
fn findings_make_a_map_invalid_only_if_asked() {
    let gap = PARCELS.replace("9.95", "10").replace("20.05", "20.25");
    for (words, valid, near_misses) in
        [("", true, 0), ("--gap-width 0.3", true, 1), ("--gap-width 0.3 --coverage", false, 1), ("--coverage", true, 0)]
    {
        has(&json(&*gap, words), &json!({"valid": valid, "coverage": {"near_misses": near_misses}}));
    }
    let thin = PARCELS.replace("[30, 10], [20.05, 10]", "[30, 0.1], [20.05, 0.1]");
    has(&json(thin, "--sliver 1000")["coverage"], &json!({"slivers": 1, "sliver_area": 1000}));
}

#[test]
fn what_snapping_removes_or_makes_is_reported() {
    has(&json(PARCELS, "--snap auto"), &json!({"valid": true, "coverage": {"overlaps": 1}}));
    let findings = json(PARCELS, "--snap 1")["coverage"]["findings"].clone();
    assert_eq!(members(&findings, &["rule", "snapping"]), json!([["C1", "removed"], ["C3", "removed"]]));
    // On a coarse grid, the mouth of a bay between two parcels closes and creates a gap.
    let bay = "POLYGON ((0 0, 10 0, 10 4, 4 4, 4 8, 6.9 8, 6.9 10, 0 10, 0 0))\n\
               POLYGON ((10 0, 20 0, 20 10, 7.1 10, 7.1 8, 10 8, 10 4, 10 0))\n";
    let mut findings = json(bay, "--snap 1")["coverage"]["findings"].as_array().unwrap().clone();
    findings.retain(|one| one["snapping"] == "made");
    assert_eq!(members(&findings.into(), &["rule"]), json!(["C2"]));
}

#[test]
fn polygons_that_are_not_valid_are_named_in_the_words_of_the_ogc() {
    let nested = "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 8 1, 8 8, 1 8, 1 1), (2 2, 3 2, 3 3, 2 3, 2 2))\n";
    let found = json(nested, "");
    let finding = found["coverage"]["findings"].as_array().unwrap().iter().find(|one| one["rule"] == "C6").unwrap();
    assert_eq!(finding["defects"], json!([{"reason": "Holes are nested", "at": [2.0, 2.0], "shape": 0, "ring": 2}]));
}

/// A hole touches the middle of a side of its shell, and a part touches the side of another part: valid for the OGC, GEOS and C6.
#[test]
fn a_touch_that_the_ogc_allows_is_no_fault() {
    let touch = "POLYGON((0 0,10 0,10 10,0 10,0 0),(0 5,3 4,3 6,0 5))\n\
                 MULTIPOLYGON(((20 0,30 0,30 10,20 10,20 0)),((30 5,33 4,33 6,30 5)))\n";
    for words in ["", "--tiles 2"] {
        // The holes are gaps, which this test ignores.
        has(&json(touch, words), &json!({"valid": true, "coverage": {"ogc_invalid": 0, "mismatches": 0}}));
    }
}

/// A cell is at least 10^17 / 2^50 wide, and edges of 10 are shorter than the next power of two.
const TOO_WIDE: &str =
    "half of the edges are shorter than 16.0000, and the grid that cuts crossing borders has cells of at least 88.8178";

/// Regression: on the finest grid for a coordinate of 10^17 a cell is 128 wide. The squares and their overlap were lost, and C1 was "ok".
#[test]
fn a_coverage_is_not_checked_where_a_coordinate_far_away_makes_the_grid_too_wide() {
    let squares = "POLYGON((0 0,10 0,10 10,0 10,0 0))\nPOLYGON((5 5,15 5,15 15,5 15,5 5))\n";
    let far = format!("{squares}POINT(1e17 0)\n");
    for words in ["", "--tiles 2", "--coverage --snap auto"] {
        has(&json(squares, words), &json!({"verdict": "invalid", "coverage": {"overlaps": 1, "not_checked": null}}));
        // Snapped, the map keeps the rules of the structure, but it no longer has the squares.
        let found = json(&*far, words);
        assert_eq!(found["coverage"]["not_checked"], TOO_WIDE, "{words}");
        assert_ne!(found["verdict"], "valid", "{words}");
        assert!(words.contains("snap") || found["verdict"] == "invalid", "{words}");
    }
    // A plane map is not cut.
    let plane = json("POLYGON((0 0,10 0,10 10,0 10,0 0))\nPOINT(1e17 0)\n", "--coverage");
    has(&plane, &json!({"verdict": "valid", "coverage": {"not_checked": null}}));
}
