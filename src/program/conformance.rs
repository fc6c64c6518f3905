//! Does a kernel do what the operators say? A program is run on it and on [`Dcel`] in step, and after every operator both
//! must have done the same.
//!
//! Compared are, after each operator:
//!
//! 1. whether it was applied, refused (and with which category of error) or skipped;
//! 2. whether the kernel is valid, by the validator;
//! 3. whether both are isomorphic, nesting and unbounded face included, by their canonical forms;
//! 4. whether the handles say the same: `twin`, `next`, origins and faces of every half-edge and isolated vertex, in order of
//!    their creation. So a kernel that hands out the wrong handle is found at once, and not when it is used.
//!
//! An operator that the kernel does not have, or has no room for, is not run on the reference either, but the kernel must be
//! as it was.
//!
//! ```
//! use twinedge::program::{Program, Textbook, conformance};
//! use twinedge::validate::Expectation;
//! let program = Program::from_bytes(b"some bytes that came from a fuzzer");
//! conformance::run(&program, Textbook::new(), &Expectation::plane())?;
//! # Ok::<(), conformance::Failure>(())
//! ```

use super::canonical::Canonizer;
use super::interpret::{Outcome, Runner};
use super::kernel::{Corner, Kernel, Refusal};
use super::op::{Op, Program};
use crate::dcel::Dcel;
use crate::validate::{Collect, Expectation, Report, validate};
use alloc::boxed::Box;
use core::fmt;
use thiserror::Error;

/// How many operators of a program came to what.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Summary {
    /// Applied by both.
    pub applied: usize,
    /// Refused by both, for the same reason.
    pub refused: usize,
    /// There was nothing to choose from.
    pub skipped: usize,
    /// Refused by the kernel for want of the operator, or of room.
    pub not_supported: usize,
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

/// What a kernel answers, in terms that do not depend on its handles.
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

/// In what a kernel differs from the reference.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum Difference {
    /// The operator came to something else.
    #[error("the outcome should be `{reference}` and is `{kernel}`")]
    Outcome {
        /// What became of it in the reference.
        reference: Outcome,
        /// What became of it in the kernel.
        kernel: Outcome,
    },
    /// The kernel breaks a rule.
    #[error("{}", FirstViolation(.0))]
    Invalid(Box<Report>),
    /// The kernel keeps every rule, but is another map.
    #[error("the map is valid, but another one than it should be")]
    NotIsomorphic,
    /// The kernel is the same map, but a handle says something else.
    #[error("of corner {corner}, {question:?} should be {reference:?} and is {kernel:?}")]
    Answers {
        /// The place of the corner in [`Runner::corners`].
        corner: usize,
        /// What was asked.
        question: Question,
        /// What the reference says.
        reference: Answer,
        /// What the kernel says.
        kernel: Answer,
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

/// Where a kernel first differs from the reference.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Failure {
    /// How many operators were run before.
    pub before: usize,
    /// The operator that did it; none if the kernel was not the empty map to begin with.
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

/// Runs a program on a kernel that is the empty map, and on the reference in step. `expectation` says what the validator can
/// hold the kernel to.
///
/// O(n²) per operator for n half-edges.
///
/// # Errors
/// The first difference, and the operator that made it.
pub fn run<K: Kernel>(program: &Program, kernel: K, expectation: &Expectation) -> Result<Summary, Failure> {
    let mut pair = Pair {
        reference: Runner::new(Dcel::new()),
        kernel: Runner::new(kernel),
        expectation,
        canonizer: Canonizer::new(),
    };
    pair.compare().map_err(|difference| Failure { before: 0, op: None, difference })?;
    let mut summary = Summary::default();
    for (before, op) in program.0.iter().enumerate() {
        let count = match pair.step(*op).map_err(|difference| Failure { before, op: Some(*op), difference })? {
            Outcome::Applied => &mut summary.applied,
            Outcome::Refused(Refusal::Full | Refusal::Unsupported) => &mut summary.not_supported,
            Outcome::Refused(_) => &mut summary.refused,
            Outcome::Skipped => &mut summary.skipped,
        };
        *count += 1;
    }
    Ok(summary)
}

/// The two structures in step.
struct Pair<'a, K: Kernel> {
    reference: Runner<Dcel>,
    kernel: Runner<K>,
    expectation: &'a Expectation,
    canonizer: Canonizer,
}

impl<K: Kernel> Pair<'_, K> {
    fn step(&mut self, op: Op) -> Result<Outcome, Difference> {
        let kernel = self.kernel.step(op);
        if !matches!(kernel, Outcome::Refused(Refusal::Full | Refusal::Unsupported)) {
            let reference = self.reference.step(op);
            if kernel != reference {
                return Err(Difference::Outcome { reference, kernel });
            }
        }
        self.compare()?;
        Ok(kernel)
    }

    fn compare(&mut self) -> Result<(), Difference> {
        let report = validate(self.kernel.kernel(), self.expectation, Collect::First);
        if !report.is_valid() {
            return Err(Difference::Invalid(Box::new(report)));
        }
        let code = self.canonizer.subdivision(self.reference.kernel());
        if self.canonizer.subdivision(self.kernel.kernel()) != code {
            return Err(Difference::NotIsomorphic);
        }
        for corner in 0..self.reference.corners().count() {
            for question in [Question::Twin, Question::Next, Question::Origin, Question::Face] {
                let reference = answer(&self.reference, corner, question);
                let kernel = answer(&self.kernel, corner, question);
                if reference != kernel {
                    return Err(Difference::Answers { corner, question, reference, kernel });
                }
            }
        }
        Ok(())
    }
}

fn answer<K: Kernel>(runner: &Runner<K>, corner: usize, question: Question) -> Answer {
    let kernel = runner.kernel();
    let corner = runner.corners().nth(corner);
    let place = match (question, corner) {
        (Question::Twin, Some(Corner::At(h))) => {
            let twin = kernel.twin_of(h).ok();
            twin.and_then(|twin| runner.half_edges().iter().position(|other| *other == twin))
        }
        (Question::Next, Some(Corner::At(h))) => {
            let next = kernel.next_of(h).ok();
            next.and_then(|next| runner.half_edges().iter().position(|other| *other == next))
        }
        (Question::Origin, Some(Corner::At(h))) => {
            let origin = kernel.origin_of(h).ok();
            let same = |other| origin.is_some() && kernel.origin_of(other).ok() == origin;
            runner.half_edges().iter().position(|other| same(*other))
        }
        (Question::Face, Some(corner)) => {
            let face = kernel.face_of(corner).ok();
            if face == Some(kernel.unbounded_face()) {
                return Answer::Unbounded;
            }
            runner.corners().position(|other| face.is_some() && kernel.face_of(other).ok() == face)
        }
        _ => None,
    };
    place.map_or(Answer::Nothing, Answer::Corner)
}
