//! The format of a report, and its destination.

use crate::output::style::BAD;
use crate::output::{Failure, plain, print, print_bytes};
use crate::output_file::{format_of, write_file};
use anstream::adapter::strip_str;
use clap::ValueEnum;
use std::path::{Path, PathBuf};
use twinedge_report::Audited;

/// The format of a report.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ReportFormat {
    /// Text, coloured on a terminal.
    Text,
    /// One JSON object.
    Json,
    /// The findings as a layer of points, lines and polygons (RFC 7946).
    Geojson,
    /// SARIF 2.1.0, for code hosts.
    Sarif,
    /// XML in the form of `JUnit`, for continuous integration: a test case for each rule.
    Junit,
    /// The map and the findings side by side, in one file that a browser shows without network.
    Html,
}

/// The format for each extension.
const EXTENSIONS: [(&str, ReportFormat); 7] = [
    ("txt", ReportFormat::Text),
    ("json", ReportFormat::Json),
    ("geojson", ReportFormat::Geojson),
    ("sarif", ReportFormat::Sarif),
    ("xml", ReportFormat::Junit),
    ("html", ReportFormat::Html),
    ("htm", ReportFormat::Html),
];

/// The arguments.
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// Output format. Default: by the extension of the output (.txt, .json, .geojson, .sarif, .xml, .html), else text. geojson and html are for
    /// maps, topologies of PostGIS and the tables of a textbook.
    #[arg(long, value_enum)]
    format: Option<ReportFormat>,

    /// File to write; `-` is standard output, and the default.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

impl Arguments {
    /// Returns the destination of a report.
    ///
    /// # Errors
    /// [`Failure`], if the output's extension names no format and no format is given.
    pub(super) fn destination<'a>(
        &'a self,
        inputs: impl IntoIterator<Item = &'a Path>,
    ) -> Result<Destination<'a>, Failure> {
        let path = self.output.as_deref().filter(|path| *path != Path::new("-"));
        let format = match self.format {
            Some(format) => format,
            None => format_of(path, &EXTENSIONS)?.unwrap_or(ReportFormat::Text),
        };
        Ok(Destination { format, path, inputs: inputs.into_iter().collect() })
    }
}

pub(crate) struct Destination<'a> {
    pub(crate) format: ReportFormat,
    path: Option<&'a Path>,
    inputs: Vec<&'a Path>,
}

impl Destination<'_> {
    pub(super) fn text(&self, text: &str) -> Result<(), Failure> {
        match self.path {
            None => print(text),
            Some(path) => write_file(path, self.inputs(), strip_str(text).to_string().as_bytes()),
        }
    }

    pub(super) fn bytes(&self, bytes: &[u8]) -> Result<(), Failure> {
        match self.path {
            None => print_bytes(bytes),
            Some(path) => write_file(path, self.inputs(), bytes),
        }
    }

    pub(super) fn inputs(&self) -> impl Iterator<Item = &Path> {
        self.inputs.iter().copied()
    }

    /// Returns the path of the output file, if there is one.
    pub(super) const fn file(&self) -> Option<&Path> {
        self.path
    }
}

/// Writes an audit. Where a layer or a page goes to a file, a line for people says so.
pub(super) fn write(audited: &Audited, to: &Destination<'_>) -> Result<(), Failure> {
    match to.format {
        ReportFormat::Text => to.text(&audited.text()?)?,
        ReportFormat::Json => to.bytes(&audited.json()?)?,
        ReportFormat::Geojson => {
            let (layer, warnings) = audited.findings()?;
            for warning in warnings {
                anstream::eprintln!("{BAD}warning{BAD:#}: {warning}");
            }
            to.bytes(&layer)?;
        }
        ReportFormat::Sarif => to.bytes(&audited.sarif()?)?,
        ReportFormat::Junit => to.bytes(audited.junit()?.as_bytes())?,
        ReportFormat::Html => to.bytes(audited.page()?.as_bytes())?,
    }
    if let (ReportFormat::Geojson | ReportFormat::Html, Some(file)) = (to.format, to.file()) {
        print(&format!("{} written to {}\n", audited.summary()?, plain(&file.display().to_string())))?;
    }
    Ok(())
}
