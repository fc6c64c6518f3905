//! `--shard` and `sum`.

use super::{json, refused, scratch_folder, trials};
use serde_json::Value;
use std::path::PathBuf;

/// Writes the JSON of each part to a file. Returns the file names, the last part first.
fn parts(folder: &str, arguments: &[&str], count: u32) -> Vec<String> {
    let folder = scratch_folder(folder);
    let part = |index| {
        let shard = format!("{index}/{count}");
        let output = trials(&[arguments, &["--format", "json", "--shard", &shard]].concat());
        assert_eq!(output.status.code(), Some(0), "{arguments:?} {shard}");
        file(&folder, &format!("{index}.json"), &output.stdout)
    };
    (0..count).rev().map(part).collect()
}

fn file(folder: &std::path::Path, name: &str, content: &[u8]) -> String {
    let path: PathBuf = folder.join(name);
    std::fs::write(&path, content).unwrap();
    path.to_str().unwrap().to_owned()
}

fn sum(files: &[String], more: &[&str]) -> std::process::Output {
    let files: Vec<&str> = files.iter().map(String::as_str).collect();
    trials(&[&["sum"], &files[..], more].concat())
}

/// Removes times, which differ from run to run.
fn without_times(mut value: Value) -> Value {
    match &mut value {
        Value::Object(object) => {
            object.retain(|key, _| key != "elapsed_ms" && key != "slowest_us");
            object.values_mut().for_each(|value| *value = without_times(value.take()));
        }
        Value::Array(array) => array.iter_mut().for_each(|value| *value = without_times(value.take())),
        _ => {}
    }
    value
}

#[test]
fn the_parts_of_each_command_add_up_to_the_whole() {
    for (arguments, count) in [
        (&["prove", "--edges", "2"][..], 3),
        (&["prove", "--meshes", "4"], 3),
        (&["corrupt", "--edges", "1", "--pairs", "2500", "--seed", "7"], 2),
        (&["tables", "--half-edges", "0"], 3),
        (&["sample", "--tables", "2500", "--seed", "7"], 2),
        (&["soak", "--programs", "12", "--steps", "20", "--seed", "3"], 3),
    ] {
        let files = parts(&format!("sum-{}{}-{count}", arguments[0], arguments[1]), arguments, count);
        let output = sum(&files, &["--format", "json"]);
        assert_eq!((output.status.code(), output.stderr), (Some(0), vec![]), "{arguments:?}");
        let added: Value = serde_json::from_slice(&output.stdout).unwrap();
        let (status, whole) = json(arguments);
        assert_eq!(status, Some(0));
        let command = if arguments[1] == "--meshes" { "prove --meshes" } else { arguments[0] };
        assert_eq!((&whole["ok"], &whole["shard"], &whole["command"]), (&true.into(), &"0/1".into(), &command.into()));
        assert_eq!(without_times(added), without_times(whole), "{arguments:?}");
    }
}

#[test]
fn a_sum_is_printed_as_the_command_prints_it() {
    let files = parts("sum-text", &["prove", "--edges", "1"], 2);
    let output = sum(&files, &[]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(output.status.code() == Some(0) && text.contains("exhausted up to 1 edge: all counts agree"), "{text}");
}

#[test]
fn something_wrong_in_a_part_is_wrong_in_the_sum() {
    let folder = scratch_folder("sum-wrong");
    let save = folder.join("x.program");
    let part = |shard: &str| {
        let arguments =
            ["soak", "--programs", "10", "--seed", "1", "--on", "planted", "--format", "json", "--shard", shard];
        trials(&[&arguments[..], &["--save", save.to_str().unwrap()]].concat()).stdout
    };
    let files = [file(&folder, "a", &part("0/2")), file(&folder, "b", &part("1/2"))];
    let output = sum(&files, &["--format", "json"]);
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!((output.status.code(), &found["ok"]), (Some(1), &false.into()));
    assert_eq!(found["failure"]["on"], "planted");
}

#[test]
fn counts_that_are_wrong_in_the_sum_are_found() {
    let files = parts("sum-counts", &["prove", "--edges", "1"], 2);
    let text = std::fs::read_to_string(&files[0]).unwrap();
    let mut part: Value = serde_json::from_str(&text).unwrap();
    part["edges"][1]["rooted"] = 7.into();
    std::fs::write(&files[0], part.to_string()).unwrap();
    let output = sum(&files, &[]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(output.status.code() == Some(1) && text.contains('≠') && text.contains("wrong: a count"), "{text}");
}

#[test]
fn what_is_no_whole_is_refused() {
    let folder = scratch_folder("sum-refused");
    let part = |name: &str, arguments: &[&str]| {
        let output = trials(&[arguments, &["--format", "json"]].concat());
        file(&folder, name, &output.stdout)
    };
    let soak = ["soak", "--programs", "4", "--steps", "5", "--on", "slots"];
    let first = part("first", &[&soak[..], &["--seed", "1", "--shard", "0/2"]].concat());
    let second = part("second", &[&soak[..], &["--seed", "1", "--shard", "1/2"]].concat());
    let seed = part("seed", &[&soak[..], &["--seed", "2", "--shard", "1/2"]].concat());
    let third = part("third", &[&soak[..], &["--seed", "1", "--shard", "1/3"]].concat());
    let model = part(
        "pointers",
        &["soak", "--programs", "4", "--steps", "5", "--seed", "1", "--on", "pointers", "--shard", "1/2"],
    );
    let tables = part("tables", &["tables", "--half-edges", "0", "--shard", "1/2"]);
    let other = file(&folder, "other", b"{\"command\": \"audit\"}");
    let mut newer: Value = serde_json::from_slice(&std::fs::read(&second).unwrap()).unwrap();
    newer["version"] = "9.9.9".into();
    let newer = file(&folder, "newer", newer.to_string().as_bytes());
    let mut interrupted: Value = serde_json::from_slice(&std::fs::read(&second).unwrap()).unwrap();
    interrupted["interrupted"] = true.into();
    let interrupted = file(&folder, "interrupted", interrupted.to_string().as_bytes());
    let mut less: Value = serde_json::from_slice(&std::fs::read(&second).unwrap()).unwrap();
    less.as_object_mut().unwrap().remove("structures");
    let less = file(&folder, "less", less.to_string().as_bytes());
    for (files, told) in [
        (&[&first][..], "1 part is missing: 1/2"),
        (&[&first, &second, &first], "first: part 0/2 is there twice"),
        (&[&first, &third], "third: this is part 1/3, but the first is part 0/2"),
        (&[&first, &seed], "seed: seed is 2, but 1 in "),
        (&[&first, &model], "pointers: this is a part of other work"),
        (&[&first, &tables], "tables: command is \"tables\", but \"soak\" in "),
        (&[&first, &newer], "newer: version is \"9.9.9\""),
        (&[&first, &interrupted], "interrupted: part 1/2 was interrupted"),
        (&[&first, &less], "less: missing field `structures`"),
        (&[&other], "other: not the JSON output of prove, corrupt, tables, sample or soak"),
        (&[&"no-such-file".to_owned()], "no-such-file: "),
        (
            &[&file(&folder, "text", b"in step")],
            "text: not the JSON output of prove, corrupt, tables, sample or soak: expected value",
        ),
    ] {
        let files: Vec<String> = files.iter().map(|file| (*file).clone()).collect();
        assert_eq!(refused(sum(&files, &[]), told), b"");
    }
}
