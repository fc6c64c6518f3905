//! Building maps: merged, dropped and refused input, nesting, and the faces that each feature covers.

use crate::location::maps::world_110m;
use crate::support::drawn::area;
use crate::support::exact::{Grid, Meets, meets, point};
use quickcheck::{QuickCheck, TestResult};
use std::collections::BTreeSet;
use twinedge::dcel::Face;
use twinedge_algorithm::lattice;
use twinedge_algorithm::overlay::overlay;
use twinedge_coverage::{Limits, check, layers};
use twinedge_geometry::Point;
use twinedge_geometry::noding::Snap;
use twinedge_map::{BuildError, Builder, Feature, FeatureId, PlanarMap, Position, QueryLine, Shape};

/// A rectangle with a vertex at every whole number, so that rectangles on whole numbers meet only at vertices.
pub(crate) fn rectangle([x0, y0]: [i32; 2], [x1, y1]: [i32; 2]) -> Vec<Point> {
    let at = |x: i32, y: i32| Point::new(f64::from(x), f64::from(y));
    let mut ring = Vec::new();
    ring.extend((x0..x1).map(|x| at(x, y0)));
    ring.extend((y0..y1).map(|y| at(x1, y)));
    ring.extend((x0 + 1..=x1).rev().map(|x| at(x, y1)));
    ring.extend((y0 + 1..=y1).rev().map(|y| at(x0, y)));
    ring.push(at(x0, y0));
    ring
}

/// The area of all faces that a feature covers.
fn covered_area(map: &PlanarMap, feature: FeatureId) -> f64 {
    let covers = |f: &Face<'_>| map.features_of(f.key()).expect("it is of this map").any(|g| g == feature);
    map.dcel().faces().filter(covers).map(|f| area(map, f)).sum()
}

#[test]
fn repeated_points_and_segments_become_one() {
    let mut builder = Builder::new();
    builder.shape(&Shape::line([[0.0, 0.0], [1.0, 0.0], [1.0, 0.0], [1.0, 1.0]])).expect("in range");
    builder.shape(&Shape::line([[1.0, 0.0], [-0.0, -0.0]])).expect("in range");
    builder.shape(&Shape::Point(Point::new(1.0, 1.0))).expect("in range");
    builder.shape(&Shape::Point(Point::new(5.0, 5.0))).expect("in range");
    let map = builder.build().expect("fits");
    assert_eq!((map.dcel().vertex_count(), map.dcel().edge_count(), map.dcel().face_count()), (4, 2, 1));
    let summary = map.summary();
    assert_eq!((summary.segments, summary.duplicate_segments, summary.zero_length_segments), (4, 1, 1));
    assert!(map.validate().is_valid());
    assert_eq!(map.validate().counts().isolated_vertices, 1);
}

#[test]
fn nothing_at_all_is_the_empty_map() {
    let map = Builder::new().build().expect("fits");
    assert_eq!(map.dcel().face_count(), 1);
    assert!(map.validate().is_valid());
}

#[test]
fn a_ring_left_open_is_closed_and_a_flat_one_encloses_nothing() {
    let mut builder = Builder::new();
    let open = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(Point::from).to_vec();
    builder.shape(&Shape::Polygon(vec![open])).expect("in range");
    let flat = builder.shape(&Shape::polygon([[5.0, 0.0], [6.0, 0.0], [5.0, 0.0]])).expect("in range");
    let map = builder.build().expect("fits");
    assert_eq!((map.summary().open_rings, map.summary().degenerate_rings), (1, 1));
    assert_eq!(map.dcel().face_count(), 2);
    assert!(map.dcel().faces().all(|f| map.features_of(f.key()).expect("of this map").all(|g| g != flat)));
}

#[test]
fn bad_coordinates_are_refused_with_their_position_and_nothing_is_taken() {
    let mut builder = Builder::new();
    builder.segment([0.0, 0.0], [1.0, 1.0]).expect("in range");
    let good = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    let bad = |x, y| {
        let bad = [good[0], good[1], [x, y]];
        Feature { shapes: vec![Shape::line(good), Shape::polygon(good).hole(bad)], ..Feature::default() }
    };
    let position = Position { feature: 1, shape: 1, ring: 1, point: 2 };
    assert!(
        matches!(builder.feature(&bad(f64::NAN, 0.0)), Err(BuildError::NotFinite { position: p, .. }) if p == position)
    );
    let infinite = builder.feature(&bad(0.0, f64::NEG_INFINITY));
    assert_eq!(infinite, Err(BuildError::NotFinite { position, x: 0.0, y: f64::NEG_INFINITY }));
    let large = builder.feature(&bad(1e200, 0.0));
    assert_eq!(large, Err(BuildError::OutOfRange { position, x: 1e200, y: 0.0 }));
    let tiny = builder.feature(&bad(0.0, 1e-200));
    assert_eq!(
        tiny.map_err(|error| error.to_string()),
        Err(format!(
            "{position}: the coordinates (0.0, 1e-200) are out of range: magnitudes must be zero or from 2^-400 to 2^500"
        ))
    );
    let map = builder.build().expect("fits");
    assert_eq!((map.dcel().vertex_count(), map.dcel().edge_count()), (2, 1));
}

#[test]
fn islands_lie_in_the_lake_that_lies_in_the_island() {
    let mut builder = Builder::new();
    for (low, high) in [(0, 20), (2, 18), (4, 16), (6, 14)] {
        builder.shape(&Shape::polygon(rectangle([low, low], [high, high]))).expect("in range");
    }
    let map = builder.build().expect("fits");
    assert!(map.validate().is_valid());
    let areas: BTreeSet<i64> = map
        .dcel()
        .faces()
        .filter(|f| !f.is_unbounded())
        .map(|f| {
            #[allow(clippy::cast_possible_truncation, reason = "areas of small squares are whole numbers")]
            let area = area(&map, f) as i64;
            area
        })
        .collect();
    assert_eq!(areas, BTreeSet::from([400 - 256, 256 - 144, 144 - 64, 64]));
    // Each is covered by itself and by all polygons around it.
    let mut covers: Vec<usize> =
        map.dcel().faces().map(|f| map.features_of(f.key()).expect("of this map").count()).collect();
    covers.sort_unstable();
    assert_eq!(covers, [0, 1, 2, 3, 4]);
}

#[test]
fn a_feature_of_many_polygons_covers_what_any_of_them_covers() {
    // Side by side, one inside the other, and one repeated, which makes no difference.
    let parts = [([0, 0], [4, 4]), ([4, 0], [8, 4]), ([1, 1], [3, 3]), ([20, 0], [24, 4]), ([20, 0], [24, 4])];
    let shapes = parts.map(|(low, high)| Shape::polygon(rectangle(low, high)));
    let mut builder = Builder::new();
    let feature = builder.feature(&Feature { shapes: shapes.to_vec(), ..Feature::default() }).expect("in range");
    let other = builder.shape(&Shape::polygon(rectangle([5, 1], [6, 2]))).expect("in range");
    let map = builder.build().expect("fits");
    assert!((covered_area(&map, feature) - 48.0).abs() < 1e-12);
    assert!((covered_area(&map, other) - 1.0).abs() < 1e-12);
}

#[test]
fn ten_thousand_polygons_inside_each_other_cover_each_other() {
    const DEPTH: i32 = 10_000;
    let mut builder = Builder::new();
    for i in 0..DEPTH {
        let (low, high) = (f64::from(i), f64::from(4 * DEPTH - i));
        builder.shape(&Shape::polygon([[low, low], [high, low], [high, high], [low, high]])).expect("in range");
    }
    let map = builder.build().expect("fits");
    for face in map.dcel().faces().step_by(999) {
        let covers: Vec<usize> = map.features_of(face.key()).expect("of this map").map(|f| f.index()).collect();
        // The corner of its outer cycle closest to the origin belongs to the smallest polygon around it.
        let corners = face.outer().into_iter().flat_map(|b| b.half_edges());
        let low = corners.map(|h| map.position(h.origin().key()).expect("of this map").x).fold(f64::NAN, f64::min);
        let around = if low.is_nan() { 0.0 } else { low + 1.0 };
        assert!((covers.len() as f64 - around).abs() < 0.5);
        assert!(covers.iter().copied().eq(0..covers.len()));
    }
}

#[test]
fn a_hole_that_touches_its_shell_at_a_vertex_is_no_hole_of_the_map() {
    let shell = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [0.0, 0.0]];
    let hole = [[0.0, 0.0], [1.0, 2.0], [2.0, 1.0], [0.0, 0.0]];
    let mut builder = Builder::new();
    let feature = builder.shape(&Shape::polygon(shell).hole(hole)).expect("in range");
    let map = builder.build().expect("fits");
    let report = map.validate();
    assert!(report.is_valid());
    assert_eq!((report.counts().components, report.counts().faces), (Some(1), 3));
    assert!((covered_area(&map, feature) - (16.0 - 1.5)).abs() < 1e-12);
}

/// Arbitrary rectangles on a small grid.
fn a_feature_covers_its_rectangles(rectangles: Vec<(u8, u8, u8, u8)>, hole: bool) -> TestResult {
    let mut builder = Builder::new();
    let mut expected = Vec::new();
    for (x, y, w, h) in rectangles.into_iter().take(6) {
        let (x, y, w, h) = (i32::from(x % 8), i32::from(y % 8), i32::from(w % 5) + 1, i32::from(h % 5) + 1);
        let mut shape = Shape::polygon(rectangle([x, y], [x + w, y + h]));
        let mut area = w * h;
        if hole && w > 2 && h > 2 {
            shape = shape.hole(rectangle([x + 1, y + 1], [x + w - 1, y + h - 1]));
            area -= (w - 2) * (h - 2);
        }
        let feature = builder.shape(&shape).expect("in range");
        expected.push((feature, area));
    }
    let map = builder.build().expect("fits");
    if !map.validate().is_valid() {
        return TestResult::error(map.validate().to_string());
    }
    for (feature, area) in expected {
        let covered = covered_area(&map, feature);
        if (covered - f64::from(area)).abs() > 1e-9 {
            return TestResult::error(format!("feature {} covers {covered} of {area}", feature.index()));
        }
    }
    TestResult::passed()
}

#[test]
fn features_cover_their_area_and_no_more() {
    QuickCheck::new()
        .tests(400)
        .quickcheck(a_feature_covers_its_rectangles as fn(Vec<(u8, u8, u8, u8)>, bool) -> TestResult);
}

/// Arbitrary segments on a small grid: built, and valid if and only if no two of them clash.
fn built_and_judged(segments: Vec<((u8, u8), (u8, u8))>, thin_out: bool) -> bool {
    let whole = |(x, y): (u8, u8)| (i32::from(x % 7), i32::from(y % 7));
    let mut kept: Vec<[Grid; 2]> = Vec::new();
    let mut clashes = false;
    for (from, to) in segments {
        let mut segment = [whole(from), whole(to)];
        segment.sort_unstable();
        if segment[0] == segment[1] || kept.contains(&segment) {
            continue;
        }
        let meets = |[c, d]: &[Grid; 2]| meets(segment[0], segment[1], *c, *d);
        let bad = kept.iter().any(|other| !matches!(meets(other), Meets::No | Meets::AtEnds));
        if !(bad && thin_out) {
            clashes |= bad;
            kept.push(segment);
        }
    }
    let mut builder = Builder::new();
    for [from, to] in &kept {
        builder.segment(point(*from), point(*to)).expect("in range");
    }
    let map = builder.build().expect("fits");
    let vertices: BTreeSet<Grid> = kept.iter().flatten().copied().collect();
    let counted = map.dcel().vertex_count() == vertices.len() && map.dcel().edge_count() == kept.len();
    let whole_plane: f64 = map.dcel().faces().map(|f| area(&map, f)).sum();
    // The area of the unbounded face is minus the area of the bounded ones.
    let tiled = clashes || whole_plane.abs() < 1e-9;
    counted && tiled && map.validate().is_valid() != clashes && map.is_plane() != clashes
}

#[test]
fn any_segments_are_built_and_judged_rightly() {
    QuickCheck::new().tests(1000).quickcheck(built_and_judged as fn(Vec<((u8, u8), (u8, u8))>, bool) -> bool);
}

#[test]
fn the_world_is_covered_by_its_countries() {
    let map = world_110m();
    let named = |name: &str| map.features().find(|f| map.name(*f) == Some(name)).expect("it is on the map");
    let (lesotho, south_africa) = (named("Lesotho"), named("South Africa"));
    let mut contested = 0;
    for face in map.dcel().faces() {
        let features: Vec<FeatureId> = map.features_of(face.key()).expect("of this map").collect();
        contested += usize::from(features.len() > 1);
        assert!(!face.is_unbounded() || features.is_empty());
        if features.contains(&lesotho) {
            assert_eq!(features, [lesotho]);
            assert!(face.neighbours().all(|f| map.features_of(f.key()).expect("of this map").eq([south_africa])));
        }
    }
    // Two slivers, by the provenance of the data. (Ray casting with plain floats finds three countries on each.)
    assert_eq!(contested, 2);
}

fn built(segments: &[[[f64; 2]; 2]]) -> PlanarMap {
    let mut builder = Builder::new();
    for [from, to] in segments {
        builder.segment(*from, *to).unwrap();
    }
    builder.build().unwrap()
}

#[test]
fn a_refusal_says_where_edges_meet_and_what_cuts_them() {
    for (segments, at) in [
        ([[[0.0, 0.0], [2.0, 2.0]], [[0.0, 2.0], [2.0, 0.0]]], "(1, 1)"),
        ([[[0.0, 0.0], [4.0, 0.0]], [[3.0, 0.0], [3.0, 2.0]]], "(3, 0)"),
        ([[[0.0, 0.0], [4.0, 0.0]], [[4.0, 0.0], [2.0, 0.0]]], "(4, 0)"),
    ] {
        let mut map = built(&segments);
        let mut refusals = vec![
            map.zone(&QueryLine::Line([0.0, 0.0].into(), [5.0, 5.0].into())).unwrap_err().to_string(),
            map.locate([5.0, 5.0].into()).unwrap_err().to_string(),
            lattice::of_map(&map).unwrap_err().to_string(),
            check(&map, &Limits::default()).unwrap_err().to_string(),
            layers::check(&map, 1, &[]).unwrap_err().to_string(),
            layers::check_parents(&map, &[], &[]).unwrap_err().to_string(),
            layers::pieces(&map, 1).unwrap_err().to_string(),
            overlay(&map, &PlanarMap::new(), Snap::Auto).unwrap_err().to_string(),
        ];
        refusals.push(map.insert_point([5.0, 5.0]).unwrap_err().to_string());
        for said in refusals {
            assert!(said.contains(&format!("as at {at}; `Builder::build_with(Noding::Snap(")), "{said}");
        }
    }
}

#[test]
fn the_place_of_a_crossing_is_near_both_edges_however_large_they_are() {
    for scale in [1e-60, 1.0, 1e100] {
        let [a, b] = [[-3.0, -1.0], [9.0, 3.0]].map(|p: [f64; 2]| p.map(|x| x * scale));
        let [c, d] = [[1.0, 5.0], [2.0, -4.0]].map(|p: [f64; 2]| p.map(|x| x * scale));
        let at = built(&[[a, b], [c, d]]).not_plane().unwrap().at.unwrap();
        assert!(at.x >= scale && at.x <= 2.0 * scale && at.y >= 0.0 && at.y <= scale, "{at:?}");
    }
    assert_eq!(built(&[[[0.0, 0.0], [1.0, 0.0]]]).not_plane(), None);
}
