//! Output as text and JSON, and the exit status.

use clap::{ColorChoice, ValueEnum};
use std::fmt::{self, Write as _};
use std::io::{self, Write};
use std::sync::atomic::{AtomicBool, Ordering};
use style::{BAD, QUIET};
use twinedge_trials::{Cell, Column, Row};

/// The output format.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// Text, coloured on a terminal.
    #[default]
    Text,
    /// One JSON object.
    Json,
}

impl Format {
    /// Prints a value in this format.
    pub(crate) fn print(self, value: &(impl fmt::Display + serde::Serialize)) -> Result<(), Failure> {
        match self {
            Self::Text => print(&value.to_string()),
            Self::Json => print_json(value),
        }
    }
}

/// The result of a command, reported by its exit status.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Verdict {
    Sound,
    Wrong,
    Interrupted,
}

impl Verdict {
    pub(crate) const fn of(is_ok: bool) -> Self {
        if is_ok { Self::Sound } else { Self::Wrong }
    }

    pub(crate) const fn status(self) -> u8 {
        match self {
            Self::Sound => 0,
            Self::Wrong => 1,
            Self::Interrupted => 130,
        }
    }
}

/// The reason why a command failed, in one line for standard error.
#[derive(Debug)]
pub(crate) struct Failure(pub(crate) String);

impl<E: std::error::Error> From<E> for Failure {
    fn from(error: E) -> Self {
        Self(error.to_string())
    }
}

/// Converts an error about a file to a failure that names the file.
pub(crate) fn named<E: fmt::Display>(file: impl fmt::Display) -> impl Fn(E) -> Failure {
    move |error| Failure(format!("{file}: {error}"))
}

impl Failure {
    /// Prints the failure to standard error, and returns the exit status.
    pub(crate) fn tell(&self) -> u8 {
        // Control characters could act as commands to the terminal.
        let plain = self.0.replace(char::is_control, "\u{fffd}");
        eprintln!("twinedge-trials: {plain}");
        2
    }
}

/// The colours of results; off if the output is not a terminal.
pub(crate) mod style {
    use anstyle::{AnsiColor, Style};

    pub(crate) const GOOD: Style = AnsiColor::Green.on_default().bold();
    pub(crate) const BAD: Style = AnsiColor::Red.on_default().bold();
    /// For secondary text.
    pub(crate) const QUIET: Style = AnsiColor::BrightBlack.on_default();
}

/// True if reports are not printed.
static IS_QUIET: AtomicBool = AtomicBool::new(false);

/// Applies the options that all commands share.
pub(crate) fn configure(color: ColorChoice, quiet: bool) {
    IS_QUIET.store(quiet, Ordering::Relaxed);
    match color {
        ColorChoice::Auto => anstream::ColorChoice::Auto,
        ColorChoice::Always => anstream::ColorChoice::Always,
        ColorChoice::Never => anstream::ColorChoice::Never,
    }
    .write_global();
}

/// Prints a report, unless the program is quiet. A closed pipe (`… | head`) is not an error.
pub(crate) fn print(text: &str) -> Result<(), Failure> {
    if IS_QUIET.load(Ordering::Relaxed) { Ok(()) } else { write(anstream::stdout().lock(), text.as_bytes()) }
}

/// Prints one JSON object.
pub(crate) fn print_json(value: &impl serde::Serialize) -> Result<(), Failure> {
    let mut bytes = serde_json::to_vec_pretty(&serde_json::to_value(value)?)?;
    bytes.push(b'\n');
    print_bytes(&bytes)
}

pub(crate) fn print_bytes(bytes: &[u8]) -> Result<(), Failure> {
    write(io::stdout().lock(), bytes)
}

fn write(mut out: impl Write, bytes: &[u8]) -> Result<(), Failure> {
    unless_closed(out.write_all(bytes).and_then(|()| out.flush()))
}

/// Ignores the error of a closed pipe.
pub(crate) fn unless_closed(written: io::Result<()>) -> Result<(), Failure> {
    match written {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(error.into()),
        _ => Ok(()),
    }
}

/// Formats a number with grouped thousands.
pub(crate) fn grouped(n: u64) -> String {
    let digits = n.to_string();
    let mut out = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            out.push(',');
        }
        out.push(digit);
    }
    out
}

/// Formats a count with its noun, singular or plural.
pub(crate) fn counted(n: usize, name: &str) -> String {
    let plural = match name.strip_suffix("ex") {
        _ if n == 1 => name.to_owned(),
        Some(stem) => format!("{stem}ices"),
        None => format!("{name}s"),
    };
    format!("{} {plural}", grouped(n as u64))
}

/// Formats a number that should be 0, marked if it is not.
pub(crate) fn zero(found: u64) -> String {
    if found == 0 { "0".to_owned() } else { format!("{BAD}{}{BAD:#}", grouped(found)) }
}

/// Formats a count, with the expected one if the two differ.
pub(crate) fn beside(found: u64, expected: u64) -> String {
    if found == expected {
        return grouped(found);
    }
    format!("{BAD}{}≠{}{BAD:#}", grouped(found), grouped(expected))
}

/// Returns the head of a table of counts, without the end of the line.
pub(crate) fn head<R: Row>() -> String {
    let names = R::COLUMNS.iter().map(|column| (*column, column.name.to_owned()));
    format!("{QUIET}{}{QUIET:#}", in_columns(names))
}

/// Formats a row, with the expected count next to each count that differs. Without the whole work (`is_complete` is false) no counts are expected.
pub(crate) fn line<R: Row>(row: &R, is_complete: bool) -> String {
    let cells = row.cells().into_iter().map(|cell| match cell {
        Cell::Text(text) => text,
        Cell::Count { found, expected } => beside(found, expected.filter(|_| is_complete).unwrap_or(found)),
        Cell::Zero(found) => zero(found),
        _ => String::new(),
    });
    in_columns(R::COLUMNS.iter().copied().zip(cells))
}

/// Formats a table of counts: its head, and a line for each row.
pub(crate) fn table<'a, R: Row + 'a>(rows: impl IntoIterator<Item = &'a R>, is_complete: bool) -> String {
    rows.into_iter().fold(head::<R>() + "\n", |text, row| text + &line(row, is_complete) + "\n")
}

/// Aligns cells in columns. Two spaces separate a label that is not in the first column.
fn in_columns(cells: impl Iterator<Item = (Column, String)>) -> String {
    let mut line = String::new();
    for (column, cell) in cells.filter(|(column, _)| column.width > 0) {
        let (width, is_first) = (column.width, line.is_empty());
        // Writing to a string never fails.
        let _ = match (column.is_label, is_first) {
            (true, true) => write!(line, "{cell:width$}"),
            (true, false) => write!(line, "  {cell:width$}"),
            (false, true) => write!(line, "{cell:>width$}"),
            (false, false) => write!(line, " {cell:>width$}"),
        };
    }
    line
}
