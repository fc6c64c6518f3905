//! Ctrl-C.

use crate::support::{Folder, root};
use std::process::{Command, Stdio};

#[test]
fn no_unfinished_files_are_left_behind() {
    let folder = Folder::new(&[]);
    // Writing takes seconds, so that the signal arrives in time even on a busy machine.
    let world: serde_json::Value =
        serde_json::from_str(&std::fs::read_to_string(root("tests/data/world-50m.geojson")).unwrap()).unwrap();
    let lines: Vec<String> = world["features"].as_array().unwrap().iter().map(ToString::to_string).collect();
    folder.write("worlds.geojsonl", (lines.join("\n") + "\n").repeat(5));
    let has_unfinished = || folder.names("").iter().any(|name| name.starts_with(".twinedge-"));
    // A program that ended before the signal proves nothing.
    let was_interrupted = (0..50).any(|_| {
        let mut child = Command::new(env!("CARGO_BIN_EXE_twinedge"))
            .args(["convert", "worlds.geojsonl", "--lossy", "-o", "worlds.geojson"])
            .current_dir(folder.path(""))
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
