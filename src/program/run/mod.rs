//! Programs of operators run on a subject.

pub(super) mod every;
pub(super) mod interpret;
pub(super) mod named;
pub(super) mod outcome;
#[cfg(feature = "proptest")]
mod proptest;
pub(super) mod resolve;
pub(super) mod runner;
