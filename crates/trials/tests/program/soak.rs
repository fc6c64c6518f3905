//! `soak` and `replay`.

use super::{json, refused, scratch_folder, trials, trials_reading};
use std::path::PathBuf;
use twinedge::program::Program;

/// Returns the path of a file in an empty folder of this name, also as text.
fn fresh(name: &str) -> (PathBuf, String) {
    let path = scratch_folder(name).join("failing.program");
    let name = path.to_str().unwrap().to_owned();
    (path, name)
}

#[test]
fn all_stores_stay_in_step() {
    let (status, found) = json(&["soak", "--programs", "60", "--steps", "60", "--seed", "1"]);
    assert_eq!((status, &found["ok"], &found["failure"]), (Some(0), &true.into(), &serde_json::Value::Null));
    let rows = found["structures"].as_array().unwrap();
    let names: Vec<&str> = rows.iter().map(|row| row["on"].as_str().unwrap()).collect();
    assert_eq!(names, ["slots", "limited", "pointers"]);
    let count = |row: &serde_json::Value, key: &str| row[key].as_u64().unwrap();
    for row in rows {
        let steps = ["applied", "refused", "skipped", "no_room"].map(|key| count(row, key)).iter().sum::<u64>();
        assert_eq!((count(row, "programs"), steps), (60, 60 * 60));
        // Programs try refusals and full stores on purpose; they are the smaller part.
        assert!(count(row, "applied") > 1000 && count(row, "refused") > 300, "{row}");
        assert!(row["on"] == "limited" || count(row, "no_room") == 0, "{row}");
    }
    // Equal seeds produce equal programs.
    let (_, again) = json(&["soak", "--programs", "60", "--steps", "60", "--seed", "1"]);
    assert_eq!(found["structures"], again["structures"]);
}

#[test]
fn a_finding_that_cannot_be_saved_is_printed_all_the_same() {
    let arguments =
        ["soak", "--programs", "50", "--seed", "1", "--on", "planted", "--save", "/no/such/folder/x.program"];
    let output = trials(&arguments);
    let text = String::from_utf8(refused(output, "/no/such/folder/x.program")).unwrap();
    assert!(text.contains("planted differs") && text.contains("#[test]"), "{text}");
    assert!(!text.contains("run it again"), "{text}");
}

#[test]
fn a_planted_bug_is_found_made_small_saved_and_replayed() {
    let (path, name) = fresh("planted");
    let arguments = ["soak", "--programs", "50", "--steps", "60", "--seed", "1", "--on", "planted", "--save", &name];
    let output = trials(&arguments);
    assert_eq!(output.status.code(), Some(1));
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.contains("planted differs") && text.contains("#[test]"), "{text}");
    // The printed test must compile: the structure with the bug is private.
    assert!(text.contains("use twinedge::dcel::Dcel;") && !text.contains("Planted"), "{text}");
    assert!(text.contains(&format!("twinedge-trials replay {name}")), "{text}");

    // A minimal program: the bug needs an edge that separates two faces, with more edges on both sides.
    let saved = std::fs::read_to_string(&path).unwrap();
    let program: Program = saved.parse().unwrap();
    assert!(program.0.len() <= 6, "{saved}");
    assert!(program.to_string().contains("flip_edge"), "{saved}");
    assert!(text.contains(&program.to_rust().replace('\n', "\n    ")), "{text}");

    let (status, replayed) = json(&["replay", &name]);
    assert_eq!((status, &replayed["on"]), (Some(1), &"planted".into()));
    assert!(replayed["difference"].as_str().unwrap().contains("flip_edge"));
    let steps = replayed["steps"].as_array().unwrap();
    assert_eq!(steps.len(), program.0.len());
    // The bug keeps every rule: only the reference reveals it.
    assert!(steps.iter().all(|step| step["valid"] == true));

    let (status, replayed) = json(&["replay", &name, "--on", "limited"]);
    assert_eq!((status, &replayed["ok"]), (Some(0), &true.into()));
}

#[test]
fn a_replay_shows_the_structure_after_each_step() {
    let program = b"twinedge program 1\nadd_isolated_vertex unbounded\nsplit_vertex i0 ~0\nremove_edge !h0\n";
    let output = trials_reading(&["replay", "-"], program);
    assert_eq!(output.status.code(), Some(0));
    let text = String::from_utf8(output.stdout).unwrap();
    for line in [
        "1. add_isolated_vertex unbounded: applied",
        "  v1  isolated b1",
        "  b1  face f1  start v1  inner, place 0",
        "   V 2  E 1  F 1  C 1",
        "  h2  origin v1  twin h3  next h3  prev h3  boundary b1",
        "  f1  outer nil  inner [b1]",
        "3. remove_edge !h0: skipped: nothing to choose from",
        "in step: slots did as the reference does",
        // The records chosen by the names in the program.
        "   records: in f1",
        "   records: v1 to v1",
    ] {
        assert!(text.lines().any(|shown| shown == line), "{line}\n{text}");
    }
    let output = trials_reading(&["replay", "-", "--on", "pointers"], program);
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.contains("  h0  origin v0  twin h1  next h1  prev h1  face f0"), "{text}");
}

#[test]
fn what_is_no_program_is_refused_with_its_place() {
    for (program, told) in [(&b"twinedge program 1\nconnect h0\n"[..], "standard input: line 2, column"), (b"\xFF", "")]
    {
        assert_eq!(refused(trials_reading(&["replay", "-"], program), told), b"");
    }
}

#[test]
fn a_panic_is_found_made_small_saved_and_replayed() {
    let (path, name) = fresh("panicking");
    let arguments = ["soak", "--programs", "50", "--seed", "1", "--on", "panicking", "--save", &name];
    let output = trials(&arguments);
    assert_eq!((output.status.code(), output.stderr), (Some(1), vec![]));
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.contains("panicked: a planted panic (") && text.contains("#[test]"), "{text}");
    let saved = std::fs::read_to_string(&path).unwrap();
    let program: Program = saved.parse().unwrap();
    assert_eq!(program.to_string(), "twinedge program 1\nadd_isolated_vertex unbounded\nmove_inner i0 unbounded\n");

    let output = trials(&["replay", &name]);
    assert_eq!((output.status.code(), output.stderr), (Some(1), vec![]));
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.starts_with("1. add_isolated_vertex unbounded: applied\n"), "{text}");
    assert!(text.contains("2. move_inner i0 unbounded: panicked: a planted panic ("), "{text}");
    assert!(text.contains("panicking differs in operator 2, `move_inner i0 unbounded`: panicked"), "{text}");
}

#[test]
fn no_earlier_finding_is_overwritten() {
    let (first, name) = fresh("earlier");
    let [second, third] = ["failing-2.program", "failing-3.program"].map(|name| first.with_file_name(name));
    std::fs::write(&first, "mine").unwrap();
    let arguments = ["soak", "--programs", "50", "--seed", "1", "--on", "planted", "--save", &name];
    let text = String::from_utf8(trials(&arguments).stdout).unwrap();
    assert_eq!(std::fs::read_to_string(&first).unwrap(), "mine");
    assert!(text.contains(&format!("saved as {}", second.display())), "{text}");
    let (_, found) = json(&["soak", "--programs", "50", "--seed", "1", "--on", "planted", "--save", &name]);
    assert_eq!(found["saved"], third.to_str().unwrap());
    assert_eq!(std::fs::read_to_string(&third).unwrap(), std::fs::read_to_string(&second).unwrap());
}
