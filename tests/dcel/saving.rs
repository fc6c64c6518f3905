//! Saving and loading: the same map with the same keys, and nothing but planar subdivisions.

use crate::support::programs::{built, check};
use crate::support::saved::each_change;
use crate::support::tracked::Keys;
use serde_json::{Value, json, to_value};
use twinedge::dcel::{Dcel, HalfEdgeKey, SecondaryMap};
use twinedge::program::{Op, Program, Runner};

fn run(program: &Program) -> Runner<Dcel> {
    let mut runner = Runner::new(Dcel::new());
    runner.run(program);
    runner
}

fn loaded(saved: &Value) -> Result<Dcel, String> {
    serde_json::from_value(saved.clone()).map_err(|error| error.to_string())
}

#[test]
fn loading_gives_the_same_table_and_the_same_keys() {
    fn law(program: Program) {
        let runner = run(&program);
        let map = runner.subject();
        let again = loaded(&to_value(map).unwrap()).unwrap();
        assert_eq!(again, *map);
        for h in runner.retired_half_edges() {
            assert!(again.half_edge(*h).is_err());
        }
        for v in runner.retired_vertices() {
            assert!(again.vertex(*v).is_err());
        }
        for f in runner.retired_faces() {
            assert!(again.face(*f).is_err());
        }
    }
    check(200, 150, law as fn(Program));
}

#[test]
fn what_is_made_after_loading_has_keys_of_its_own() {
    fn law(program: Program, more: Program) {
        let runner = run(&program);
        let mut again = loaded(&to_value(runner.subject()).unwrap()).unwrap();
        let before = Keys::of(&again);
        let mut fresh = Vec::new();
        let outside = again.unbounded_face().key();
        for _ in 0..=more.0.len() {
            fresh.push(again.add_isolated_vertex(outside).unwrap().vertex);
        }
        for (i, v) in fresh.iter().enumerate() {
            assert!(!before.vertices.contains(v) && !runner.retired_vertices().contains(v) && !fresh[..i].contains(v));
        }
        assert!(again.validate().is_valid());
    }
    check(100, 60, law as fn(Program, Program));
}

#[test]
fn data_by_key_finds_its_records_again() {
    let map = built(&grown());
    let lengths: SecondaryMap<HalfEdgeKey, usize> = map.half_edges().map(|h| (h.key(), 10 * h.index())).collect();
    let text = serde_json::to_string(&(&map, &lengths)).unwrap();
    let (map, lengths): (Dcel, SecondaryMap<HalfEdgeKey, usize>) = serde_json::from_str(&text).unwrap();
    assert!(map.half_edge_count() > 0);
    for h in map.half_edges() {
        assert_eq!(lengths[h.key()], 10 * h.index());
    }
}

/// A triangle with a vertex inside, and a separate edge; some records were removed.
fn grown() -> Program {
    "twinedge program 1
    add_isolated_vertex unbounded
    split_vertex i0 i0
    connect h0 h1 left
    split_edge h0
    add_isolated_vertex h0
    add_isolated_vertex unbounded
    split_vertex i1 i1
    connect h2 h2 left
    remove_edge h8"
        .parse()
        .unwrap()
}

#[test]
fn every_value_changed_is_refused_with_a_report_or_gives_a_valid_map() {
    let saved = to_value(built(&grown())).unwrap();
    let (mut refused, mut reports, mut accepted) = (0, 0, 0);
    each_change(&saved, |_, changed| match loaded(&changed) {
        Ok(map) => {
            assert!(map.validate().is_valid());
            accepted += 1;
        }
        Err(error) => {
            refused += 1;
            reports += usize::from(error.contains("BROKEN"));
        }
    });
    assert!(refused > 300 && reports > 200, "{refused} refused, {reports} reports");
    // Generations and starts may differ.
    assert!(accepted > 0, "{accepted}");
}

#[test]
fn what_is_broken_is_refused_with_the_report() {
    let mut saved = to_value(built(&grown())).unwrap();
    let first = saved["next"][0].clone();
    saved["next"][1] = first;
    let error = loaded(&saved).unwrap_err();
    assert!(error.starts_with("the structure is not valid:"), "{error}");
    assert!(error.contains("L2"), "{error}");
}

#[test]
fn columns_must_fit_each_other() {
    let saved = to_value(built(&grown())).unwrap();
    for column in ["leaving", "origin", "next", "boundary", "start", "outer", "inner"] {
        let mut short = saved.clone();
        short[column].as_array_mut().unwrap().pop();
        assert_eq!(loaded(&short).unwrap_err(), "a column is too short or too long", "{column}");
        let mut long = saved.clone();
        let last = long[column].as_array().unwrap().last().unwrap().clone();
        long[column].as_array_mut().unwrap().push(last);
        assert_eq!(loaded(&long).unwrap_err(), "a column is too short or too long", "{column}");
    }
}

#[test]
fn other_forms_are_refused() {
    let mut saved = to_value(Dcel::new()).unwrap();
    saved["form"] = json!(2);
    assert_eq!(loaded(&saved).unwrap_err(), "form 2 of a structure is not known");
    saved["form"] = json!(1);
    saved["more"] = json!(1);
    assert!(loaded(&saved).unwrap_err().contains("unknown field `more`"));
}

#[test]
fn impossible_generations_are_refused() {
    let map = built(&grown());
    let saved = to_value(&map).unwrap();
    let mut odd = saved.clone();
    odd["generations"]["offset"] = json!(saved["generations"]["offset"].as_u64().unwrap() + 1);
    assert!(loaded(&odd).is_err());
    // The first slot of each kind is never used.
    let mut first = to_value(Dcel::new()).unwrap();
    first["generations"]["vertices"] = json!([1]);
    first["leaving"] = json!([null]);
    first["start"] = json!([{ "vertex": 0 }]);
    first["generations"]["boundaries"] = json!([0, 1]);
    first["inner"] = json!([[1]]);
    assert!(loaded(&first).is_err());
}

#[test]
fn programs_are_saved_and_loaded() {
    fn law(program: Program) -> bool {
        let text = serde_json::to_string(&program).unwrap();
        serde_json::from_str::<Program>(&text).unwrap() == program
    }
    check(100, 60, law as fn(Program) -> bool);
    let op: Op = serde_json::from_str(r#"{"SplitEdge":{"half_edge":{"Live":3}}}"#).unwrap();
    assert_eq!(op.to_string(), "split_edge h3");
}
