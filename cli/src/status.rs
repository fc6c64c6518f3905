//! The result of a command and its exit status.

use std::process::ExitCode;

/// The result of a command, as its exit status tells it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Verdict {
    Sound,
    Wrong,
    Interrupted,
}

/// Why a command could not be carried out, in one line for standard error.
#[derive(Debug)]
pub(crate) struct Failure(pub(crate) String);

impl<E: std::error::Error> From<E> for Failure {
    fn from(error: E) -> Self {
        Self(error.to_string())
    }
}

/// Makes an error about an input a failure that names the input.
pub(crate) fn named<E: std::fmt::Display>(input: &str) -> impl Fn(E) -> Failure + '_ {
    move |error| Failure(format!("{input}: {error}"))
}

impl From<Verdict> for ExitCode {
    fn from(verdict: Verdict) -> Self {
        Self::from(match verdict {
            Verdict::Sound => 0,
            Verdict::Wrong => 1,
            Verdict::Interrupted => 130,
        })
    }
}

/// The exit status of a command that could not be carried out.
pub(crate) const FAILED: u8 = 2;
