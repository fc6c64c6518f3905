//! `--print`: each table that is judged, with the verdict of the validator, one on each line.

use crate::expectation_text::ExpectationText;
use crate::progress;
use crate::status::Failure;
use std::io::{self, BufWriter, Stdout, Write};
use std::sync::{Mutex, MutexGuard, PoisonError};
use twinedge::validate::{Expectation, Table};
use twinedge_trials::{Checker, Validator, Verdict};

/// The validator, which prints each table that it judged to standard output.
pub(crate) struct Printer(Mutex<Lines>);

struct Lines {
    out: BufWriter<Stdout>,
    /// The expectation of the last table.
    expectation: Option<Expectation>,
    error: Option<io::Error>,
}

impl Default for Printer {
    fn default() -> Self {
        let out = BufWriter::with_capacity(1 << 16, io::stdout());
        Self(Mutex::new(Lines { out, expectation: None, error: None }))
    }
}

impl Lines {
    fn write(&mut self, expectation: Expectation, line: &str) -> io::Result<()> {
        if self.expectation != Some(expectation) {
            self.expectation = Some(expectation);
            writeln!(self.out, "# expect: {}", ExpectationText(expectation))?;
        }
        self.out.write_all(line.as_bytes())
    }
}

impl Printer {
    fn lines(&self) -> MutexGuard<'_, Lines> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
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
        Validator.check(table, expectation)
    }

    fn checked(&self, table: &Table, expectation: &Expectation, verdict: Verdict) {
        let line = format!("{table} = {}\n", verdict.broken.map_or("ok", |rule| rule.id()));
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
