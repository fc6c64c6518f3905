//! `--help`.

mod support;

use support::twinedge;

const COMMANDS: [&[&str]; 15] = [
    &[],
    &["audit"],
    &["query"],
    &["query", "neighbours"],
    &["query", "at"],
    &["query", "line"],
    &["query", "contour"],
    &["query", "faces"],
    &["draw"],
    &["prove"],
    &["corrupt"],
    &["tables"],
    &["soak"],
    &["replay"],
    &["sum"],
];

fn help(command: &[&str]) -> String {
    let output = twinedge(&[command, &["--help"]].concat());
    assert_eq!(output.status.code(), Some(0), "{command:?}");
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn every_command_has_examples_and_tells_its_exit_status() {
    for command in COMMANDS {
        let text = help(command);
        let (_, end) = text.split_once("Examples:\n").unwrap_or_else(|| panic!("{command:?}\n{text}"));
        let (examples, end) = end.split_once("\n\n").unwrap();
        assert!(examples.contains(&["twinedge", &command.join(" ")].join(" ")), "{command:?}\n{examples}");
        assert!(end.contains("Exit status: 0 ") && end.contains("; 2 "), "{command:?}\n{end}");
    }
}

#[test]
fn every_command_is_here() {
    let text = help(&[]);
    let (_, commands) = text.split_once("Commands:\n").unwrap();
    let listed = commands.lines().take_while(|line| !line.is_empty()).filter_map(|line| line.split_whitespace().next());
    for command in listed.filter(|command| *command != "help") {
        assert!(COMMANDS.contains(&&[command][..]), "{command}");
    }
}

#[test]
fn options_say_what_they_do() {
    for (command, told) in [
        (&["prove"][..], "Output format"),
        (&["prove"], "Run even if the estimate exceeds 30 minutes"),
        (&["prove"], "Disconnected maps: up to min(N - 1, 4) edges, and two more vertices"),
        (&["prove"], "plus one stale key of each kind"),
        (&["tables"], "Do part K of N of the same work, counted from 0"),
        (&["audit"], "OBJ, OFF, PLY, STL"),
        (&["audit"], "SIZE is the greatest width of its cells"),
        (&["corrupt"], "Work that is drawn at random needs --seed"),
        (&["corrupt"], "Print each table and the verdict of the validator"),
    ] {
        // Lines are wrapped.
        let text = help(command).split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(text.contains(told), "{command:?}: {told}\n{text}");
    }
}
