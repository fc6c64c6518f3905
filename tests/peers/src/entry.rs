//! An audited crate, by name.

use crate::peer::Peer;
use crate::program::{Operator, Program};
use crate::run::{self, Verdict};

/// Runs a program on the empty structure, and tells the closure of each call before it is made.
pub type Run = fn(&Program, &mut dyn FnMut(&str)) -> Verdict;

/// An audited crate, by name.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// The crate, as the command line names it.
    pub name: &'static str,
    /// Its version.
    pub version: &'static str,
    /// Its operators.
    pub operators: &'static [Operator],
    /// Runs a program.
    pub run: Run,
}

impl Entry {
    /// The entry of a crate.
    #[must_use]
    pub const fn of<P: Peer>(name: &'static str, version: &'static str) -> Self {
        Self { name, version, operators: P::OPERATORS, run: run::run::<P> }
    }
}
