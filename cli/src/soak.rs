//! `twinedge soak`: random programs on every store and a second model, in step with an independent model.

use crate::output::style::{BAD, GOOD, QUIET};
use crate::output::{Format, counted, grouped, print, print_json};
use crate::random::{Random, seed_of_the_moment};
use crate::regression;
use crate::subjects::SubjectName;
use crate::trial::{End, Trial};
use crate::work::{self, Effort};
use crate::{Failure, Verdict};
use serde::Serialize;
use std::ffi::OsString;
use std::fmt::{self, Write as _};
use std::fs::File;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::time::Instant;
use twinedge::program::conformance::ConformanceSummary;
use twinedge::program::{FacePick, Op, Program, candidates};

/// Run random programs on every store, and on a second model, in step with an independent model.
///
/// The reference is the structure of the textbooks, written from the definitions of the operators. After each operator all
/// must have done the same (applied, refused for the same reason, or skipped), must be valid by the validator, must be
/// isomorphic, nesting included, and their handles must say the same. Programs use handles of what is gone on purpose. A
/// program that fails, be it by a panic, is made small, printed as Rust source for a regression test, and saved as a file
/// for `twinedge replay`.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge soak
  twinedge soak --programs 100000 --steps 300 --seed 1
  twinedge soak --on planted              a structure with a bug, to see that it is found

Exit status: 0 no structure differed; 1 one did, or panicked; 2 misuse, or the failing program could not be saved;
130 interrupted (Ctrl-C), after printing what was covered.")]
pub(crate) struct Soak {
    /// How many programs.
    #[arg(long, value_name = "P", default_value_t = 1000, value_parser = clap::value_parser!(u32).range(1..))]
    programs: u32,

    /// How many operators each has.
    #[arg(long, value_name = "S", default_value_t = 100, value_parser = clap::value_parser!(u32).range(1..))]
    steps: u32,

    /// The seed of the programs; without it, one that is printed.
    #[arg(long, value_name = "X")]
    seed: Option<u64>,

    /// On what to run them; all stores and the second model, unless said otherwise.
    #[arg(long, value_enum, value_name = "STRUCTURE")]
    on: Vec<SubjectName>,

    /// Where to save a program that fails. No file is overwritten: a number is put behind a name that is taken.
    #[arg(long, value_name = "FILE", default_value = "failing.program")]
    save: PathBuf,

    #[command(flatten)]
    effort: Effort,

    /// For whom to print.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

#[derive(Debug, Serialize)]
struct Outcome {
    seed: u64,
    structures: Vec<Row>,
    failure: Option<Failing>,
    saved: Option<PathBuf>,
    interrupted: bool,
    ok: bool,
    elapsed_ms: f64,
}

#[derive(Clone, Copy, Debug, Serialize)]
struct Row {
    on: SubjectName,
    programs: u64,
    /// Programs that were interrupted. Their operators up to there are counted.
    cut_short: u64,
    applied: u64,
    refused: u64,
    skipped: u64,
    no_room: u64,
}

/// A program on which a structure fails, as small as it could be made.
#[derive(Clone, Debug, Serialize)]
struct Failing {
    on: SubjectName,
    /// Its place among the programs of the seed.
    number: u32,
    message: String,
    program: String,
    rust: String,
}

impl Soak {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        let on = if self.on.is_empty() { SubjectName::SOUND.to_vec() } else { self.on.clone() };
        let amount = u128::from(self.programs) * u128::from(self.steps) * on.len() as u128;
        self.effort.refuse_too_much(amount, "steps", per_second(&on, self.steps), self.format)?;
        work::stop_on_interrupt()?;
        let start = Instant::now();
        let seed = self.seed.unwrap_or_else(seed_of_the_moment);
        let programs = self.programs as usize;
        let bar = work::bar(programs, "programs");
        let fresh = || Worker { rows: on.iter().map(|on| Row::of(*on)).collect(), failing: None };
        let workers = work::share(self.effort.threads(), programs, &bar, fresh, |worker, number| {
            worker.soak(&random_program(seed, number as u32, self.steps), number as u32);
        });
        let mut outcome = Outcome {
            seed,
            structures: on.iter().map(|on| Row::of(*on)).collect(),
            // The first of them, whichever thread found it.
            failure: workers.iter().filter_map(|worker| worker.failing.as_ref()).min_by_key(|f| f.number).cloned(),
            saved: None,
            interrupted: work::stopped(),
            ok: false,
            elapsed_ms: start.elapsed().as_secs_f64() * 1000.0,
        };
        for worker in &workers {
            outcome.structures.iter_mut().zip(&worker.rows).for_each(|(sum, row)| sum.add(row));
        }
        outcome.ok = outcome.failure.is_none() && !outcome.interrupted;
        let mut not_saved = None;
        if let Some(failing) = &outcome.failure {
            match save(&self.save, &failing.file(seed)) {
                Ok(path) => outcome.saved = Some(path),
                Err(error) => not_saved = Some(Failure(format!("{}: {error}", self.save.display()))),
            }
        }
        match self.format {
            Format::Text => print(&outcome.to_string())?,
            Format::Json => print_json(&outcome)?,
        }
        // Only now, so that what was found is not lost.
        if let Some(failure) = not_saved {
            return Err(failure);
        }
        Ok(match (&outcome.failure, outcome.interrupted) {
            (Some(_), _) => Verdict::Wrong,
            (None, true) => Verdict::Interrupted,
            (None, false) => Verdict::Sound,
        })
    }
}

/// Steps per second of one thread, if these structures each run programs of so many steps.
///
/// The map grows with the steps, so a program takes longer than in proportion to them: about so many seconds as here, as
/// measured with up to 4,000 steps.
#[allow(clippy::cast_sign_loss, reason = "no number here is negative")]
fn per_second(on: &[SubjectName], steps: u32) -> u64 {
    let thousands = f64::from(steps) / 1000.0;
    let seconds = |on: &SubjectName| match on {
        // It is full soon, and grows no more.
        SubjectName::Fixed => 0.025 * thousands,
        SubjectName::RotationSystem => 1.7 * thousands.powf(2.8),
        _ => 0.1 * thousands.powf(2.4),
    };
    let steps = f64::from(steps) * on.len() as f64;
    (steps / on.iter().map(seconds).sum::<f64>()).ceil() as u64
}

/// Writes a new file, of this name or, if it is taken, of the first with a number behind it that is not. Gives the name.
fn save(path: &Path, text: &str) -> io::Result<PathBuf> {
    let mut free = path.to_owned();
    for number in 2_u32.. {
        match File::create_new(&free) {
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
            file => {
                file?.write_all(text.as_bytes())?;
                break;
            }
        }
        let mut name = path.file_stem().map_or_else(OsString::new, OsString::from);
        name.push(format!("-{number}"));
        free.set_file_name(name);
        if let Some(extension) = path.extension() {
            free.as_mut_os_string().push(".");
            free.as_mut_os_string().push(extension);
        }
    }
    Ok(free)
}

/// A vertex, without which there is nothing to be done, and operators by lot.
fn random_program(seed: u64, number: u32, steps: u32) -> Program {
    let mut bytes = Random::new(seed, number.into()).bytes();
    let first = Op::AddIsolatedVertex { face: FacePick::Unbounded };
    let ops = std::iter::from_fn(|| Op::from_bytes(&mut bytes));
    std::iter::once(first).chain(ops).take(steps as usize).collect()
}

/// What one thread found.
struct Worker {
    rows: Vec<Row>,
    failing: Option<Failing>,
}

impl Worker {
    fn soak(&mut self, program: &Program, number: u32) {
        // One failure is enough: making it small takes its time.
        if self.failing.is_some() {
            return;
        }
        for row in &mut self.rows {
            let tried = row.on.run(Trial(program));
            row.count(tried.summary);
            match tried.end {
                End::Finished => row.programs += 1,
                End::Interrupted => {
                    row.cut_short += 1;
                    return;
                }
                End::Failed { before, message } => {
                    self.failing = Some(Failing::of(row.on, number, program, before, message));
                    return;
                }
            }
        }
    }
}

impl Row {
    const fn of(on: SubjectName) -> Self {
        Self { on, programs: 0, cut_short: 0, applied: 0, refused: 0, skipped: 0, no_room: 0 }
    }

    const fn count(&mut self, summary: ConformanceSummary) {
        self.applied += summary.applied as u64;
        self.refused += summary.refused as u64;
        self.skipped += summary.skipped as u64;
        self.no_room += summary.not_supported as u64;
    }

    const fn add(&mut self, other: &Self) {
        self.programs += other.programs;
        self.cut_short += other.cut_short;
        self.applied += other.applied;
        self.refused += other.refused;
        self.skipped += other.skipped;
        self.no_room += other.no_room;
    }
}

impl Failing {
    /// Makes a failing program small, as far as that gets until told to stop. `before` is how many operators it ran before
    /// the one that failed, and `message` says how.
    fn of(on: SubjectName, number: u32, program: &Program, before: usize, message: String) -> Self {
        let mut smallest: Program = program.0.iter().take(before + 1).copied().collect();
        let mut message = message;
        let failure = |program: Program| on.run(Trial(&program)).failure().map(|message| (program, message));
        while let Some(smaller) = candidates(&smallest).take_while(|_| !work::stopped()).find_map(failure) {
            (smallest, message) = smaller;
        }
        let rust = regression::test(on, &message, &smallest);
        Self { on, number, message, program: smallest.to_string(), rust }
    }

    /// The file that is saved.
    fn file(&self, seed: u64) -> String {
        let Self { on, number, message, program, .. } = self;
        format!("# {message}\n# program {number} of seed {seed}, made small; on: {}\n{program}", on.name())
    }
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.interrupted {
            writeln!(f, "{BAD}interrupted{BAD:#}: this is what was covered\n")?;
        }
        writeln!(f, "seed {}; operators in step with the textbook's structure", self.seed)?;
        let mut head = String::new();
        for what in ["programs", "applied", "refused", "skipped", "no room"] {
            write!(head, " {what:>13}")?;
        }
        writeln!(f, "{QUIET}{:10}{head}{QUIET:#}", "on")?;
        for row in &self.structures {
            write!(f, "{:10}", row.on.name())?;
            for count in [row.programs, row.applied, row.refused, row.skipped, row.no_room] {
                write!(f, " {:>13}", grouped(count))?;
            }
            writeln!(f)?;
        }
        let cut_short: u64 = self.structures.iter().map(|row| row.cut_short).sum();
        if cut_short > 0 {
            let cut_short = counted(cut_short as usize, "program");
            writeln!(f, "{cut_short} cut short, with the operators up to there counted above")?;
        }
        let seconds = self.elapsed_ms / 1000.0;
        match &self.failure {
            Some(failing) => {
                writeln!(f, "\n{BAD}{} differs{BAD:#} {}\n", failing.on.name(), failing.message)?;
                writeln!(f, "{}", failing.rust)?;
                if let Some(path) = &self.saved {
                    writeln!(f, "saved as {0}; run it again: twinedge replay {0}", path.display())?;
                }
                Ok(())
            }
            None if self.interrupted => writeln!(f, "\n{BAD}not finished{BAD:#} ({seconds:.1} s)"),
            None => writeln!(f, "\n{GOOD}in step{GOOD:#}: no structure differed ({seconds:.1} s)"),
        }
    }
}
