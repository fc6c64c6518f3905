//! Output of numbers, text and JSON.

use clap::{ColorChoice, ValueEnum};
use std::io::{self, Write};
use std::sync::atomic::{AtomicBool, Ordering};
pub(crate) use twinedge_report::words::{counted, grouped, json, measure, plain, style};

/// The output format.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// Text, coloured on a terminal.
    #[default]
    Text,
    /// One JSON object.
    Json,
}

/// True if reports are not printed.
static IS_QUIET: AtomicBool = AtomicBool::new(false);

pub(crate) fn set_quiet(quiet: bool) {
    IS_QUIET.store(quiet, Ordering::Relaxed);
}

pub(crate) fn set_color(choice: ColorChoice) {
    match choice {
        ColorChoice::Auto => anstream::ColorChoice::Auto,
        ColorChoice::Always => anstream::ColorChoice::Always,
        ColorChoice::Never => anstream::ColorChoice::Never,
    }
    .write_global();
}

/// Prints to standard output. A closed pipe (`… | head`) is not an error.
pub(crate) fn print_answer(text: &str) -> Result<(), crate::status::Failure> {
    let mut out = anstream::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(error.into()),
        _ => Ok(()),
    }
}

pub(crate) fn print(text: &str) -> Result<(), crate::status::Failure> {
    if IS_QUIET.load(Ordering::Relaxed) { Ok(()) } else { print_answer(text) }
}

/// Prints one JSON object. A closed pipe is not an error.
pub(crate) fn print_json(value: &impl serde::Serialize) -> Result<(), crate::status::Failure> {
    print_bytes(&json(value)?)
}

/// Prints bytes. A closed pipe is not an error.
pub(crate) fn print_bytes(bytes: &[u8]) -> Result<(), crate::status::Failure> {
    let mut out = io::stdout().lock();
    match out.write_all(bytes).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(error.into()),
        _ => Ok(()),
    }
}
