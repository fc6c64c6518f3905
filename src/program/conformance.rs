//! Does a subject do what the operators say? A program is run on it and on the reference in step, and after every
//! operator both must have done the same.
//!
//! The reference is [`PointerModel`], which has nothing in common with [`Dcel`](crate::dcel::Dcel) but the meaning of the
//! operators: `Dcel` is held to it like any other subject.
//!
//! Compared are, after each operator:
//!
//! 1. whether it was applied, refused (and with which category of error) or skipped;
//! 2. whether the subject is valid, by the validator;
//! 3. whether both are isomorphic, nesting and unbounded face included, by their canonical forms;
//! 4. whether the handles say the same: `twin`, `next`, origins and faces of every half-edge and isolated vertex, in
//!    order of their creation. So a subject that hands out the wrong handle is found at once, and not when it is used.
//!
//! The third needs a view with faces, their inner boundary components and the unbounded face. What else a view may lack,
//! the expectation says: `prev`, half-edges at vertices, records of boundary components, places.
//!
//! An operator that the subject does not have, or has no room for, is not run on the reference either, but the subject
//! must be as it was.
//!
//! ```
//! use twinedge::program::{RotationSystem, Program, conformance};
//! let program = Program::from_bytes(b"some bytes that came from a fuzzer");
//! conformance::run(&program, RotationSystem::new(), &RotationSystem::expectation())?;
//! # Ok::<(), conformance::Failure>(())
//! ```

mod answers;

use super::canonical::Canonizer;
use super::interpret::{Runner, StepOutcome};
use super::op::{Op, Program};
use super::pointer_model::PointerModel;
use super::subject::{Refusal, Subject};
use crate::validate::{Collect, Expectation, Part, Report, validate};
use alloc::boxed::Box;
use core::fmt;
use thiserror::Error;

/// How many operators of a program came to what.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct ConformanceSummary {
    /// Applied by both.
    pub applied: usize,
    /// Refused by both, for the same reason.
    pub refused: usize,
    /// There was nothing to choose from.
    pub skipped: usize,
    /// Refused by the subject for want of the operator, or of room.
    pub not_supported: usize,
}

impl ConformanceSummary {
    /// All of them.
    #[must_use]
    pub const fn operators(&self) -> usize {
        self.applied + self.refused + self.skipped + self.not_supported
    }
}

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
    /// The corner with this place in [`Runner::corners`].
    Corner(usize),
    /// The unbounded face.
    Unbounded,
    /// An error, or a handle that it never gave out.
    Nothing,
}

/// In what a subject differs from the reference.
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
        /// The place of the corner in [`Runner::corners`].
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
    /// In what it differs.
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

/// Runs a program on a subject that is the empty map, and on the reference in step. `expectation` says what the
/// validator can hold the subject to: the plane, with [`Part::Faces`], [`Part::Holes`] and [`Part::UnboundedFace`].
///
/// O(n²) per operator for n half-edges and vertices, if the subject answers a question in O(1) and its view does. Of this
/// only comparing handles takes more than O(n log n), beside a few operators of the reference and maps with many
/// symmetries.
///
/// A panic of the subject is not caught.
///
/// # Errors
/// The first difference, and the operator that made it; [`Difference::Lacks`] before the first operator if the
/// expectation leaves out one of these parts.
pub fn run<K: Subject>(
    program: &Program,
    subject: K,
    expectation: &Expectation,
) -> Result<ConformanceSummary, Failure> {
    let mut pair = InStep::new(subject, expectation)?;
    for op in &program.0 {
        pair.step(*op)?;
    }
    Ok(pair.summary())
}

/// A subject and the reference, operator by operator: what [`run`] does, for those who want to look, or to stop, between
/// two.
#[derive(Debug)]
pub struct InStep<K: Subject> {
    reference: Runner<PointerModel>,
    subject: Runner<K>,
    expectation: Expectation,
    canonizer: Canonizer,
    summary: ConformanceSummary,
}

impl<K: Subject> InStep<K> {
    /// Begins with a subject that is the empty map.
    ///
    /// # Errors
    /// Those of [`run`] before the first operator.
    pub fn new(subject: K, expectation: &Expectation) -> Result<Self, Failure> {
        let mut pair = Self {
            reference: Runner::new(PointerModel::new()),
            subject: Runner::new(subject),
            expectation: *expectation,
            canonizer: Canonizer::new(),
            summary: ConformanceSummary::default(),
        };
        let lacks = [Part::Faces, Part::Holes, Part::UnboundedFace].into_iter().find(|part| !expectation.has(*part));
        lacks.map_or_else(|| pair.compare(), |part| Err(Difference::Lacks(part))).map_err(|difference| Failure {
            before: 0,
            op: None,
            difference,
        })?;
        Ok(pair)
    }

    /// Runs one operator on both, and compares them. Costs what is said of [`run`].
    ///
    /// # Errors
    /// The first difference. After one, or after a panic of the subject, the two are no longer in step, and what further
    /// operators do means nothing.
    pub fn step(&mut self, op: Op) -> Result<StepOutcome, Failure> {
        let outcome = self.step_both(op).map_err(|difference| Failure {
            before: self.summary.operators(),
            op: Some(op),
            difference,
        })?;
        *match outcome {
            StepOutcome::Applied => &mut self.summary.applied,
            StepOutcome::Refused(Refusal::Full | Refusal::Unsupported) => &mut self.summary.not_supported,
            StepOutcome::Refused(_) => &mut self.summary.refused,
            StepOutcome::Skipped => &mut self.summary.skipped,
        } += 1;
        Ok(outcome)
    }

    /// What the operators so far came to.
    #[must_use]
    pub const fn summary(&self) -> ConformanceSummary {
        self.summary
    }

    fn step_both(&mut self, op: Op) -> Result<StepOutcome, Difference> {
        let subject = self.subject.step(op);
        if !matches!(subject, StepOutcome::Refused(Refusal::Full | Refusal::Unsupported)) {
            let reference = self.reference.step(op);
            if subject != reference {
                return Err(Difference::StepOutcome { reference, subject });
            }
        }
        self.compare()?;
        Ok(subject)
    }

    fn compare(&mut self) -> Result<(), Difference> {
        let report = validate(self.subject.subject(), &self.expectation, Collect::First);
        if !report.is_valid() {
            return Err(Difference::Invalid(Box::new(report)));
        }
        let code = self.canonizer.subdivision(self.reference.subject());
        if self.canonizer.subdivision(self.subject.subject()) != code {
            return Err(Difference::NotIsomorphic);
        }
        answers::compare(&self.reference, &self.subject)
    }
}
