//! A map as a whole and by its tiles.

use crate::maps::Random;
use twinedge::map::{Builder, Feature, PlanarMap};
use twinedge::tile::{Grid, Outcome, Summary};

/// The map of all features.
pub(crate) fn whole(features: &[Feature]) -> PlanarMap {
    let mut builder = Builder::new();
    for feature in features {
        builder.feature(feature).expect("in range");
    }
    builder.build().expect("there is room")
}

/// The grid with lines at these places: at most two of each kind.
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

/// The summary of each tile.
pub(crate) fn summaries(features: &[Feature], grid: &Grid) -> Vec<Summary> {
    let numbered = || (0..).zip(features);
    grid.tiles().map(|tile| Summary::new(grid, tile, numbered()).expect("in range")).collect()
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

/// The audit by tiles.
pub(crate) fn by_tiles(features: &[Feature], grid: &Grid, random: &mut Random) -> Outcome {
    merged(summaries(features, grid), random).finish().expect("no tile is missing")
}

/// The same, compared with the whole.
pub(crate) fn compare(features: &[Feature], grid: &Grid, random: &mut Random) {
    let map = whole(features);
    let report = map.validate();
    let outcome = by_tiles(features, grid, random);
    assert_eq!(outcome.is_valid(), report.is_valid(), "{grid:?} {features:?}\n{outcome:?}");
    assert_eq!(outcome.counts, *report.counts(), "{grid:?} {features:?}");
}
