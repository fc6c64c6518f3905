//! Summaries corrupted after they were made, and the order of merging.

use crate::maps::{Random, area, feature, line, nested, point};
use crate::whole::{all_pieces, grid, merged, pieces, summaries};
use serde_json::{Value, json, to_value};
use twinedge::validate::Rule;
use twinedge_coverage::Limits;
use twinedge_coverage::tile::{
    Cuts, FinishError, Grid, GridError, MergeError, Outcome, SeamRule, Summary, Tile, TileError,
};
use twinedge_map::{BuildError, Feature, Shape};

/// A cross of four parcels with an enclave, an island and a path, cut by both lines of the grid.
fn parcels() -> Vec<Feature> {
    vec![
        feature([area([0.0, 0.0], [4.0, 4.0]).hole([[1.0, 1.0], [1.0, 3.0], [3.0, 3.0], [3.0, 1.0]])]),
        feature([area([1.0, 1.0], [3.0, 3.0])]),
        feature([Shape::polygon([[4.0, 0.0], [8.0, 0.0], [8.0, 4.0], [4.0, 4.0]])]),
        feature([line(&[[5.0, 1.0], [7.0, 3.0], [5.0, 3.0]]), point(2.0, 2.0)]),
        feature([area([0.0, 6.0], [8.0, 7.0])]),
    ]
}

fn lines() -> Grid {
    grid(&[2.0, 6.0], &[2.0, 6.5])
}

fn finished(mut summaries: Vec<Summary>) -> Outcome {
    let first = summaries.remove(0);
    let sum = summaries.into_iter().fold(first, |sum, one| sum.merge(one).expect("different tiles"));
    sum.finish().expect("none is missing")
}

/// All changes of a value at some place of a summary, one at a time.
fn changes(of: &Value) -> Vec<(String, Value)> {
    let mut found = Vec::new();
    let value = |at: &str| of.pointer(at).unwrap_or_else(|| panic!("nothing at {at}"));
    let mut set = |at: &str, to: Value| {
        if *value(at) != to {
            let mut changed = of.clone();
            let what = format!("{at}: {to}");
            *changed.pointer_mut(at).expect("it has a value") = to;
            found.push((what, changed));
        }
    };
    let list = |at: &str| value(at).as_array().expect("a list").clone();
    let more = |at: &str| json!(value(at).as_u64().expect("a number") + 1);
    let [components, cycles, faces] = ["/components", "/cycles", "/faces"].map(|key| list(key).len());
    for border in (0..list("/borders").len()).map(|b| format!("/borders/{b}")) {
        let [contacts, beside] = ["contacts", "faces"].map(|key| list(&format!("{border}/{key}")));
        for c in 0..contacts.len() {
            let at = format!("{border}/contacts/{c}");
            for place in ["0/0", "0/1", "1/0", "1/1"] {
                let at = format!("{at}/edge/{place}");
                set(&at, json!(value(&at).as_f64().expect("a number") + 0.25));
            }
            let features = list(&format!("{at}/features"));
            set(&format!("{at}/features"), json!([&features[..], &[json!(77)]].concat()));
            set(&format!("{at}/features"), json!(features[..features.len().saturating_sub(1)]));
            (0..components).for_each(|component| set(&format!("{at}/component"), json!(component)));
            for way in 0..2 {
                (0..cycles).for_each(|cycle| set(&format!("{at}/cycles/{way}"), json!(cycle)));
            }
            // A contact is dropped, repeated, or swapped with the one before it.
            for how in 0..3 {
                let (mut these, mut those) = (contacts.clone(), beside.clone());
                match how {
                    0 => drop((these.remove(c), those.remove(c))),
                    1 => {
                        these.insert(c, contacts[c].clone());
                        those.insert(c, beside[c].clone());
                    }
                    _ => these.swap(c.saturating_sub(1), c),
                }
                let mut changed = value(&border).clone();
                (changed["contacts"], changed["faces"]) = (these.into(), those.into());
                set(&border, changed);
            }
        }
        for place in 0..=contacts.len() {
            (0..faces).for_each(|face| set(&format!("{border}/faces/{place}"), json!(face)));
        }
    }
    for face in (0..faces).map(|face| format!("/faces/{face}")) {
        let at = format!("{face}/is_unbounded");
        set(&at, json!(!value(&at).as_bool().expect("a truth value")));
        set(&format!("{face}/features"), json!([]));
        set(&format!("{face}/features"), json!([77]));
    }
    for cycle in 0..cycles {
        (0..components).for_each(|component| set(&format!("/cycles/{cycle}"), json!(component)));
    }
    let of_component = |one| ["vertices", "edges", "cycles"].map(|key| format!("/components/{one}/{key}"));
    let totals = ["components", "isolated_vertices", "faces", "unbounded_faces", "cycles"];
    for at in (0..components).flat_map(of_component).chain(totals.map(|key| format!("/totals/{key}"))) {
        set(&at, more(&at));
    }
    found
}

#[test]
fn every_change_of_a_contact_is_found() {
    let summaries = summaries(&parcels(), &lines(), &Limits::default());
    let right = finished(summaries.clone());
    assert!(right.is_valid());
    let (mut refused, mut found, mut harmless) = (0, 0, 0);
    for tile in 0..summaries.len() {
        for (what, changed) in changes(&to_value(&summaries[tile]).expect("it can be saved")) {
            let Ok(summary) = serde_json::from_value::<Summary>(changed) else {
                refused += 1;
                continue;
            };
            let mut all = summaries.clone();
            all[tile] = summary;
            let outcome = finished(all);
            if outcome.is_valid() {
                assert_eq!(outcome, right, "tile {tile}: {what}");
                harmless += 1;
            } else {
                found += 1;
            }
        }
    }
    assert!(found > 1000 && refused > 20 && harmless < found / 10, "{found} {refused} {harmless}");
}

#[test]
fn a_contact_of_one_side_is_named() {
    let summaries = summaries(&parcels(), &lines(), &Limits::default());
    let tile = summaries[0].tiles()[0];
    let mut changed = to_value(&summaries[0]).expect("it can be saved");
    let border = changed["borders"].as_array_mut().and_then(|all| all.first_mut()).expect("a border");
    let dropped = border["contacts"].as_array_mut().expect("a list").remove(0);
    border["faces"].as_array_mut().expect("a list").remove(0);
    let mut all = summaries.clone();
    all[0] = serde_json::from_value(changed).expect("it could be a summary");
    let outcome = finished(all);
    let [fault] = &outcome.seams[..] else { panic!("{:?}", outcome.seams) };
    assert_eq!((fault.rule, fault.rule.id()), (SeamRule::Contact, "S1"));
    assert_eq!(to_value(fault.edge).expect("it can be saved"), dropped["edge"]);
    assert_ne!(fault.tile, tile);
}

#[test]
fn a_feature_that_a_tile_was_not_given_is_found() {
    let (features, grid) = (parcels(), lines());
    for missing in 0..features.len() as u32 {
        for (place, tile) in grid.tiles().enumerate() {
            let mut all = summaries(&features, &grid, &Limits::default());
            let mut given = all_pieces(&grid, &features);
            given.retain(|piece| piece.feature() != missing);
            let without = Summary::new(&grid, tile, &given, &Limits::default()).expect("in range");
            if without != all[place] {
                all[place] = without;
                let outcome = finished(all);
                assert!(!outcome.is_valid() && outcome.not_given == [missing], "{missing} {tile}");
            }
        }
    }
}

/// The parts of one feature on a row of three tiles, given by their starts, each 3 long, as each tile receives them.
#[test]
fn a_feature_that_differs_between_tiles_is_found_in_any_order_of_merging() {
    let grid = grid(&[4.0, 8.0], &[]);
    let given: [[&[f64]; 3]; 4] = [
        // Two tiles agree on less than the first one received.
        [&[0.5, 4.5, 8.5], &[0.5, 4.5], &[0.5, 4.5]],
        [&[0.5], &[0.5, 4.5], &[]],
        // The correct number of tiles for each, but not the tiles of one.
        [&[0.5, 4.5], &[], &[4.5, 8.5]],
        [&[0.5, 4.5], &[0.5, 4.5], &[4.5, 8.5]],
    ];
    for given in given {
        let summary = |(tile, parts): (Tile, &[f64])| {
            let parts: Vec<Shape> = parts.iter().map(|x| area([*x, 0.0], [x + 3.0, 1.0])).collect();
            let pieces = pieces(&grid, [(7, &feature(parts))], 12.0);
            Summary::new(&grid, tile, &pieces, &Limits::default()).expect("in range")
        };
        let all: Vec<Summary> = grid.tiles().zip(given).map(summary).collect();
        let mut outcomes = Vec::new();
        for [i, j, k] in [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
            let outcome = finished(vec![all[i].clone(), all[j].clone(), all[k].clone()]);
            assert_eq!(outcome.not_given, [7], "{given:?} {i} {j} {k}");
            outcomes.push(outcome);
        }
        assert!(outcomes.windows(2).all(|pair| pair[0] == pair[1]), "{given:?}");
    }
}

#[test]
fn numbers_that_no_map_has_are_refused_or_stay_where_they_are() {
    const MOST: u64 = 1 << 53;
    let all = summaries(&parcels(), &lines(), &Limits::default());
    let saved = to_value(&all[4]).expect("it can be saved");
    let changed = |of: &Value, at: &str, to: Value| {
        let mut changed = of.clone();
        *changed.pointer_mut(at).unwrap_or_else(|| panic!("{at} in {of}")) = to;
        changed
    };
    let refused = |at: &str, to: Value, why: &str| {
        let error = serde_json::from_value::<Summary>(changed(&saved, at, to)).expect_err(at).to_string();
        assert!(error.contains(why), "{at}: {error}");
    };
    let totals = ["vertices", "edges", "cycles", "components", "isolated_vertices", "faces", "unbounded_faces"];
    let totals = totals.map(|key| format!("/totals/{key}"));
    let of_component = ["vertices", "edges", "cycles"].map(|key| format!("/components/0/{key}"));
    for at in totals.iter().chain(&of_component) {
        refused(at, json!(MOST + 1), "larger than any map has");
        refused(at, json!(u64::MAX), "larger than any map has");
    }
    refused("/extents", json!([[2048, 1]]), "larger than any map has");
    refused("/extents", json!([[1023, MOST + 1]]), "larger than any map has");
    refused("/extents", json!([[7, 1], [7, 1]]), "out of order");
    refused("/claimed/0/of", json!(0), "out of range");
    refused("/claimed/0/first", json!(9), "out of range");
    // The remaining sums do not overflow.
    let mut most = all.iter().map(|one| to_value(one).expect("it can be saved")).collect::<Vec<_>>();
    for one in &mut most {
        for at in totals.iter().chain(&of_component) {
            if one.pointer(at).is_some() {
                *one = changed(one, at, json!(MOST));
            }
        }
        *one = changed(one, "/extents", json!([[2047, MOST]]));
    }
    let outcome = finished(most.into_iter().map(|one| serde_json::from_value(one).expect("in range")).collect());
    assert!(!outcome.is_valid());
    assert_eq!((outcome.counts.vertices, outcome.counts.half_edges), (1 << 53, 1 << 54));
    assert_eq!(outcome.extents, [(2047, MOST)]);
    assert_eq!(outcome.bounds().map(|bounds| bounds.most_edges), Some((3 << 53) - 6));
    let checked = |rule| outcome.rules().find(|(other, _)| *other == rule).map(|(_, outcome)| outcome.checked);
    assert_eq!((checked(Rule::L1), checked(Rule::V1)), (Some(1 << 54), Some(0)));
}

#[test]
fn any_order_of_merging_gives_the_same_bytes() {
    let mut random = Random::new(41);
    for limits in [Limits::default(), Limits { gap_width: Some(0.1), sliver_area: Some(0.5), ..Limits::default() }] {
        for _ in 0..40 {
            let mut features = Vec::new();
            nested([-7, -7], [7, 7], &mut random, &mut features);
            let all = summaries(&features, &grid(&[-2.5, 1.0], &[-1.0, 3.0]), &limits);
            // Any tiles, in any order, even without common sides.
            let mut chosen: Vec<Summary> = all.into_iter().filter(|_| random.below(3) > 0).collect();
            if chosen.is_empty() {
                continue;
            }
            let bytes = |summary: &Summary| serde_json::to_vec(summary).expect("it can be saved");
            let first = merged(chosen.clone(), &mut random);
            chosen.reverse();
            let second = merged(chosen, &mut random);
            assert_eq!(bytes(&first), bytes(&second));
            // A saved summary can be loaded.
            let read: Summary = serde_json::from_slice(&bytes(&first)).expect("it was saved");
            assert_eq!(read, first);
        }
    }
}

#[test]
fn an_early_merge_finds_no_more_at_a_seam_than_a_late_one_where_another_tile_has_crossings() {
    let mut features = parcels();
    features.push(feature([line(&[[6.5, 6.6], [7.5, 6.9]]), line(&[[6.5, 6.9], [7.5, 6.6]])]));
    let all = summaries(&features, &lines(), &Limits::default());
    let mut contradictions = 0;
    let mut changes = changes(&to_value(&all[0]).expect("it can be saved"));
    changes.retain(|(what, _)| what.contains("feature") || what.contains("/faces/"));
    for (what, changed) in changes {
        let Ok(changed) = serde_json::from_value::<Summary>(changed) else { continue };
        let mut early = all.clone();
        early[0] = changed;
        let mut late = early.clone();
        late.rotate_left(1);
        late.reverse();
        let [early, late] = [early, late].map(finished);
        assert_eq!(early, late, "{what}");
        contradictions += usize::from(!early.seams.is_empty());
    }
    assert!(contradictions > 5, "{contradictions}");
}

#[test]
fn what_cannot_be_merged_is_refused() {
    let (features, grid) = (parcels(), lines());
    let limits = Limits::default();
    let all = summaries(&features, &grid, &limits);
    let (tile, of_grid) = (Tile(0), all_pieces(&grid, &features));
    assert_eq!(all[0].clone().merge(all[0].clone()), Err(MergeError::Twice(tile)));
    let other = Grid::new([0.0, 0.0], [1.0, 1.0], 3, 3).expect("a grid");
    let of_other = Summary::new(&other, Tile(1), &all_pieces(&other, &features), &limits).expect("in range");
    assert!(matches!(all[0].clone().merge(of_other), Err(MergeError::Different { what, .. }) if what == "the grid"));
    let by_width = Limits { gap_width: Some(1.0), ..Limits::default() };
    let of_width = Summary::new(&grid, Tile(1), &of_grid, &by_width).expect("in range");
    let (what, one, other) = ("gap_width".to_owned(), "none".to_owned(), "1".to_owned());
    assert_eq!(all[0].clone().merge(of_width), Err(MergeError::Different { what, one, other }));
    assert_eq!(all[1].clone().finish().unwrap_err(), FinishError::Missing { first: tile, count: 8 });
    let outside = Tile(9);
    assert_eq!(Summary::new(&grid, outside, &of_grid, &limits).unwrap_err(), TileError::NoSuchTile(outside));
    let twice = pieces(&grid, [(5, &features[0]), (5, &features[1])], 8.0);
    assert_eq!(Summary::new(&grid, Tile(4), &twice, &limits).unwrap_err(), TileError::SameNumber(5));
    let far = feature([line(&[[0.0, 0.0], [1e200, 0.0]])]);
    let divided = Cuts::new(1e300).expect("finite").pieces(&grid, 0, &far);
    assert!(matches!(divided, Err(BuildError::OutOfRange { .. })), "{divided:?}");
    assert_eq!(Grid::new([0.0, 0.0], [1.0, 1.0], 0, 3), Err(GridError::Size));
    assert_eq!(Grid::new([0.0, 0.0], [0.0, 1.0], 3, 3), Err(GridError::Lines));
}
