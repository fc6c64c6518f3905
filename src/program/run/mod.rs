//! Programs of operators run on a subject.

pub(super) mod every;
pub(super) mod interpret;
pub(super) mod named;
pub(super) mod outcome;
pub(super) mod resolve;
pub(super) mod runner;
