//! Cuts saved and loaded between rounds, and forged files of cuts.

use crate::maps::{Random, area, feature, line};
use crate::whole::{all_pieces, grid, largest};
use serde_json::{Value, json, to_value};
use std::collections::BTreeMap;
use twinedge_coverage::Limits;
use twinedge_coverage::tile::{Cuts, Found, Grid, Piece, Summary, TileError};
use twinedge_map::{Feature, Shape};

/// Triangles so far from the origin that pieces are bent again, and a grid through the middle of them.
fn far(random: &mut Random, count: usize) -> (Vec<Feature>, Grid) {
    let far = f64::from(1 << 24) * f64::from(1 << 24);
    let mut corner = || [0; 2].map(|_| far + (random.part() * 640.0).floor() / 16.0);
    let triangles = (0..count).map(|_| feature([Shape::polygon([corner(), corner(), corner()])])).collect();
    (triangles, grid(&[far + 16.0], &[far + 20.0]))
}

fn found(cuts: &Cuts, grid: &Grid, pieces: &[Piece]) -> Vec<Found> {
    let concerned = grid.tiles().filter(|tile| cuts.concern(grid, *tile));
    concerned.map(|tile| cuts.search(grid, tile, pieces).expect("in range")).collect()
}

fn text(of: &impl serde::Serialize) -> String {
    serde_json::to_string(of).expect("it can be saved")
}

#[test]
fn cuts_that_are_saved_between_rounds_are_those_that_are_not() {
    let (mut random, mut most) = (Random::new(61), 0);
    for _ in 0..40 {
        let (features, grid) = far(&mut random, 12);
        let given = all_pieces(&grid, &features);
        let shuffled: Vec<_> = given.iter().rev().chain(&given[..2]).cloned().collect();
        let mut whole = Cuts::new(largest(&features)).expect("finite");
        let (mut saved, mut rounds) = (text(&whole), 0);
        while !whole.is_complete() {
            let mut read: Cuts = serde_json::from_str(&saved).expect("it was saved");
            let these = found(&whole, &grid, &given);
            // As on workers that see features in another order, and twice; one of them runs again.
            let mut those: Vec<Found> = found(&read, &grid, &shuffled);
            assert_eq!(text(&these), text(&those));
            those.reverse();
            those.push(those[0].clone());
            let those = serde_json::from_str::<Vec<Found>>(&text(&those)).expect("they were saved");
            whole.take(these).expect("few rounds");
            read.take(those).expect("few rounds");
            (saved, rounds) = (text(&read), rounds + 1);
            assert_eq!(saved, text(&whole), "round {rounds}");
        }
        let read: Cuts = serde_json::from_str(&saved).expect("it was saved");
        assert!(read.is_complete() && !read.is_empty());
        for tile in grid.tiles() {
            let cut = |cuts| Summary::cut(&grid, tile, &given, &Limits::default(), cuts).expect("in range");
            assert_eq!(cut(&read), cut(&whole));
        }
        most = most.max(rounds);
    }
    assert!(most > 3, "{most}");
}

#[test]
fn what_another_round_or_map_found_is_not_taken() {
    let square = |x: f64| feature([area([x, x], [x + 2.0, x + 2.0])]);
    let features = [square(0.0), square(1.0)];
    let grid = grid(&[1.5], &[1.5]);
    let given = all_pieces(&grid, &features);
    let mut cuts = Cuts::new(3.0).expect("finite");
    let first = found(&cuts, &grid, &given);
    let before = text(&cuts);
    let other = found(&Cuts::new(4.0).expect("finite"), &grid, &given);
    assert_eq!(cuts.take(first.iter().chain(&other).cloned()), Err(TileError::OtherCuts));
    assert_eq!(text(&cuts), before, "nothing was taken");
    cuts.take(first.clone()).expect("in order");
    assert_eq!(cuts.take(first), Err(TileError::OtherCuts));
    while !cuts.is_complete() {
        cuts.take(found(&cuts, &grid, &given)).expect("in order");
    }
    let last = found(&cuts, &Grid::everything(), &given);
    assert!(last.is_empty(), "nothing is left");
}

/// The cuts of two crossing lines after their first round, and the finds of that round.
fn crossing() -> (Value, Value) {
    let features = [feature([line(&[[0.0, 0.0], [4.0, 4.0]])]), feature([line(&[[0.0, 3.0], [4.0, 1.0]])])];
    let mut cuts = Cuts::new(4.0).expect("finite");
    let everything = Grid::everything();
    let found = found(&cuts, &everything, &all_pieces(&everything, &features));
    let saved = to_value(&found[0]).expect("it can be saved");
    cuts.take(found).expect("in order");
    (to_value(&cuts).expect("it can be saved"), saved)
}

#[test]
fn cuts_that_nothing_made_are_refused() {
    let (cuts, found) = crossing();
    let changed = |of: &Value, at: &str, to: Value| {
        let mut changed = of.clone();
        *changed.pointer_mut(at).unwrap_or_else(|| panic!("{at} in {of}")) = to;
        changed
    };
    let refused = |at: &str, to: Value, why: &str| {
        let error = serde_json::from_value::<Cuts>(changed(&cuts, at, to)).expect_err(at).to_string();
        assert!(error.contains(why), "{at}: {error}");
    };
    assert_eq!(cuts.pointer("/chains/0/0"), Some(&json!([[0.0, 0.0], [4.0, 4.0]])), "{cuts}");
    refused("/largest", json!(-1.0), "largest coordinate");
    refused("/largest", json!(3.0), "out of range");
    refused("/rounds", json!(0), "no such rounds");
    refused("/rounds", json!(61), "no such rounds");
    refused("/rounds", json!(u32::MAX), "no such rounds");
    // Invalid chains that turn back or leave the grid, so that following them would not terminate or would lead nowhere.
    for chain in
        [json!([]), json!([[0.0, 0.0]]), json!([[1.0, 1.0], [0.5, 2.0]]), json!([[1.0, 5.0]]), json!([[1e300, 1.0]])]
    {
        refused("/chains/0/1", chain, "out of order");
    }
    for point in [json!([0.1, 2.0]), json!([1e-300, 2.0]), json!([-0.0, 2.0]), json!([4.5, 4.5])] {
        refused("/crossings/0", point.clone(), "out of order");
        refused("/fresh/0/0", point.clone(), "out of order");
        refused("/seen/0/0", point, "out of order");
    }
    refused("/crossings", json!([[2.0, 2.0], [1.0, 1.0]]), "out of order");
    refused("/chains/0/0", json!([[4.0, 4.0], [0.0, 0.0]]), "out of order");
    refused("/seen", json!([]), "out of order");
    let refused = |at: &str, to: Value, why: &str| {
        let error = serde_json::from_value::<Found>(changed(&found, at, to)).expect_err(at).to_string();
        assert!(error.contains(why), "{at}: {error}");
    };
    refused("/round", json!(1), "no such rounds");
    refused("/largest", json!(-1.0), "largest coordinate");
    refused("/chains/0/0/0", json!([-9.0, 0.0]), "out of order");
    refused("/chains/0/1", json!([[0.1, 0.1]]), "out of order");
    refused("/doubtful", json!([[[1.0, 1.0], [0.0, 0.0]]]), "out of order");
    // Chains of several tiles are assembled before they are checked.
    for chain in [json!([]), json!([[4.0, 4.0]]), json!([[0.0, 4.0], [4.0, 0.0]]), json!([[1.0, 3.0], [3.0, 2.0]])] {
        let found: Found = serde_json::from_value(changed(&found, "/chains/0/1", chain)).expect("points are in range");
        assert_eq!(Cuts::new(4.0).expect("finite").take([found]), Err(TileError::OtherCuts));
    }
}

/// Every number of a file, by its path.
fn numbers(of: &Value, at: &str, all: &mut BTreeMap<String, f64>) {
    match of {
        Value::Number(number) => drop(all.insert(at.to_owned(), number.as_f64().expect("finite"))),
        Value::Array(list) => list.iter().enumerate().for_each(|(i, one)| numbers(one, &format!("{at}/{i}"), all)),
        Value::Object(map) => map.iter().for_each(|(name, one)| numbers(one, &format!("{at}/{name}"), all)),
        _ => {}
    }
}

/// A well-formed file may contain invalid cuts, but the rounds continue and end.
#[test]
fn rounds_with_changed_cuts_end() {
    let mut random = Random::new(62);
    let (mut refused, mut ended) = (0, 0);
    for _ in 0..3 {
        let (features, grid) = far(&mut random, 6);
        let given = all_pieces(&grid, &features);
        let mut cuts = Cuts::new(largest(&features)).expect("finite");
        cuts.take(found(&cuts, &grid, &given)).expect("in order");
        let saved = to_value(&cuts).expect("it can be saved");
        let mut places = BTreeMap::new();
        numbers(&saved, "", &mut places);
        for (at, number) in places.iter().filter(|(at, _)| at.matches('/').count() > 1) {
            let by = [0.125, -0.125, 1.0, -3.0][random.below(4)];
            let mut changed = saved.clone();
            *changed.pointer_mut(at).expect("it is there") = json!(number + by);
            let Ok(mut cuts) = serde_json::from_value::<Cuts>(changed) else {
                refused += 1;
                continue;
            };
            while !cuts.is_complete() && cuts.take(found(&cuts, &grid, &given)).is_ok() {}
            for tile in grid.tiles().filter(|_| cuts.is_complete()) {
                Summary::cut(&grid, tile, &given, &Limits::default(), &cuts).expect("in range");
            }
            ended += 1;
        }
    }
    assert!(refused > 50 && ended > 50, "{refused} {ended}");
}
