//! Saving and loading: the same map with the same keys, and nothing but planar subdivisions.

use quickcheck::{Gen, QuickCheck, Testable};
use serde_json::{Value, json};
use twinedge::dcel::{BoundaryKey, Dcel, FaceKey, HalfEdgeKey, SecondaryMap, VertexKey};
use twinedge::program::{Op, Program, Runner};

fn check(tests: u64, size: usize, law: impl Testable) {
    QuickCheck::new().rng(Gen::from_size_and_seed(size, 2026)).tests(tests).quickcheck(law);
}

fn built(program: &Program) -> Runner<Dcel> {
    let mut runner = Runner::new(Dcel::new());
    runner.run(program);
    runner
}

fn loaded(saved: &Value) -> Result<Dcel, String> {
    serde_json::from_value(saved.clone()).map_err(|error| error.to_string())
}

type AllKeys = (Vec<VertexKey>, Vec<HalfEdgeKey>, Vec<BoundaryKey>, Vec<FaceKey>);

fn keys(map: &Dcel) -> AllKeys {
    (
        map.vertices().map(|v| v.key()).collect(),
        map.half_edges().map(|h| h.key()).collect(),
        map.boundaries().map(|b| b.key()).collect(),
        map.faces().map(|f| f.key()).collect(),
    )
}

#[test]
fn loading_gives_the_same_table_and_the_same_keys() {
    fn law(program: Program) {
        let runner = built(&program);
        let map = runner.subject();
        let again = loaded(&serde_json::to_value(map).unwrap()).unwrap();
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
        let runner = built(&program);
        let mut again = loaded(&serde_json::to_value(runner.subject()).unwrap()).unwrap();
        let before = keys(&again);
        let mut fresh = Vec::new();
        let outside = again.unbounded_face().key();
        for _ in 0..=more.0.len() {
            fresh.push(again.add_isolated_vertex(outside).unwrap().vertex);
        }
        for (i, v) in fresh.iter().enumerate() {
            assert!(!before.0.contains(v) && !runner.retired_vertices().contains(v) && !fresh[..i].contains(v));
        }
        assert!(again.validate().is_valid());
    }
    check(100, 60, law as fn(Program, Program));
}

#[test]
fn data_by_key_finds_its_records_again() {
    let map = built(&grown()).into_subject();
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
fn every_number_changed_is_refused_with_a_report_or_gives_a_valid_map() {
    let map = built(&grown()).into_subject();
    let saved = serde_json::to_value(&map).unwrap();
    let mut paths = Vec::new();
    numbers(&saved, &mut Vec::new(), &mut paths);
    let (mut refused, mut reports, mut accepted) = (0, 0, 0);
    for path in &paths {
        for other in [json!(null), json!(0), json!(1), json!(2), json!(3), json!(7), json!(4_294_967_295_u32)] {
            let mut changed = saved.clone();
            let place = path.iter().fold(&mut changed, |value, step| match step {
                Step::Field(name) => &mut value[name.as_str()],
                Step::Item(i) => &mut value[*i],
            });
            if *place == other {
                continue;
            }
            *place = other;
            match loaded(&changed) {
                Ok(map) => {
                    assert!(map.validate().is_valid());
                    accepted += 1;
                }
                Err(error) => {
                    refused += 1;
                    reports += usize::from(error.contains("BROKEN"));
                }
            }
        }
    }
    assert!(refused > 300 && reports > 200, "{refused} refused, {reports} reports");
    // Generations and starts may differ.
    assert!(accepted > 0, "{accepted}");
}

enum Step {
    Field(String),
    Item(usize),
}

impl Clone for Step {
    fn clone(&self) -> Self {
        match self {
            Self::Field(name) => Self::Field(name.clone()),
            Self::Item(i) => Self::Item(*i),
        }
    }
}

/// Collects the paths of all values that are neither objects nor arrays.
fn numbers(value: &Value, at: &mut Vec<Step>, paths: &mut Vec<Vec<Step>>) {
    match value {
        Value::Object(fields) => {
            for (name, value) in fields {
                at.push(Step::Field(name.clone()));
                numbers(value, at, paths);
                at.pop();
            }
        }
        Value::Array(items) => {
            for (i, value) in items.iter().enumerate() {
                at.push(Step::Item(i));
                numbers(value, at, paths);
                at.pop();
            }
        }
        _ => paths.push(at.clone()),
    }
}

#[test]
fn what_is_broken_is_refused_with_the_report() {
    let mut saved = serde_json::to_value(built(&grown()).into_subject()).unwrap();
    let first = saved["next"][0].clone();
    saved["next"][1] = first;
    let error = loaded(&saved).unwrap_err();
    assert!(error.starts_with("the structure is not valid:"), "{error}");
    assert!(error.contains("L2"), "{error}");
}

#[test]
fn columns_must_fit_each_other() {
    let saved = serde_json::to_value(built(&grown()).into_subject()).unwrap();
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
    let mut saved = serde_json::to_value(Dcel::new()).unwrap();
    saved["form"] = json!(2);
    assert_eq!(loaded(&saved).unwrap_err(), "form 2 of a structure is not known");
    saved["form"] = json!(1);
    saved["more"] = json!(1);
    assert!(loaded(&saved).unwrap_err().contains("unknown field `more`"));
}

#[test]
fn impossible_generations_are_refused() {
    let map = built(&grown()).into_subject();
    let saved = serde_json::to_value(&map).unwrap();
    let mut odd = saved.clone();
    odd["generations"]["offset"] = json!(saved["generations"]["offset"].as_u64().unwrap() + 1);
    assert!(loaded(&odd).is_err());
    // The first slot of each kind is never used.
    let mut first = serde_json::to_value(Dcel::new()).unwrap();
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
