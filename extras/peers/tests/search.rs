//! The machinery: programs as text, the search, the shrinker, and the child process.

use twinedge_peers::crates::PEERS;
use twinedge_peers::entry::Entry;
use twinedge_peers::judge::Judge;
use twinedge_peers::program::{Operator, Program};
use twinedge_peers::run::Verdict;
use twinedge_peers::search::Search;
use twinedge_peers::shrink::shrink;

fn entry(name: &str) -> Entry {
    *PEERS.iter().find(|entry| entry.name == name).unwrap()
}

#[test]
fn programs_are_read_as_they_are_written() {
    for entry in PEERS {
        for number in 0..50 {
            let program = Program::random(entry.operators, 1, number, 30);
            assert_eq!(Program::parse(&program.to_text(entry.operators), entry.operators), Ok(program.clone()));
            assert_eq!(Program::random(entry.operators, 1, number, 30), program);
            assert!((1..=30).contains(&program.0.len()));
        }
    }
    let operators = entry("dcel").operators;
    for wrong in ["insert_polygons 1", "insert_polygon", "insert_polygon 1 2", "insert_polygon x"] {
        assert!(Program::parse(wrong, operators).is_err(), "{wrong}");
    }
    assert_eq!(Program::parse(" ", operators), Ok(Program::default()));
}

/// The shrunk program keeps a call of `use` with the place of the third record, and drops two records and their calls.
#[test]
fn programs_shrink_to_what_matters() {
    let operators = [Operator::with_values("make", 1, 1), Operator::on_records("use", 1, 1)];
    let program = Program::parse("make 5; make 6; use 0; make 7; use 1; use 5; make 9", &operators).unwrap();
    let keeps = |program: &Program| {
        let mut made = Vec::new();
        Ok::<_, ()>(program.0.iter().any(|step| {
            let [argument] = step.arguments[..] else { unreachable!() };
            if operators[step.operator].name == "make" {
                made.push(argument);
            }
            operators[step.operator].name == "use" && !made.is_empty() && made[argument as usize % made.len()] >= 7
        }))
    };
    assert!(keeps(&program).unwrap());
    assert_eq!(shrink(&program, &operators, keeps).unwrap().to_text(&operators), "make 7; use 0");
}

/// Works in a release build of this package, because it compares findings and not times.
#[test]
fn the_same_search_finds_the_same() {
    let search = |seed| {
        let executable = env!("CARGO_BIN_EXE_twinedge-peers").into();
        let without =
            ["insert_polygon", "insert_polygon_in_face", "merge_faces_around_inner_vertex"].map(str::to_owned);
        let search =
            Search { entry: entry("dcel"), programs: 300, seed, steps: 30, without: without.into(), executable };
        search.run().unwrap()
    };
    let (first, second) = (search(1), search(1));
    let told = |outcome: &twinedge_peers::search::Outcome| format!("{outcome:?}");
    assert_eq!(told(&first), told(&second));
    assert_ne!(told(&first), told(&search(2)));
    let found = &first.found["remove_edge breaks F1"];
    assert!(found.programs > 0 && found.shortest.to_text(entry("dcel").operators) == "insert_mesh 0 0; remove_edge 0");
    assert!(first.sound > 0);
}

/// A judge whose child never answers: each program "ends the process".
#[test]
fn a_child_that_ends_is_a_finding() {
    let mut judge = Judge::new(entry("dcel"), "/does/not/exist".into());
    let program = Program::parse("insert_polygon 0", entry("dcel").operators).unwrap();
    match judge.run(&program) {
        Ok(Verdict::Finding(finding)) => assert_eq!(finding.what, "ends the process"),
        Ok(verdict) => panic!("{verdict:?}"),
        Err(error) => assert_eq!(error.kind(), std::io::ErrorKind::NotFound),
    }
}
