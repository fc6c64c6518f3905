//! The findings of C1 … C6.

use crate::maps::{Random, area, feature, line, point};
use crate::whole::{by_tiles, compare, grid, whole};
use std::collections::BTreeSet;
use twinedge_coverage::{Coverage, Finding, Limits, check};
use twinedge_geometry::Point;
use twinedge_map::{Feature, Shape};

fn limits() -> Vec<Limits> {
    let accepted = vec![Point::new(3.3, 3.4), Point::new(6.6, 1.2), Point::new(1.7, 5.1)];
    vec![
        Limits::default(),
        Limits { gap_width: Some(0.3), sliver_area: Some(0.7), ..Limits::default() },
        Limits { gap_width: Some(0.6), lake_width: Some(0.9), accepted_gaps: accepted, ..Limits::default() },
    ]
}

/// Parcels on a lattice with planted faults: rectangles that overlap at lattice lines, parcels that are missing, repeated,
/// divided by lines or pierced by holes, thin strips, strips that nearly meet.
fn parcels(random: &mut Random) -> Vec<Feature> {
    let mut features = Vec::new();
    // Every coordinate is a lattice line, so that edges meet only at vertices: cells are drawn with all points of the lattice.
    let cell = |x0: usize, y0: usize, x1: usize, y1: usize| {
        let at = |x: usize, y: usize| [x as f64 / 2.0, y as f64 / 2.0];
        let mut ring = Vec::new();
        ring.extend((x0..x1).map(|x| at(x, y0)));
        ring.extend((y0..y1).map(|y| at(x1, y)));
        ring.extend((x0 + 1..=x1).rev().map(|x| at(x, y1)));
        ring.extend((y0 + 1..=y1).rev().map(|y| at(x0, y)));
        ring
    };
    for x in (0..16).step_by(4) {
        for y in (0..16).step_by(4) {
            match random.below(12) {
                0 => {}
                1 => {
                    for _ in 0..=random.below(2) {
                        features.push(feature([Shape::polygon(cell(x, y, x + 4, y + 4))]));
                    }
                }
                2 => features.push(feature([Shape::polygon(cell(x, y, (x + 7).min(16), y + 4))])),
                3 => features.push(feature([Shape::polygon(cell(x, y, x + 4, y + 4)).hole(cell(
                    x + 1,
                    y + 1,
                    x + 2,
                    y + 3,
                ))])),
                4 => {
                    features.push(feature([Shape::polygon(cell(x, y, x + 1, y + 4))]));
                    features.push(feature([Shape::polygon(cell(x + 1, y, x + 4, y + 4))]));
                }
                5 => {
                    features.push(feature([Shape::polygon(cell(x, y, x + 4, y + 4))]));
                    let at = |dx: usize, dy: usize| [(x + dx) as f64 / 2.0, (y + dy) as f64 / 2.0];
                    features.push(feature([line(&[at(0, 0), at(1, 1), at(3, 3), at(4, 4)])]));
                }
                6 => features.push(feature([
                    Shape::polygon(cell(x, y, x + 1, y + 4)),
                    Shape::polygon(cell(x + 3, y, x + 4, y + 4)),
                    point(x as f64 / 2.0 + 1.0, y as f64 / 2.0 + 1.0),
                ])),
                _ => features.push(feature([Shape::polygon(cell(x, y, x + 4, y + 4))])),
            }
        }
    }
    features
}

#[test]
fn findings_on_a_lattice_are_those_of_the_whole() {
    let mut random = Random::new(11);
    let limits = limits();
    let mut seen = BTreeSet::new();
    for round in 0..150 {
        let mut features = parcels(&mut random);
        // Two strips that nearly meet, and a thin one.
        features.push(feature([area([9.0, 0.0], [9.5, 8.0])]));
        features.push(feature([area([9.75, 0.5], [10.0, 8.5])]));
        features.push(feature([area([12.0, 0.0], [12.01, 8.0])]));
        let (upright, level) = (random.lines(0, 4.0), random.lines(0, 4.0));
        let limits = &limits[round % limits.len()];
        compare(&features, &grid(&upright, &level), limits, &mut random);
        let found = check(&whole(&features), limits).expect("it is plane");
        seen.extend(found.findings.iter().map(|finding| finding.rule));
    }
    assert_eq!(seen.len(), 5, "{seen:?}");
}

#[test]
fn a_feature_around_all_tiles_covers_them() {
    let mut random = Random::new(12);
    // Around everything without touching it; with a lake around the middle tile; with an island in it that is claimed twice.
    let land = area([-50.0, -50.0], [50.0, 50.0]).hole([[-1.0, -1.0], [-1.0, 9.0], [9.0, 9.0], [9.0, -1.0]]);
    let island = || feature([area([3.2, 3.2], [3.4, 3.9])]);
    let features = [feature([land]), island(), island(), feature([area([6.0, 7.0], [6.01, 7.5])])];
    for limits in limits() {
        for (upright, level) in [(vec![3.0, 6.0], vec![3.0, 6.0]), (vec![3.2], vec![3.9]), (vec![], vec![3.4, 8.0])] {
            compare(&features, &grid(&upright, &level), &limits, &mut random);
        }
    }
}

/// Straight below an island, the border of a diamond has a corner on a line between tiles and passes the line there.
#[test]
fn islands_above_corners_on_lines_are_placed_beside_them() {
    let mut random = Random::new(13);
    let diamond = feature([Shape::polygon([[0.0, -1.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0]])]);
    for x in -5..5 {
        for y in -5..5 {
            let [x, y] = [x, y].map(|at| f64::from(at) / 4.0);
            let island = feature([Shape::polygon([[x, y + 0.75], [x + 0.1, y + 0.8], [x + 0.1, y + 0.9]])]);
            for (upright, level) in [(vec![0.5], vec![0.0]), (vec![-0.5, 0.5], vec![0.0, 0.5])] {
                compare(&[diamond.clone(), island.clone()], &grid(&upright, &level), &Limits::default(), &mut random);
            }
        }
    }
}

#[test]
fn a_gap_is_accepted_where_a_vertex_lies_alone_in_it() {
    let land = area([0.0, 0.0], [8.0, 8.0]).hole([[2.0, 2.0], [2.0, 6.0], [6.0, 6.0], [6.0, 2.0]]);
    let features = [feature([land]), feature([point(3.0, 3.0)])];
    let limits = Limits { accepted_gaps: vec![Point::new(3.0, 3.0)], ..Limits::default() };
    let found = check(&whole(&features), &limits).expect("it is plane");
    assert_eq!((found.findings.len(), found.accepted_gaps.len()), (0, 1));
    compare(&features, &grid(&[4.0], &[3.0]), &limits, &mut Random::new(14));
}

/// Every area is an exact multiple of a quarter.
#[test]
fn findings_of_equal_area_are_in_the_same_order_by_tiles() {
    let mut random = Random::new(15);
    let mut ties = 0;
    for _ in 0..40 {
        let mut features = parcels(&mut random);
        for i in 0..features.len() {
            features.swap(i, random.below(i + 1));
        }
        let (upright, level) = (random.lines(0, 4.0), random.lines(0, 4.0));
        for limits in limits() {
            let of_whole = check(&whole(&features), &limits).expect("it is plane");
            let by_tiles = by_tiles(&features, &grid(&upright, &level), &limits, &mut random).coverage;
            let lists = |of: &Coverage| [&of.findings, &of.wider_gaps, &of.accepted_gaps].map(Clone::clone).concat();
            let key = |one: &Finding| (one.rule, one.area, one.corner, one.features.clone(), one.at);
            let [these, those] = [lists(&by_tiles.expect("it is plane")), lists(&of_whole)]
                .map(|findings| findings.iter().map(key).collect::<Vec<_>>());
            assert_eq!(these, those, "{upright:?} {level:?} {limits:?} {features:?}");
            ties += those.windows(2).filter(|pair| (pair[0].0, pair[0].1) == (pair[1].0, pair[1].1)).count();
        }
    }
    assert!(ties > 100, "{ties}");
}

/// Islands with nothing below them in their tile, between edges that pass its lower side and in the strips that these bound.
#[test]
fn islands_are_placed_between_the_edges_at_the_lower_side() {
    let mut features = Vec::new();
    for x in 0..30 {
        let x = f64::from(x);
        features.push(feature([area([x, -1.0], [x + 0.5, 2.0])]));
        features.push(feature([area([x + 0.25, 0.5], [x + 0.375, 1.0])]));
        features.push(feature([area([x + 0.625, 0.5], [x + 0.75, 1.0])]));
    }
    compare(&features, &grid(&[10.3, 20.7], &[0.0]), &Limits::default(), &mut Random::new(16));
}

/// Features with equal cover; some also have parts that cover nothing, and so have another box.
#[test]
fn features_that_are_alike_are_found_in_any_order_of_merging() {
    let mut random = Random::new(17);
    let mut duplicates = 0;
    for _ in 0..200 {
        let mut features = Vec::new();
        for _ in 0..random.below(12) + 2 {
            let [x, y] = [0; 2].map(|_| 3.0 * random.below(3) as f64);
            let mut shapes = vec![area([x, y], [x + 2.0, y + 2.0])];
            match random.below(5) {
                0 => shapes.push(area([x + 9.0, y], [x + 11.0, y + 2.0])),
                1 => shapes.push(point(x - 3.0, y + 5.0)),
                2 => shapes.push(line(&[[x, y], [x + 2.0, y + 2.0]])),
                3 => shapes = vec![line(&[[x, y], [x + 2.0, y]])],
                _ => {}
            }
            features.push(feature(shapes));
        }
        let (upright, level) = (random.lines(-1, 4.0), random.lines(-1, 4.0));
        compare(&features, &grid(&upright, &level), &Limits::default(), &mut random);
        let found = check(&whole(&features), &Limits::default()).expect("it is plane");
        duplicates += found.of(twinedge_coverage::CoverageRule::Duplicate).count();
    }
    assert!(duplicates > 150, "{duplicates}");
}
