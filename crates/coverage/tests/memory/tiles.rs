//! Memory used by tiles, counted by the allocator.

use crate::counting::{LIVE_BYTES, PEAK_BYTES};
use twinedge_coverage::tile::{Grid, Summary};
use twinedge_coverage::{CoverageRule, Limits};
use twinedge_map::{Feature, Shape};

/// The greatest number of bytes used by four tiles of `count` equal squares, and the saved size of the sum of three tiles.
fn of_equal(count: usize) -> [usize; 2] {
    let square = Shape::polygon([[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]);
    let square = Feature { shapes: vec![square], ..Feature::default() };
    let grid = Grid::new([0.0, 0.0], [2.0, 2.0], 2, 2).unwrap();
    let before = LIVE_BYTES.get();
    PEAK_BYTES.set(before);
    let given = (0..count as u32).map(|number| (number, &square));
    let tile = |tile| Summary::new(&grid, tile, given.clone(), &Limits::default()).unwrap();
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
