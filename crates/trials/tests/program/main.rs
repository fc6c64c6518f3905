//! The output of the commands, their exit status, and the way they end.

mod ends;
mod fuzz_template;
mod journal;
mod reports;
mod soak;
mod sum;

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// Returns the program with these arguments and without input.
fn command(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_twinedge-trials"));
    command.args(arguments).stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}

/// Runs the program with these arguments.
fn trials(arguments: &[&str]) -> Output {
    command(arguments).output().unwrap()
}

/// Runs the program with these arguments and this input.
fn trials_reading(arguments: &[&str], input: &[u8]) -> Output {
    let mut child = command(arguments).stdin(Stdio::piped()).spawn().unwrap();
    child.stdin.take().unwrap().write_all(input).unwrap();
    child.wait_with_output().unwrap()
}

/// Runs the program. Returns its exit status, and its text for people.
fn text(arguments: &[&str]) -> (Option<i32>, String) {
    let output = trials(arguments);
    (output.status.code(), String::from_utf8(output.stdout).unwrap())
}

/// Runs the program and parses its JSON. Standard error must be empty.
fn json(arguments: &[&str]) -> (Option<i32>, serde_json::Value) {
    let output = trials(&[arguments, &["--format", "json"]].concat());
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
    (output.status.code(), serde_json::from_slice(&output.stdout).unwrap())
}

/// Checks that the program fails with one line on standard error, which has these words. Returns its standard output.
fn refused(output: Output, told: &str) -> Vec<u8> {
    let said = String::from_utf8(output.stderr).unwrap();
    assert_eq!((output.status.code(), said.lines().count()), (Some(2), 1), "{said}");
    assert!(said.starts_with("twinedge-trials: ") && said.contains(told), "{told}\n{said}");
    output.stdout
}

/// Creates an empty folder for a test.
fn scratch_folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}
