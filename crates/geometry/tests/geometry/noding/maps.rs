//! Real maps with known numbers of vertices, edges and components.

use crate::noding::check::{Segment, check, counts, is_plane};
use twinedge_geometry::Point;
use twinedge_geometry::noding::Snap;

/// The segments of all rings, ring after ring.
pub(crate) fn map(text: &str) -> Vec<Segment> {
    let value: serde_json::Value = serde_json::from_str(text).expect("JSON");
    let mut segments = Vec::new();
    let mut stack: Vec<&serde_json::Value> = value["features"]
        .as_array()
        .expect("features")
        .iter()
        .map(|feature| &feature["geometry"]["coordinates"])
        .collect();
    while let Some(list) = stack.pop().and_then(serde_json::Value::as_array) {
        let points: Vec<Point> =
            list.iter().filter_map(|p| Some(Point::new(p.get(0)?.as_f64()?, p.get(1)?.as_f64()?))).collect();
        if points.is_empty() {
            stack.extend(list);
        }
        segments.extend(points.windows(2).map(|pair| [pair[0], pair[1]]));
    }
    segments
}

#[test]
fn two_crossings_of_the_small_world_are_cut() {
    let noded = check(&map(include_str!("../../../../../tests/data/world-110m-crossing.geojson")), &[], Snap::Auto);
    assert_eq!(counts(&noded), [7_493, 7_655, 125]);
    let summary = noded.summary;
    assert_eq!((summary.crossings, summary.rounds, summary.merged), (2, 1, 0));
    // The published map with its crossings cut has the two points.
    for [x, y] in [[23.888_056_018_6, 8.619_090_951_7], [33.962_861_161_9, 9.463_914_345_4]] {
        assert!(noded.points.iter().any(|p| (p.x - x).abs() < 1e-9 && (p.y - y).abs() < 1e-9));
    }
}

#[test]
fn the_small_world_is_plane_as_it_stands() {
    let noded = check(&map(include_str!("../../../../cli/data/world-110m.geojson")), &[], Snap::Auto);
    assert_eq!(counts(&noded), [7_493, 7_655, 125]);
    assert_eq!((noded.summary.crossings, noded.summary.split, noded.summary.merged), (0, 0, 0));
}

#[test]
fn the_large_world_is_plane_as_it_stands() {
    let rings = map(include_str!("../../../../../tests/data/world-50m.geojson"));
    let noded = check(&rings, &[], Snap::Auto);
    assert_eq!(counts(&noded), [75_685, 75_863, 1_438]);
    assert_eq!((noded.summary.crossings, noded.summary.split, noded.summary.merged), (0, 0, 0));
    assert_eq!(noded.summary.duplicates, rings.len() - 75_863);
    // On a coarse grid many vertices merge, and the rest is plane.
    let coarse = check(&rings, &[], Snap::Size(0.1));
    assert!(is_plane(&coarse) && coarse.summary.merged > 0 && coarse.points.len() < 70_000);
}
