//! Equality of maps: equal if and only if their structures with keys, points, features and names are equal.

use crate::support::saved::each_change;
use serde_json::{from_value, to_value};
use std::collections::BTreeMap;
use twinedge::dcel::{Face, FaceKey, HalfEdge, HalfEdgeKey};
use twinedge_map::edit::EditError;
use twinedge_map::{Builder, PlanarMap, Shape};

/// Two parcels side by side, one of them named, with a pond in one, and a line and a point nearby.
fn sample() -> PlanarMap {
    let square = |x: f64| Shape::polygon([[x, 0.0], [x + 4.0, 0.0], [x + 4.0, 4.0], [x, 4.0]]);
    let mut builder = Builder::new();
    builder.shape(&square(0.0).hole([[1.0, 1.0], [1.0, 2.0], [2.0, 1.0]])).unwrap();
    builder.shape(&square(4.0)).unwrap();
    builder.shape(&Shape::line([[4.0, 0.0], [4.0, 4.0]])).unwrap();
    builder.shape(&Shape::Point([9.0, 9.0].into())).unwrap();
    let mut map = builder.build().unwrap();
    map.add_feature(Some("fallow".to_owned()));
    map
}

/// A map is saved completely. A saved map with one change is refused or loads as another map, unless the change affects only
/// findings of the builder, or the generation of an unused slot.
#[test]
fn another_point_feature_name_or_link_makes_a_difference() {
    let map = sample();
    let saved = to_value(&map).unwrap();
    let mut seen = BTreeMap::new();
    each_change(&saved, |place, changed| {
        let Ok(other) = from_value::<PlanarMap>(changed) else { return };
        let is_beside = place.starts_with("/summary") || place.starts_with("/noding");
        let is_vacant = place.starts_with("/dcel/generations") && other.dcel() == map.dcel();
        assert_eq!(other == map, is_beside || is_vacant, "{place}");
        let kind = place.split('/').nth(1).unwrap_or_default();
        *seen.entry(kind.to_owned()).or_insert(0) += 1;
    });
    let kinds: Vec<&str> = seen.keys().map(String::as_str).collect();
    assert_eq!(kinds, ["dcel", "edges", "faces", "names", "points", "sets", "summary"], "{seen:?}");
}

#[test]
fn an_edit_makes_a_difference_until_it_is_undone() {
    type Step<'a> = &'a dyn Fn(&mut PlanarMap) -> Result<(), EditError>;
    let sample = sample();
    let dcel = sample.dcel();
    let of_face = |f: FaceKey| sample.features_of(f).unwrap().collect::<Vec<_>>();
    let along = |h: HalfEdgeKey| sample.features_along(h).unwrap().collect::<Vec<_>>();
    let field = dcel.faces().map(Face::key).find(|f| !of_face(*f).is_empty()).unwrap();
    let road = dcel.edges().map(HalfEdge::key).find(|h| !along(*h).is_empty()).unwrap();
    let lone = dcel.vertices().find(|v| v.isolated().is_some()).unwrap().key();
    let steps: [(Step<'_>, Step<'_>); 4] = [
        (&|map| map.insert_point([2.5, 3.0]).map(drop), &|map| {
            let made = map.dcel().vertices().last().unwrap().key();
            map.remove_vertex(made).map(drop)
        }),
        (&|map| map.move_vertex(lone, [10.0, 9.0]), &|map| map.move_vertex(lone, [9.0, 9.0])),
        (&|map| map.set_features_of(field, []), &|map| map.set_features_of(field, of_face(field))),
        (&|map| map.set_features_along(road, []), &|map| map.set_features_along(road, along(road))),
    ];
    for (does, undoes) in steps {
        let mut map = sample.clone();
        assert_eq!(map, sample);
        does(&mut map).unwrap();
        assert_ne!(map, sample);
        undoes(&mut map).unwrap();
        assert_eq!(map, sample);
    }
    // A feature is permanent, even if it covers nothing.
    let mut map = sample.clone();
    map.add_feature(None);
    assert_ne!(map, sample);
}

#[test]
fn a_vertex_is_an_index_of_its_point() {
    let map = sample();
    assert!(map.dcel().vertices().all(|v| map.position(v.key()) == Ok(map[v.key()])));
}

#[test]
#[should_panic(expected = "names no vertex of this structure (any more)")]
fn a_stale_vertex_is_no_index() {
    let _ = sample()[sample().dcel().vertices().next().unwrap().key()];
}

#[test]
fn the_debug_form_is_one_short_line() {
    let expected = "PlanarMap { vertices: 10, edges: 10, faces: 4, features: 5, plane: true, .. }";
    assert_eq!(format!("{:?}", sample()), expected);
}
