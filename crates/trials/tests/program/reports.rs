//! The reports of the engines, as text, as JSON and with `--print`. The tests of the library check the counts in them.

use super::{json, text, trials};
use serde_json::json;
use twinedge::validate::{Expectation, Table};
use twinedge_trials::{Checker as _, Validator};

#[test]
fn people_get_a_table_and_a_verdict() {
    for (arguments, told) in [
        (&["prove", "--edges", "2", "--threads", "2"][..], &["exhausted up to 2 edges: all counts agree"][..]),
        (&["prove", "--edges", "1", "--shard", "1/2"], &["Part 1/2, counted from 0", "no violation in this part"]),
        (&["corrupt", "--edges", "1", "--pairs", "10"], &["pairs, seed ", "\nsound: everything wrong was caught"]),
        (&["tables", "--half-edges", "0"], &["two isolated vertices", "\nagreed: on "]),
        (&["sample", "--tables", "100"], &["100 tables judged, seed ", "\nagreed ("]),
        (&["soak", "--programs", "2", "--steps", "5"], &["operators in step", "\nin step: no structure differed ("]),
    ] {
        let (status, text) = text(arguments);
        assert_eq!(status, Some(0), "{arguments:?}");
        assert!(told.iter().all(|told| text.contains(told)), "{told:?}\n{text}");
        assert!(!text.contains('≠') && !text.contains('\u{1b}'), "{text}");
    }
    let (status, text) = text(&["prove", "--meshes", "4", "--on", "planted", "--color", "always"]);
    assert!(status == Some(1) && text.contains("not as defined") && text.contains("flip_edge h"), "{text}");
    assert!(text.contains('\u{1b}'));
    assert_eq!(super::text(&["prove", "--edges", "1", "-q"]), (Some(0), String::new()));
}

#[test]
fn scripts_get_what_identifies_the_work_and_the_results_in_one_object() {
    let common = ["command", "version", "work", "shard", "interrupted", "ok", "elapsed_ms"];
    for (arguments, command, keys) in [
        (&["prove", "--edges", "1"][..], "prove", &["on", "edges", "genus", "nested", "unsupported", "findings"][..]),
        (&["prove", "--meshes", "3"], "prove --meshes", &["on", "rows", "operators", "findings"]),
        (
            &["corrupt", "--edges", "0", "--pairs", "9"],
            "corrupt",
            &[
                "on",
                "maps",
                "maps_found",
                "unusable",
                "fields",
                "expectations",
                "small_pairs",
                "pairs",
                "first_broken",
                "hung",
                "panics",
                "findings",
            ],
        ),
        (&["tables", "--half-edges", "0"], "tables", &["tables", "findings"]),
        (&["sample", "--tables", "9"], "sample", &["judged", "right", "first_broken", "disagreements", "findings"]),
        (&["soak", "--programs", "2"], "soak", &["seed", "structures", "failure", "saved"]),
    ] {
        let (status, found) = json(arguments);
        let mut expected: Vec<&str> = common.iter().chain(keys).copied().collect();
        expected.sort_unstable();
        let mut keys: Vec<&str> = found.as_object().unwrap().keys().map(String::as_str).collect();
        keys.sort_unstable();
        assert_eq!((status, keys), (Some(0), expected), "{arguments:?}");
        assert_eq!([&found["command"], &found["shard"]], [command, "0/1"]);
        assert_eq!([&found["ok"], &found["interrupted"]], [true, false]);
    }
}

#[test]
fn lazy_runs_are_estimated_on_standard_error() {
    let output = trials(&["tables", "--lazy", "--parts", "prev,leaving", "--half-edges", "2"]);
    let said = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(0));
    assert!(said.starts_with("estimated: ") && said.ends_with(" runs, about 0 seconds\n"), "{said}");

    let edge = ["tables", "--lazy", "--certificates", "--parts", "all", "--half-edges", "2", "--faces", "1"];
    let plane = [&edge[..], &["--boundaries", "1", "--expect", "plane"]].concat();
    let output = trials(&[&plane[..], &["--format", "json"]].concat());
    let found: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!((output.status.code(), &found["command"]), (Some(0), &json!("tables --lazy")));
    assert_eq!([&found["accepted"], &found["differences"], &found["ok"]].map(ToString::to_string), ["4", "0", "true"]);
    // Each table with 3 orders of ranks.
    assert_eq!(found["judges"][1]["accepted"], 12);
    let (_, text) = text(&plane);
    assert!(text.starts_with("Tables: 10^11.5, with labels 10^13.1\n"), "{text}");
    let output = trials(&[&edge[..], &["--expect", "plane open"]].concat());
    super::refused(output, "certificates are of the plane");
}

/// `twinedge audit` reads the printed lines.
#[test]
fn every_table_is_printed_with_its_verdict() {
    for arguments in [
        &["tables", "--half-edges", "0", "--print", "--threads", "3"][..],
        &["sample", "--tables", "1500", "--seed", "1", "--print"],
        &["corrupt", "--edges", "0", "--pairs", "50", "--seed", "1", "--print", "--on", "pointers"],
    ] {
        let output = trials(arguments);
        let [lines, summary] = [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).unwrap());
        assert!(
            output.status.code() == Some(0) && summary.contains("judged") | summary.contains("agreed"),
            "{summary}"
        );
        let mut expectation: Option<Expectation> = None;
        let (mut right, mut wrong) = (0, 0);
        for line in lines.lines() {
            if let Some(expected) = line.strip_prefix("# expect: ") {
                expectation = Some(expected.parse().unwrap());
                continue;
            }
            let (written, verdict) = line.split_once(" = ").unwrap();
            let table: Table = written.parse().unwrap();
            assert_eq!(table.to_string(), written);
            let broken = Validator.check(&table, &expectation.unwrap()).broken;
            assert_eq!(verdict, broken.map_or("ok", |rule| rule.id()), "{line}");
            *if broken.is_some() { &mut wrong } else { &mut right } += 1;
        }
        assert!(right > 0 && wrong > 0, "{arguments:?}");
        if arguments[0] == "tables" {
            // As the formula says.
            assert_eq!(right, 4);
            let (_, found) = json(&["tables", "--half-edges", "0"]);
            assert_eq!(found["tables"][0]["judged"], right + wrong);
        }
    }
}

#[test]
fn the_readme_shows_what_is_printed() {
    let page = include_str!("../../README.md");
    let (_, sample) = page.split_once("```console\n$ twinedge-trials ").unwrap();
    let (arguments, expected) = sample.split_once("\n```").unwrap().0.split_once('\n').unwrap();
    let (_, printed) = text(&arguments.split(' ').collect::<Vec<_>>());
    // The time differs.
    let [printed, expected] = [printed.trim_end(), expected].map(|text| text.rsplit_once(" (").unwrap().0);
    assert_eq!(printed, expected);
}
