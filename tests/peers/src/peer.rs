//! What an audited crate supplies.

use crate::program::{Operator, Program};
use crate::run::{self, Verdict};
use twinedge::validate::Report;

/// What became of a call.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Applied {
    /// It was made, and it returned.
    Done,
    /// It was made, and it returned an error.
    Refused,
    /// It was not made: there is nothing to call it on, or the documentation asks for something that does not hold.
    Skipped,
}

/// A structure of an audited crate, with its operators.
pub trait Peer {
    /// The operators that programs call.
    const OPERATORS: &'static [Operator];

    /// The empty structure.
    fn new() -> Self;

    /// Calls the operator, unless its documented preconditions do not hold.
    fn apply(&mut self, operator: &str, arguments: &[u32]) -> Applied;

    /// What the rules say of the structure.
    fn report(&self) -> Report;

    /// What the crate's own check says of the structure, if it has a public one.
    fn own_check(&self) -> Option<bool> {
        None
    }
}

/// An audited crate, by name.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// The crate, as the command line names it.
    pub name: &'static str,
    /// Its version.
    pub version: &'static str,
    /// Its operators.
    pub operators: &'static [Operator],
    /// Runs a program on the empty structure, and tells of each call before it is made.
    pub run: fn(&Program, &mut dyn FnMut(&str)) -> Verdict,
}

impl Entry {
    /// The entry of a crate.
    #[must_use]
    pub const fn of<P: Peer>(name: &'static str, version: &'static str) -> Self {
        Self { name, version, operators: P::OPERATORS, run: run::run::<P> }
    }
}
