//! Running the program.

use std::io::Write;
use std::process::{Command, Output, Stdio};

/// Runs the program with these arguments, without input.
pub(crate) fn twinedge(arguments: &[&str]) -> Output {
    twinedge_reading(arguments, b"")
}

/// Runs the program with these arguments and this input.
pub(crate) fn twinedge_reading(arguments: &[&str], input: &[u8]) -> Output {
    spawned(Command::new(env!("CARGO_BIN_EXE_twinedge")).args(arguments), input)
}

/// Runs the program with a variable of the environment, these arguments and this input.
pub(crate) fn twinedge_with((name, value): (&str, &str), arguments: &[&str], input: &[u8]) -> Output {
    spawned(Command::new(env!("CARGO_BIN_EXE_twinedge")).env(name, value).args(arguments), input)
}

fn spawned(command: &mut Command, input: &[u8]) -> Output {
    let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let mut stdin = child.stdin.take().unwrap();
    // A program that does not read its input may have ended already.
    let _ = stdin.write_all(input);
    drop(stdin);
    child.wait_with_output().unwrap()
}

/// Runs the program and parses its JSON. Standard error must be empty.
pub(crate) fn json(arguments: &[&str]) -> (Option<i32>, serde_json::Value) {
    let output = twinedge(arguments);
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
    (output.status.code(), serde_json::from_slice(&output.stdout).unwrap())
}

/// Returns the path of a test file of the library.
pub(crate) fn data(name: &str) -> String {
    format!("{}/../../tests/data/{name}", env!("CARGO_MANIFEST_DIR"))
}

/// Returns the line that the program prints to standard error.
pub(crate) fn complaint(output: &Output) -> String {
    let text = String::from_utf8(output.stderr.clone()).unwrap();
    assert_eq!(text.lines().count(), 1, "{text}");
    text
}

/// Creates an empty folder for a test.
pub(crate) fn scratch_folder(name: &str) -> std::path::PathBuf {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}
