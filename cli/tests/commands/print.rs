//! `--print`, and `twinedge audit` on files of tables.

use crate::support::{complaint, json as json_of, twinedge, twinedge_reading};
use serde_json::{Value, json};
use twinedge::validate::Table;

/// Returns the lines printed by a command, and its summary.
fn printed(arguments: &[&str]) -> (Vec<String>, String) {
    let output = twinedge(arguments);
    assert_eq!(output.status.code(), Some(0), "{arguments:?}");
    let text = String::from_utf8(output.stdout).unwrap();
    (text.lines().map(str::to_owned).collect(), String::from_utf8(output.stderr).unwrap())
}

fn audit(input: &str, more: &[&str]) -> (Option<i32>, Value) {
    let output = twinedge_reading(&[&["audit", "-", "--format", "json"], more].concat(), input.as_bytes());
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
    (output.status.code(), serde_json::from_slice(&output.stdout).unwrap())
}

#[test]
fn every_table_is_printed_with_its_verdict() {
    let (lines, summary) = printed(&["tables", "--half-edges", "0", "--print"]);
    assert!(summary.contains("two isolated vertices") && summary.contains("agreed"), "{summary}");
    assert_eq!(lines[0], "# expect: plane");
    let tables: Vec<(&str, &str)> = lines[1..].iter().map(|line| line.split_once(" = ").unwrap()).collect();
    for (table, _) in &tables {
        assert_eq!(table.parse::<Table>().unwrap().to_string(), *table);
    }
    // As the formula says.
    assert_eq!(tables.iter().filter(|(_, verdict)| *verdict == "ok").count(), 4);
    let (_, found) = json_of(&["tables", "--half-edges", "0", "--format", "json"]);
    assert_eq!(found["tables"][0]["judged"], tables.len());
}

#[test]
fn what_is_printed_is_judged_the_same() {
    for arguments in [
        &["tables", "--half-edges", "0", "--print", "--threads", "3"][..],
        &["sample", "--tables", "1500", "--seed", "1", "--print"],
        &["corrupt", "--edges", "0", "--pairs", "50", "--seed", "1", "--print"],
        &["corrupt", "--edges", "0", "--pairs", "50", "--seed", "1", "--print", "--on", "pointers"],
    ] {
        let (lines, _) = printed(arguments);
        let tables = lines.iter().filter(|line| !line.starts_with('#')).count();
        let right = lines.iter().filter(|line| line.ends_with(" = ok")).count();
        let (status, found) = audit(&(lines.join("\n") + "\n"), &["--list", "0"]);
        assert_eq!((status, &found["verdicts_differ"]), (Some(1), &json!(0)), "{arguments:?}");
        assert_eq!((&found["tables"], &found["valid_tables"]), (&json!(tables), &json!(right)));
        assert!(tables > right && right > 0);
    }
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
    assert_eq!(twinedge(&["tables", "--print", "--format", "json"]).status.code(), Some(2));
}

#[test]
#[cfg(unix)]
fn printing_stops_when_nobody_reads_on() {
    use std::process::{Command, Stdio};
    let mut child = Command::new(env!("CARGO_BIN_EXE_twinedge"))
        .args(["tables", "--half-edges", "8", "--force", "--print"])
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    assert_eq!(child.wait().unwrap().code(), Some(130));
}
