//! Memory use of audits, counted by the allocator.
#![allow(clippy::incompatible_msrv, reason = "the tests need the Rust version of their own dependencies")]
#![allow(clippy::needless_pass_by_value, reason = "quickcheck hands its arguments over")]

#[path = "../../../../tests/memory/counting.rs"]
mod counting;

use counting::{LIVE_BYTES, PEAK_BYTES};
use twinedge_coverage::tile::{Cuts, Grid, Piece, Summary};
use twinedge_coverage::{CoverageRule, Limits, check};
use twinedge_map::{Builder, Feature, Shape};

/// Islands in a sea are the worst case: near misses are searched between all of their edges.
#[test]
fn the_edges_of_coasts_are_held_by_the_index_alone() {
    // The whole check runs on this thread, whose memory is counted.
    rayon::ThreadPoolBuilder::new().num_threads(1).use_current_thread().build().unwrap();
    let edges: u16 = 40_000;
    let coast = (0..edges).map(|i| f64::from(i) / f64::from(edges) * std::f64::consts::TAU);
    let mut builder = Builder::new();
    builder.shape(&Shape::polygon(coast.map(|angle| [angle.cos(), angle.sin()]))).unwrap();
    let map = builder.build().unwrap();
    let before = LIVE_BYTES.get();
    PEAK_BYTES.set(before);
    assert!(check(&map, &Limits::default()).unwrap().findings.is_empty());
    let peak = (PEAK_BYTES.get() - before).cast_unsigned() / usize::from(edges);
    assert!(peak < 130, "{peak} bytes an edge");
}

/// The greatest number of bytes used by four tiles of `count` equal squares, and the saved size of the sum of three tiles.
fn of_equal(count: usize) -> [usize; 2] {
    let square = Shape::polygon([[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]);
    let square = Feature { shapes: vec![square], ..Feature::default() };
    let grid = Grid::new([0.0, 0.0], [2.0, 2.0], 2, 2).unwrap();
    let before = LIVE_BYTES.get();
    PEAK_BYTES.set(before);
    let cuts = Cuts::new(2.0).unwrap();
    let given: Vec<Piece> = (0..count as u32).flat_map(|number| cuts.pieces(&grid, number, &square).unwrap()).collect();
    let tile = |tile| Summary::new(&grid, tile, &given, &Limits::default()).unwrap();
    let mut tiles = grid.tiles().map(tile);
    let last = tiles.next().unwrap();
    let sum = tiles.reduce(|sum, one| sum.merge(one).unwrap()).unwrap();
    let saved = serde_json::to_vec(&sum).unwrap().len();
    let coverage = sum.merge(last).unwrap().finish().unwrap().coverage.unwrap();
    let [duplicate] = &coverage.findings[..] else { panic!("{:?}", coverage.findings) };
    assert_eq!((duplicate.rule, duplicate.features.len()), (CoverageRule::Duplicate, count));
    [(PEAK_BYTES.get() - before).cast_unsigned(), saved]
}

#[test]
fn equal_features_take_memory_in_proportion_to_their_number() {
    // Everything runs on this thread, whose memory is counted.
    rayon::ThreadPoolBuilder::new().num_threads(1).use_current_thread().build().unwrap();
    let (few, many) = (of_equal(400), of_equal(1600));
    for (few, many) in few.into_iter().zip(many) {
        assert!(many < 6 * few, "{few} {many}");
    }
}
