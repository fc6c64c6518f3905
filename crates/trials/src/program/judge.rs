//! The judged tables: the validator that judges them, and `--print`, which prints each table with its verdict, or its certificates.

use crate::document::{Document, Printed};
use crate::effort::{Effort, stop};
use crate::output::{Failure, Verdict as Status, unless_closed};
use std::fmt::Write as _;
use std::io::{self, BufWriter, Stdout, Write};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Instant;
use twinedge::validate::{Expectation, Table};
use twinedge_certificate::Column;
use twinedge_trials::{Certificates, Checker, Estimate, FastPath, Outcome, Run, Validator, Verdict, certificates_of};

/// The options of the commands that judge tables.
#[derive(Clone, Copy, Debug, clap::Args)]
pub(crate) struct Judge {
    /// Judge by certificates: a table is right if its labels pass, or random or changed ones. With --print: certificates of each table that
    /// has all parts, with the tests that fail, instead of the table.
    #[arg(long)]
    pub(crate) certificates: bool,

    /// Judge by the fast path alone: a table is right if the fast path accepts it. With --print: `= accepted` or `= refused`
    /// instead of a rule.
    #[arg(long, conflicts_with = "certificates")]
    fast_path: bool,

    /// Print each table and the verdict of the validator; the summary goes to standard error.
    #[arg(long, conflicts_with = "format")]
    print: bool,
}

/// Prints the outcome of an engine.
pub(crate) type Print<'a, R> = &'a (dyn Fn(&Outcome<R>) -> Result<Status, Failure> + Sync);

impl Judge {
    /// Lets an engine judge tables, unless that is too much work, and prints the outcome.
    pub(crate) fn perform<R: Printed>(
        self,
        effort: &Effort,
        estimate: Estimate,
        engine: impl FnOnce(&dyn Checker, &Run<'_>, Print<'_, R>) -> Result<Outcome<R>, Failure>,
    ) -> Result<Status, Failure> {
        let run = effort.begin(estimate)?;
        let start = Instant::now();
        let printer = Printer::new(self);
        let checker: &dyn Checker = if self.print { &printer } else { self.checker() };
        let print = |outcome: &Outcome<R>| {
            let document = Document::new(outcome.clone(), start.elapsed());
            if self.print {
                printer.finish(&document.to_string())?;
            } else {
                effort.format.print(&document)?;
            }
            Ok(document.verdict())
        };
        print(&engine(checker, &run, &print)?)
    }

    const fn checker(self) -> &'static dyn Checker {
        match self {
            Self { certificates: true, .. } => &Certificates,
            Self { fast_path: true, .. } => &FastPath,
            Self { .. } => &Validator,
        }
    }

    /// The printed lines of a table.
    fn line(self, table: &Table, expectation: &Expectation, verdict: Verdict) -> String {
        let said = match self {
            Self { certificates: true, .. } => return certificates(table, expectation),
            Self { fast_path: true, .. } if verdict.valid => "accepted",
            Self { fast_path: true, .. } => "refused",
            Self { .. } => verdict.broken.map_or("ok", |rule| rule.id()),
        };
        format!("{table} = {said}\n")
    }
}

/// A validator that prints each table it judges to standard output.
struct Printer {
    lines: Mutex<Lines>,
    judge: Judge,
}

struct Lines {
    out: BufWriter<Stdout>,
    expectation: Option<Expectation>,
    error: Option<io::Error>,
}

impl Lines {
    fn write(&mut self, expectation: Expectation, line: &str) -> io::Result<()> {
        if self.expectation != Some(expectation) {
            self.expectation = Some(expectation);
            // `twinedge audit` reads such comments.
            writeln!(self.out, "# expect: {expectation}")?;
        }
        self.out.write_all(line.as_bytes())
    }
}

impl Printer {
    fn new(judge: Judge) -> Self {
        let out = BufWriter::with_capacity(1 << 16, io::stdout());
        Self { lines: Mutex::new(Lines { out, expectation: None, error: None }), judge }
    }

    fn lines(&self) -> MutexGuard<'_, Lines> {
        self.lines.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Writes the remaining output, and the summary to standard error.
    fn finish(&self, summary: &str) -> Result<(), Failure> {
        let mut lines = self.lines();
        let flushed = lines.out.flush();
        anstream::eprint!("{summary}");
        unless_closed(lines.error.take().map_or(flushed, Err))
    }
}

impl Checker for Printer {
    fn check(&self, table: &Table, expectation: &Expectation) -> Verdict {
        self.judge.checker().check(table, expectation)
    }

    fn checked(&self, table: &Table, expectation: &Expectation, verdict: Verdict) {
        let line = self.judge.line(table, expectation, verdict);
        let mut lines = self.lines();
        if lines.error.is_none()
            && let Err(error) = lines.write(*expectation, &line)
        {
            // The pipe is closed, or the disk is full.
            stop();
            lines.error = Some(error);
        }
    }
}

/// Certificates of a table, one per line: the columns in order, each preceded by its length, and the failed tests.
fn certificates(table: &Table, expectation: &Expectation) -> String {
    let mut lines = String::new();
    let has_all = *expectation == Expectation::plane();
    for certificate in certificates_of(table).filter(|_| has_all).into_iter().flatten() {
        for column in Column::of_subdivision() {
            let numbers = certificate.columns().column(*column);
            let _ = write!(lines, "{}", numbers.len());
            for number in numbers {
                let _ = write!(lines, " {number}");
            }
            lines.push(' ');
        }
        lines.push('=');
        for failure in certificate.check().err().into_iter().flatten() {
            let _ = write!(lines, " {}", failure.test().name());
        }
        lines.push('\n');
    }
    lines
}
