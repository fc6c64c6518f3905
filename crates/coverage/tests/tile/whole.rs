//! A map as a whole and by its tiles.

use crate::maps::Random;
use std::collections::BTreeMap;
use twinedge::validate::{Report, Rule, Violation};
use twinedge_coverage::tile::{Crossing, CrossingKind, Cuts, Grid, Outcome, Piece, Summary, Uneven};
use twinedge_coverage::{Coverage, Finding, Limits, check, defects, mismatches};
use twinedge_geometry::Point;
use twinedge_geometry::noding::Snap;
use twinedge_map::{Builder, Embedding as _, Feature, Noding, PlanarMap, Shape};

fn builder(features: &[Feature]) -> Builder {
    let mut builder = Builder::new();
    for feature in features {
        builder.feature(feature).expect("in range");
    }
    builder
}

pub(crate) fn whole(features: &[Feature]) -> PlanarMap {
    builder(features).build().expect("there is room")
}

/// The findings of the map whose edges are cut where they meet.
pub(crate) fn whole_cut(features: &[Feature], limits: &Limits) -> Coverage {
    let builder = builder(features);
    let unmatched = builder.unmatched();
    let map = builder.build_with(Noding::Snap(Snap::Auto)).expect("in reach");
    let mut coverage = check(&map, limits).expect("it is plane");
    coverage.findings.extend(mismatches(&map, &unmatched).expect("it is plane"));
    coverage
}

/// The number of rounds in which edges of the whole are bent.
pub(crate) fn rounds(features: &[Feature]) -> usize {
    let map = builder(features).build_with(Noding::Snap(Snap::Auto)).expect("in reach");
    map.noding().map_or(0, |summary| summary.rounds)
}

pub(crate) fn points(features: &[Feature]) -> impl Iterator<Item = Point> + Clone {
    let points = |shape: &Shape| match shape {
        Shape::Polygon(rings) => rings.concat(),
        Shape::Line(points) => points.clone(),
        Shape::Point(point) => vec![*point],
    };
    features.iter().flat_map(|feature| &feature.shapes).flat_map(points)
}

pub(crate) fn largest(features: &[Feature]) -> f64 {
    points(features).fold(0.0, |most, p| most.max(p.x.abs()).max(p.y.abs()))
}

/// The corners of the box around all features.
fn corners(features: &[Feature]) -> Option<[Point; 2]> {
    points(features).next()?;
    let corner = |of: fn(f64, f64) -> f64, from: f64| {
        points(features).fold(Point::new(from, from), |to, p| Point::new(of(to.x, p.x), of(to.y, p.y)))
    };
    Some([corner(f64::min, f64::INFINITY), corner(f64::max, f64::NEG_INFINITY)])
}

/// The pieces of all features, with their numbers.
pub(crate) fn pieces<'f>(
    grid: &Grid,
    features: impl IntoIterator<Item = (u32, &'f Feature)>,
    largest: f64,
) -> Vec<Piece> {
    let cuts = Cuts::new(largest).expect("finite");
    let of = |(number, feature)| cuts.pieces(grid, number, feature).expect("in range");
    features.into_iter().flat_map(of).collect()
}

pub(crate) fn all_pieces(grid: &Grid, features: &[Feature]) -> Vec<Piece> {
    pieces(grid, (0..).zip(features), largest(features))
}

/// The findings by tiles that cut edges.
pub(crate) fn by_tiles_cut(features: &[Feature], grid: &Grid, limits: &Limits, random: &mut Random) -> Coverage {
    let mut cuts = Cuts::new(largest(features)).expect("finite");
    let pieces = all_pieces(grid, features);
    while !cuts.is_complete() {
        let concerned = grid.tiles().filter(|tile| cuts.concern(grid, *tile));
        let found = concerned.map(|tile| cuts.search(grid, tile, &pieces).expect("in range"));
        let found: Vec<_> = found.collect();
        cuts.take(found).expect("few rounds");
    }
    let summary = |tile| Summary::cut(grid, tile, &pieces, limits, &cuts).expect("in range");
    let outcome = merged(grid.tiles().map(summary).collect(), random).finish().expect("no tile is missing");
    assert!(outcome.is_valid(), "{outcome:?}");
    outcome.coverage.expect("it is plane")
}

/// The grid with lines at these positions: at most two of each kind.
pub(crate) fn grid(upright: &[f64], level: &[f64]) -> Grid {
    let ends = |lines: &[f64]| match *lines {
        [] => (0.0, 1.0),
        [at] => (at - 1.0, at + 1.0),
        [first, second] => (2.0 * first - second, 2.0 * second - first),
        _ => unreachable!("two lines at most"),
    };
    let ((left, right), (bottom, top)) = (ends(upright), ends(level));
    Grid::new([left, bottom], [right, top], upright.len() as u32 + 1, level.len() as u32 + 1).expect("a grid")
}

pub(crate) fn summaries(features: &[Feature], grid: &Grid, limits: &Limits) -> Vec<Summary> {
    let pieces = all_pieces(grid, features);
    grid.tiles().map(|tile| Summary::new(grid, tile, &pieces, limits).expect("in range")).collect()
}

/// Merges in the order of a random tree.
pub(crate) fn merged(mut summaries: Vec<Summary>, random: &mut Random) -> Summary {
    while summaries.len() > 1 {
        let one = summaries.swap_remove(random.below(summaries.len()));
        let other = summaries.swap_remove(random.below(summaries.len()));
        summaries.push(one.merge(other).expect("different tiles of one grid"));
    }
    summaries.pop().expect("a grid has a tile")
}

pub(crate) fn by_tiles(features: &[Feature], grid: &Grid, limits: &Limits, random: &mut Random) -> Outcome {
    merged(summaries(features, grid, limits), random).finish().expect("no tile is missing")
}

/// The number of polygon edges by the exponent of their extent.
fn extents(features: &[Feature]) -> Vec<(u16, u64)> {
    let mut extents = BTreeMap::new();
    for shape in features.iter().flat_map(|feature| &feature.shapes) {
        let Shape::Polygon(rings) = shape else { continue };
        for ring in rings {
            for (a, b) in ring.iter().zip(ring.iter().skip(1)) {
                let extent = f64::max((a.x - b.x).abs(), (a.y - b.y).abs());
                *extents.entry((extent.to_bits() >> 52) as u16).or_default() += 1;
            }
        }
    }
    extents.into_iter().collect()
}

/// Compares the audit by tiles with the audit of the whole; sometimes also by tiles that fit the map, whose lines meet its vertices.
pub(crate) fn compare(features: &[Feature], grid: &Grid, limits: &Limits, random: &mut Random) {
    compare_with(features, grid, limits, random);
    if random.below(4) == 0 {
        let most = 1 + random.below(12);
        let fitted = Grid::fitted(points(features).collect(), most).expect("a grid");
        compare_with(features, &fitted, limits, random);
    }
}

fn compare_with(features: &[Feature], grid: &Grid, limits: &Limits, random: &mut Random) {
    let map = whole(features);
    let report = map.validate();
    let outcome = by_tiles(features, grid, limits, random);
    assert_eq!(outcome.is_valid(), report.is_valid(), "{grid:?} {features:?}\n{outcome:?}");
    assert_eq!(outcome.counts, *report.counts(), "{grid:?} {features:?}");
    assert_eq!(outcome.corners, corners(features));
    assert_eq!(outcome.extents, extents(features));
    for (of_tiles, of_whole) in outcome.rules().zip(report.outcomes()) {
        assert_eq!(of_tiles, of_whole, "{:?}", report.counts());
    }
    if let Some(figures) = report.figures() {
        assert_eq!(outcome.bounds(), figures.bounds);
    }
    assert_eq!(outcome.rules().count(), report.outcomes().len());
    let all = (0..).zip(features).map(|(number, feature)| (number, defects(&feature.shapes)));
    assert_eq!(outcome.defects, all.filter(|(_, found)| !found.is_empty()).collect::<Vec<_>>());
    let (by_tiles, whole) = if let Some(by_tiles) = outcome.coverage {
        (by_tiles, check(&map, limits).expect("it is plane"))
    } else {
        assert!(!map.is_plane());
        broken(&map, &report, &outcome.crossings, &outcome.uneven);
        (by_tiles_cut(features, grid, limits, random), whole_cut(features, limits))
    };
    assert!(
        near(by_tiles.gap_width, whole.gap_width) && near(by_tiles.sliver_area, whole.sliver_area),
        "{grid:?} {features:?}"
    );
    for (these, those) in [
        (by_tiles.findings, whole.findings),
        (by_tiles.wider_gaps, whole.wider_gaps),
        (by_tiles.accepted_gaps, whole.accepted_gaps),
    ] {
        same(these, those, &format!("{grid:?} {limits:?} {features:?}"));
    }
}

fn broken(map: &PlanarMap, report: &Report, crossings: &[Crossing], uneven: &[Uneven]) {
    let point = |v: usize| map.point(v);
    let edge = |h: usize| {
        let h = map.dcel().half_edge_at(h).expect("it is live");
        let mut ends = [h.origin(), h.target()].map(|v| point(v.index()));
        ends.sort_by(|a, b| a.partial_cmp(b).expect("finite"));
        ends
    };
    let mut expected = Vec::new();
    let mut components = Vec::new();
    for violation in report.violations() {
        match *violation {
            Violation::Cross { first, second } => expected.push((CrossingKind::Cross, edge(first), edge(second))),
            Violation::Overlap { first, second } => expected.push((CrossingKind::Overlap, edge(first), edge(second))),
            Violation::Touch { vertex, half_edge } => {
                expected.push((CrossingKind::Touch, [point(vertex); 2], edge(half_edge)));
            }
            Violation::Genus { vertices, edges, cycles, .. } => components.push((vertices, edges, cycles)),
            // These follow from the crossings, and are not checked by tiles.
            _ => assert!(matches!(violation.rule(), Rule::T4 | Rule::G2 | Rule::G3 | Rule::G5), "{violation:?}"),
        }
    }
    for (kind, first, second) in &mut expected {
        if *kind != CrossingKind::Touch && first[..] > second[..] {
            std::mem::swap(first, second);
        }
    }
    expected.sort_by(|a, b| a.partial_cmp(b).expect("finite"));
    let found: Vec<_> = crossings.iter().map(|one| (one.kind, one.first, one.second)).collect();
    assert_eq!(found, expected);
    components.sort_unstable();
    let mut found: Vec<_> =
        uneven.iter().map(|one| (one.vertices as usize, one.edges as usize, one.cycles as usize)).collect();
    found.sort_unstable();
    assert_eq!(found, components);
}

/// Compares findings in any order, up to rounding, but locations exactly.
fn same(these: Vec<Finding>, those: Vec<Finding>, context: &str) {
    let sorted = |mut findings: Vec<Finding>| {
        findings.sort_by(|a, b| {
            let key = |one: &Finding| (one.rule, one.features.clone());
            key(a).cmp(&key(b)).then(a.at.partial_cmp(&b.at).expect("finite")).then(a.area.total_cmp(&b.area))
        });
        findings
    };
    let (these, those) = (sorted(these), sorted(those));
    assert_eq!(these.len(), those.len(), "{context}\n{these:?}\n{those:?}");
    for (a, b) in these.iter().zip(&those) {
        let key = |one: &Finding| (one.rule, one.features.clone(), one.at, one.corner, one.missing.clone());
        let is_same = key(a) == key(b);
        let is_near = near(a.area, b.area) && near(a.width, b.width) && near(a.length, b.length);
        let stretches = |one: &Finding| {
            let mut all: Vec<[[u64; 2]; 2]> =
                one.stretches.iter().map(|ends| ends.map(|p| [p.x.to_bits(), p.y.to_bits()])).collect();
            all.sort_unstable();
            all
        };
        assert!(is_same && is_near && stretches(a) == stretches(b), "{context}\n{a:?}\n{b:?}");
    }
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-9 * a.abs().max(b.abs()).max(1.0)
}
