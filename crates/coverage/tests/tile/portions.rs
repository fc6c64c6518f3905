//! Portions of maps: merged in any order, saved as bytes, and refused if they belong to other maps.

use crate::maps::{Random, area, feature};
use crate::whole::{all_pieces, grid, largest};
use serde_json::{from_value, to_value};
use twinedge_coverage::tile::{BytesError, Cuts, Found, Grid, MergeError, Portion, Source, Tile, TileError};
use twinedge_coverage::{CoverageRule, Limits};
use twinedge_map::Feature;

fn source(snapshot: u32) -> Source {
    Source::from([("snapshot".to_owned(), snapshot.to_string())])
}

fn found(cuts: &Cuts, grid: &Grid, features: &[Feature]) -> Vec<Found> {
    let pieces = all_pieces(grid, features);
    grid.tiles().map(|tile| cuts.search(grid, tile, &pieces).expect("in range")).collect()
}

/// All cuts of a map of this snapshot.
fn cuts(grid: &Grid, features: &[Feature], snapshot: u32) -> Cuts {
    let mut cuts = Cuts::new(largest(features)).expect("finite").with_source(source(snapshot));
    while !cuts.is_complete() {
        let these = found(&cuts, grid, features);
        cuts.take(these).expect("few rounds");
    }
    cuts
}

fn portions(grid: &Grid, features: &[Feature], snapshot: u32) -> Vec<Portion> {
    let (cuts, limits) = (cuts(grid, features, snapshot), Limits::default());
    let pieces = all_pieces(grid, features);
    let portion = |tile| Portion::new(grid, tile, &pieces, &limits, Some(&cuts)).expect("in range");
    grid.tiles().map(portion).collect()
}

/// Two parcels that overlap, and one that has a corner between their ends, across the lines of [`lines`].
fn parcels() -> Vec<Feature> {
    let corners = [([0.0, 0.0], [4.0, 3.0]), ([3.0, 2.0], [7.0, 6.0]), ([0.0, 3.0], [3.0, 8.0])];
    corners.map(|(low, high)| feature([area(low, high)])).into()
}

fn lines() -> Grid {
    grid(&[2.5, 6.0], &[3.0, 5.5])
}

#[test]
fn portions_are_merged_in_any_order_down_to_the_bytes_and_loaded_as_they_were_saved() {
    let (features, grid, mut random) = (parcels(), lines(), Random::new(3));
    let all = portions(&grid, &features, 7);
    let sum = |of: &[Portion]| {
        of.iter()
            .map(|one| Portion::from_bytes(&one.to_bytes()).expect("it was saved"))
            .reduce(|a, b| a.merge(b).unwrap())
    };
    let whole = sum(&all).unwrap();
    assert_eq!((whole.source(), whole.without_cuts(), whole.summary().tiles().len()), (&source(7), vec![], all.len()));
    for _ in 0..20 {
        let mut shuffled = all.clone();
        shuffled.sort_by_cached_key(|_| random.below(1000));
        let (one, other) = shuffled.split_at(random.below(shuffled.len() - 1) + 1);
        let merged = sum(one).unwrap().merge(sum(other).unwrap()).unwrap();
        assert_eq!(merged.to_bytes(), whole.to_bytes());
    }
}

/// Regression: tiles of two layers added up to a valid map.
#[test]
fn tiles_and_cuts_of_two_snapshots_are_not_put_together() {
    let (features, grid) = (parcels(), lines());
    let [seven, eight] = [7, 8].map(|snapshot| portions(&grid, &features, snapshot));
    let (what, one, other) = ("snapshot".to_owned(), "7".to_owned(), "8".to_owned());
    let error = MergeError::Different { what, one, other };
    assert_eq!(error.to_string(), "these are not tiles of one map: snapshot is 7 for the first and 8 for the second");
    assert_eq!(seven[0].clone().merge(eight[1].clone()), Err(error));
    let nameless = MergeError::Different { what: "snapshot".into(), one: "7".into(), other: "none".into() };
    assert_eq!(seven[0].belongs_to(&eight[1].clone().with_source(Source::new())), Err(nameless));
    assert_eq!(seven[0].belongs_to(&seven[0]), Err(MergeError::Twice(seven[0].summary().tiles()[0])));

    let empty = |snapshot| Cuts::new(largest(&features)).expect("finite").with_source(source(snapshot));
    let of_eight = found(&empty(8), &grid, &features);
    assert_eq!(empty(7).take(of_eight.clone()), Err(TileError::OtherCuts));
    assert_eq!(empty(8).take(of_eight), Ok(()));
    let early = Portion::new(&grid, Tile(0), &all_pieces(&grid, &features), &Limits::default(), Some(&empty(7)));
    assert_eq!(early.unwrap_err(), TileError::OtherCuts);
}

/// Regression: where edges meet within one cell there are no cuts, and the coverage was not judged.
#[test]
fn edges_that_meet_within_one_cell_are_rounded_though_nothing_is_cut() {
    let above = f64::EPSILON;
    let squares = [([0.0, 0.0], [1.0, 1.0]), ([1.0, above], [2.0, 1.0 + above])];
    let features: Vec<Feature> = squares.map(|(low, high)| feature([area(low, high)])).into();
    let grid = grid(&[1.0], &[0.5]);
    assert!(cuts(&grid, &features, 7).is_empty());
    let all = portions(&grid, &features, 7).into_iter();
    let (summary, cut) = all.reduce(|one, other| one.merge(other).unwrap()).unwrap().into_summaries();
    let outcome = summary.finish().unwrap();
    assert!(outcome.needs_cut());
    let coverage = outcome.with_cut(cut.unwrap().finish().unwrap()).coverage.unwrap();
    assert_eq!(coverage.findings.iter().map(|one| one.rule).collect::<Vec<_>>(), [CoverageRule::Mismatch]);
}

#[test]
fn bytes_that_were_changed_are_refused() {
    let all = portions(&lines(), &parcels(), 7);
    let bytes = all[0].to_bytes();
    for place in 0..bytes.len() {
        let mut changed = bytes.clone();
        changed[place] ^= 1 << (place % 8);
        let expected = match place {
            0..27 => BytesError::Foreign { expected: "a summary of tiles" },
            27..30 => BytesError::Version,
            _ => BytesError::Damaged,
        };
        assert_eq!(Portion::from_bytes(&changed), Err(expected), "byte {place}");
    }
    for length in 0..bytes.len() {
        assert!(Portion::from_bytes(&bytes[..length]).is_err(), "{length} bytes");
    }
    assert_eq!(Portion::from_bytes(&[&bytes[..], b"0"].concat()), Err(BytesError::Damaged));

    // With the right checksum, what a portion names must be there all the same.
    let forged = |from: &Portion, of: &str, to: &Portion| {
        let mut json = to_value(to).unwrap();
        json[of] = to_value(from).unwrap()[of].clone();
        from_value::<Portion>(json).is_ok()
    };
    assert!(forged(&all[0], "cut", &all[0]));
    assert!(!forged(&all[1], "cut", &all[0]));
}
