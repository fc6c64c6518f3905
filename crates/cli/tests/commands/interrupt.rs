//! Ctrl-C.

use crate::support::{data, scratch_folder};
use std::process::{Command, Stdio};

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
