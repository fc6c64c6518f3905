//! Ctrl-C.

use crate::support::{data, scratch_folder};
use std::process::{Child, Command, Stdio};

/// Returns true if the process handles SIGINT itself.
fn is_ready(child: &Child) -> bool {
    let status = std::fs::read_to_string(format!("/proc/{}/status", child.id())).unwrap();
    let caught = status.lines().find_map(|line| line.strip_prefix("SigCgt:")).unwrap();
    u64::from_str_radix(caught.trim(), 16).unwrap() & 1 << 1 != 0
}

/// Returns the output of the program when interrupted as early as possible.
fn interrupted(arguments: &[&str]) -> String {
    let mut child = Command::new(env!("CARGO_BIN_EXE_twinedge"))
        .args(arguments)
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    while child.try_wait().unwrap().is_none() && !is_ready(&child) {
        std::thread::yield_now();
    }
    let sent = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(sent.success());
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(130), "{arguments:?}");
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn what_was_covered_is_printed() {
    for arguments in [
        &["prove", "--edges", "10", "--force"][..],
        &["corrupt", "--edges", "8", "--force"],
        &["tables", "--half-edges", "8", "--force"],
        &["soak", "--programs", "100000000", "--force"],
        // A single program runs to its end.
        &["soak", "--programs", "1", "--steps", "1000000", "--force"],
    ] {
        let text = interrupted(arguments);
        assert!(text.contains("interrupted: this is what was covered") && text.contains("not finished"), "{text}");
    }
}

#[test]
fn maps_that_were_only_found_do_not_count_as_covered() {
    let text = interrupted(&["corrupt", "--edges", "8", "--force"]);
    assert!(
        // The number of maps depends on the progress.
        text.lines().any(|line| line.starts_with("0 of ") && line.contains(" judged, made by slots")),
        "{text}"
    );
    let text = interrupted(&["corrupt", "--edges", "8", "--force", "--format", "json"]);
    let found: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!((&found["maps"], &found["ok"]), (&0.into(), &false.into()));
}

#[test]
fn an_unfinished_proof_has_no_wrong_counts() {
    let text = interrupted(&["prove", "--edges", "10", "--force"]);
    assert!(!text.contains('≠'), "{text}");
}

#[test]
fn no_unfinished_files_are_left_behind() {
    let folder = scratch_folder("unfinished");
    // Writing takes seconds, so that the signal arrives in time even on a busy machine.
    let world: serde_json::Value =
        serde_json::from_str(&std::fs::read_to_string(data("world-50m.geojson")).unwrap()).unwrap();
    let lines: Vec<String> = world["features"].as_array().unwrap().iter().map(ToString::to_string).collect();
    let input = folder.join("worlds.geojsonl");
    std::fs::write(&input, (lines.join("\n") + "\n").repeat(5)).unwrap();
    let output = folder.join("worlds.geojson");
    let has_unfinished = || {
        std::fs::read_dir(&folder)
            .unwrap()
            .any(|entry| entry.unwrap().file_name().to_string_lossy().starts_with(".twinedge-"))
    };
    // A program that ended before the signal proves nothing.
    let was_interrupted = (0..50).any(|_| {
        let mut child = Command::new(env!("CARGO_BIN_EXE_twinedge"))
            .arg("convert")
            .arg(&input)
            .args(["--lossy", "-o"])
            .arg(&output)
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        while child.try_wait().unwrap().is_none() && !has_unfinished() {
            std::thread::yield_now();
        }
        let _ = Command::new("kill").args(["-INT", &child.id().to_string()]).stderr(Stdio::null()).status().unwrap();
        child.wait().unwrap().code() == Some(130)
    });
    assert!(was_interrupted);
    assert!(!has_unfinished());
}
