//! `twinedge-peers`: searches the audited crates again, or runs one program.

use std::process::ExitCode;
use twinedge_peers::crates::PEERS;
use twinedge_peers::entry::Entry;
use twinedge_peers::judge::{self, Judge};
use twinedge_peers::program::Program;
use twinedge_peers::run::Verdict;
use twinedge_peers::search::{Outcome, Search};

const HELP: &str = "\
twinedge-peers search [--crate NAME] [--programs N] [--seed N] [--steps N] [--only OPERATOR,…] [--without OPERATOR,…]
    Runs N random programs (800, of up to 100 steps, seed 1) over the operators of the crate, or of every crate, judges
    after each step, and prints what was found, how often, and the shortest program.
twinedge-peers run CRATE 'STEP; STEP; …'
    Runs one program and prints what it finds.
twinedge-peers list
    The crates and their operators.
";

fn main() -> ExitCode {
    let arguments = std::env::args().skip(1).collect::<Vec<_>>();
    match command(&arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::from(2)
        }
    }
}

fn command(arguments: &[String]) -> Result<(), String> {
    let words = arguments.iter().map(String::as_str).collect::<Vec<_>>();
    match words[..] {
        ["search", ref options @ ..] => search(options),
        ["run", name, program] => run_one(peer(name)?, program),
        ["list"] => {
            for entry in PEERS {
                let names = entry.operators.iter().map(|operator| operator.name).collect::<Vec<_>>();
                println!("{} {}: {}", entry.name, entry.version, names.join(", "));
            }
            Ok(())
        }
        ["worker", name] => judge::serve(peer(name)?).map_err(|error| error.to_string()),
        _ => Err(HELP.to_owned()),
    }
}

fn peer(name: &str) -> Result<&'static Entry, String> {
    PEERS.iter().find(|entry| entry.name == name).ok_or_else(|| {
        let names = PEERS.iter().map(|entry| entry.name).collect::<Vec<_>>();
        format!("no crate '{name}' is audited; these are: {}", names.join(", "))
    })
}

fn search(options: &[&str]) -> Result<(), String> {
    let executable = std::env::current_exe().map_err(|error| error.to_string())?;
    let mut entries = PEERS.iter().collect::<Vec<_>>();
    let (mut programs, mut seed, mut steps, mut without) = (800, 1, 100, Vec::<String>::new());
    for pair in options.chunks(2) {
        let [option, value] = pair else { return Err(HELP.to_owned()) };
        let number = || value.parse::<u64>().map_err(|error| format!("{option} {value}: {error}"));
        match *option {
            "--crate" => entries = vec![peer(value)?],
            "--programs" => programs = number()?,
            "--seed" => seed = number()?,
            "--steps" => steps = usize::try_from(number()?.max(1)).map_err(|error| error.to_string())?,
            "--only" => {
                let only = value.split(',').collect::<Vec<_>>();
                let all = entries.iter().flat_map(|entry| entry.operators).map(|operator| operator.name);
                without.extend(all.filter(|name| !only.contains(name)).map(str::to_owned));
            }
            "--without" => without.extend(value.split(',').map(str::to_owned)),
            _ => return Err(HELP.to_owned()),
        }
    }
    for entry in entries {
        let search =
            Search { entry: *entry, programs, seed, steps, without: without.clone(), executable: executable.clone() };
        print(entry, programs, &search.run().map_err(|error| error.to_string())?);
    }
    Ok(())
}

fn print(entry: &Entry, programs: u64, outcome: &Outcome) {
    let findings = programs - outcome.sound;
    println!("{} {}: something found in {findings} of {programs} programs", entry.name, entry.version);
    let Outcome { sound, done, refused, skipped, .. } = outcome;
    println!("  the other {sound}: {done} calls made, {refused} refused with an error, {skipped} not made");
    let mut found = outcome.found.iter().collect::<Vec<_>>();
    found.sort_by_key(|(_, found)| std::cmp::Reverse(found.programs));
    for (signature, found) in found {
        println!("\n  {signature}\n    first found in {} of {programs}", found.programs);
        println!("    {}\n    {}", found.shortest.to_text(entry.operators), found.finding.detail);
    }
    println!();
}

fn run_one(entry: &'static Entry, program: &str) -> Result<(), String> {
    let program = Program::parse(program, entry.operators)?;
    let executable = std::env::current_exe().map_err(|error| error.to_string())?;
    match Judge::new(*entry, executable).run(&program).map_err(|error| error.to_string())? {
        Verdict::Sound { done, refused, skipped } => {
            println!("nothing found: {done} calls made, {refused} refused with an error, {skipped} not made");
        }
        Verdict::Finding(finding) => println!("{}\n{}", finding.signature(), finding.detail),
    }
    Ok(())
}
