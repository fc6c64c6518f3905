//! The interface of an audited crate.

use crate::program::Operator;
use twinedge::validate::Report;

/// The result of a call.
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

    /// Returns the report of the validator on the structure.
    fn report(&self) -> Report;

    /// Returns the verdict of the crate's own check on the structure, if it has a public one.
    fn own_check(&self) -> Option<bool> {
        None
    }
}
