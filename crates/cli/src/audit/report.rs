//! The arguments of `audit` and `sum` about their reports, and how these are written.

use super::destination::{self, Destination, write};
use crate::output::{Failure, Verdict, named};
use crate::output_file::write_file;
use std::path::{Path, PathBuf};
use twinedge_report::{Accepted, Audited, Options};

/// The arguments.
#[derive(Debug, clap::Args)]
pub(crate) struct Report {
    #[command(flatten)]
    destination: destination::Arguments,

    /// Greatest number of violations to list, and of findings of each rule C1 … C7; all are counted. Default: 1000, and in the text 3
    /// findings of each of C1 … C7.
    #[arg(long, value_name = "N", value_parser = twinedge_report::whole, allow_negative_numbers = true)]
    list: Option<usize>,

    /// Print the usual cause and the remedy of each kind of violation or finding. In JSON these are the keys `cause` and
    /// `remedy`. For a topology of PostGIS: the SQL that shows the rows, and the SQL that fixes faults with a single fix (key `sql`).
    #[arg(long)]
    explain: bool,

    /// Accept the findings of C1 … C7 and X1 … X6 that are listed in this file, as long as they do not grow: with --coverage they break nothing, and neither do
    /// violations that touch no other finding. The report says which of them no longer occur. `--accept-all` writes such a file.
    #[arg(long, value_name = "FILE")]
    accept: Option<PathBuf>,

    /// Write all findings of C1 … C7 and X1 … X6 to this file, as accepted ones. Those that the file of --accept has keep their reason and date.
    #[arg(long, value_name = "FILE")]
    accept_all: Option<PathBuf>,

    /// The reason that --accept-all writes.
    #[arg(long, value_name = "TEXT", requires = "accept_all", default_value = "accepted as it is")]
    reason: String,
}

impl Report {
    /// Returns the destination of the report on these inputs, which is none of them.
    ///
    /// # Errors
    /// [`Failure`], if the output's extension names no format and no format is given.
    pub(crate) fn destination<'a>(
        &'a self,
        inputs: impl IntoIterator<Item = &'a Path>,
    ) -> Result<Destination<'a>, Failure> {
        self.destination.destination(inputs)
    }

    pub(super) const fn has_lists(&self) -> bool {
        self.accept.is_some() || self.accept_all.is_some()
    }

    /// Reads the list of accepted findings.
    pub(crate) fn accepted(&self) -> Result<Option<Accepted>, Failure> {
        let read = |path: &PathBuf| {
            let name = path.display().to_string();
            let text = std::fs::read_to_string(path).map_err(named(&name))?;
            Accepted::read(&text).map_err(named(&name))
        };
        self.accept.as_ref().map(read).transpose()
    }

    /// Adds the options of the report to others; with lists of accepted findings, all findings are listed.
    pub(crate) fn options(&self, accepted: Option<Accepted>, options: Options) -> Options {
        let list = if self.has_lists() { Some(usize::MAX) } else { self.list };
        Options { list, accepted, explain: self.explain, ..options }
    }

    /// Writes the report, and the list of findings if it is requested.
    pub(crate) fn write(
        &self,
        audited: &Audited,
        options: &Options,
        name: &str,
        to: &Destination<'_>,
    ) -> Result<Verdict, Failure> {
        if let Some(path) = &self.accept_all {
            let today = chrono::Utc::now().date_naive().to_string();
            let all = audited.accept_all(options.accepted.as_ref(), &self.reason, &today).map_err(named(name))?;
            write_file(path, to.inputs(), &all)?;
        }
        write(audited, to)?;
        Ok(if audited.is_valid() { Verdict::Sound } else { Verdict::Wrong })
    }
}
