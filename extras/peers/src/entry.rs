//! An audited crate, by name.

use crate::peer::Peer;
use crate::program::{Operator, Program};
use crate::run::{self, Verdict};

/// Runs a program on the empty structure, and passes each call to the closure before making it.
pub type Run = fn(&Program, &mut dyn FnMut(&str)) -> Verdict;

/// An audited crate, by name.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// The name of the crate on the command line.
    pub name: &'static str,
    /// Its version.
    pub version: &'static str,
    /// Its operators.
    pub operators: &'static [Operator],
    /// Runs a program.
    pub run: Run,
}

impl Entry {
    /// Creates the entry of a crate.
    #[must_use]
    pub const fn of<P: Peer>(name: &'static str, version: &'static str) -> Self {
        Self { name, version, operators: P::OPERATORS, run: run::run::<P> }
    }
}
