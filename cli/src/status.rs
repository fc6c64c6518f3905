//! The result of a command and its exit status.

use twinedge_report::words::plain;

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
