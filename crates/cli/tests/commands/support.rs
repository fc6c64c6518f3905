//! Running the program in a folder of files, and transcripts.

use serde_json::Value;
use std::collections::BTreeSet;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use tempfile::TempDir;

/// A folder with inputs, in which the program runs.
pub(crate) struct Folder(TempDir);

/// The exit status and the output of a run.
#[derive(Debug)]
pub(crate) struct Ran {
    pub(crate) status: Option<i32>,
    pub(crate) out: String,
    pub(crate) err: String,
}

impl Folder {
    pub(crate) fn new(files: &[(&str, &str)]) -> Self {
        let folder = Self(tempfile::tempdir().unwrap());
        for (name, content) in files {
            folder.write(name, content);
        }
        folder
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub(crate) fn write(&self, name: &str, content: impl AsRef<[u8]>) {
        std::fs::write(self.path(name), content).unwrap();
    }

    pub(crate) fn read(&self, name: &str) -> Vec<u8> {
        std::fs::read(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    pub(crate) fn text(&self, name: &str) -> String {
        String::from_utf8(self.read(name)).unwrap()
    }

    /// The names of the files.
    pub(crate) fn names(&self, of: &str) -> BTreeSet<String> {
        let entries = std::fs::read_dir(self.path(of)).unwrap();
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
    }

    /// Runs the program with the arguments of a line. `'` encloses an argument with spaces, and `< FILE` at the end names the standard input.
    pub(crate) fn run(&self, line: &str) -> Ran {
        self.run_with(&[], line)
    }

    /// Runs the program with these variables of the environment.
    pub(crate) fn run_with(&self, variables: &[(&str, &str)], line: &str) -> Ran {
        let (line, input) = line.split_once(" < ").unwrap_or((line, ""));
        let input = if input.is_empty() { Vec::new() } else { self.read(input) };
        let quoted = line.split('\'').enumerate().flat_map(|(i, part)| match i % 2 {
            0 => part.split_whitespace().collect(),
            _ => vec![part],
        });
        let mut command = Command::new(env!("CARGO_BIN_EXE_twinedge"));
        command.args(quoted).current_dir(self.0.path()).envs(variables.iter().copied());
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn().unwrap();
        let mut stdin = child.stdin.take().unwrap();
        // A program that does not read its input may have ended already.
        let _ = stdin.write_all(&input);
        drop(stdin);
        let output = child.wait_with_output().unwrap();
        let [out, err] = [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).unwrap());
        Ran { status: output.status.code(), out, err }
    }

    /// Runs the program with success. Returns its output.
    #[track_caller]
    pub(crate) fn ok(&self, line: &str) -> String {
        let ran = self.run(line);
        assert_eq!(ran.status, Some(0), "{line}: {ran:?}");
        ran.out
    }

    /// Runs the program. Returns the exit status and the JSON that it prints; standard error must be empty.
    #[track_caller]
    pub(crate) fn json(&self, line: &str) -> (Option<i32>, Value) {
        let ran = self.run(line);
        // No program is as small as the memory that makes tiles of small maps.
        assert!(ran.err.lines().all(|said| said.contains("where --memory gives")), "{line}: {}", ran.err);
        (ran.status, serde_json::from_str(&ran.out).unwrap_or_else(|error| panic!("{line}: {error}: {ran:?}")))
    }

    /// Runs each line `ARGUMENTS => STATUS words ++ words` of a transcript: the program prints these words; `\n` stands for the end of a line. Errors of the command line have several
    /// lines; others have one, and leave standard output empty.
    pub(crate) fn transcript(&self, lines: &str) {
        for line in lines.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with('#')) {
            let (arguments, expected) = line.split_once("=>").unwrap_or_else(|| panic!("{line}"));
            let (status, words) = expected.trim().split_once(' ').unwrap_or((expected.trim(), ""));
            let ran = self.run(arguments.trim());
            // The name of a temporary folder.
            assert!(!ran.err.contains(".twinedge-"), "{line}: {ran:?}");
            assert_eq!(ran.status, Some(status.parse().unwrap()), "{line}: {ran:?}");
            for words in words.split("++").map(|words| words.trim().replace("\\n", "\n")) {
                assert!(ran.out.contains(&words) || ran.err.contains(&words), "{line}: {ran:?}");
            }
            if status == "2" {
                let is_one_line = ran.err.starts_with("twinedge: ") && ran.err.lines().count() == 1;
                let is_usage = ran.err.starts_with("error: ") || ran.err.contains("Usage: ");
                assert!(ran.out.is_empty() && (is_one_line || is_usage), "{line}: {ran:?}");
            }
        }
    }
}

/// Returns the path of a file of the workspace.
pub(crate) fn root(name: &str) -> String {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(name).display().to_string()
}

/// The map of the world with two crossings.
pub(crate) fn crossing() -> String {
    root("tests/data/world-110m-crossing.geojson")
}
