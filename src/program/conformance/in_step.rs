//! A subject and the reference, operator by operator.

use super::answers;
use super::difference::{Difference, Failure};
use crate::program::canonical::Canonizer;
use crate::program::op::{Op, Program};
use crate::program::outcome::StepOutcome;
use crate::program::pointer_model::PointerModel;
use crate::program::runner::Runner;
use crate::program::subject::{Refusal, Subject};
use crate::validate::{Collect, Expectation, Part, validate};
use alloc::boxed::Box;

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

/// A subject and the reference, operator by operator. [`run`] does the same for a whole program.
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
