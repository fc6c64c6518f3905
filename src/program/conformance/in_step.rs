//! A subject and the reference, operator by operator.

use super::answers::{self, Vertices};
use super::difference::{Difference, Failure};
use super::settings::Conformance;
use super::summary::{ConformanceSummary, NotCompared};
use super::survivors::Exchange;
use super::view;
use crate::program::canonical::Canonizer;
use crate::program::operators::Op;
use crate::program::panics::catch;
use crate::program::pointer_model::PointerModel;
use crate::program::run::outcome::StepOutcome;
use crate::program::run::runner::Runner;
use crate::program::subject::{Refusal, Subject};
use crate::validate::adapt::Borders;
use crate::validate::{Collect, Expectation, Part, Parts, View, validate};
use alloc::boxed::Box;
use alloc::vec::Vec;

/// Without these, a structure that is empty cannot be added to, or maps cannot be told apart by their canonical forms.
const NEEDED: [Part; 3] = [Part::Faces, Part::Holes, Part::UnboundedFace];

/// A subject and the reference, operator by operator. [`run`](super::run) does the same for a whole program.
#[derive(Debug)]
pub struct InStep<K: Subject> {
    reference: Runner<PointerModel>,
    subject: Runner<K>,
    settings: Conformance,
    /// The parts that are looked at.
    parts: Parts,
    /// The vertices as they were after the last operator.
    vertices: Vertices<K>,
    canonizer: Canonizer,
    summary: ConformanceSummary,
    steps: usize,
}

impl<K: Subject> InStep<K> {
    /// Begins with the subject as it is: the empty map, or any other.
    ///
    /// O(n²) for n half-edges and vertices.
    ///
    /// # Errors
    /// Those of [`run`](super::run) before the first operator.
    pub fn new(subject: K, expectation: &Expectation) -> Result<Self, Failure> {
        Self::with(subject, Conformance::of(expectation))
    }

    pub(super) fn with(subject: K, settings: Conformance) -> Result<Self, Failure> {
        caught(|| Self::begin(subject, settings)).map_err(|difference| Failure { before: 0, op: None, difference })
    }

    fn begin(subject: K, settings: Conformance) -> Result<Self, Difference> {
        let expectation = &settings.expectation;
        let parts = expectation.looks_at(subject.parts());
        let lacks = NEEDED.into_iter().find(|part| !parts.has(*part));
        let is_empty = !(0..subject.half_edge_slots()).any(|h| subject.is_half_edge(h))
            && !(0..subject.vertex_slots()).any(|v| subject.is_vertex(v));
        if let (true, Some(part)) = (is_empty, lacks) {
            return Err(Difference::Lacks(part));
        }
        judge(&subject, expectation)?;
        let start = PointerModel::from_view(&subject, expectation).map_err(Difference::Start)?;
        let mut handles = Vec::new();
        let mut names = Vec::new();
        for (index, name) in start.half_edges {
            handles.push(subject.half_edge_at(index).ok_or(Difference::NoHandle { half_edge: index })?);
            names.push(name);
        }
        let mut isolated = Vec::new();
        let mut isolated_names = Vec::new();
        for (index, name) in start.isolated {
            isolated.push(subject.vertex_at(index).ok_or(Difference::NoVertexHandle { vertex: index })?);
            isolated_names.push(name);
        }
        let mut pair = Self {
            reference: Runner::starting_with(start.model, names, isolated_names),
            subject: Runner::starting_with(subject, handles, isolated),
            settings,
            parts,
            vertices: Vertices::<K>::default(),
            canonizer: Canonizer::new(),
            summary: ConformanceSummary::default(),
            steps: 0,
        };
        pair.note_what_is_not_there();
        pair.vertices = pair.compare()?;
        Ok(pair)
    }

    /// Runs one operator on both, and compares them. Costs as much as a step of [`run`](super::run).
    ///
    /// # Errors
    /// The first difference, a panic of the subject among them. After one the two are no longer in step, and what further operators do
    /// means nothing.
    pub fn step(&mut self, op: Op) -> Result<StepOutcome, Failure> {
        let before = self.steps;
        let outcome = caught(|| self.run(op)).map_err(|difference| Failure { before, op: Some(op), difference })?;
        self.steps += 1;
        Ok(outcome)
    }

    fn run(&mut self, op: Op) -> Result<StepOutcome, Difference> {
        let exchange = Exchange::of(op, &self.reference, &self.subject, self.settings.survivor);
        let chosen = self.subject.resolve(op);
        let is_called = chosen.is_ok();
        let outcome = chosen.and_then(|call| self.subject.call(call)).err().unwrap_or(StepOutcome::Applied);
        // An operator that is not applied exchanges nothing.
        let exchange = if outcome == StepOutcome::Applied { exchange } else { Exchange::Nothing };
        self.follow(op, outcome, &exchange)?;
        self.summary.count(op, if is_called { outcome } else { StepOutcome::Skipped });
        Ok(outcome)
    }

    /// The summary of the operators so far.
    #[must_use]
    pub const fn summary(&self) -> ConformanceSummary {
        self.summary
    }

    /// The subject, with the handles that it gave out.
    #[must_use]
    pub const fn subject(&self) -> &Runner<K> {
        &self.subject
    }

    /// Runs an operator on the reference, after the subject did this, and compares.
    fn follow(&mut self, op: Op, subject: StepOutcome, exchange: &Exchange) -> Result<(), Difference> {
        if !matches!(subject, StepOutcome::Refused(Refusal::Full | Refusal::Unsupported)) {
            let reference = self.reference.step(op);
            if subject != reference {
                return Err(Difference::StepOutcome { reference, subject });
            }
        }
        if !self.settings.stale_handles {
            self.reference.forget_retired();
            self.subject.forget_retired();
        }
        let vertices = self.compare()?;
        if self.settings.vertex_handles {
            exchange.compare::<K>(&self.vertices, &vertices)?;
        }
        self.vertices = vertices;
        Ok(())
    }

    fn note_what_is_not_there(&mut self) {
        let not_compared = [
            (Part::Faces, NotCompared::Faces),
            (Part::Holes, NotCompared::Holes),
            (Part::UnboundedFace, NotCompared::Outside),
        ];
        for (_, not_compared) in not_compared.into_iter().filter(|(part, _)| !self.parts.has(*part)) {
            self.summary.note(not_compared);
        }
        if !self.settings.stale_handles {
            self.summary.note(NotCompared::StaleHandles);
        }
        if !self.settings.vertex_handles {
            self.summary.note(NotCompared::VertexHandles);
        }
    }

    /// Compares all, and pairs the vertices.
    fn compare(&mut self) -> Result<Vertices<K>, Difference> {
        judge(self.subject.subject(), &self.settings.expectation)?;
        let has_faces = self.parts.has(Part::Faces);
        if NEEDED.into_iter().all(|part| self.parts.has(part)) {
            let code = self.canonizer.subdivision(self.reference.subject());
            if self.canonizer.subdivision(self.subject.subject()) != code {
                return Err(Difference::NotIsomorphic);
            }
        } else {
            view::compare(&self.reference, &self.subject, has_faces)?;
        }
        let agreement = answers::compare(&self.reference, &self.subject, has_faces)?;
        if agreement.lacks_next {
            self.summary.note(NotCompared::BorderNext);
        }
        Ok(agreement.vertices)
    }
}

/// Does what asks the subject. A panic of it is a difference.
fn caught<T>(work: impl FnOnce() -> Result<T, Difference>) -> Result<T, Difference> {
    catch(work).unwrap_or_else(|panic| Err(Difference::Panicked(panic)))
}

/// Holds a subject to the rules. Where half-edges on the border have no `next`, it is the one that follows from the rest.
///
/// Through a pointer: the validator is compiled once then, and not for every subject.
fn judge(subject: &dyn View, expectation: &Expectation) -> Result<(), Difference> {
    let borders = if expectation.is_open() { Borders::of(subject) } else { None };
    let report = match borders {
        Some(borders) => validate(&borders, expectation, Collect::First),
        None => validate(subject, expectation, Collect::First),
    };
    if report.is_valid() { Ok(()) } else { Err(Difference::Invalid(Box::new(report))) }
}
