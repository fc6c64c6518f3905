//! The rules of a coverage, each broken alone.

use crate::support::{Numbers, feature, mirrored};
use twinedge_coverage::{CoverageRule, Limits};
use twinedge_geometry::Point;
use twinedge_map::{Feature, Shape};
use twinedge_sphere::{Clash, Cover, Coverage, Drawing, Inside, Subdivision, check, mismatches};

fn judged(features: &[Feature], inside: Inside, limits: &Limits) -> (Vec<Clash>, Coverage) {
    let drawing = Drawing::new(features).expect("places");
    let (clashes, map) = Subdivision::new(&drawing);
    let map = map.expect("it can be cut");
    (clashes, check(&Cover::new(&map, &drawing, inside), limits))
}

/// Returns the broken rules, with the features involved.
fn broken(found: &Coverage) -> Vec<(CoverageRule, Vec<u32>)> {
    found.findings.iter().map(|finding| (finding.rule, finding.features.clone())).collect()
}

fn boxed([west, south, east, north]: [f64; 4]) -> Feature {
    feature(Shape::polygon([[west, south], [east, south], [east, north], [west, north]]))
}

/// The border of Kansas and Colorado has one more vertex on Colorado's side, on the meridian of 102.05 degrees west. In doubles it is not the
/// midpoint of the ends, but its place lies exactly on the arc.
#[test]
fn a_vertex_on_a_neighbours_meridian_is_neither_gap_nor_overlap() {
    let colorado =
        feature(Shape::polygon([[-109.05, 37.0], [-102.05, 37.0], [-102.05, 39.13], [-102.05, 41.0], [-109.05, 41.0]]));
    let kansas = boxed([-102.05, 37.0, -94.61, 40.0]);
    let (clashes, found) = judged(&[colorado, kansas], Inside::Smaller, &Limits::default());
    assert_eq!(broken(&found), []);
    // Each side has vertices that the other lacks: 39.13 and 40 degrees.
    assert!(clashes.iter().all(|clash| matches!(clash, Clash::Overlap { .. } | Clash::Touch { .. })), "{clashes:?}");
    assert!(!clashes.is_empty());
}

/// A vertex that a neighbour lacks is a mismatch; a vertex of both is not. Where features overlap, the finding is an overlap.
#[test]
fn a_vertex_that_a_neighbour_lacks_is_a_mismatch() {
    let missing = |features: &[Feature]| {
        let drawing = Drawing::new(features).expect("places");
        let (clashes, map) = Subdivision::new(&drawing);
        let map = map.expect("it can be cut");
        let found = mismatches(&Cover::new(&map, &drawing, Inside::Smaller), &drawing, &clashes);
        let missing = found.iter().flat_map(|one| &one.missing);
        missing.map(|vertex| (vertex.feature, vertex.at.y)).collect::<Vec<_>>()
    };
    let west = boxed([-5.0, 40.0, 7.3, 50.0]);
    let east = boxed([7.3, 45.0, 12.0, 55.0]);
    assert_eq!(missing(&[west.clone(), east.clone()]), [(0, 45.0), (1, 50.0)]);
    // A line of the western feature has the vertex that its polygon lacks.
    let mut with_line = west.clone();
    with_line.shapes.push(Shape::line([[7.0, 45.0], [7.3, 45.0]]));
    assert_eq!(missing(&[with_line, east]), [(1, 50.0)]);
    // It also ends at a vertex of both.
    let below = boxed([7.3, 40.0, 12.0, 45.0]);
    assert_eq!(missing(&[west.clone(), below]), [(0, 45.0)]);
    // The eastern feature begins inside the western one, and ends on its border.
    let inside = feature(Shape::polygon([[0.0, 42.0], [7.3, 43.0], [7.3, 44.0]]));
    assert_eq!(missing(&[west, inside]), []);
}

/// Moving the border west by a unit in the last place makes it a different border.
#[test]
fn a_border_beside_a_neighbours_by_a_nanometre_is_a_gap_or_an_overlap() {
    let west = boxed([-109.05, 37.0, (-102.05_f64).next_down(), 41.0]);
    let east = boxed([-102.05, 37.0, -94.61, 41.0]);
    let between = boxed([-109.05, 41.0, -94.61, 43.0]);
    let below = boxed([-109.05, 35.0, -94.61, 37.0]);
    let (_, found) =
        judged(&[west, east, between, below], Inside::Smaller, &Limits { thinness: 0.0, ..Limits::default() });
    assert!(broken(&found).iter().any(|(rule, _)| *rule == CoverageRule::Gap), "{found:?}");
}

/// The parallel of 49 degrees, drawn by its ends from one side and by more vertices from the other: over 28 degrees, the arc between the ends bulges
/// to the north by at most 1.06 degrees (see `predicates`), 94 km, and on average by two thirds of that.
#[test]
fn a_parallel_drawn_by_its_ends_overlaps_what_lies_to_the_north() {
    let along: Vec<[f64; 2]> = (0..=28).map(|i| [-123.0 + f64::from(i), 49.0]).collect();
    let north = feature(Shape::polygon(along.into_iter().chain([[-95.0, 60.0], [-123.0, 60.0]])));
    let south = boxed([-123.0, 25.0, -95.0, 49.0]);
    let limits = Limits { thinness: 0.0, ..Limits::default() };
    let (clashes, found) = judged(&[north.clone(), south.clone()], Inside::Smaller, &limits);
    assert_eq!(clashes, []);
    assert_eq!(broken(&found), [(CoverageRule::Overlap, vec![0, 1])]);
    let overlap = &found.findings[0];
    // 2,041 km along the parallel, by 63 km.
    assert!((1.1e11..1.5e11).contains(&overlap.area), "{overlap:?}");
    // Two features claim a town between the parallel and the arc.
    assert!((49.0..50.1).contains(&overlap.at.y) && (-123.0..-95.0).contains(&overlap.at.x));
    // South of the equator, the bulge is a gap.
    let (_, found) = judged(&mirrored(&[north, south], 1.0, -1.0), Inside::Smaller, &limits);
    assert_eq!(broken(&found), [(CoverageRule::Overlap, vec![0, 1])]);
}

/// These borders do not meet if they are straight on the map. On the globe the long ones, along the parallels of 40 and 50 degrees, bulge to 59.2 and
/// 67.2 degrees.
#[test]
fn borders_that_cross_on_the_globe_only_are_found() {
    let long = boxed([-60.0, 40.0, 60.0, 50.0]);
    let beside = boxed([-5.0, 51.0, 5.0, 72.0]);
    let (clashes, found) = judged(&[long, beside], Inside::Smaller, &Limits::default());
    assert!(clashes.len() == 4 && clashes.iter().all(|clash| matches!(clash, Clash::Cross { .. })), "{clashes:?}");
    assert_eq!(broken(&found)[0], (CoverageRule::Overlap, vec![0, 1]));
}

/// The reverse: a ring that crosses itself on the map but not on the globe, because a point lies above the straight line and below the arc.
#[test]
fn a_ring_that_crosses_itself_on_the_map_only_is_accepted() {
    let spike =
        |latitude: f64| Shape::polygon([[-60.0, 50.0], [-20.0, 40.0], [0.0, latitude], [20.0, 40.0], [60.0, 50.0]]);
    for (latitude, crosses) in [(55.0, false), (70.0, true)] {
        let (clashes, _) = judged(&[feature(spike(latitude))], Inside::Smaller, &Limits::default());
        assert_eq!(!clashes.is_empty(), crosses, "{latitude}");
    }
}

#[test]
fn each_rule_is_broken_alone() {
    // Four boxes around a fifth, on both sides of the antimeridian; their parallels are short arcs, which they share.
    let around = |hole: [f64; 4], id: usize| {
        let [west, south, east, north] = hole;
        let bounds = [
            [west - 1.0, south - 1.0, east, south],
            [east, south - 1.0, east + 1.0, north],
            [west, north, east + 1.0, north + 1.0],
            [west - 1.0, south, west, north + 1.0],
        ];
        boxed(bounds[id])
    };
    let hole = [179.5, -17.0, 180.5, -16.0];
    let all: Vec<Feature> = (0..4).map(|id| around(hole, id)).chain([boxed(hole)]).collect();
    // Corners of some boxes lie inside the bulging parallels of others, so each corner becomes a vertex of all.
    let all = with_all_vertices(&all);
    let limits = Limits::default();
    let of = |features: &[Feature], limits: &Limits| {
        let (clashes, found) = judged(features, Inside::Smaller, limits);
        assert_eq!(clashes, []);
        broken(&found)
    };
    assert_eq!(of(&all, &limits), []);
    assert_eq!(of(&all[..4], &limits), [(CoverageRule::Gap, vec![0, 1, 2, 3])]);
    let twice: Vec<Feature> = all.iter().chain(&all[4..]).cloned().collect();
    assert_eq!(of(&twice, &limits), [(CoverageRule::Duplicate, vec![4, 5])]);
    // Wide and accepted gaps are counted.
    let wide = Limits { gap_width: Some(10_000.0), ..Limits::default() };
    let accepted = Limits { accepted_gaps: vec![Point::new(-179.9, -16.2)], ..Limits::default() };
    for (limits, counts) in [(wide, (1, 0)), (accepted, (0, 1))] {
        let (_, found) = judged(&all[..4], Inside::Smaller, &limits);
        assert_eq!((broken(&found), (found.wider_gaps, found.accepted_gaps)), (vec![], counts));
    }
    // Borders 100 m apart, along 111 km, at the antimeridian.
    let west = boxed([179.0, 30.0, 180.0, 31.0]);
    let east = feature(Shape::polygon([[-179.999, 30.0], [-179.0, 30.0], [-179.0, 31.0], [-179.999, 31.0]]));
    let (_, found) = judged(&[west.clone(), east.clone()], Inside::Smaller, &limits);
    assert_eq!(broken(&found), [(CoverageRule::NearMiss, vec![0, 1])]);
    let near_miss = &found.findings[0];
    assert!(
        (95.0..97.0).contains(&near_miss.width) && (220_000.0..223_000.0).contains(&near_miss.length),
        "{near_miss:?}"
    );
    let narrow = Limits { gap_width: Some(90.0), ..Limits::default() };
    assert_eq!(of(&[west, east], &narrow), []);
    // An island 10 m wide and 10 km long.
    let mut island = all.clone();
    island[4].shapes.push(Shape::polygon([[170.0, 0.0], [170.1, 0.0], [170.1, 0.0001], [170.0, 0.0001]]));
    assert_eq!(of(&island, &limits), [(CoverageRule::Sliver, vec![4])]);
    // A part that is also only 10 m long is not a sliver.
    let mut small = all;
    small[4].shapes.push(Shape::polygon([[170.0, 0.0], [170.0001, 0.0], [170.0001, 0.0001], [170.0, 0.0001]]));
    assert_eq!(of(&small, &limits), []);
}

/// Adds each corner that lies on a side of another box as a vertex there.
fn with_all_vertices(features: &[Feature]) -> Vec<Feature> {
    let rings = |feature: &Feature| match &feature.shapes[0] {
        Shape::Polygon(rings) => rings[0].clone(),
        _ => Vec::new(),
    };
    let all: Vec<Point> = features.iter().flat_map(rings).collect();
    let of = |one: &Feature| {
        let ring = rings(one);
        let mut whole = Vec::new();
        for (i, a) in ring.iter().enumerate() {
            let b = ring[(i + 1) % ring.len()];
            let part = |p: &Point| (p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y);
            let length = part(&b);
            let is_on = |p: &&Point| {
                let across = (p.x - a.x) * (b.y - a.y) - (p.y - a.y) * (b.x - a.x);
                across == 0.0 && part(p) > 0.0 && part(p) < length
            };
            let mut inside: Vec<Point> = all.iter().filter(is_on).copied().collect();
            inside.sort_by(|p, q| part(p).total_cmp(&part(q)));
            inside.dedup();
            whole.push(*a);
            whole.extend(inside);
        }
        feature(Shape::polygon(whole))
    };
    features.iter().map(of).collect()
}

/// A sea around the world is larger than half of it: only the orientation of its ring tells its side.
#[test]
fn a_feature_larger_than_half_of_the_sphere_is_told_by_its_ring() {
    let ring: Vec<[f64; 2]> = [0.0, 90.0, 180.0, -90.0].map(|x| [x, 60.0]).into();
    let drawing = |ring: Vec<[f64; 2]>| Drawing::new(&[feature(Shape::polygon(ring))]).expect("places");
    let backwards: Vec<[f64; 2]> = ring.iter().rev().copied().collect();
    // Counter-clockwise around the north pole: the cap is to its left.
    for (ring, inside, is_cap) in [
        (&ring, Inside::Smaller, true),
        (&backwards, Inside::Smaller, true),
        (&ring, Inside::Left, true),
        (&backwards, Inside::Left, false),
    ] {
        let drawing = drawing(ring.clone());
        let map = Subdivision::new(&drawing).1.expect("it is one");
        let cover = Cover::new(&map, &drawing, inside);
        assert_eq!(cover.features_at(twinedge_sphere::Place::NORTH) == [0], is_cap, "{inside:?}");
        assert_eq!(cover.area_of(0) < 1e14, is_cap);
    }
}

/// Cutting a map into parts along a meridian keeps its area, and the parts neither overlap nor leave gaps.
#[test]
fn parts_along_a_meridian_add_up() {
    let mut numbers = Numbers(7);
    for _ in 0..200 {
        let middle = (numbers.fraction() * 360.0 - 180.0 + 360.0) % 360.0 - 180.0;
        let (south, north) = (numbers.fraction() * 80.0 - 90.0, numbers.fraction() * 80.0 + 10.0);
        let (west, east) = (middle - 1.0 - numbers.fraction() * 80.0, middle + 1.0 + numbers.fraction() * 80.0);
        let left = [[west, south], [middle, south], [middle, north], [west, north]];
        let right = [[middle, south], [east, south], [east, north], [middle, north]];
        let whole = [[west, south], [middle, south], [east, south], [east, north], [middle, north], [west, north]];
        let at = [[middle, south + (north - south) * numbers.fraction()]];
        // The left part has one more vertex on the meridian.
        let left: Vec<[f64; 2]> = left[..2].iter().chain(&at).chain(&left[2..]).copied().collect();
        let features = [feature(Shape::polygon(left)), feature(Shape::polygon(right))];
        let (_, found) = judged(&features, Inside::Smaller, &Limits { thinness: 0.0, ..Limits::default() });
        assert_eq!(broken(&found), []);
        let area = |features: &[Feature]| {
            let drawing = Drawing::new(features).expect("places");
            let map = Subdivision::new(&drawing).1.expect("it can be cut");
            let cover = Cover::new(&map, &drawing, Inside::Smaller);
            (0..features.len() as u32).map(|one| cover.area_of(one)).sum::<f64>()
        };
        let (parts, whole) = (area(&features), area(&[feature(Shape::polygon(whole))]));
        assert!((parts / whole - 1.0).abs() < 1e-11, "{parts} {whole}");
    }
}
