//! `twinedge-trials soak`: random programs in step with a reference.

use crate::document::Printed;
use crate::effort::Effort;
use crate::output::style::BAD;
use crate::output::{Failure, Verdict, counted, named, table};
use crate::structures::StructureName;
use std::ffi::OsString;
use std::fmt;
use std::fs::File;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use twinedge_trials::soak::{Comparable, SoakFailure, SoakResults, SoakWork};
use twinedge_trials::{Estimate, Outcome, soak};

/// Run random programs on structures in step with a reference.
///
/// By default the structures are the structure of the library, with limits and without, and a second model.
///
/// The reference is the pointer structure of the literature, written from the definitions of the operators. After each operator
/// all structures must have done the same (applied, refused for the same reason, or skipped), must be valid, must be isomorphic,
/// nesting included, and their handles must say the same. Programs use stale handles on purpose. The stores must report what they
/// made, kept and dropped, and keys of dropped boundary components must be stale.
///
/// The first program that fails, or panics, is made small, printed as Rust source for a regression test, and saved as a file for
/// `twinedge-trials replay`.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge-trials soak
  twinedge-trials soak --programs 100000 --steps 300 --seed 1
  twinedge-trials soak --on pointers --on limited
  twinedge-trials soak --on planted              a structure with a bug, to see that it is found
  twinedge-trials soak --programs 100000 --seed 1 --shard 0/16 --format json > part-0.json

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
}

impl Soak {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        let seed = self.effort.seed(self.seed)?;
        let on = if self.on.is_empty() { &StructureName::SOUND[..] } else { &self.on };
        let structures: Vec<Box<dyn Comparable>> = on.iter().map(|on| on.comparable()).collect();
        let structures: Vec<&dyn Comparable> = structures.iter().map(|structure| &**structure).collect();
        let work = SoakWork { programs: self.programs, steps: self.steps, seed };
        let mut saved = Ok(());
        let verdict = self.effort.perform(self.estimate(on), |run| {
            let mut outcome = soak(&structures, work, run);
            if let Some(failing) = &outcome.failure {
                let path = save(&self.save, &file(failing, seed)).map_err(named(self.save.display()));
                saved = path.map(|path| outcome.saved = Some(path));
            }
            Ok(outcome)
        });
        // Return this error last, so that the findings are printed first.
        verdict.and_then(|verdict| saved.map(|()| verdict))
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

impl Printed for SoakResults {
    const COMMAND: &'static str = "soak";

    fn is_wrong(outcome: &Outcome<Self>) -> bool {
        outcome.failure.is_some()
    }

    fn describe(outcome: &Outcome<Self>, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "seed {}; operators in step with the reference", outcome.seed)?;
        f.write_str(&table(&outcome.structures, outcome.is_complete()))?;
        let cut_short: u64 = outcome.structures.iter().map(|row| row.cut_short).sum();
        if cut_short > 0 {
            let cut_short = counted(cut_short as usize, "program");
            writeln!(f, "{cut_short} cut short; the operators up to there are counted above")?;
        }
        if let Some(SoakFailure { on, message, rust, .. }) = &outcome.failure {
            writeln!(f, "\n{BAD}{on} differs{BAD:#} {message}\n\n{rust}")?;
            if let Some(path) = &outcome.saved {
                writeln!(f, "saved as {0}; run it again: twinedge-trials replay {0}", path.display())?;
            }
        }
        writeln!(f)
    }

    fn verdict(_: &Outcome<Self>, is_ok: bool) -> (String, String) {
        if is_ok {
            return ("in step".to_owned(), ": no structure differed".to_owned());
        }
        ("not in step".to_owned(), String::new())
    }
}
