//! The commands in the READMEs print the shown output, and the picture made by one of them is current.

use std::path::{Path, PathBuf};
use std::process::Command;

fn root() -> PathBuf {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).to_path_buf()
}

/// The program, as a block calls it.
const COMMANDS: [&str; 2] = ["$ twinedge ", "$ cargo run -- "];

/// A command, and the lines of its output.
struct Sample {
    arguments: Vec<String>,
    output: Vec<String>,
}

/// Returns the commands `twinedge …`, or their form in a clone, in the `console` blocks of a text.
fn samples(text: &str) -> Vec<Sample> {
    let mut samples: Vec<Sample> = Vec::new();
    let mut inside = false;
    for line in text.lines() {
        if line.starts_with("```") {
            inside = line == "```console";
        } else if !inside || line == "$ cargo test" {
            // This line is not a command of the program.
        } else if let Some(command) = COMMANDS.iter().find_map(|command| line.strip_prefix(command)) {
            let arguments = command.split_whitespace().map(str::to_owned).collect();
            samples.push(Sample { arguments, output: Vec::new() });
        } else {
            samples.last_mut().expect("a block begins with a command").output.push(line.to_owned());
        }
    }
    samples
}

/// Removes blank lines at the end, and replaces every time by a constant.
fn normal(lines: impl IntoIterator<Item = String>) -> Vec<String> {
    let untimed = |line: String| match line.rsplit_once(" (") {
        Some((before, time)) if time.ends_with(" ms)") || time.ends_with(" s)") => format!("{before} (some time)"),
        _ => line,
    };
    let mut lines: Vec<String> = lines.into_iter().map(untimed).collect();
    while lines.last().is_some_and(|line| line.trim().is_empty()) {
        lines.pop();
    }
    lines
}

/// Compares lines: `…` stands for any lines, and at the end of a line for any rest of it.
fn matches(expected: &[String], found: &[String]) -> bool {
    let Some((line, rest)) = expected.split_first() else { return found.is_empty() };
    if line.trim() == "…" {
        return (0..=found.len()).any(|skipped| matches(rest, &found[skipped..]));
    }
    let is_same = |first: &String| line.strip_suffix('…').map_or(line == first, |start| first.starts_with(start));
    found.split_first().is_some_and(|(first, others)| is_same(first) && matches(rest, others))
}

#[test]
fn the_commands_of_the_readmes_print_what_stands_there() {
    for (file, least) in [("README.md", 2), ("crates/cli/README.md", 6)] {
        let text = std::fs::read_to_string(root().join(file)).expect("the file can be read");
        let samples = samples(&text);
        assert!(samples.len() >= least, "{file}: {} commands", samples.len());
        for Sample { mut arguments, output } in samples {
            let shown = arguments.join(" ");
            let picture = arguments.iter().position(|argument| argument == "-o").map(|at| at + 1);
            let picture = picture.filter(|at| arguments[*at] != "-");
            let drawn = picture.map(|at| std::mem::replace(&mut arguments[at], "-".to_owned()));
            let mut command = Command::new(env!("CARGO_BIN_EXE_twinedge"));
            let run = command.current_dir(root()).args(&arguments).output().expect("it starts");
            if let Some(picture) = drawn {
                let kept = std::fs::read(root().join(&picture)).expect("the picture can be read");
                assert!(run.stdout == kept, "{file}: {picture} is not what twinedge {shown} draws");
                continue;
            }
            let printed = String::from_utf8([run.stdout, run.stderr].concat()).expect("it prints UTF-8");
            let (expected, found) = (normal(output), normal(printed.lines().map(str::to_owned)));
            assert!(matches(&expected, &found), "{file}: twinedge {shown} prints\n{}", found.join("\n"));
        }
    }
}

#[test]
fn a_sample_that_is_not_current_is_found() {
    let lines = |text: &str| normal(text.lines().map(str::to_owned));
    assert!(matches(&lines("a (2 ms)\n\n"), &lines("a (31 ms)")));
    assert!(matches(&lines("…\nc"), &lines("a\nb\nc")));
    assert!(matches(&lines("a\n  …\nc d …"), &lines("a\nb\nb\nc d e")));
    assert!(!matches(&lines("a"), &lines("a\nb")));
    assert!(!matches(&lines("…\nb"), &lines("a\nb\nc")));
    assert!(!matches(&lines("a b…"), &lines("a c")));
    assert!(!matches(&lines("a 2 ms"), &lines("a 3 ms")));
    let samples =
        samples("$ twinedge no\n```console\n$ twinedge a b\nc\n$ twinedge d\n```\n```text\n$ twinedge e\n```\n");
    assert_eq!(samples.len(), 2);
    assert_eq!(
        (samples[0].arguments.as_slice(), samples[0].output.as_slice()),
        (["a", "b"].map(str::to_owned).as_slice(), ["c".to_owned()].as_slice())
    );
}
