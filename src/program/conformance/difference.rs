//! How a subject differs from the reference.

use crate::program::op::Op;
use crate::program::outcome::StepOutcome;
use crate::validate::{Part, Report};
use alloc::boxed::Box;
use core::fmt;
use thiserror::Error;

/// What is asked of a corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Question {
    /// The twin of its half-edge.
    Twin,
    /// The half-edge that follows its half-edge.
    Next,
    /// The first half-edge with the same origin.
    Origin,
    /// The first corner in the same face.
    Face,
}

/// What a subject answers, in terms that do not depend on its handles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Answer {
    /// The corner with this place in [`Runner::corners`](crate::program::Runner::corners).
    Corner(usize),
    /// The unbounded face.
    Unbounded,
    /// An error, or a handle that it never gave out.
    Nothing,
}

/// How the structure under test differs from the reference.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum Difference {
    /// The expectation leaves out a part without which two maps cannot be compared.
    #[error("the expectation leaves out {}; without it there is no telling which map it is", .0.name())]
    Lacks(Part),
    /// The operator came to something else.
    #[error("the outcome should be `{reference}` and is `{subject}`")]
    StepOutcome {
        /// What became of it in the reference.
        reference: StepOutcome,
        /// What became of it in the subject.
        subject: StepOutcome,
    },
    /// The subject breaks a rule.
    #[error("{}", FirstViolation(.0))]
    Invalid(Box<Report>),
    /// The subject keeps every rule that it is held to, but is another map.
    #[error("the map is valid, but another one than it should be")]
    NotIsomorphic,
    /// The subject is the same map, but a handle says something else.
    #[error("of corner {corner}, {question:?} should be {reference:?} and is {subject:?}")]
    Answers {
        /// The place of the corner in [`Runner::corners`](crate::program::Runner::corners).
        corner: usize,
        /// What was asked.
        question: Question,
        /// What the reference says.
        reference: Answer,
        /// What the subject says.
        subject: Answer,
    },
}

/// The first violation of a report, in words.
struct FirstViolation<'a>(&'a Report);

impl fmt::Display for FirstViolation<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0.violations().first() {
            Some(violation) => write!(f, "{} is broken: {violation}", violation.rule()),
            None => f.write_str("a rule could not be checked"),
        }
    }
}

/// Where a subject first differs from the reference.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Failure {
    /// How many operators were run before.
    pub before: usize,
    /// The operator that did it; none if the subject was not the empty map to begin with, or cannot be compared.
    pub op: Option<Op>,
    /// How it differs.
    pub difference: Difference,
}

impl core::error::Error for Failure {}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.op {
            Some(op) => write!(f, "after operator {}, `{op}`: {}", self.before + 1, self.difference),
            None => write!(f, "at the start: {}", self.difference),
        }
    }
}
