//! `--print`: each table that is judged, with the verdict of the validator, one on each line; or certificates of it.

use crate::progress;
use crate::status::Failure;
use std::fmt::Write as _;
use std::io::{self, BufWriter, Stdout, Write};
use std::sync::{Mutex, MutexGuard, PoisonError};
use twinedge::validate::certificate::Column;
use twinedge::validate::{Expectation, Table};
use twinedge_trials::{Certificates, Checker, Validator, Verdict, certificates_of};

/// Begins a comment that says what the tables below it are held to.
pub(crate) const EXPECT: &str = "# expect:";

/// A validator, which prints each table that it judged to standard output.
pub(crate) struct Printer {
    lines: Mutex<Lines>,
    /// The validator is that of certificates, and these are printed.
    certificates: bool,
}

struct Lines {
    out: BufWriter<Stdout>,
    /// The expectation of the last table.
    expectation: Option<Expectation>,
    error: Option<io::Error>,
}

/// A validator of tables: that of certificates, or that of all rules.
pub(crate) fn validator(certificates: bool) -> &'static dyn Checker {
    if certificates { &Certificates } else { &Validator }
}

impl Lines {
    fn write(&mut self, expectation: Expectation, line: &str) -> io::Result<()> {
        if self.expectation != Some(expectation) {
            self.expectation = Some(expectation);
            writeln!(self.out, "{EXPECT} {expectation}")?;
        }
        self.out.write_all(line.as_bytes())
    }
}

impl Printer {
    pub(crate) fn new(certificates: bool) -> Self {
        let out = BufWriter::with_capacity(1 << 16, io::stdout());
        Self { lines: Mutex::new(Lines { out, expectation: None, error: None }), certificates }
    }

    fn lines(&self) -> MutexGuard<'_, Lines> {
        self.lines.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Writes what is left, and the summary to standard error.
    pub(crate) fn finish(&self, summary: &str) -> Result<(), Failure> {
        let mut lines = self.lines();
        let flushed = lines.out.flush();
        anstream::eprint!("{summary}");
        match lines.error.take().map_or(flushed, Err) {
            Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(error.into()),
            _ => Ok(()),
        }
    }
}

impl Checker for Printer {
    fn check(&self, table: &Table, expectation: &Expectation) -> Verdict {
        validator(self.certificates).check(table, expectation)
    }

    fn checked(&self, table: &Table, expectation: &Expectation, verdict: Verdict) {
        let line = if self.certificates {
            certificates(table, expectation)
        } else {
            format!("{table} = {}\n", verdict.broken.map_or("ok", |rule| rule.id()))
        };
        let mut lines = self.lines();
        if lines.error.is_none()
            && let Err(error) = lines.write(*expectation, &line)
        {
            // Nobody reads on, or the disk is full.
            progress::stop();
            lines.error = Some(error);
        }
    }
}

/// Certificates of a table, one on each line: the columns in their order, each after its number of entries, and the tests that fail.
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
