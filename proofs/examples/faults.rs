//! Plants every fault of `proofs/faults/` in a copy of the sources, and prints which check catches which.
//!
//! One build holds all faults, each behind a switch that is read from the environment. Each check then runs once without a fault,
//! and must pass, and once with each. A fault is caught if the check fails, panics, or takes longer than a minute and five times
//! what it takes without a fault. The checks of the part of the library that has the fault are run first, and of these the quickest.
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "it is a program")]

use clap::Parser;
use std::collections::BTreeMap;
use std::error::Error;
use std::fs;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::{Duration, Instant};
use twinedge_proofs::faults::{Fault, SWITCH, parse, plant};

type Result<T> = std::result::Result<T, Box<dyn Error + Send + Sync>>;

/// Plants every fault of `proofs/faults/` in a copy of the sources under `target/faults`, and prints, in Markdown, which check
/// catches which.
#[derive(Parser)]
#[command(after_help = "\
Examples:
  cargo run -p twinedge-proofs --example faults                           every cell of the table: hours
  cargo run -p twinedge-proofs --example faults -- --enough 2             until two checks have caught each fault
  cargo run -p twinedge-proofs --example faults -- --only R1 --checks corrupt,tables")]
struct Arguments {
    /// The faults with these words in their names
    #[arg(long, value_name = "WORDS")]
    only: Option<String>,
    /// These checks alone, separated by commas
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    checks: Option<Vec<String>>,
    /// Run no further check with a fault that as many have caught
    #[arg(long, value_name = "N")]
    enough: Option<usize>,
    /// Begin no check later than this
    #[arg(long, value_name = "N")]
    minutes: Option<u64>,
}

/// A check that takes longer than this, and than five times what it takes without a fault, counts as one that does not end.
const LIMIT: Duration = Duration::from_secs(60);

/// A check: its name, and the program with its arguments.
struct Check {
    name: &'static str,
    program: PathBuf,
    arguments: Vec<&'static str>,
    /// How long it takes without a fault.
    takes: Duration,
}

/// What became of a check.
#[derive(Clone, Copy, PartialEq, Eq)]
enum End {
    NotRun,
    Passed,
    Failed,
    TimedOut,
}

/// The checks that are test binaries: the name, the arguments by which cargo builds it, and its source as cargo names it.
const TESTS: [(&str, &[&str], &str); 4] = [
    ("validate", &["-p", "twinedge", "--test", "validate"], "tests/validate/main.rs"),
    ("dcel", &["-p", "twinedge", "--test", "dcel"], "tests/dcel/main.rs"),
    ("program", &["-p", "twinedge", "--test", "program"], "tests/program/main.rs"),
    ("harnesses", &["-p", "twinedge-proofs", "--lib"], "unittests src/lib.rs"),
];

/// The checks of the program `twinedge`.
const COMMANDS: [(&str, &[&str]); 5] = [
    ("corrupt", &["corrupt", "--edges", "2", "--pairs", "1000", "--seed", "1", "--threads", "1"]),
    ("tables", &["tables", "--half-edges", "2", "--threads", "1"]),
    ("sample", &["sample", "--tables", "1000", "--seed", "1", "--threads", "1"]),
    ("prove", &["prove", "--edges", "2", "--threads", "1"]),
    ("soak", &["soak", "--programs", "30", "--seed", "1", "--threads", "1", "--save", "/dev/null/none"]),
];

fn main() -> Result<()> {
    let Arguments { only, checks: chosen, enough, minutes } = Arguments::parse();
    let named = TESTS.iter().map(|(name, ..)| *name).chain(COMMANDS.iter().map(|(name, _)| *name)).collect::<Vec<_>>();
    if let Some(other) = chosen.iter().flatten().find(|name| !named.contains(&name.as_str())) {
        return Err(format!("there is no check {other}; the checks are {}", named.join(", ")).into());
    }
    let is_chosen = |name: &str| chosen.as_ref().is_none_or(|names| names.iter().any(|other| other == name));
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").canonicalize()?;
    let faults = read(&root.join("proofs/faults"))?;
    let build = root.join("target/faults");
    let copy = build.join("sources");
    copy_planted(&root, &copy, &faults)?;
    let mut checks = built(&copy, &build, is_chosen)?;
    let start = Instant::now();
    for check in &mut checks {
        let start = Instant::now();
        if check.run(None)? != End::Passed {
            return Err(format!("{} does not pass without a fault", check.name).into());
        }
        check.takes = start.elapsed();
        eprintln!("{} passes without a fault in {:.1} s", check.name, check.takes.as_secs_f64());
    }
    let wanted: Vec<usize> =
        (0..faults.len()).filter(|n| only.as_ref().is_none_or(|words| faults[*n].what.contains(words))).collect();
    let until = minutes.map(|minutes| start + Duration::from_secs(60 * minutes));
    let limits = Limits { until, enough: enough.unwrap_or(usize::MAX) };
    let ends = matrix(&checks, &faults, &wanted, limits)?;
    print(&checks, &faults, &ends);
    Ok(())
}

fn read(folder: &Path) -> Result<Vec<Fault>> {
    let mut files = fs::read_dir(folder)?.map(|entry| Ok(entry?.path())).collect::<Result<Vec<_>>>()?;
    files.retain(|file| file.extension().is_some_and(|extension| extension == "txt"));
    files.sort();
    let mut faults = Vec::new();
    for file in files {
        faults.extend(parse(&fs::read_to_string(file)?)?);
    }
    Ok(faults)
}

/// Writes a copy of the sources with all faults planted. Files that are the same already are left alone.
fn copy_planted(root: &Path, copy: &Path, faults: &[Fault]) -> Result<()> {
    let mut folders = vec![PathBuf::new()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(root.join(&folder))? {
            let entry = entry?;
            let path = folder.join(entry.file_name());
            if entry.file_type()?.is_dir() {
                let is_source =
                    !["target", ".git", "coq", "corpus", "artifacts"].iter().any(|name| path.ends_with(name));
                folders.extend(is_source.then_some(path));
                continue;
            }
            let mut bytes = fs::read(entry.path())?;
            let of_file: Vec<(usize, &Fault)> =
                faults.iter().enumerate().filter(|(_, fault)| Path::new(&fault.file) == path).collect();
            if !of_file.is_empty() {
                bytes = plant(&String::from_utf8(bytes)?, &of_file)?.into_bytes();
            }
            if path == Path::new("src/lib.rs") {
                bytes.extend(SWITCH.bytes());
            }
            let to = copy.join(&path);
            if fs::read(&to).ok().as_ref() != Some(&bytes) {
                fs::create_dir_all(copy.join(&folder))?;
                fs::write(to, bytes)?;
            }
        }
    }
    Ok(())
}

/// Builds the copy, and gives the checks.
fn built(copy: &Path, build: &Path, is_chosen: impl Fn(&str) -> bool) -> Result<Vec<Check>> {
    let cargo = |arguments: &[&str]| -> Result<String> {
        let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
        cargo.args(arguments).current_dir(copy).env("CARGO_TARGET_DIR", build).env("CARGO_INCREMENTAL", "0");
        // Fast enough to run, and quick to build; what overflows panics.
        for (name, value) in [("LTO", "off"), ("DEBUG", "0"), ("OPT_LEVEL", "2"), ("DEBUG_ASSERTIONS", "true")] {
            cargo.env(format!("CARGO_PROFILE_RELEASE_{name}"), value);
        }
        cargo.env("CARGO_PROFILE_RELEASE_OVERFLOW_CHECKS", "true").env_remove("RUSTFLAGS");
        let output = cargo.output()?;
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        if output.status.success() { Ok(said) } else { Err(format!("cargo {}: {said}", arguments.join(" ")).into()) }
    };
    let mut checks = Vec::new();
    for (name, arguments, source) in TESTS.iter().filter(|(name, ..)| is_chosen(name)) {
        let said = cargo(&[&["test", "--release", "--no-run"], *arguments].concat())?;
        let line = said.lines().find(|line| line.contains(source)).ok_or_else(|| format!("cargo made no {source}"))?;
        let program =
            line.split_once('(').and_then(|(_, rest)| rest.split_once(')')).ok_or("cargo says something else")?.0;
        checks.push(Check { name, program: copy.join(program), arguments: vec!["--test-threads=1"], takes: LIMIT });
    }
    if COMMANDS.iter().any(|(name, _)| is_chosen(name)) {
        cargo(&["build", "--release", "-p", "twinedge-cli"])?;
    }
    let program = build.join("release/twinedge");
    for (name, arguments) in COMMANDS.iter().filter(|(name, _)| is_chosen(name)) {
        checks.push(Check { name, program: program.clone(), arguments: arguments.to_vec(), takes: LIMIT });
    }
    Ok(checks)
}

impl Check {
    /// Whether the check is about the part of the library that has this fault.
    fn is_near(&self, fault: &Fault) -> bool {
        let of_validator = ["validate", "corrupt", "tables", "sample"].contains(&self.name);
        of_validator == fault.file.starts_with("src/validate/") && self.name != "harnesses"
    }

    /// Runs the check with a fault switched on.
    fn run(&self, fault: Option<usize>) -> Result<End> {
        let mut command = Command::new(&self.program);
        command.args(&self.arguments).stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::null());
        // Some tests read files beside their sources.
        let folder = self.program.ancestors().find(|folder| folder.ends_with("faults")).unwrap_or(Path::new("."));
        command.current_dir(folder.join("sources"));
        if let Some(fault) = fault {
            command.env("PLANTED_FAULT", fault.to_string());
        }
        let mut child = command.spawn()?;
        let output = child.stdout.take().ok_or("the check has no output")?;
        let has_failed = AtomicBool::new(false);
        std::thread::scope(|scope| {
            // The first test that fails is enough.
            scope.spawn(|| {
                let lines = BufReader::new(output).lines().map_while(std::result::Result::ok);
                for line in lines {
                    if line.ends_with("... FAILED") {
                        has_failed.store(true, Ordering::Relaxed);
                    }
                }
            });
            let start = Instant::now();
            loop {
                if let Some(status) = child.try_wait()? {
                    return Ok(if status.success() { End::Passed } else { End::Failed });
                }
                let is_late = start.elapsed() > LIMIT.max(5 * self.takes);
                if is_late || has_failed.load(Ordering::Relaxed) {
                    child.kill()?;
                    child.wait()?;
                    return Ok(if is_late { End::TimedOut } else { End::Failed });
                }
                std::thread::sleep(Duration::from_millis(5));
            }
        })
    }
}

/// When to stop.
#[derive(Clone, Copy)]
struct Limits {
    until: Option<Instant>,
    enough: usize,
}

/// Runs each check with each of these faults, four at a time.
fn matrix(checks: &[Check], faults: &[Fault], wanted: &[usize], limits: Limits) -> Result<BTreeMap<usize, Vec<End>>> {
    let mut cells: Vec<(usize, usize)> =
        (0..checks.len()).flat_map(|check| wanted.iter().map(move |fault| (check, *fault))).collect();
    cells.sort_by_key(|(check, fault)| (!checks[*check].is_near(&faults[*fault]), checks[*check].takes));
    let none: BTreeMap<usize, Vec<End>> =
        wanted.iter().map(|fault| (*fault, vec![End::NotRun; checks.len()])).collect();
    let (next, done) = (AtomicUsize::new(0), Mutex::new(none));
    let work = || -> Result<()> {
        while let Some((check, fault)) = cells.get(next.fetch_add(1, Ordering::Relaxed)) {
            if limits.until.is_some_and(|until| Instant::now() >= until) {
                break;
            }
            let is_caught = |done: &BTreeMap<usize, Vec<End>>| {
                done.get(fault).is_some_and(|ends| ends.iter().filter(|end| end.is_caught()).count() >= limits.enough)
            };
            if is_caught(&*done.lock().map_err(|_| "another thread panicked")?) {
                continue;
            }
            let end = checks[*check].run(Some(*fault))?;
            eprintln!("{} {} {fault}", mark(end), checks[*check].name);
            if let Some(ends) = done.lock().map_err(|_| "another thread panicked")?.get_mut(fault) {
                ends[*check] = end;
            }
        }
        Ok(())
    };
    std::thread::scope(|scope| {
        let threads = [(); 4].map(|()| scope.spawn(work));
        threads.into_iter().try_for_each(|thread| thread.join().map_err(|_| "a thread panicked")?)
    })?;
    Ok(done.into_inner().map_err(|_| "a thread panicked")?)
}

const fn mark(end: End) -> char {
    match end {
        End::NotRun => '–',
        End::Passed => '·',
        End::Failed => '×',
        End::TimedOut => 't',
    }
}

/// The table in Markdown.
fn print(checks: &[Check], faults: &[Fault], caught: &BTreeMap<usize, Vec<End>>) {
    println!(
        "| fault | where | {} |",
        checks.iter().map(|check| format!("`{}`", check.name)).collect::<Vec<_>>().join(" | ")
    );
    println!("| --- | --- |{}", " --- |".repeat(checks.len()));
    for (n, ends) in caught {
        let Fault { what, file, .. } = &faults[*n];
        let name = file.strip_prefix("src/").unwrap_or(file);
        let marks: Vec<String> = ends.iter().map(|end| mark(*end).to_string()).collect();
        println!("| {what} | `{name}` | {} |", marks.join(" | "));
    }
    let by = |ends: &[End]| -> Vec<usize> { (0..checks.len()).filter(|check| ends[*check].is_caught()).collect() };
    let names = |catchers: &[usize]| {
        let of_it = caught.iter().filter(|(_, ends)| by(ends) == catchers);
        of_it.map(|(n, _)| format!("*{}*", faults[*n].what)).collect::<Vec<_>>()
    };
    let none = names(&[]);
    let one: Vec<_> = (0..checks.len()).map(|check| names(&[check])).collect();
    let by_one: usize = one.iter().map(Vec::len).sum();
    let several = caught.len() - none.len() - by_one;
    println!(
        "\n{} faults: {several} caught by several checks, {by_one} by one, {} by none.\n",
        caught.len(),
        none.len()
    );
    println!(
        "| check | caught | not run | caught by it alone | seconds without a fault |\n| --- | --- | --- | --- | --- |"
    );
    for (position, Check { name, takes, .. }) in checks.iter().enumerate() {
        let count = |test: fn(&End) -> bool| caught.values().filter(|ends| test(&ends[position])).count();
        let (by_it, not_run) = (count(|end| end.is_caught()), count(|end| *end == End::NotRun));
        println!("| `{name}` | {by_it} | {not_run} | {} | {:.1} |", one[position].len(), takes.as_secs_f64());
    }
    println!("\nCaught by one of those that were run:\n");
    for (check, names) in checks.iter().zip(&one).filter(|(_, names)| !names.is_empty()) {
        println!("- `{}`: {}", check.name, names.join("; "));
    }
    println!("\nCaught by none of those that were run: {}", none.join("; "));
}

impl End {
    const fn is_caught(self) -> bool {
        matches!(self, Self::Failed | Self::TimedOut)
    }
}
