//! The interface of an audited crate.

use crate::program::Operator;
use twinedge::validate::Report;

/// The result of a call.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Applied {
    /// The call was made and returned.
    Done,
    /// The call was made and returned an error.
    Refused,
    /// The call was not made: there was no element to call it on, or a documented precondition did not hold.
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
