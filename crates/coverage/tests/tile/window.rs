//! Windows: data outside a window has no influence on its tile.

use crate::maps::{Random, feature, line};
use crate::whole::{largest, pieces, points, rounds};
use twinedge_coverage::Limits;
use twinedge_coverage::tile::{Cuts, Grid, Summary, Tile};
use twinedge_geometry::Point;
use twinedge_map::{Feature, Shape};

/// The features whose boxes meet a window, with their numbers.
fn in_window(features: &[Feature], [low, high]: [Point; 2]) -> Vec<(u32, &Feature)> {
    let meets = |(_, feature): &(u32, &Feature)| {
        let points: Vec<Point> = points(std::slice::from_ref(feature)).collect();
        let span = |of: fn(&Point) -> f64| {
            let all = points.iter().map(of);
            (all.clone().fold(f64::INFINITY, f64::min), all.fold(f64::NEG_INFINITY, f64::max))
        };
        let ((left, right), (bottom, top)) = (span(|p| p.x), span(|p| p.y));
        left <= high.x && low.x <= right && bottom <= high.y && low.y <= top
    };
    (0..).zip(features).filter(meets).collect()
}

fn complete(mut cuts: Cuts, features: &[(u32, &Feature)], largest: f64) -> Cuts {
    let everything = Grid::everything();
    let pieces = pieces(&everything, features.iter().copied(), largest);
    while !cuts.is_complete() {
        let all = cuts.search(&everything, Tile(0), &pieces).expect("in range");
        cuts.take([all]).expect("few rounds");
    }
    cuts
}

/// Compares the summaries of all tiles, made from all features and from the features in windows. Returns the fraction in windows.
fn compare(features: &[Feature], grid: &Grid) -> f64 {
    let largest = largest(features);
    let none = Cuts::new(largest).expect("finite");
    let numbered: Vec<(u32, &Feature)> = (0..).zip(features).collect();
    let all = complete(none.clone(), &numbered, largest);
    let limits = Limits::default();
    let mut given = 0;
    for tile in grid.tiles() {
        let first = in_window(features, none.window(grid, tile, []));
        let pieces = |features: &[(u32, &Feature)]| pieces(grid, features.iter().copied(), largest);
        let plain = |features: &[(u32, &Feature)]| Summary::new(grid, tile, &pieces(features), &limits);
        assert_eq!(plain(&first), plain(&numbered), "{tile}");
        let second =
            in_window(features, none.window(grid, tile, pieces(&first).iter().filter(|piece| piece.tile() == tile)));
        let cuts = complete(none.clone(), &second, largest);
        let cut = |features: &[(u32, &Feature)], cuts| {
            Summary::cut(grid, tile, &pieces(features), &limits, cuts).expect("in range")
        };
        assert_eq!(cut(&second, &cuts), cut(&numbered, &all), "{tile}");
        given += second.len();
    }
    given as f64 / (features.len() * grid.tiles().count()) as f64
}

#[test]
fn a_tile_needs_what_lies_in_its_window() {
    let mut random = Random::new(61);
    let mut share = 0.0;
    for round in 0..30 {
        let size = [1.0, 3.0, 9.0][round % 3];
        let mut triangle = || {
            let [x, y] = [random.part() * 20.0, random.part() * 20.0];
            let mut corner = || [x + random.part() * size, y + random.part() * size];
            [corner(), corner(), corner()]
        };
        let mut features: Vec<Feature> = (0..40).map(|_| feature([Shape::polygon(triangle())])).collect();
        features.push(feature([line(&[[0.0, 10.0], [20.0, 10.0]])]));
        share += compare(&features, &Grid::new([0.0, 0.0], [20.0, 20.0], 4, 3).expect("a grid"));
    }
    assert!(share < 30.0 * 0.6, "{share}");
}

/// Far from the origin, where bent edges are bent again by pixels that they visit.
#[test]
fn a_tile_needs_no_more_where_edges_are_bent_again() {
    let mut random = Random::new(62);
    let far = f64::from(1 << 24) * f64::from(1 << 24);
    let (mut bent, mut share) = (0, 0.0);
    for _ in 0..30 {
        let mut part = |size: f64| (random.part() * size * 16.0).floor() / 16.0;
        let clusters: Vec<[f64; 2]> = (0..12).map(|_| [far + part(20_000.0), far + part(20_000.0)]).collect();
        let features = clusters.iter().flat_map(|[x, y]| [[*x, *y]; 5]);
        let corners = features.map(|[x, y]| [0; 3].map(|_| [x + part(12.0), y + part(12.0)]));
        let mut features: Vec<Feature> = corners.map(|corners| feature([Shape::polygon(corners)])).collect();
        features.push(feature([line(&[[far + 6000.0, far + 6000.0], [far + 8000.0, far + 7000.0]])]));
        bent += usize::from(rounds(&features) > 1);
        let grid = Grid::new([far, far], [far + 20_000.0, far + 20_000.0], 3, 3).expect("a grid");
        share += compare(&features, &grid);
    }
    assert!(bent > 10 && share < 30.0 * 0.6, "{bent} {share}");
}
