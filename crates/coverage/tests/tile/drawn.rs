//! Maps with coordinates of many digits, plane or not, and maps of the world.

use crate::maps::{Random, feature, line, point};
use crate::whole::{compare, grid};
use twinedge_coverage::Limits;
use twinedge_coverage::tile::Grid;
use twinedge_layers::{ReadOptions, read_for_map};
use twinedge_map::{Feature, Shape};

/// Triangles that grow until they may meet others.
fn triangles(random: &mut Random, count: usize, size: f64) -> Vec<Feature> {
    let shape = |random: &mut Random| {
        let [x, y] = [random.part(), random.part()];
        let corner = |random: &mut Random| [x + random.part() * size, y + random.part() * size];
        let corners = [corner(random), corner(random), corner(random)];
        match random.below(4) {
            0 => line(&corners),
            1 => point(x, y),
            _ => Shape::polygon(corners),
        }
    };
    (0..count).map(|_| feature([shape(random)])).collect()
}

#[test]
fn random_maps_add_up_plane_or_not() {
    let mut random = Random::new(21);
    let mut plane = 0;
    for round in 0..300 {
        let size = [0.02, 0.1, 0.4][round % 3];
        let features = triangles(&mut random, 24, size);
        plane += usize::from(crate::whole::whole(&features).is_plane());
        let (upright, level) = (random.pair(Random::part), random.pair(Random::part));
        compare(&features, &grid(&upright, &level), &Limits::default(), &mut random);
    }
    assert!((50..250).contains(&plane), "{plane}");
}

fn world(mut text: &[u8]) -> Vec<Feature> {
    read_for_map(&mut text, &ReadOptions::default()).expect("it is GeoJSON").0
}

/// Runs `rounds` grids around the world.
fn around_the_world(features: &[Feature], rounds: usize, random: &mut Random) {
    for round in 0..rounds {
        let low = [-180.0 - random.part(), -90.0 - random.part()];
        let high = [180.0 + random.part(), 90.0 + random.part()];
        let [columns, rows] = [1 + random.below(6), 1 + random.below(6)].map(|n| n as u32);
        // Lines also pass through vertices, at degrees with many borders.
        let (low, high) = if round % 3 == 0 { ([-180.0, -90.0], [180.0, 90.0]) } else { (low, high) };
        let grid = Grid::new(low, high, columns, rows).expect("a grid");
        let limits = match round % 2 {
            0 => Limits::default(),
            _ => Limits { gap_width: Some(0.05), sliver_area: Some(0.01), ..Limits::default() },
        };
        compare(features, &grid, &limits, random);
    }
}

const SMALL: &[u8] = include_bytes!("../../../cli/data/world-110m.geojson");
const CROSSING: &[u8] = include_bytes!("../../../../tests/data/world-110m-crossing.geojson");
const LARGE: &[u8] = include_bytes!("../../../../tests/data/world-50m.geojson");

/// Leaves some features out, and repeats others.
fn planted(mut features: Vec<Feature>, random: &mut Random) -> Vec<Feature> {
    for _ in 0..4 {
        features.remove(random.below(features.len()));
        features.push(features[random.below(features.len())].clone());
    }
    features
}

#[test]
fn the_world_adds_up() {
    let mut random = Random::new(31);
    around_the_world(&world(SMALL), 6, &mut random);
    around_the_world(&planted(world(SMALL), &mut random), 6, &mut random);
    around_the_world(&world(CROSSING), 2, &mut random);
}

/// Coasts with many islands, cut by few lines: the smaller map already covers grids of all sizes.
#[test]
fn a_larger_world_adds_up() {
    let mut random = Random::new(32);
    around_the_world(&planted(world(LARGE), &mut random), 1, &mut random);
}
