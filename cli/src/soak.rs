//! `twinedge soak`: random programs in step with a reference.

use crate::document::{Document, Printed};
use crate::effort::{Effort, seed_of_the_moment};
use crate::output::style::{BAD, GOOD};
use crate::output::{Format, counted};
use crate::print_rows::table;
use crate::status::{Failure, Verdict};
use crate::structures::StructureName;
use serde::{Deserialize, Serialize};
use std::ffi::OsString;
use std::fmt;
use std::fs::File;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::time::Instant;
use twinedge_trials::soak::{Comparable, SoakFailure, SoakOutcome, SoakWork};
use twinedge_trials::{Estimate, soak};

/// Run random programs on the structure, with limits and without, and on a second model, in step with a reference.
///
/// The reference is the pointer structure of the literature, written from the definitions of the operators. After each operator
/// all structures must have done the same (applied, refused for the same reason, or skipped), must be valid, must be isomorphic,
/// nesting included, and their handles must say the same. Programs use stale handles on purpose. The stores must report what they
/// made, kept and dropped, and keys of dropped boundary components must be stale.
///
/// The first program that fails, or panics, is made small, printed as Rust source for a regression test, and saved as a file for
/// `twinedge replay`.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge soak
  twinedge soak --programs 100000 --steps 300 --seed 1
  twinedge soak --on pointers --on fixed
  twinedge soak --on planted              a structure with a bug, to see that it is found
  twinedge soak --programs 100000 --seed 1 --shard 0/16 --format json > part-0.json

Exit status: 0 no structure differed; 1 a structure differed or panicked; 2 misuse, the run would take too long, or the failing \
program could not be saved; 130 interrupted (Ctrl-C), after printing what was covered.")]
pub(crate) struct Soak {
    /// Number of programs.
    #[arg(long, value_name = "P", default_value_t = 1000, value_parser = clap::value_parser!(u32).range(1..))]
    programs: u32,

    /// Number of operators in each program.
    #[arg(long, value_name = "S", default_value_t = 100, value_parser = clap::value_parser!(u32).range(1..))]
    steps: u32,

    /// Seed of the programs. Default: the time of day; it is printed.
    #[arg(long, value_name = "X")]
    seed: Option<u64>,

    /// A structure to run them on; may be repeated. Default: the structure, with limits and without, and the second model.
    #[arg(long, value_enum, value_name = "STRUCTURE")]
    on: Vec<StructureName>,

    /// File to save a failing program to. No file is overwritten: if the name is taken, a number is appended.
    #[arg(long, value_name = "FILE", default_value = "failing.program")]
    save: PathBuf,

    #[command(flatten)]
    effort: Effort,

    /// Output format.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

#[derive(Debug, Default, Serialize, Deserialize)]
pub(crate) struct Saved {
    saved: Option<PathBuf>,
}

impl Soak {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        self.effort.needs_seed(self.seed)?;
        let on = if self.on.is_empty() { &StructureName::SOUND[..] } else { &self.on };
        self.effort.refuse_too_much(self.estimate(on), self.format)?;
        let run = self.effort.start()?;
        let start = Instant::now();
        let seed = self.seed.unwrap_or_else(seed_of_the_moment);
        let structures: Vec<Box<dyn Comparable>> = on.iter().map(|on| on.comparable()).collect();
        let structures: Vec<&dyn Comparable> = structures.iter().map(|structure| &**structure).collect();
        let work = SoakWork { programs: self.programs, steps: self.steps, seed };
        let mut document = Document::new(soak(&structures, work, &run), start);
        let mut not_saved = None;
        if let Some(failing) = &document.outcome.failure {
            match save(&self.save, &file(failing, seed)) {
                Ok(path) => document.extra.saved = Some(path),
                Err(error) => not_saved = Some(Failure(format!("{}: {error}", self.save.display()))),
            }
        }
        document.print(self.format)?;
        // Return this error last, so that the findings are printed first.
        not_saved.map_or_else(|| Ok(document.verdict()), Err)
    }

    fn estimate(&self, on: &[StructureName]) -> Estimate {
        let amount = u128::from(self.programs) * u128::from(self.steps) * on.len() as u128;
        Estimate { amount, unit: "steps", per_second: per_second(on, self.steps) }
    }
}

/// The text of the file for a failing program.
fn file(failure: &SoakFailure, seed: u64) -> String {
    let SoakFailure { on, number, message, program, .. } = failure;
    format!("# {message}\n# program {number} of seed {seed}, made small; on: {on}\n{program}")
}

/// Returns the steps per second of one thread that runs programs of `steps` steps on each of these structures.
///
/// The map grows with the steps, so the time grows faster than their number. The formulas fit measurements of up to 4,000 steps.
#[allow(clippy::cast_sign_loss, reason = "no number here is negative")]
fn per_second(on: &[StructureName], steps: u32) -> u64 {
    let thousands = f64::from(steps) / 1000.0;
    let seconds = |on: &StructureName| match on {
        // This structure is soon full.
        StructureName::Limited => 0.025 * thousands,
        // Copies are kept and compared.
        StructureName::History => 0.4 * thousands.powf(2.4),
        StructureName::Pointers => 1.7 * thousands.powf(2.8),
        _ => 0.1 * thousands.powf(2.4),
    };
    let steps = f64::from(steps) * on.len() as f64;
    (steps / on.iter().map(seconds).sum::<f64>()).ceil() as u64
}

/// Writes a new file of this name, appending the first free number if the name is taken. Returns the name.
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

impl Printed for SoakOutcome {
    const COMMAND: &'static str = "soak";
    type Extra = Saved;

    fn text(&self, extra: &Saved, seconds: f64) -> String {
        Text(self, extra, seconds).to_string()
    }

    fn is_wrong(&self) -> bool {
        self.failure.is_some()
    }
}

struct Text<'a>(&'a SoakOutcome, &'a Saved, f64);

impl fmt::Display for Text<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(outcome, Saved { saved }, seconds) = self;
        writeln!(f, "seed {}; operators in step with the reference", outcome.seed)?;
        f.write_str(&table(&outcome.structures, outcome.shard.is_whole()))?;
        let cut_short: u64 = outcome.structures.iter().map(|row| row.cut_short).sum();
        if cut_short > 0 {
            let cut_short = counted(cut_short as usize, "program");
            writeln!(f, "{cut_short} cut short; the operators up to there are counted above")?;
        }
        match &outcome.failure {
            Some(SoakFailure { on, message, rust, .. }) => {
                writeln!(f, "\n{BAD}{on} differs{BAD:#} {message}\n")?;
                writeln!(f, "{rust}")?;
                if let Some(path) = saved {
                    writeln!(f, "saved as {0}; run it again: twinedge replay {0}", path.display())?;
                }
                Ok(())
            }
            None if outcome.interrupted => writeln!(f, "\n{BAD}not finished{BAD:#} ({seconds:.1} s)"),
            None => writeln!(f, "\n{GOOD}in step{GOOD:#}: no structure differed ({seconds:.1} s)"),
        }
    }
}
