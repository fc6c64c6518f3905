//! Output of numbers, text and JSON, and the exit status.

pub(crate) use twinedge_report::words::{counted, grouped, json, measure, plain, style};

use clap::{ColorChoice, ValueEnum};
use std::io::{self, Write};
use std::sync::atomic::{AtomicBool, Ordering};

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
pub(crate) fn print_answer(text: &str) -> Result<(), crate::output::Failure> {
    let mut out = anstream::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(error.into()),
        _ => Ok(()),
    }
}

pub(crate) fn print(text: &str) -> Result<(), crate::output::Failure> {
    if IS_QUIET.load(Ordering::Relaxed) { Ok(()) } else { print_answer(text) }
}

/// Prints one JSON object. A closed pipe is not an error.
pub(crate) fn print_json(value: &impl serde::Serialize) -> Result<(), crate::output::Failure> {
    print_bytes(&json(value)?)
}

/// Prints bytes. A closed pipe is not an error.
pub(crate) fn print_bytes(bytes: &[u8]) -> Result<(), crate::output::Failure> {
    let mut out = io::stdout().lock();
    match out.write_all(bytes).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(error.into()),
        _ => Ok(()),
    }
}

/// The result of a command, reported by its exit status.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Verdict {
    Sound,
    Wrong,
}

/// The reason why a command failed, in one line for standard error.
#[derive(Debug)]
pub(crate) struct Failure(pub(crate) String);

impl<E: std::error::Error> From<E> for Failure {
    fn from(error: E) -> Self {
        Self(error.to_string())
    }
}

/// Converts an error about an input to a failure that names the input.
pub(crate) fn named<E: std::fmt::Display>(input: &str) -> impl Fn(E) -> Failure + '_ {
    move |error| Failure(format!("{input}: {error}"))
}

impl Verdict {
    pub(crate) const fn status(self) -> u8 {
        match self {
            Self::Sound => 0,
            Self::Wrong => 1,
        }
    }
}

impl Failure {
    /// Prints the failure to standard error, and returns the exit status.
    pub(crate) fn tell(&self) -> u8 {
        eprintln!("twinedge: {}", plain(&self.0));
        FAILED
    }
}

/// The exit status of a failed command.
const FAILED: u8 = 2;
