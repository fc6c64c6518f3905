//! Counts and the verdict.

use crate::maps::{Random, area, feature, lattice_edges, line, nested, point, sets};
use crate::whole::{compare, grid};
use twinedge_coverage::Limits;
use twinedge_map::Feature;

/// Positions of lines: between the points of the lattice, through them, and outside.
const LINES: [f64; 6] = [-0.5, 0.0, 0.5, 1.0, 1.25, 2.0];

fn features_of(edges: &[[[f64; 2]; 2]], chosen: usize) -> Vec<Feature> {
    let is_chosen = |(i, _): &(usize, &[[f64; 2]; 2])| chosen >> i & 1 == 1;
    edges.iter().enumerate().filter(is_chosen).map(|(_, edge)| feature([line(edge)])).collect()
}

#[test]
fn every_map_of_lattice_edges_adds_up() {
    let (edges, sets, mut random) = (lattice_edges(), sets(&LINES), Random::new(1));
    assert_eq!(edges.len(), 16);
    for chosen in (0..1 << 16).step_by(41) {
        let features = features_of(&edges, chosen);
        let [upright, level] = [0; 2].map(|_| sets[random.below(sets.len())].clone());
        compare(&features, &grid(&upright, &level), &Limits::default(), &mut random);
    }
}

#[test]
fn some_maps_add_up_under_every_tiling() {
    let (edges, sets, mut random) = (lattice_edges(), sets(&LINES), Random::new(2));
    for _ in 0..2 {
        let mut features = features_of(&edges, random.below(1 << 16));
        features.push(feature([point(0.5, 1.25), point(-0.5, -0.5), point(1.0, 0.25), point(2.0, 2.5)]));
        features.push(feature([area([-0.5, 3.0], [2.0, 4.0])]));
        for upright in &sets {
            for level in &sets {
                compare(&features, &grid(upright, level), &Limits::default(), &mut random);
            }
        }
    }
}

#[test]
fn nested_islands_add_up() {
    let mut random = Random::new(3);
    for _ in 0..150 {
        let mut features = Vec::new();
        nested([-7, -7], [7, 7], &mut random, &mut features);
        let (upright, level) = (random.lines(-14, 2.0), random.lines(-14, 2.0));
        compare(&features, &grid(&upright, &level), &Limits::default(), &mut random);
    }
}
