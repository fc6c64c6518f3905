//! Maps of segments that cross, touch and overlap: cut exactly, or snapped to a grid, with features that follow.

use crate::location::maps::features;
use crate::support::drawn::area;
use quickcheck::{Gen, QuickCheck, TestResult};
use std::collections::BTreeSet;
use twinedge::program::choose::{Choose, Random};
use twinedge_geometry::Point;
use twinedge_geometry::noding::{NodingSummary, Snap};
use twinedge_map::{BuildError, Builder, Feature, FeatureId, Noding, PlanarMap, Shape};

type Whole = (i8, i8);

fn at((x, y): Whole) -> Point {
    Point::new(f64::from(x), f64::from(y))
}

fn polygon(corners: &[Whole]) -> Feature {
    Feature { shapes: vec![Shape::Polygon(vec![corners.iter().copied().map(at).collect()])], ..Feature::default() }
}

pub(crate) fn gather(features: &[Feature]) -> Builder {
    let mut builder = Builder::new();
    for feature in features {
        builder.feature(feature).expect("in range");
    }
    builder
}

fn segments(segments: &[(Whole, Whole)]) -> Builder {
    let mut builder = Builder::new();
    for (a, b) in segments {
        builder.segment(at(*a), at(*b)).expect("in range");
    }
    builder
}

fn counts(map: &PlanarMap) -> [usize; 3] {
    [map.dcel().vertex_count(), map.dcel().edge_count(), map.dcel().face_count()]
}

/// The bounded faces, each with its features and its area.
fn covered(map: &PlanarMap) -> Vec<(Vec<usize>, f64)> {
    let bounded = map.dcel().faces().filter(|face| !face.is_unbounded());
    let mut found: Vec<_> = bounded
        .map(|face| {
            let features = map.features_of(face.key()).expect("of this map");
            (features.map(FeatureId::index).collect(), area(map, face))
        })
        .collect();
    found.sort_by(|a, b| a.partial_cmp(b).expect("areas are numbers"));
    found
}

fn points(map: &PlanarMap) -> BTreeSet<[i64; 2]> {
    let at = |v: twinedge::dcel::Vertex<'_>| map.position(v.key()).expect("of this map");
    map.dcel().vertices().map(at).map(|p| [p.x as i64, p.y as i64]).collect()
}

#[test]
fn exact_noding_cuts_at_points_that_lie_on_segments_and_moves_nothing() {
    // A second house adjoins the long wall of the first, which has no point there.
    let houses = [polygon(&[(0, 0), (6, 0), (6, 3), (0, 3)]), polygon(&[(2, 3), (4, 3), (4, 5), (2, 5)])];
    let map = gather(&houses).build_with(Noding::Exact).expect("nothing crosses");
    assert_eq!(counts(&map), [8, 9, 3]);
    assert!(map.validate().is_valid());
    assert_eq!(covered(&map), [(vec![0], 18.0), (vec![1], 4.0)]);
    let noding = map.noding().expect("it was noded");
    assert_eq!((noding.split, noding.duplicates, noding.crossings, noding.largest_move), (1, 1, 0, [0.0, 0.0]));
    // Both houses share the wall between them.
    let shared = map.dcel().half_edges().find(|h| {
        let ends = [h.origin(), h.target()].map(|v| map.position(v.key()).expect("of this map"));
        ends == [at((2, 3)), at((4, 3))]
    });
    let along = map.features_along(shared.expect("it was cut out").key()).expect("of this map");
    assert_eq!(along.map(FeatureId::index).collect::<Vec<_>>(), [0, 1]);
}

#[test]
fn exact_noding_of_what_is_plane_is_the_same_map() {
    let shapes = [polygon(&[(0, 0), (6, 0), (6, 3), (0, 3)]), polygon(&[(1, 1), (3, 1), (3, 2)])];
    let cells = (0..64).map(|i| (i % 8, 10 + i / 8));
    let cells = cells.map(|(x, y)| polygon(&[(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)]));
    let shapes: Vec<Feature> = shapes.into_iter().chain(cells).collect();
    let [plain, cut] =
        [Noding::None, Noding::Exact].map(|noding| gather(&shapes).build_with(noding).expect("nothing crosses"));
    assert_eq!(cut.noding(), Some(&NodingSummary::default()));
    assert!(cut.is_plane() && cut.validate().is_valid());
    let records = |map: &PlanarMap| {
        let at = |v: twinedge::dcel::Vertex<'_>| map.position(v.key()).expect("of this map");
        let of = |h: twinedge::dcel::HalfEdge<'_>| (h.index(), at(h.origin()), h.next().index(), h.face().index());
        map.dcel().half_edges().map(of).collect::<Vec<_>>()
    };
    assert!(records(&plain) == records(&cut));
    assert_eq!(covered(&plain), covered(&cut));
}

#[test]
fn exact_noding_cuts_a_crossing_at_which_the_input_has_a_point() {
    let mut builder = segments(&[((0, 0), (4, 4)), ((0, 4), (4, 0))]);
    builder.shape(&Shape::Point(at((2, 2)))).expect("in range");
    let map = builder.build_with(Noding::Exact).expect("there is a point");
    assert_eq!(counts(&map), [5, 4, 1]);
    assert!(map.validate().is_valid());
}

#[test]
fn exact_noding_refuses_crossings_without_a_point() {
    let tic_tac_toe = [((1, 0), (1, 3)), ((2, 0), (2, 3)), ((0, 1), (3, 1)), ((0, 2), (3, 2)), ((9, 9), (9, 8))];
    match segments(&tic_tac_toe).build_with(Noding::Exact) {
        Err(BuildError::Crossing { one, other, count: 4 }) => {
            assert!(tic_tac_toe.iter().any(|(a, b)| [at(*a), at(*b)] == one));
            assert!(tic_tac_toe.iter().any(|(a, b)| [at(*a), at(*b)] == other));
            assert_ne!(one, other);
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn more_cuts_than_are_allowed_are_an_error() {
    // Each horizontal segment crosses each vertical one.
    let level = (0..40).map(|i| ((-1, i), (40, i)));
    let all: Vec<(Whole, Whole)> = level.chain((0..40).map(|i| ((i, -1), (i, 40)))).collect();
    let within = |cuts: usize| {
        let mut builder = segments(&all);
        builder.limit_cuts(cuts);
        builder.build_with(Noding::Snap(Snap::Size(1.0)))
    };
    assert_eq!(within(3200).expect("each of 1600 crossings cuts two").noding().map(|n| n.crossings), Some(1600));
    // A large excess is predicted, a small one is found.
    for allowed in [0, 100, 3199] {
        assert_eq!(within(allowed).err(), Some(BuildError::TooManyCuts { allowed }));
    }
}

#[test]
fn lines_that_cross_a_million_times_are_refused_unless_that_is_allowed() {
    let mut random = Random::seeded(1);
    let mut coordinate = || random.choose(1 << 31) as f64;
    let mut builder = Builder::new();
    for _ in 0..6000 {
        let [a, b, c, d] = [(); 4].map(|()| coordinate());
        builder.segment([a, b], [c, d]).expect("in range");
    }
    let refused = builder.build_with(Noding::Snap(Snap::Auto));
    assert!(matches!(refused, Err(BuildError::TooManyCuts { allowed }) if allowed == (1 << 20) + 16 * 6000));
}

#[test]
fn snapping_cuts_crossings_and_features_follow() {
    let squares = [polygon(&[(0, 0), (4, 0), (4, 4), (0, 4)]), polygon(&[(1, 1), (1, 5), (5, 5), (5, 1)])];
    let map = gather(&squares).build_with(Noding::Snap(Snap::Auto)).expect("in reach");
    assert_eq!(counts(&map), [10, 12, 4]);
    assert!(map.validate().is_valid());
    assert_eq!(covered(&map), [(vec![0], 7.0), (vec![0, 1], 9.0), (vec![1], 7.0)]);
    assert_eq!(map.noding().map(|noding| (noding.crossings, noding.split)), Some((2, 4)));
    // Without noding the map is built, and reported as not plane.
    let map = gather(&squares).build().expect("built as far as it goes");
    assert_eq!((map.noding(), map.is_plane(), map.validate().is_valid()), (None, false, false));
}

#[test]
fn what_collapses_in_a_cell_encloses_nothing() {
    let features = [polygon(&[(0, 0), (1, 0), (1, 1)]), polygon(&[(0, 0), (16, 0), (0, 16)])];
    let map = gather(&features).build_with(Noding::Snap(Snap::Size(16.0))).expect("in reach");
    assert_eq!(covered(&map), [(vec![1], 128.0)]);
    assert_eq!(map.noding().map(|noding| noding.collapsed), Some(3));
}

#[test]
fn cells_without_a_size_are_refused() {
    for size in [0.0, -1.0, 1e-200, f64::NAN, f64::INFINITY] {
        let built = segments(&[((0, 0), (1, 1))]).build_with(Noding::Snap(Snap::Size(size)));
        assert!(matches!(built, Err(BuildError::CellSize)), "{size}: {built:?}");
    }
}

#[test]
fn a_map_near_zero_is_snapped_to_coordinates_for_which_the_predicates_are_exact() {
    let tiny = 2.0_f64.powi(-399);
    let mut builder = Builder::new();
    builder.segment([0.0, 0.0], [3.0 * tiny, tiny]).expect("in range");
    builder.segment([0.0, tiny], [3.0 * tiny, 0.0]).expect("in range");
    let map = builder.build_with(Noding::Snap(Snap::Auto)).expect("in reach");
    assert!(map.is_plane() && map.validate().is_valid());
    assert_eq!(map.noding().map(|noding| noding.cell), Some(2.0_f64.powi(-400)));
}

#[test]
fn coordinates_out_of_reach_of_the_grid_are_refused_and_named() {
    let mut builder = segments(&[((0, 0), (1, 1))]);
    builder.segment([3.0, 5.0], [3.0, 1e30]).expect("in range");
    let built = builder.build_with(Noding::Snap(Snap::Size(1.0)));
    assert!(matches!(built, Err(BuildError::OutOfReach { x: 3.0, y: 1e30 })), "{built:?}");
}

#[test]
fn the_crossing_map_of_the_world_snapped_is_the_map_after_its_crossings_were_cut() {
    // The counts in the README of the data, for the map with both crossings cut.
    let features = features(include_bytes!("../../../../tests/data/world-110m-crossing.geojson"));
    let map = gather(&features).build_with(Noding::Snap(Snap::Auto)).expect("in reach");
    assert_eq!(counts(&map), [7_493, 7_655, 288]);
    let report = map.validate();
    assert!(report.is_valid());
    assert_eq!(report.counts().components, Some(125));
    let noding = map.noding().expect("it was noded");
    assert_eq!((noding.crossings, noding.split, noding.merged), (2, 4, 0));
    assert!(noding.largest_move.into_iter().all(|moved| moved <= noding.cell / 2.0));
}

#[test]
fn any_segments_snapped_are_a_valid_map() {
    #[expect(clippy::needless_pass_by_value, reason = "quickcheck hands values over")]
    fn law(drawn: Vec<(Whole, Whole)>, coarse: bool) -> bool {
        let snap = if coarse { Snap::Size(8.0) } else { Snap::Auto };
        let map = segments(&drawn).build_with(Noding::Snap(snap)).expect("in reach");
        map.is_plane() && map.validate().is_valid()
    }
    QuickCheck::new().tests(100).quickcheck(law as fn(_, _) -> _);
}

#[test]
fn exact_noding_keeps_the_points_or_names_a_crossing() {
    fn law(drawn: Vec<(Whole, Whole)>) -> TestResult {
        // Few positions, so that contacts and overlaps are frequent.
        let few = |(x, y): Whole| (x.rem_euclid(5), y.rem_euclid(5));
        let drawn: Vec<_> = drawn.into_iter().take(6).map(|(a, b)| (few(a), few(b))).collect();
        let given: BTreeSet<_> =
            drawn.iter().flat_map(|(a, b)| [*a, *b]).map(|(x, y)| [i64::from(x), i64::from(y)]).collect();
        let snapped = segments(&drawn).build_with(Noding::Snap(Snap::Auto)).expect("in reach");
        let free = snapped.noding().expect("it was noded").crossings > 0;
        match segments(&drawn).build_with(Noding::Exact) {
            Ok(map) if !free => TestResult::from_bool(
                points(&map) == given && map.validate().is_valid() && counts(&map) == counts(&snapped),
            ),
            Err(BuildError::Crossing { count, .. }) => TestResult::from_bool(free && count > 0),
            other => TestResult::error(format!("{other:?}, crossings: {free}")),
        }
    }
    QuickCheck::new().tests(500).quickcheck(law as fn(_) -> _);
}

#[test]
fn the_faces_of_overlapping_triangles_add_up() {
    // With a ring that goes there and back again, a polygon covers the same area; it is only no longer simple.
    #[expect(clippy::needless_pass_by_value, reason = "quickcheck hands values over")]
    fn law(triangles: Vec<(Whole, Whole, Whole)>, there_and_back: bool) -> bool {
        let features: Vec<_> = triangles
            .iter()
            .map(|(a, b, c)| {
                let mut rings = vec![vec![at(*a), at(*b), at(*c)]];
                rings.extend(there_and_back.then(|| vec![at(*b), at(*c)]));
                Feature { shapes: vec![Shape::Polygon(rings)], ..Feature::default() }
            })
            .collect();
        let map = gather(&features).build_with(Noding::Snap(Snap::Auto)).expect("in reach");
        let faces = covered(&map);
        triangles.iter().enumerate().all(|(feature, (a, b, c))| {
            let [a, b, c] = [a, b, c].map(|p| [f64::from(p.0), f64::from(p.1)]);
            let exact = ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])).abs() / 2.0;
            let found: f64 = faces.iter().filter(|(of, _)| of.contains(&feature)).map(|(_, area)| area).sum();
            (exact - found).abs() < 1e-6
        })
    }
    // A hundred triangles, the default of the generator, cross in thousands of places.
    QuickCheck::new().rng(Gen::new(40)).tests(100).quickcheck(law as fn(_, _) -> _);
}
