//! `twinedge audit` on files of tables.

use crate::support::{complaint, twinedge_reading};
use serde_json::{Value, json};
use std::fmt::Write as _;
use std::sync::Mutex;
use twinedge::dcel::Dcel;
use twinedge::validate::{Expectation, Table};
use twinedge_trials::corrupt::{CorruptWork, abort};
use twinedge_trials::sample::SampleWork;
use twinedge_trials::tables::TablesWork;
use twinedge_trials::{Checker, Run, Structure, Validator, Verdict, corrupt, sample, tables};

fn audit(input: &str, more: &[&str]) -> (Option<i32>, Value) {
    let output = twinedge_reading(&[&["audit", "-", "--format", "json"], more].concat(), input.as_bytes());
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
    (output.status.code(), serde_json::from_slice(&output.stdout).unwrap())
}

/// Writes each judged table with its verdict, as `twinedge-trials … --print` does.
#[derive(Default)]
struct Lines(Mutex<String>);

impl Checker for Lines {
    fn check(&self, table: &Table, expectation: &Expectation) -> Verdict {
        Validator.check(table, expectation)
    }

    fn checked(&self, table: &Table, expectation: &Expectation, verdict: Verdict) {
        let verdict = verdict.broken.map_or("ok", |rule| rule.id());
        writeln!(self.0.lock().unwrap(), "# expect: {expectation}\n{table} = {verdict}").unwrap();
    }
}

#[test]
fn the_tables_of_the_trials_are_judged_as_they_are_there() {
    let (lines, run) = (Lines::default(), Run::default());
    tables(TablesWork { half_edges: 0 }, &lines, &run);
    sample(SampleWork { tables: 1500, seed: 1 }, &lines, &run);
    let slots = Structure::new("slots", Dcel::new, Expectation::plane());
    corrupt(&slots, CorruptWork { edges: 0, pairs: 50, seed: 1 }, &lines, &run, &abort).unwrap();
    let lines = lines.0.into_inner().unwrap();
    let tables = lines.lines().count() / 2;
    let right = lines.lines().filter(|line| line.ends_with(" = ok")).count();
    let (status, found) = audit(&lines, &["--list", "0"]);
    assert_eq!((status, &found["verdicts_differ"]), (Some(1), &json!(0)));
    assert_eq!((&found["tables"], &found["valid_tables"]), (&json!(tables), &json!(right)));
    assert!(tables > right && right > 0);
}

/// An isolated vertex in the unbounded face.
const RIGHT: &str = "V 1 - 0 H 0 B 1 0 v0 i0 F 1 - 1 0";

#[test]
fn each_line_is_judged_and_each_verdict_compared() {
    let (status, found) = audit(&format!("# a comment\n\n{RIGHT}\n  {RIGHT} = ok\n"), &[]);
    assert_eq!(status, Some(0));
    assert_eq!((&found["valid"], &found["tables"], &found["violations"]), (&json!(true), &json!(2), &json!([])));

    // The face lists nothing.
    let wrong = "V 1 - 0 H 0 B 1 0 v0 i0 F 1 - 0";
    let (status, found) = audit(&format!("{wrong}\n{wrong} = F2\n{RIGHT} = R1\n{wrong} = ok\n"), &[]);
    assert_eq!((status, &found["valid"], &found["verdicts_differ"]), (Some(1), &json!(false), &json!(2)));
    assert_eq!(found["rules"], json!([{"id": "F2", "tables": 3}]));
    let lines: Vec<_> = found["violations"].as_array().unwrap().iter().map(|v| (&v["line"], &v["rule"])).collect();
    let f2 = &json!("F2");
    assert_eq!(lines, [(&json!(1), f2), (&json!(2), f2), (&json!(3), &json!("ok")), (&json!(4), f2), (&json!(4), f2)]);
    assert_eq!(found["violations"][2]["message"], "the file says R1");

    let output = twinedge_reading(&["audit", "-", "--list", "1"], format!("{wrong}\n{wrong} = ok\n").as_bytes());
    let text = String::from_utf8(output.stdout).unwrap();
    for line in ["line 1  F2 ", "… and 2 more; see --list", "  F2  broken in 2 tables"] {
        assert!(text.contains(line), "{line}\n{text}");
    }
    assert!(text.contains("not valid: 0 of 2 tables valid, 1 verdict of the file differs"), "{text}");
}

#[test]
fn a_comment_says_what_tables_are_held_to() {
    let mesh = "V 0 H 2 0 1 0 - - 0 0 1 - - B 0 F 0\n";
    assert_eq!(audit(mesh, &[]).0, Some(1));
    // A torus of one face.
    let torus = "P 0 V 1 - - H 4 0 1 2 - - 0 0 3 - - 0 3 1 - - 0 2 0 - - B 0 F 0\n";
    let (status, found) = audit(&format!("# expect: surface\n{torus}"), &[]);
    assert_eq!((status, &found["valid"]), (Some(0), &json!(true)), "{found}");
    assert_eq!(audit(&format!("# expect: surface\n{torus}# expect: plane\n{torus}"), &[]).0, Some(1));
}

#[test]
fn lines_that_are_no_tables_are_errors() {
    for (input, told) in [
        (format!("{RIGHT}\nV 1 - zero\n"), "standard input: line 2: "),
        (format!("{RIGHT} R1\n"), "standard input: line 1: "),
        ("# expect: sphere\n".to_owned(), "standard input: line 1: expected `plane` or `surface`"),
        (
            format!("{RIGHT}\n# expect: plane without arms\n"),
            "line 2: expected `open` or `asking` in place of `without`",
        ),
        (format!("{RIGHT}\nP 1 arms {RIGHT}\n"), "line 2: a part (`prev`,"),
    ] {
        let output = twinedge_reading(&["audit", "-"], input.as_bytes());
        assert_eq!(output.status.code(), Some(2), "{input}");
        let complained = complaint(&output);
        assert!(complained.contains(told), "{told}\n{complained}");
    }
    let output = twinedge_reading(&["audit", "-"], b"V 0 H 0 B 0 F 0\n\xFF\n");
    assert!(output.status.code() == Some(2) && complaint(&output).contains("line 2"));
}
