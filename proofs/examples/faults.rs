//! Plants every fault of `proofs/faults/` in a copy of the sources, and prints which check catches which.
//!
//! One build holds all faults, each behind a switch that is read from the environment. Each check then runs once
//! without a fault, and must pass, and once with each. A fault is caught if the check fails, panics, takes longer than
//! a minute and five times its time without a fault, or needs more memory than any check without a fault. The checks of
//! the part of the library that has the fault run first, the quickest of them before the others. Each result is written
//! to `target/faults/cells.txt`, and the next run of the same sources reads it from there.
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "it is a program")]

use clap::Parser;
use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;
use std::fs::{self, File, OpenOptions};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::{Duration, Instant};
use twinedge_proofs::faults::{Fault, SWITCH, parse, plant};

type Result<T> = std::result::Result<T, Box<dyn Error + Send + Sync>>;

/// Plants every fault of `proofs/faults/` in a copy of the sources under `target/faults`, and prints, separated by tabs, which
/// check catches which.
#[derive(Parser)]
#[command(after_help = "\
Examples:
  cargo run -p twinedge-proofs --example faults                           every cell of the table: hours
  cargo run -p twinedge-proofs --example faults -- --enough 2             until two checks have caught each fault
  cargo run -p twinedge-proofs --example faults -- --minutes 30           go on for half an hour: what was run before is kept
  cargo run -p twinedge-proofs --example faults -- --only R1 --checks corrupt,tables")]
struct Arguments {
    /// The faults with these words in their names, or in the paths of their files; may be given several times
    #[arg(long, value_name = "WORDS")]
    only: Vec<String>,
    /// These checks alone, separated by commas: the program's commands, test binaries, and modules of these, as `validate near`
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    checks: Option<Vec<String>>,
    /// Run no further check with a fault that as many have caught
    #[arg(long, value_name = "N")]
    enough: Option<usize>,
    /// Begin no check later than this. The next run goes on from there, unless a source has changed
    #[arg(long, value_name = "N")]
    minutes: Option<u64>,
    /// The number of checks that run side by side
    #[arg(long, value_name = "N", default_value_t = std::thread::available_parallelism().map_or(1, std::num::NonZero::get))]
    threads: usize,
}

/// A check that takes longer than this, and than five times its time without a fault, counts as one that does not end.
const LIMIT: Duration = Duration::from_secs(60);

/// The address space of a check in kibibytes, where there is a shell to limit it.
const MEMORY: &str = "3000000";

/// A check: its name, and the program with its arguments. The tests of one module are one check.
struct Check {
    name: String,
    program: PathBuf,
    arguments: Vec<String>,
    /// The time that it takes without a fault.
    takes: Duration,
}

/// The end of a check.
#[derive(Clone, Copy, PartialEq, Eq)]
enum End {
    NotRun,
    Passed,
    Failed,
    TimedOut,
}

/// A test binary that is a check: the package, the option by which cargo chooses it, and its name.
type Test = (&'static str, &'static str, &'static str);

/// The checks that are test binaries.
const TESTS: [(&str, Test); 17] = [
    ("validate", ("twinedge", "--test=validate", "validate")),
    ("dcel", ("twinedge", "--test=dcel", "dcel")),
    ("program", ("twinedge", "--test=program", "program")),
    ("map", ("twinedge-map", "--test=map", "map")),
    ("algorithm", ("twinedge-algorithm", "--test=algorithm", "algorithm")),
    ("certificate", ("twinedge-certificate", "--test=certificate", "certificate")),
    ("coverage", ("twinedge-coverage", "--test=coverage", "coverage")),
    ("tile", ("twinedge-coverage", "--test=tile", "tile")),
    ("units", ("twinedge", "--lib", "twinedge")),
    ("sphere", ("twinedge-sphere", "--test=sphere", "sphere")),
    ("harnesses", ("twinedge-proofs", "--lib", "twinedge_proofs")),
    ("layer", ("twinedge-layers", "--test=layer", "layer")),
    ("osm", ("twinedge-osm", "--test=osm", "osm")),
    ("mesh", ("twinedge-meshes", "--test=mesh", "mesh")),
    ("report", ("twinedge-report", "--lib", "twinedge_report")),
    ("report", ("twinedge-report", "--test=report", "report")),
    ("commands", ("twinedge-cli", "--test=commands", "commands")),
];

/// The modules of the program's tests that are checks: the first compares two checkers of certificates, the second is
/// about repairs.
const OF_COMMANDS: [&str; 2] = ["certificate", "clean"];

/// The packages that faults are planted in, by the root files of their libraries.
const ROOTS: [&str; 12] = [
    "src/lib.rs",
    "crates/algorithm/src/lib.rs",
    "crates/certificate/src/lib.rs",
    "crates/coverage/src/lib.rs",
    "crates/geometry/src/lib.rs",
    "crates/map/src/lib.rs",
    "crates/layers/src/lib.rs",
    "crates/meshes/src/lib.rs",
    "crates/postgis/src/lib.rs",
    "crates/report/src/lib.rs",
    "extras/osm/src/lib.rs",
    "extras/sphere/src/lib.rs",
];

/// The folder of the proved checker of certificates, if it is built.
const PROVED: &str = "proofs/coq";

/// The checks of the program `twinedge-trials`.
const COMMANDS: [(&str, &[&str]); 10] = [
    ("corrupt", &["corrupt", "--edges", "2", "--pairs", "1000", "--seed", "1", "--threads", "1"]),
    (
        "certificates",
        &["corrupt", "--edges", "2", "--pairs", "1000", "--seed", "1", "--threads", "1", "--certificates"],
    ),
    ("tables", &["tables", "--half-edges", "2", "--threads", "1"]),
    (
        "tables-lazy",
        &["tables", "--lazy", "--expect", "plane", "--parts", "prev,leaving", "--half-edges", "4", "--threads", "1"],
    ),
    (
        "certificates-lazy",
        &[
            "tables",
            "--lazy",
            "--certificates",
            "--expect",
            "plane",
            "--parts",
            "all",
            "--vertices",
            "1",
            "--half-edges",
            "2",
            "--boundaries",
            "2",
            "--faces",
            "2",
            "--threads",
            "1",
        ],
    ),
    (
        "surfaces-lazy",
        &[
            "tables",
            "--lazy",
            "--certificates",
            "--expect",
            "surface asking genus 0",
            "--parts",
            "places,prev,leaving",
            "--half-edges",
            "2",
            "--boundaries",
            "2",
            "--faces",
            "2",
            "--threads",
            "1",
        ],
    ),
    ("sample", &["sample", "--tables", "1000", "--seed", "1", "--threads", "1"]),
    ("prove", &["prove", "--edges", "2", "--threads", "1"]),
    ("soak", &["soak", "--programs", "30", "--seed", "1", "--threads", "1", "--save", "/dev/null/none"]),
    (
        "audited",
        &["soak", "--on", "audited", "--programs", "30", "--seed", "1", "--threads", "1", "--save", "/dev/null/none"],
    ),
];

fn main() -> Result<()> {
    let Arguments { only, checks: chosen, enough, minutes, threads } = Arguments::parse();
    let named = TESTS.iter().map(|(name, ..)| *name).chain(COMMANDS.iter().map(|(name, _)| *name)).collect::<Vec<_>>();
    let binary = |name: &str| name.split(' ').next().unwrap_or_default().to_owned();
    if let Some(other) = chosen.iter().flatten().find(|name| !named.contains(&binary(name).as_str())) {
        return Err(format!("there is no check {other}; the checks are {}", named.join(", ")).into());
    }
    let is_built = |name: &str| chosen.as_ref().is_none_or(|names| names.iter().any(|other| binary(other) == name));
    let is_chosen = |check: &Check| {
        let is_named = |name: &String| *name == check.name || *name == binary(&check.name);
        chosen.as_ref().is_none_or(|names| names.iter().any(is_named))
    };
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").canonicalize()?;
    let faults = read(&root.join("proofs/faults"))?;
    let build = root.join("target/faults");
    let copy = build.join("sources");
    let sources = copy_planted(&root, &copy, &faults)?;
    let mut checks = built(&copy, &build, is_built)?;
    checks.retain(is_chosen);
    if checks.is_empty() {
        return Err("no module of the tests has this name".into());
    }
    let start = Instant::now();
    for check in &mut checks {
        let start = Instant::now();
        if check.run(None)? != End::Passed {
            return Err(format!("{} does not pass without a fault", check.name).into());
        }
        check.takes = start.elapsed();
        eprintln!("{} passes without a fault in {:.1} s", check.name, check.takes.as_secs_f64());
    }
    let wanted: Vec<usize> = (0..faults.len())
        .filter(|n| {
            only.is_empty()
                || only.iter().any(|words| faults[*n].what.contains(words) || faults[*n].file.contains(words))
        })
        .collect();
    let until = minutes.map(|minutes| start + Duration::from_secs(60 * minutes));
    let limits = Limits { until, enough: enough.unwrap_or(usize::MAX), threads };
    let mut cells = Cells::open(&build.join("cells.txt"), sources)?;
    let ends = matrix(&checks, &faults, &wanted, limits, &mut cells)?;
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

/// Writes a copy of the sources with all faults planted, and returns a hash of them. Leaves unchanged files alone, and
/// deletes files that are no longer sources.
fn copy_planted(root: &Path, copy: &Path, faults: &[Fault]) -> Result<u64> {
    let mut sum = DefaultHasher::new();
    let mut copied = BTreeSet::new();
    let mut folders = vec![PathBuf::new()];
    while let Some(folder) = folders.pop() {
        let mut entries = fs::read_dir(root.join(&folder))?.collect::<std::result::Result<Vec<_>, _>>()?;
        entries.sort_by_key(|entry| entry.file_name());
        for entry in entries {
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
            if ROOTS.iter().any(|root| path == Path::new(root)) {
                bytes.splice(..0, "#![allow(warnings)]\n".bytes());
                bytes.extend(SWITCH.bytes());
            }
            if path.extension().is_some_and(|extension| extension != "md") {
                (&path, &bytes).hash(&mut sum);
            }
            let to = copy.join(&path);
            if fs::read(&to).ok().as_ref() != Some(&bytes) {
                fs::create_dir_all(copy.join(&folder))?;
                fs::write(&to, bytes)?;
            }
            copied.insert(to);
        }
    }
    copied.extend(link_proved(root, copy)?);
    let mut folders = vec![copy.to_owned()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder)? {
            let entry = entry?;
            if entry.file_type()?.is_dir() {
                folders.push(entry.path());
            } else if !copied.contains(&entry.path()) {
                fs::remove_file(entry.path())?;
            }
        }
    }
    Ok(sum.finish())
}

/// Links the built proved checker into the copy. Returns the path of the link.
fn link_proved(root: &Path, copy: &Path) -> Result<Option<PathBuf>> {
    let link = copy.join(PROVED);
    #[cfg(unix)]
    if !link.exists() {
        std::os::unix::fs::symlink(root.join(PROVED), &link)?;
    }
    Ok(link.exists().then_some(link))
}

/// Builds the whole copy at once, since each selection of packages would have features of its own, and returns the
/// checks.
fn built(copy: &Path, build: &Path, is_built: impl Fn(&str) -> bool) -> Result<Vec<Check>> {
    let commands: Vec<_> = COMMANDS.iter().filter(|(name, _)| is_built(name)).collect();
    let tests: Vec<_> = TESTS.iter().filter(|(name, _)| is_built(name)).collect();
    // The tests of the program need it.
    let program = (!commands.is_empty()).then_some(("twinedge-trials", "--test=trials_program", ""));
    let chosen = tests.iter().map(|(_, test)| *test).chain(program);
    // Each once: cargo takes no option twice.
    let (packages, options): (BTreeSet<_>, BTreeSet<_>) = chosen.map(|(package, option, _)| (package, option)).unzip();
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cargo.args(["test", "--release", "--no-run"]);
    cargo.args(packages.iter().flat_map(|package| ["-p", package])).args(options);
    cargo.current_dir(copy).env("CARGO_TARGET_DIR", build).env("CARGO_INCREMENTAL", "0");
    // Fast enough to run, and quick to build; overflow panics.
    for (name, value) in [("LTO", "off"), ("DEBUG", "0"), ("OPT_LEVEL", "2"), ("DEBUG_ASSERTIONS", "true")] {
        cargo.env(format!("CARGO_PROFILE_RELEASE_{name}"), value);
    }
    cargo.env("CARGO_PROFILE_RELEASE_OVERFLOW_CHECKS", "true").env_remove("RUSTFLAGS");
    let output = cargo.output()?;
    let said = String::from_utf8_lossy(&output.stderr);
    if !output.status.success() {
        return Err(format!("it does not compile: {said}").into());
    }
    // `Executable crates/map/tests/map/main.rs (…/deps/map-0123456789abcdef)`
    let executable = |line| {
        let (path, _) = str::split_once(line, '(')?.1.split_once(')')?;
        Some((Path::new(path).file_name()?.to_str()?.rsplit_once('-')?.0, path))
    };
    let executables: BTreeMap<&str, &str> = said.lines().filter_map(executable).collect();
    let mut checks = Vec::new();
    for (name, (_, _, binary)) in tests {
        let program = copy.join(executables.get(binary).ok_or_else(|| format!("cargo made no {binary}"))?);
        for module in
            modules(&program)?.iter().filter(|module| *name != "commands" || OF_COMMANDS.contains(&module.as_str()))
        {
            let arguments = vec![format!("{module}::"), "--test-threads=1".to_owned()];
            checks.push(Check { name: format!("{name} {module}"), program: program.clone(), arguments, takes: LIMIT });
        }
    }
    let program = build.join("release/twinedge-trials");
    for (name, arguments) in commands {
        let arguments = arguments.iter().map(|argument| (*argument).to_owned()).collect();
        checks.push(Check { name: (*name).to_owned(), program: program.clone(), arguments, takes: LIMIT });
    }
    Ok(checks)
}

/// Returns the names of the modules that have the tests of a program.
fn modules(program: &Path) -> Result<BTreeSet<String>> {
    let output = Command::new(program).args(["--list", "--format", "terse"]).output()?;
    let listed = String::from_utf8(output.stdout)?;
    Ok(listed.lines().filter_map(|line| line.split_once("::")).map(|(module, _)| module.to_owned()).collect())
}

impl Check {
    /// Returns true if the check is about the part of the library that has this fault.
    fn is_near(&self, fault: &Fault) -> bool {
        let near: &[&str] = match fault.file.as_str() {
            file if file.starts_with("extras/sphere/") => &["sphere"],
            file if file.starts_with("extras/osm/") => &["osm"],
            file if file.starts_with("src/validate/near") => &["validate", "dcel", "audited"],
            file if file.starts_with("src/validate/") => {
                &["validate", "map", "corrupt", "tables", "tables-lazy", "sample", "report"]
            }
            file if file.starts_with("crates/certificate/") => {
                &["certificate", "map", "certificates", "certificates-lazy", "surfaces-lazy", "commands"]
            }
            file if file.starts_with("crates/coverage/src/clean/") => &["layer", "report", "commands"],
            file if file.starts_with("crates/meshes/src/") => &["mesh", "report"],
            file if file.starts_with("crates/layers/") => &["layer", "report", "commands"],
            file if file.starts_with("crates/report/") => &["report", "commands"],
            file if file.starts_with("crates/coverage/src/tile/") => &["tile"],
            file if file.starts_with("crates/coverage/src/") => &["coverage"],
            file if file.starts_with("crates/algorithm/src/") => &["algorithm"],
            file if file.starts_with("crates/map/src/") => &["map"],
            _ => &["dcel", "program", "prove", "soak", "audited"],
        };
        near.iter().any(|name| self.name.split(' ').next() == Some(name))
    }

    /// Runs the check with a fault switched on.
    fn run(&self, fault: Option<usize>) -> Result<End> {
        let mut command = if cfg!(unix) {
            let mut shell = Command::new("sh");
            shell.args(["-c", &format!("ulimit -v {MEMORY}; exec \"$0\" \"$@\"")]).arg(&self.program);
            shell
        } else {
            Command::new(&self.program)
        };
        command.args(&self.arguments).stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::null());
        // Some tests read files next to their sources.
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

/// When to stop, and how many checks run side by side.
#[derive(Clone, Copy)]
struct Limits {
    until: Option<Instant>,
    enough: usize,
    threads: usize,
}

/// The cells that were run with these sources, in a file.
struct Cells {
    known: BTreeMap<(String, String), End>,
    file: File,
}

impl Cells {
    fn open(path: &Path, sources: u64) -> Result<Self> {
        let head = format!("sources {sources:016x}");
        let text = fs::read_to_string(path).unwrap_or_default();
        let mut known = BTreeMap::new();
        let is_current = text.lines().next() == Some(&head);
        for line in text.lines().skip(1).filter(|_| is_current) {
            let mut columns = line.splitn(3, '\t');
            if let (Some(end), Some(check), Some(what)) =
                (columns.next().and_then(End::of_mark), columns.next(), columns.next())
            {
                known.insert((check.to_owned(), what.to_owned()), end);
            }
        }
        if !is_current {
            fs::write(path, format!("{head}\n"))?;
        }
        Ok(Self { known, file: OpenOptions::new().append(true).open(path)? })
    }

    fn add(&mut self, end: End, check: &str, what: &str) -> Result<()> {
        Ok(writeln!(self.file, "{}\t{check}\t{what}", end.mark())?)
    }
}

/// Runs each check with each of these faults, except for known results.
fn matrix(
    checks: &[Check],
    faults: &[Fault],
    wanted: &[usize],
    limits: Limits,
    known: &mut Cells,
) -> Result<BTreeMap<usize, Vec<End>>> {
    let mut cells: Vec<(usize, usize)> =
        (0..checks.len()).flat_map(|check| wanted.iter().map(move |fault| (check, *fault))).collect();
    cells.sort_by_key(|(check, fault)| (!checks[*check].is_near(&faults[*fault]), checks[*check].takes));
    let recorded = |fault: usize| {
        let cell = |check: &Check| known.known.get(&(check.name.clone(), faults[fault].what.clone())).copied();
        checks.iter().map(|check| cell(check).unwrap_or(End::NotRun)).collect::<Vec<End>>()
    };
    let recorded: BTreeMap<usize, Vec<End>> = wanted.iter().map(|fault| (*fault, recorded(*fault))).collect();
    cells.retain(|(check, fault)| recorded.get(fault).is_some_and(|ends| ends[*check] == End::NotRun));
    let count = cells.len();
    let (next, done, known) = (AtomicUsize::new(0), Mutex::new(recorded), Mutex::new(known));
    let work = || -> Result<()> {
        loop {
            let number = next.fetch_add(1, Ordering::Relaxed);
            let Some((check, fault)) = cells.get(number) else { return Ok(()) };
            if limits.until.is_some_and(|until| Instant::now() >= until) {
                return Ok(());
            }
            let is_caught = |done: &BTreeMap<usize, Vec<End>>| {
                done.get(fault).is_some_and(|ends| ends.iter().filter(|end| end.is_caught()).count() >= limits.enough)
            };
            if is_caught(&*done.lock().map_err(|_| "another thread panicked")?) {
                continue;
            }
            let end = checks[*check].run(Some(*fault))?;
            let (name, what) = (&checks[*check].name, &faults[*fault].what);
            eprintln!("{number} of {count}: {} {name}, {what}", end.mark());
            known.lock().map_err(|_| "another thread panicked")?.add(end, name, what)?;
            if let Some(ends) = done.lock().map_err(|_| "another thread panicked")?.get_mut(fault) {
                ends[*check] = end;
            }
        }
    };
    std::thread::scope(|scope| {
        let threads: Vec<_> = (0..limits.threads).map(|_| scope.spawn(work)).collect();
        threads.into_iter().try_for_each(|thread| thread.join().map_err(|_| "a thread panicked")?)
    })?;
    Ok(done.into_inner().map_err(|_| "a thread panicked")?)
}

/// Prints a row for each fault, separated by tabs, and to the standard error how many were caught, and by which checks.
fn print(checks: &[Check], faults: &[Fault], caught: &BTreeMap<usize, Vec<End>>) {
    println!("fault\tfile\tcaught by\tpassed\tnot run");
    let mut counts = [0; 3];
    for (n, ends) in caught {
        let Fault { what, file, .. } = &faults[*n];
        let by: Vec<String> = (checks.iter().zip(ends).filter(|(_, end)| end.is_caught()))
            .map(|(check, end)| format!("{}{}", check.name, if *end == End::TimedOut { " (t)" } else { "" }))
            .collect();
        let passed = ends.iter().filter(|end| **end == End::Passed).count();
        println!("{what}\t{file}\t{}\t{passed}\t{}", by.join(", "), ends.len() - by.len() - passed);
        counts[by.len().min(2)] += 1;
    }
    let [by_none, by_one, by_several] = counts;
    eprintln!("{} faults: {by_several} caught by several checks, {by_one} by one, {by_none} by none", caught.len());
    for (position, Check { name, takes, .. }) in checks.iter().enumerate() {
        let count = |test: fn(End) -> bool| caught.values().filter(|ends| test(ends[position])).count();
        let (by_it, not_by_it) = (count(End::is_caught), count(|end| end == End::Passed));
        eprintln!("{name}: {by_it} caught, {not_by_it} not, {:.1} s without a fault", takes.as_secs_f64());
    }
}

impl End {
    const fn mark(self) -> char {
        match self {
            Self::NotRun => '–',
            Self::Passed => '·',
            Self::Failed => '×',
            Self::TimedOut => 't',
        }
    }

    fn of_mark(mark: &str) -> Option<Self> {
        [Self::Passed, Self::Failed, Self::TimedOut].into_iter().find(|end| mark.chars().eq([end.mark()]))
    }

    const fn is_caught(self) -> bool {
        matches!(self, Self::Failed | Self::TimedOut)
    }
}
