//! Pieces are little more than the map, and no tile is given much of it.

use crate::whole::{largest, points};
use twinedge_coverage::tile::{Cuts, Grid, Piece};
use twinedge_geometry::Point;
use twinedge_layers::{ReadOptions, read_for_map};
use twinedge_map::Feature;

fn world() -> Vec<Feature> {
    let mut file: &[u8] = include_bytes!("../../../../tests/data/world-50m.geojson");
    let (features, _) = read_for_map(&mut file, &ReadOptions::default()).expect("it is a map");
    features
}

/// Returns the number of points in pieces, divided by the number of points of features, and the greatest share of a tile.
fn proportions(features: &[Feature], grid: &Grid) -> [f64; 2] {
    let cuts = Cuts::new(largest(features)).expect("finite");
    let mut given = vec![0; grid.len()];
    for (number, feature) in (0..).zip(features) {
        for piece in cuts.pieces(grid, number, feature).expect("in range") {
            given[piece.tile().0 as usize] += piece.point_count();
        }
    }
    let all = points(features).count() as f64;
    let most = given.iter().max().expect("a tile");
    [given.iter().sum::<usize>() as f64 / all, *most as f64 / all]
}

/// Regression: features were given to all tiles that their boxes meet, as a whole, 20 times the map on 16 × 16 tiles.
#[test]
fn tiles_together_are_given_little_more_than_the_map() {
    let features = world();
    let even = Grid::new([-180.0, -90.0], [180.0, 90.0], 16, 16).expect("a grid");
    let [all, most] = proportions(&features, &even);
    assert!(all < 1.1 && most < 0.06, "{all} {most}");
    let count = points(&features).count();
    let fitted = Grid::fitted(points(&features).collect(), count / 256).expect("a grid");
    let [all, most] = proportions(&features, &fitted);
    assert!((256..=512).contains(&fitted.len()) && all < 1.2 && most < 0.01, "{} {all} {most}", fitted.len());
}

/// A diagonal is given only to the tiles that it passes, and a feature around tiles is a number to them.
#[test]
fn a_tile_is_given_what_lies_in_it() {
    let grid = Grid::new([0.0, 0.0], [8.0, 8.0], 8, 8).expect("a grid");
    let cuts = Cuts::new(16.0).expect("finite");
    let sizes = |ring: &[[f64; 2]]| {
        let feature = crate::maps::feature([crate::maps::line(ring)]);
        cuts.pieces(&grid, 3, &feature).expect("in range").iter().map(Piece::point_count).collect::<Vec<_>>()
    };
    assert_eq!(sizes(&[[0.25, 0.5], [7.25, 7.5]]), [2; 15]);
    let around = crate::maps::feature([crate::maps::area([-8.0, -8.0], [16.0, 16.0])]);
    let pieces = cuts.pieces(&grid, 3, &around).expect("in range");
    let inside = pieces.iter().filter(|piece| piece.point_count() == 0);
    assert_eq!((pieces.len(), inside.count()), (64, 36));
    assert!(pieces.iter().all(|piece| piece.feature() == 3));
    // The bytes of a number.
    assert!(pieces[9].to_bytes().len() < 60, "{}", pieces[9].to_bytes().len());
    let at = |x: f64| grid.tile_of(Point::new(x, x));
    assert_eq!((pieces[9].tile(), pieces[0].tile()), (at(1.5), at(0.0)));
}
