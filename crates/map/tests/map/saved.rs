//! Saved maps: loading restores the map with its keys, and accepts only plane maps.

use crate::support::drawn::crossing;
use quickcheck::{Gen, QuickCheck};
use serde_json::{Value, json};
use twinedge_geometry::Point;
use twinedge_geometry::noding::Snap;
use twinedge_map::{Builder, Feature, Noding, PlanarMap, Shape};

/// Returns true if the maps are equal, including the summaries.
fn is_same(map: &PlanarMap, again: &PlanarMap) -> bool {
    map == again && map.summary() == again.summary() && map.noding() == again.noding()
}

fn saved(map: &PlanarMap) -> Value {
    serde_json::to_value(map).unwrap()
}

fn loaded(saved: Value) -> Result<PlanarMap, String> {
    serde_json::from_value(saved).map_err(|error: serde_json::Error| error.to_string())
}

/// A map with features, edges without features, isolated vertices, and reused slots.
fn edited(segments: &[(i8, i8, i8, i8)], rings: &[(i8, i8, u8)], edits: &[(i8, i8, bool)]) -> PlanarMap {
    let mut builder = Builder::new();
    for (a, b, c, d) in segments {
        builder.segment([f64::from(*a), f64::from(*b)], [f64::from(*c), f64::from(*d)]).unwrap();
    }
    for (i, (x, y, size)) in rings.iter().enumerate() {
        let (x, y, size) = (f64::from(*x), f64::from(*y), f64::from(*size));
        let ring = [[x, y], [x + size, y], [x, y + size]];
        let name = (i % 2 == 0).then(|| format!("ring {i} \u{1F600}"));
        builder.feature(&Feature { name, shapes: vec![Shape::polygon(ring)], ..Feature::default() }).unwrap();
    }
    let mut map = builder.build_with(Noding::Snap(Snap::Size(1.0))).unwrap();
    for (x, y, removes) in edits {
        let at = [f64::from(*x), f64::from(*y)];
        let outcome = map.insert_segment_snapped([0.0, 0.0], at, Snap::Size(1.0));
        let edge = outcome.ok().and_then(|edited| edited.way.first().copied());
        match edge.filter(|_| *removes) {
            Some(edge) => drop(map.remove_edge(edge).unwrap()),
            None => drop(map.insert_point(at).unwrap()),
        }
    }
    map
}

type Edits = (Vec<(i8, i8, i8, i8)>, Vec<(i8, i8, u8)>, Vec<(i8, i8, bool)>);

#[test]
fn what_is_loaded_is_what_was_saved() {
    fn law((segments, rings, edits): Edits) -> bool {
        let mut map = edited(&segments, &rings, &edits);
        let text = serde_json::to_string(&map).unwrap();
        let mut again: PlanarMap = serde_json::from_str(&text).unwrap();
        let same = is_same(&map, &again) && serde_json::to_string(&again).unwrap() == text;
        // Both can be edited further. The order of vacant slots is not saved, so new keys may differ.
        let [ours, theirs] = [&mut map, &mut again].map(|map| {
            let made = map.insert_ring([[1000.0, 0.0], [1001.0, 0.0], [1000.0, 1.0]]).unwrap();
            (made.way.len(), made.faces_split.len(), map.dcel().face_count())
        });
        same && ours == theirs && again.validate().is_valid()
    }
    QuickCheck::new().rng(Gen::from_size_and_seed(12, 2026)).tests(80).quickcheck(law as fn(Edits) -> bool);
}

#[test]
fn the_empty_map_and_points_alone() {
    let mut map = PlanarMap::new();
    assert!(is_same(&map, &loaded(saved(&map)).unwrap()));
    let gone = map.insert_point([1.0, 1.0]).unwrap().vertices[0];
    let kept = map.insert_point([-0.0, 1e-100]).unwrap().vertices[0];
    map.remove_vertex(gone).unwrap();
    let again = loaded(saved(&map)).unwrap();
    assert_eq!(again.position(kept), Ok(Point::new(0.0, 1e-100)));
    assert!(again.position(gone).is_err(), "a stale key stays stale");
}

fn square() -> PlanarMap {
    edited(&[(9, 9, 12, 9)], &[(0, 0, 4), (6, 0, 2)], &[])
}

#[test]
fn garbage_is_an_error() {
    let good = saved(&square());
    assert!(loaded(good.clone()).is_ok());
    let cases: [(&str, Value, &str); 10] = [
        ("/form", json!(2), "form 2 of a map is not known"),
        ("/points", json!([[0.0, 0.0]]), "there are 1 entries for 8 vertices"),
        ("/faces", json!([]), "there are 0 entries for 3 faces"),
        ("/edges", json!([0]), "there are 1 entries for 7 edges"),
        ("/faces/1", json!(99), "there is no set 99 of features"),
        ("/edges/0", json!(99), "there is no set 99 of features"),
        ("/sets/1", json!([7]), "set 1 of features is not sorted, or has a feature that the map does not have"),
        ("/sets/1", json!([1, 0]), "set 1 of features is not sorted"),
        ("/removed", json!([7]), "feature 7 cannot have been removed"),
        ("/points/0", json!([100.0, 100.0]), "the map is not valid:"),
    ];
    for (place, value, says) in cases {
        let mut bad = good.clone();
        *bad.pointer_mut(place).unwrap() = value;
        let error = loaded(bad).unwrap_err();
        assert!(error.starts_with(says), "{place}: {error}");
    }
    let mut more = good.clone();
    more["more"] = json!(1);
    assert!(loaded(more).unwrap_err().contains("unknown field"));
    let mut links = good;
    let next = links.pointer_mut("/dcel/next").unwrap();
    next[0] = next[2].clone();
    assert!(loaded(links).is_err());
}

#[test]
fn a_map_that_is_not_plane_is_not_saved() {
    let error = serde_json::to_string(&crossing()).unwrap_err();
    assert_eq!(error.to_string(), "a map that is not plane cannot be saved");
}
