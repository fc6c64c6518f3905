//! Irregular rings are legal: they are built unchanged, counted, and listed with their places.
#![allow(clippy::float_cmp, reason = "areas on a grid of whole numbers are exact")]

use quickcheck::{Gen, QuickCheck, TestResult};
use std::collections::BTreeSet;
use twinedge_algorithm::area::feature_area;
use twinedge_geometry::Point;
use twinedge_map::{BuildSummary, Builder, IrregularityKind, PlanarMap, Position, Shape};

type Grid = (i32, i32);

fn at((x, y): Grid) -> Point {
    Point::new(f64::from(x), f64::from(y))
}

fn ring(points: &[Grid]) -> Vec<Point> {
    points.iter().copied().map(at).collect()
}

fn built(rings: &[&[Grid]]) -> PlanarMap {
    let mut builder = Builder::new();
    builder.shape(&Shape::Polygon(rings.iter().map(|r| ring(r)).collect())).expect("in range");
    builder.build().expect("fits")
}

/// Returns the listed irregularities: kind, ring, point and place.
fn listed(map: &PlanarMap) -> Vec<(IrregularityKind, usize, usize, Point)> {
    map.summary().irregularities.iter().map(|i| (i.kind, i.position.ring, i.position.point, i.at)).collect()
}

fn counted(map: &PlanarMap) -> [usize; 6] {
    let s = map.summary();
    [s.zero_length_segments, s.open_rings, s.degenerate_rings, s.rings_wound_wrongly, s.self_touching_rings, s.spikes]
}

fn area(map: &PlanarMap) -> f64 {
    feature_area(map, map.features().next().expect("one"))
}

const SHELL: [Grid; 5] = [(0, 0), (6, 0), (6, 6), (0, 6), (0, 0)];

#[test]
fn a_hole_that_touches_its_shell_makes_one_cycle() {
    let map = built(&[&SHELL, &[(0, 0), (1, 3), (3, 1), (0, 0)]]);
    assert!(map.validate().is_valid());
    assert_eq!(counted(&map), [0; 6]);
    assert_eq!(map.dcel().face_count(), 3);
    let inside = map.dcel().faces().find(|f| f.half_edges().count() == 7).expect("its cycle has the edges of both");
    assert_eq!((inside.inner_count(), inside.outer().map(|b| b.half_edges().count())), (0, Some(7)));
    let visits = inside.half_edges().filter(|h| map.position(h.origin().key()) == Ok(at((0, 0)))).count();
    assert_eq!((visits, area(&map)), (2, 32.0));
}

#[test]
fn the_same_as_one_ring_touches_itself() {
    let map = built(&[&[(0, 0), (6, 0), (6, 6), (0, 6), (0, 0), (1, 3), (3, 1), (0, 0)]]);
    assert!(map.validate().is_valid());
    assert_eq!(listed(&map), [(IrregularityKind::SelfTouching, 0, 4, at((0, 0)))]);
    assert_eq!((counted(&map), area(&map)), ([0, 0, 0, 0, 1, 0], 32.0));
    // A hole on a bridge also runs there and back along it.
    let map = built(&[&[(0, 0), (6, 0), (6, 6), (0, 6), (0, 0), (1, 1), (1, 3), (3, 1), (1, 1), (0, 0)]]);
    assert!(map.validate().is_valid());
    assert_eq!(listed(&map), [(IrregularityKind::SelfTouching, 0, 4, at((0, 0)))]);
    assert_eq!(area(&map), 34.0);
}

#[test]
fn rings_that_run_the_wrong_way_cover_the_same() {
    let map = built(&[&[(0, 0), (0, 6), (6, 6), (6, 0), (0, 0)], &[(1, 1), (3, 1), (1, 3), (1, 1)]]);
    assert!(map.validate().is_valid());
    let wrong = IrregularityKind::WoundWrongly;
    assert_eq!(listed(&map), [(wrong, 0, 0, at((0, 0))), (wrong, 1, 0, at((1, 1)))]);
    assert_eq!((counted(&map), area(&map)), ([0, 0, 0, 2, 0, 0], 34.0));
}

#[test]
fn spikes_stay_as_edges_inside_or_outside() {
    // One kickback to the outside over two edges, and one to the inside across the end of the list.
    let map = built(&[&[(1, 1), (0, 0), (6, 0), (7, 0), (8, 0), (7, 0), (6, 0), (6, 6), (0, 6), (0, 0), (1, 1)]]);
    assert!(map.validate().is_valid());
    let spike = IrregularityKind::Spike;
    assert_eq!(listed(&map), [(spike, 0, 4, at((8, 0))), (spike, 0, 0, at((1, 1)))]);
    assert_eq!((counted(&map), area(&map)), ([0, 0, 0, 0, 0, 2], 36.0));
    assert_eq!((map.dcel().face_count(), map.dcel().edge_count()), (2, 7));
    // A kickback that stops short of its start overlaps an edge, which is also a violation.
    let map = built(&[&[(0, 0), (6, 0), (3, 0), (3, 6), (0, 0)]]);
    assert_eq!(listed(&map), [(spike, 0, 1, at((6, 0)))]);
    assert!(!map.is_plane());
}

#[test]
fn repeated_points_and_open_rings_are_listed() {
    let map = built(&[&[(0, 0), (6, 0), (6, 0), (6, 6), (0, 6)]]);
    assert!(map.validate().is_valid());
    let (repeated, open) = (IrregularityKind::RepeatedPoint, IrregularityKind::OpenRing);
    assert_eq!(listed(&map), [(repeated, 0, 2, at((6, 0))), (open, 0, 4, at((0, 6)))]);
    assert_eq!((counted(&map), area(&map)), ([1, 1, 0, 0, 0, 0], 36.0));
}

#[test]
fn long_chains_are_followed_without_a_gap() {
    // There and back, over more points than one block; some are repeated.
    let (there, repeated) = (0..200, [62, 63, 64, 127, 128]);
    let way = there.clone().chain(there.clone().rev()).map(|x| (x, 0));
    let chain: Vec<Grid> = way.flat_map(|p| vec![p; 1 + usize::from(repeated.contains(&p.0))]).collect();
    let mut builder = Builder::new();
    for _ in 0..2 {
        builder.shape(&Shape::Line(ring(&chain))).expect("in range");
    }
    let map = builder.build().expect("fits");
    let summary = map.summary();
    assert_eq!((map.dcel().vertex_count(), map.dcel().edge_count()), (200, 199));
    // Five repeated points each way, and the middle point, which follows itself.
    assert_eq!((summary.segments, summary.zero_length_segments), (2 * 409, 2 * 11));
    assert_eq!(summary.duplicate_segments, 3 * 199);
    let kind = IrregularityKind::RepeatedPoint;
    assert_eq!(
        listed(&map)[..5],
        [(62, 63), (63, 65), (64, 67), (127, 131), (128, 133)].map(|(x, point)| (kind, 0, point, at((x, 0))))
    );
}

#[test]
fn components_without_area_are_inner_boundary_components() {
    let degenerate = IrregularityKind::DegenerateRing;
    // A flat hole, a hole of one point, and a line.
    let mut builder = Builder::new();
    let holes: [&[Grid]; 2] = [&[(1, 1), (2, 2), (1, 1)], &[(4, 4), (4, 4)]];
    let rings = [&SHELL[..]].into_iter().chain(holes).map(ring).collect();
    builder.shape(&Shape::Polygon(rings)).expect("in range");
    builder.shape(&Shape::Line(ring(&[(1, 4), (2, 4), (3, 5)]))).expect("in range");
    let map = builder.build().expect("fits");
    assert!(map.validate().is_valid());
    assert_eq!((map.dcel().face_count(), map.dcel().boundary_count()), (2, 5));
    let inside = map.dcel().faces().find(|f| !f.is_unbounded()).expect("one");
    let sizes: BTreeSet<usize> = inside.inner().map(|b| b.half_edges().count()).collect();
    assert_eq!((inside.inner_count(), sizes), (3, BTreeSet::from([0, 2, 4])));
    assert_eq!(inside.inner().filter(|b| b.isolated_vertex().is_some()).count(), 1);
    let repeated = IrregularityKind::RepeatedPoint;
    assert_eq!(
        listed(&map),
        [(degenerate, 1, 0, at((1, 1))), (repeated, 2, 1, at((4, 4))), (degenerate, 2, 0, at((4, 4)))]
    );
    assert_eq!(area(&map), 36.0);
}

#[test]
fn of_each_kind_only_so_many_are_listed() {
    let mut builder = Builder::new();
    for i in 0..50 {
        let ring = ring(&[(i, 0), (i, 0), (i, 1)]);
        builder.shape(&Shape::Polygon(vec![ring])).expect("in range");
    }
    let summary = builder.summary();
    assert_eq!((summary.zero_length_segments, summary.open_rings, summary.degenerate_rings), (50, 50, 50));
    assert_eq!(summary.irregularities.len(), 3 * BuildSummary::LISTED);
    let position = Position { feature: 19, shape: 0, ring: 0, point: 2 };
    assert!(summary.irregularities.iter().any(|i| i.kind == IrregularityKind::OpenRing && i.position == position));
    assert!(summary.irregularities.iter().all(|i| i.position.feature < 20));
}

/// Twice the area, as an integer.
fn twice_area(ring: &[Grid]) -> i32 {
    (0..ring.len()).map(|i| (ring[i], ring[(i + 1) % ring.len()])).map(|((a, b), (c, d))| a * d - b * c).sum()
}

fn rings_look_as_one_sees(points: Vec<(u8, u8)>, hole: bool) -> TestResult {
    let mut corners: Vec<Grid> = points.iter().map(|(x, y)| (i32::from(x % 5), i32::from(y % 5))).collect();
    corners.dedup();
    while corners.len() > 1 && corners.first() == corners.last() {
        corners.pop();
    }
    if corners.len() < 3 {
        return TestResult::discard();
    }
    let outer = ring(&[(-9, -9), (9, -9), (9, 9), (-9, 9), (-9, -9)]);
    let mut builder = Builder::new();
    let rings = if hole { vec![outer, ring(&corners)] } else { vec![ring(&corners)] };
    builder.shape(&Shape::Polygon(rings)).expect("in range");
    let map = builder.build().expect("fits");

    let n = corners.len();
    let turns_back = |i: &usize| {
        let [(ax, ay), (bx, by), (cx, cy)] = [i + n - 1, *i, i + 1].map(|i| corners[i % n]);
        let ((px, py), (qx, qy)) = ((ax - bx, ay - by), (cx - bx, cy - by));
        px * qy == py * qx && px * qx + py * qy > 0
    };
    let spikes = (0..n).filter(turns_back).count();
    // Removes points that run there and back until there are none.
    let mut trimmed = corners.clone();
    while let Some(i) =
        (0..trimmed.len()).find(|i| trimmed.len() > 2 && trimmed[*i] == trimmed[(i + 2) % trimmed.len()])
    {
        let tip = (i + 1) % trimmed.len();
        trimmed.remove(tip);
        trimmed.remove(if tip <= i { i - 1 } else { i });
    }
    let touches = trimmed.len() > 2 && trimmed.iter().collect::<BTreeSet<_>>().len() < trimmed.len();
    let counts = map.summary();
    let mut right = counts.spikes == spikes && counts.self_touching_rings == usize::from(touches);
    if map.is_plane() && !touches {
        let twice = twice_area(&corners);
        right &= counts.rings_wound_wrongly == usize::from(if hole { twice > 0 } else { twice < 0 });
    }
    TestResult::from_bool(right)
}

#[test]
fn rings_agree_with_the_slow_answer() {
    QuickCheck::new()
        .rng(Gen::new(9))
        .tests(20_000)
        .max_tests(100_000)
        .quickcheck(rings_look_as_one_sees as fn(Vec<(u8, u8)>, bool) -> TestResult);
}
