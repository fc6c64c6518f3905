//! Misuse, refusals, interruptions and help.

use super::{command, json, refused, text, trials};

#[test]
fn what_would_not_finish_is_refused_and_scripts_can_tell_a_refusal_from_misuse() {
    for (arguments, unit) in [
        (&["prove", "--edges", "12"][..], "operators to try"),
        (&["prove", "--meshes", "9"], "operators to try"),
        (&["corrupt", "--edges", "8"], "corruptions"),
        (&["tables", "--half-edges", "8"], "tables"),
        (&["tables", "--lazy", "--expect", "surface open", "--vertices", "4", "--half-edges", "8"], "runs, about "),
        (&["soak", "--programs", "4000000000"], "steps"),
        // One program can be too much as well: the time grows faster than the number of steps.
        (&["soak", "--programs", "1", "--steps", "59000", "--threads", "2"], "about "),
    ] {
        let output = trials(&[arguments, &["--format", "json"]].concat());
        let complaint = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(complaint.contains(unit), "{arguments:?}: {complaint}");
        let found: serde_json::Value =
            serde_json::from_slice(&refused(output, " of them a second on each core; --force")).unwrap();
        assert_eq!(found["ok"], false);
        assert!(complaint.contains(found["refused"].as_str().unwrap()));
    }
    assert_eq!(refused(trials(&["prove", "--edges", "12"]), "--force"), b"");
    // More threads than cores do not make it less.
    let complaint = |more: &[&str]| trials(&[&["prove", "--edges", "12"], more].concat()).stderr;
    assert_eq!(complaint(&["--threads", "256"]), complaint(&[]));
    // The whole is too much; a hundred-millionth of it is not.
    let whole = ["soak", "--programs", "4000000000", "--steps", "50", "--seed", "1", "--on", "slots"];
    let (status, found) = json(&[&whole[..], &["--shard", "0/100000000"]].concat());
    assert_eq!((status, &found["structures"][0]["programs"]), (Some(0), &40.into()));
}

#[test]
fn misuse_has_its_own_status() {
    for (arguments, told) in [
        ("prove --edges many --format json", "invalid value 'many'"),
        ("prove --edges 99", "99 is not in 0..=16"),
        ("prove extra", "unexpected argument"),
        ("prove --meshes 4 --edges 2", "cannot be used with"),
        ("prove --meshes 2", "2 is not in 3..=9"),
        ("proove", "unrecognized subcommand"),
        ("corrupt --edges 9", "9 is not in 0..=8"),
        ("corrupt --seed x", "invalid value 'x'"),
        ("corrupt --threads 0", "0 is not in 1..=256"),
        ("tables --half-edges -1", "unexpected argument"),
        ("tables --print --format json", "cannot be used with"),
        ("soak --on nothing", "invalid value 'nothing'"),
        ("soak --programs 0", "0 is not in 1.."),
        ("soak --steps 0", "0 is not in 1.."),
        ("replay", "<FILE>"),
        ("replay --map --on slots -", "cannot be used with"),
        ("sum", "<FILES>"),
        ("prove --shard 2/2", "there is no part 2 of 2; parts are counted from 0"),
        ("tables --shard 0/0", "there must be at least 1 part"),
        ("tables --shard half", "expected K/N"),
        ("soak --shard 0/2", "--shard needs --seed"),
        ("corrupt --shard 0/2", "--shard needs --seed"),
        ("replay no-such.program", "no-such.program: "),
    ] {
        let output = trials(&arguments.split(' ').collect::<Vec<_>>());
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!((output.status.code(), output.stdout), (Some(2), vec![]), "{arguments}");
        assert!(said.contains(told), "{arguments}: {told}\n{said}");
    }
}

#[test]
fn every_command_has_examples_and_tells_its_exit_status() {
    let (_, all) = text(&["--help"]);
    // One screen.
    assert!(all.lines().map(|line| line.len().div_ceil(120).max(1)).sum::<usize>() <= 40, "{all}");
    let listed = all.split_once("Commands:\n").unwrap().1.lines().take_while(|line| !line.is_empty());
    let commands: Vec<&str> = listed.map(|line| line.split_whitespace().next().unwrap()).collect();
    let expected =
        ["prove", "corrupt", "tables", "sample", "soak", "replay", "fuzz-template", "sum", "completions", "help"];
    assert_eq!(commands, expected);
    for command in &commands[..9] {
        let (status, text) = text(&[command, "--help"]);
        let (_, end) = text.split_once("Examples:\n").unwrap();
        let (examples, end) = end.split_once("\n\n").unwrap();
        assert!(status == Some(0) && examples.contains(&format!("twinedge-trials {command}")), "{examples}");
        assert!(end.contains("Exit status: 0 ") && end.contains("; 2 "), "{end}");
    }
    for (command, told) in [
        ("prove", "Run even if the estimate exceeds 30 minutes"),
        ("prove", "Disconnected maps: up to min(N - 1, 4) edges, and two more vertices"),
        ("prove", "plus one stale key of each kind"),
        ("tables", "Do part K of N of the same work, counted from 0"),
        ("corrupt", "Work that is drawn at random needs --seed"),
        ("corrupt", "Print each table and the verdict of the validator"),
    ] {
        let (_, text) = text(&[command, "--help"]);
        let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(text.contains(told), "{command}: {told}\n{text}");
    }
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        assert!(text(&["completions", shell]).1.contains("fuzz-template"), "{shell}");
    }
}

#[test]
#[cfg(unix)]
fn printing_stops_when_nobody_reads_on() {
    let mut child = command(&["tables", "--half-edges", "8", "--force", "--print"]).spawn().unwrap();
    drop(child.stdout.take());
    assert_eq!(child.wait().unwrap().code(), Some(130));
}

/// Returns the output of the program when interrupted as early as possible.
#[cfg(target_os = "linux")]
fn interrupted(arguments: &[&str]) -> String {
    let mut child = command(&[arguments, &["--force"]].concat()).spawn().unwrap();
    // The process handles SIGINT itself.
    let is_ready = |id| {
        let status = std::fs::read_to_string(format!("/proc/{id}/status")).unwrap();
        let caught = status.lines().find_map(|line| line.strip_prefix("SigCgt:")).unwrap();
        u64::from_str_radix(caught.trim(), 16).unwrap() & 1 << 1 != 0
    };
    while child.try_wait().unwrap().is_none() && !is_ready(child.id()) {
        std::thread::yield_now();
    }
    let sent = std::process::Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(sent.success());
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(130), "{arguments:?}");
    String::from_utf8(output.stdout).unwrap()
}

#[test]
#[cfg(target_os = "linux")]
fn what_was_covered_is_printed_after_an_interruption() {
    for arguments in [
        // Without wrong counts.
        &["prove", "--edges", "10"][..],
        &["corrupt", "--edges", "8"],
        &["tables", "--half-edges", "8"],
        &["soak", "--programs", "100000000"],
        // A single program runs to its end.
        &["soak", "--programs", "1", "--steps", "1000000"],
    ] {
        let text = interrupted(arguments);
        assert!(text.contains("interrupted: this is what was covered") && text.contains("not finished"), "{text}");
        assert!(!text.contains('≠'), "{text}");
        // Maps that were only found do not count as covered. Their number depends on the progress.
        let covers_none = || text.lines().any(|line| line.starts_with("0 of ") && line.contains(" judged, made by"));
        assert!(arguments[0] != "corrupt" || covers_none(), "{text}");
    }
    let found = interrupted(&["corrupt", "--edges", "8", "--format", "json"]);
    let found: serde_json::Value = serde_json::from_str(&found).unwrap();
    assert_eq!((&found["maps"], &found["ok"], &found["interrupted"]), (&0.into(), &false.into(), &true.into()));
}
