//! `twinedge soak`: random programs on every store, in step with the reference and an independent model.

use crate::kernels::{KernelName, Task};
use crate::output::style::{BAD, GOOD, QUIET};
use crate::output::{Format, grouped, print, print_json};
use crate::random::{Random, seed_of_the_moment};
use crate::work::{self, Effort};
use crate::{Failure, Verdict};
use serde::Serialize;
use std::fmt::{self, Write as _};
use std::path::PathBuf;
use std::time::Instant;
use twinedge::program::conformance::{self, Summary};
use twinedge::program::{FacePick, Kernel, Op, Program, shrink};
use twinedge::validate::Expectation;

/// Run random programs on every store in step with an independent model.
///
/// After each operator all must have done the same (applied, refused for the same reason, or skipped), must be valid by the
/// validator, must be isomorphic, nesting included, and their handles must say the same. Programs use handles of what is gone
/// on purpose. A program that fails is made small, printed as Rust source for a regression test, and saved as a file for
/// `twinedge replay`.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge soak
  twinedge soak --programs 100000 --steps 300 --seed 1
  twinedge soak --on planted              a structure with a bug, to see that it is found

Exit status: 0 no structure differed; 1 one did; 2 misuse, or the failing program could not be saved;
130 interrupted (Ctrl-C), after printing what was covered.")]
pub(crate) struct Soak {
    /// How many programs.
    #[arg(long, value_name = "P", default_value_t = 1000)]
    programs: u32,

    /// How many operators each has.
    #[arg(long, value_name = "S", default_value_t = 100)]
    steps: u16,

    /// The seed of the programs; without it, one that is printed.
    #[arg(long, value_name = "X")]
    seed: Option<u64>,

    /// On what to run them; all stores and the model, unless said otherwise.
    #[arg(long, value_enum, value_name = "STRUCTURE")]
    on: Vec<KernelName>,

    /// Where to save a program that fails.
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
    on: KernelName,
    programs: u64,
    applied: u64,
    refused: u64,
    skipped: u64,
    no_room: u64,
}

/// A program on which a structure fails, as small as it could be made.
#[derive(Clone, Debug, Serialize)]
struct Failing {
    on: KernelName,
    /// Its place among the programs of the seed.
    number: u32,
    message: String,
    program: String,
    rust: String,
}

/// Steps per second of one thread on one structure, times the steps of a program, about: the map grows with these, and a step
/// takes as long as the map is large.
const PER_SECOND: u64 = 4_000_000;

impl Soak {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        let on = if self.on.is_empty() { KernelName::SOUND.to_vec() } else { self.on.clone() };
        let amount = u128::from(self.programs) * u128::from(self.steps) * on.len() as u128;
        self.effort.refuse_too_much(amount, "steps", PER_SECOND / u64::from(self.steps.max(60)), self.format)?;
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
            match std::fs::write(&self.save, failing.file(seed)) {
                Ok(()) => outcome.saved = Some(self.save.clone()),
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

/// A vertex, without which there is nothing to be done, and operators by lot.
fn random_program(seed: u64, number: u32, steps: u16) -> Program {
    let mut bytes = Random::new(seed, number.into()).bytes();
    let first = Op::AddIsolatedVertex { face: FacePick::Unbounded };
    let ops = std::iter::from_fn(|| Op::from_bytes(&mut bytes));
    std::iter::once(first).chain(ops).take(steps.into()).collect()
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
            let Ok(summary) = row.on.run(Conform(program)) else {
                self.failing = Some(Failing::of(row.on, number, program));
                return;
            };
            row.count(summary);
        }
    }
}

/// Running a program in step with the reference.
pub(crate) struct Conform<'a>(pub(crate) &'a Program);

impl Task for Conform<'_> {
    type Result = Result<Summary, conformance::Failure>;

    fn run<K: Kernel>(self, make: fn() -> K, expectation: Expectation) -> Self::Result {
        conformance::run(self.0, make(), &expectation)
    }
}

impl Row {
    const fn of(on: KernelName) -> Self {
        Self { on, programs: 0, applied: 0, refused: 0, skipped: 0, no_room: 0 }
    }

    const fn count(&mut self, summary: Summary) {
        self.programs += 1;
        self.applied += summary.applied as u64;
        self.refused += summary.refused as u64;
        self.skipped += summary.skipped as u64;
        self.no_room += summary.not_supported as u64;
    }

    const fn add(&mut self, other: &Self) {
        self.programs += other.programs;
        self.applied += other.applied;
        self.refused += other.refused;
        self.skipped += other.skipped;
        self.no_room += other.no_room;
    }
}

impl Failing {
    /// Makes a failing program small.
    fn of(on: KernelName, number: u32, program: &Program) -> Self {
        let smallest = shrink(program, |program| on.run(Conform(program)).is_err());
        let message = on.run(Conform(&smallest)).err().map_or_else(String::new, |failure| failure.to_string());
        let (make, expectation) = on.rust();
        let source = smallest.to_rust().replace('\n', "\n    ");
        let rust = format!(
            "/// {message}\n#[test]\nfn regression() {{\n    let program = {source};\n    let result = \
             conformance::run(&program, {make}, &{expectation});\n    assert!(result.is_ok(), \"{{result:?}}\");\n}}\n"
        );
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
        writeln!(f, "seed {}; operators in step with the reference", self.seed)?;
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
        let seconds = self.elapsed_ms / 1000.0;
        match &self.failure {
            Some(failing) => {
                writeln!(f, "\n{BAD}{} differs{BAD:#} {}\n", failing.on.name(), failing.message)?;
                writeln!(f, "{}", failing.rust)?;
                if let Some(path) = &self.saved {
                    writeln!(f, "run it again: twinedge replay {}", path.display())?;
                }
                Ok(())
            }
            None if self.interrupted => writeln!(f, "\n{BAD}not finished{BAD:#} ({seconds:.1} s)"),
            None => writeln!(f, "\n{GOOD}in step{GOOD:#}: no structure differed ({seconds:.1} s)"),
        }
    }
}
