//! `--help`.

use crate::support::Folder;

/// Returns this command and its subcommands, as listed by `--help`.
fn commands(command: &[String]) -> Vec<Vec<String>> {
    let mut all = vec![command.to_vec()];
    let text = help(command);
    let listed = text.split_once("Commands:\n").map_or("", |(_, commands)| commands);
    let listed = listed.lines().take_while(|line| !line.is_empty()).filter_map(|line| line.split_whitespace().next());
    for below in listed.filter(|below| *below != "help") {
        all.extend(commands(&[command, &[below.to_owned()]].concat()));
    }
    all
}

fn help<S: AsRef<str>>(command: &[S]) -> String {
    let words: Vec<&str> = command.iter().map(AsRef::as_ref).chain(["--help"]).collect();
    Folder::new(&[]).ok(&words.join(" "))
}

#[test]
fn every_command_has_examples_and_tells_its_exit_status() {
    let commands = commands(&[]);
    assert!(commands.len() > 15, "{commands:?}");
    // One screen.
    assert!(help(&[""; 0]).lines().count() <= 45);
    for command in commands {
        let text = help(&command);
        let (_, end) = text.split_once("Examples:\n").unwrap_or_else(|| panic!("{command:?}\n{text}"));
        let (examples, end) = end.split_once("\n\n").unwrap_or_else(|| panic!("{command:?}\n{text}"));
        let last = command.last().map_or("", String::as_str);
        assert!(examples.contains("twinedge") && examples.contains(last), "{command:?}\n{examples}");
        assert!(end.contains("Exit status: 0 ") && end.contains("; 2 "), "{command:?}\n{end}");
    }
}

#[test]
fn options_say_what_they_do() {
    let text = help(&["audit"]).split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(text.contains("OBJ, OFF, PLY, STL") && text.contains("SIZE is the width of its cells"), "{text}");
}
