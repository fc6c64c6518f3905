//! Runs a structure and the reference in step: operator by operator, for one program, or for many random ones.

use super::compare::{Exchange, Vertices, compare_answers, compare_view};
use super::difference::{
    ConformanceSummary, Counterexample, Difference, Failure, NotCompared, OperatorCounts, Words, call_in_words,
    places_in_words,
};
use super::{Conformance, Coverage};
use crate::dcel::{Corner, Side};
use crate::program::arguments::{FacePick, HalfEdgePick, InnerPick, SecondPick, VertexPick};
use crate::program::choose::Random;
use crate::program::every::{every_mesh_op, every_op};
use crate::program::generator::Generator;
use crate::program::instances::Start;
use crate::program::operators::{Op, OpKind, Program};
use crate::program::panics::catch;
use crate::program::pointer_model::PointerModel;
use crate::program::runner::Runner;
use crate::program::shrink::shrink_from;
use crate::program::subject::{Refusal, StepOutcome, Subject};
use crate::validate::adapt::Borders;
use crate::validate::{Collect, Expectation, Part, Parts, View, validate};
use alloc::boxed::Box;
use alloc::vec;
use alloc::vec::Vec;

/// Without these parts, nothing can be added to an empty structure, or maps cannot be distinguished.
const NEEDED: [Part; 3] = [Part::Faces, Part::Holes, Part::UnboundedFace];

/// A subject and the reference, operator by operator. [`run`](super::run) does the same for a whole program.
#[derive(Debug)]
pub struct InStep<K: Subject> {
    reference: Runner<PointerModel>,
    subject: Runner<K>,
    settings: Conformance,
    parts: Parts,
    vertices: Vertices<K>,
    summary: ConformanceSummary,
    steps: usize,
}

impl<K: Subject> InStep<K> {
    /// Begins with the subject in its current state: the empty map, or any other.
    ///
    /// O(n²) for n half-edges and vertices.
    ///
    /// # Errors
    /// The errors of [`run`](super::run) before the first operator.
    pub fn new(subject: K, expectation: &Expectation) -> Result<Self, Failure> {
        Self::with(subject, Conformance::of(expectation))
    }

    fn with(subject: K, settings: Conformance) -> Result<Self, Failure> {
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
            summary: ConformanceSummary::default(),
            steps: 0,
        };
        pair.note_what_is_not_there();
        pair.vertices = pair.compare()?;
        Ok(pair)
    }

    /// Runs one operator on both structures and compares them. Costs as much as a step of [`run`](super::run).
    ///
    /// # Errors
    /// The first difference, including a panic of the subject. After a difference the two structures are no longer in step, and further
    /// steps are meaningless.
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
        let outcome = chosen.and_then(|call| self.subject.apply(call)).err().unwrap_or(StepOutcome::Applied);
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

    /// The subject, with the handles that it returned.
    #[must_use]
    pub const fn subject(&self) -> &Runner<K> {
        &self.subject
    }

    /// Runs an operator on the reference, given the outcome in the subject, and compares.
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

    fn compare(&mut self) -> Result<Vertices<K>, Difference> {
        judge(self.subject.subject(), &self.settings.expectation)?;
        compare_view(&self.reference, &self.subject, self.parts)?;
        let agreement = compare_answers(&self.reference, &self.subject, self.parts.has(Part::Faces))?;
        if agreement.lacks_next {
            self.summary.note(NotCompared::BorderNext);
        }
        Ok(agreement.vertices)
    }
}

/// Runs `work` on the subject. A panic becomes a difference.
fn caught<T>(work: impl FnOnce() -> Result<T, Difference>) -> Result<T, Difference> {
    catch(work).unwrap_or_else(|panic| Err(Difference::Panicked(panic)))
}

/// Validates a subject. Where half-edges on the border have no `next`, it is derived from the other links.
///
/// Takes a trait object, so the validator is compiled once rather than for every subject.
fn judge(subject: &dyn View, expectation: &Expectation) -> Result<(), Difference> {
    let borders = if expectation.is_open() { Borders::of(subject) } else { None };
    let report = match borders {
        Some(borders) => validate(&borders, expectation, Collect::First),
        None => validate(subject, expectation, Collect::First),
    };
    if report.is_valid() { Ok(()) } else { Err(Difference::Invalid(Box::new(report))) }
}

impl Conformance {
    /// Begins a comparison, to be continued with [`InStep::step`].
    ///
    /// # Errors
    /// The errors of [`run`](super::run) before the first operator.
    pub fn begin<K: Subject>(self, subject: K) -> Result<InStep<K>, Failure> {
        InStep::with(subject, self)
    }

    /// Runs a program, as [`run`](super::run) does.
    ///
    /// # Errors
    /// The errors of [`run`](super::run).
    pub fn run<K: Subject>(self, program: &Program, subject: K) -> Result<ConformanceSummary, Failure> {
        let summary = self.compare(program, subject)?;
        if !program.0.is_empty() {
            Self::judge(self.coverage.unwrap_or(Coverage::SomeOperator), &summary).map_err(|difference| Failure {
                before: program.0.len(),
                op: None,
                difference,
            })?;
        }
        Ok(summary)
    }

    /// Runs a program, as [`run`](super::run) does, and shrinks it if it fails: the body of a fuzz target. `make` must return the same
    /// starting structure each time.
    ///
    /// # Errors
    /// The smallest program found that shows a difference, with the difference.
    pub fn run_and_shrink<K: Subject>(
        self,
        program: &Program,
        mut make: impl FnMut() -> K,
    ) -> Result<ConformanceSummary, Counterexample> {
        self.run(program, make()).map_err(|failure| self.smallest(program.clone(), failure, &mut make))
    }

    /// Runs random programs, each on a new subject, as [`check`](super::check) does.
    ///
    /// # Errors
    /// The errors of [`check`](super::check).
    pub fn check<K: Subject>(self, mut make: impl FnMut() -> K) -> Result<ConformanceSummary, Counterexample> {
        let mut sum = ConformanceSummary::default();
        let mut noise = Random::seeded(self.seed);
        let mut generator = generator_for(&sum);
        for _ in 0..self.programs {
            let mut program = Program::default();
            let mut pair = self.begin(make()).map_err(|failure| Counterexample::of(Program::default(), failure))?;
            let mut step = |op: Op, pair: &mut InStep<K>| {
                program.0.push(op);
                pair.step(op).map_err(|failure| self.smallest(program.clone(), failure, &mut make))
            };
            for _ in 0..self.operators {
                let Some(op) = generator.op(&mut noise) else { break };
                step(op, &mut pair)?;
            }
            // Tries operators with all arguments if random arguments seldom suit them. Operators of meshes first need a mesh.
            for op in triangle_for(&Self::rest(&pair, &sum), pair.subject()) {
                step(op, &mut pair)?;
            }
            for op in Self::rest(&pair, &sum) {
                let is_applied = |summary: &ConformanceSummary| summary.of(op.name()).is_some_and(|c| c.applied > 0);
                if !is_applied(&sum) && !is_applied(&pair.summary()) {
                    step(op, &mut pair)?;
                }
            }
            sum.add(&pair.summary());
            generator = generator_for(&sum);
        }
        let coverage = self.coverage.unwrap_or(Coverage::EveryOperator);
        Self::judge(coverage, &sum).map_err(|difference| {
            let failure = Failure { before: sum.total().all(), op: None, difference };
            Counterexample::of(Program::default(), failure)
        })?;
        Ok(sum)
    }

    fn smallest<K: Subject>(self, program: Program, failure: Failure, make: &mut impl FnMut() -> K) -> Counterexample {
        if failure.is_coverage() {
            return Counterexample::of(program, failure);
        }
        // A start that cannot be read only makes counterexamples larger.
        let start = catch(|| Start::of(&make(), &self.expectation)).ok().and_then(Result::ok).unwrap_or_default();
        let small = shrink_from(&program, &start, |program| self.compare(program, make()).is_err());
        // If the subject is not deterministic, reports the original failure.
        self.explain(small, make()).unwrap_or_else(|| Counterexample::of(program, failure))
    }

    fn explain<K: Subject>(self, program: Program, subject: K) -> Option<Counterexample> {
        let mut pair = match self.begin(subject) {
            Err(failure) => return Some(Counterexample::of(program, failure)),
            Ok(pair) => pair,
        };
        let mut calls = Vec::new();
        let failure = program.0.iter().find_map(|op| {
            calls.push(call_in_words(pair.subject(), *op));
            pair.step(*op).err()
        })?;
        let places = places_in_words(pair.subject(), &failure.difference);
        Some(Counterexample { program, failure: Box::new(failure), words: Box::new(Words { places, calls }) })
    }

    /// The operators that the subject supports but has not applied yet, with every argument.
    fn rest<K: Subject>(pair: &InStep<K>, sum: &ConformanceSummary) -> Vec<Op> {
        let mut all = *sum;
        all.add(&pair.summary());
        let is_left = |op: &Op| all.of(op.name()).is_some_and(|counts| counts.is_supported() && counts.applied == 0);
        let mut ops = every_mesh_op(pair.subject());
        ops.extend(every_op(pair.subject()));
        ops.retain(is_left);
        ops
    }

    fn compare<K: Subject>(self, program: &Program, subject: K) -> Result<ConformanceSummary, Failure> {
        let mut pair = self.begin(subject)?;
        for op in &program.0 {
            pair.step(*op)?;
        }
        Ok(pair.summary())
    }

    fn judge(coverage: Coverage, summary: &ConformanceSummary) -> Result<(), Difference> {
        let total = summary.total();
        if coverage != Coverage::Nothing && total.applied == 0 {
            return Err(Difference::NothingApplied);
        }
        let never =
            |(name, counts): (_, OperatorCounts)| (counts.is_supported() && counts.applied == 0).then_some(name);
        let names: Vec<&'static str> = summary.by_operator().filter_map(never).collect();
        if coverage == Coverage::EveryOperator && !names.is_empty() {
            return Err(Difference::NeverApplied(names));
        }
        Ok(())
    }
}

/// Adds a triangle with a vertex inside, if an operator of meshes is left and the structure has a face for it: edges of random maps
/// seldom have triangles on both sides.
fn triangle_for<K: Subject>(left: &[Op], on: &Runner<K>) -> Vec<Op> {
    let is_of_mesh = |op: &Op| OpKind::SHARES.iter().any(|(kind, share)| *kind == op.kind() && *share == 0);
    if on.subject().unbounded_face().is_none() || !left.iter().any(is_of_mesh) {
        return Vec::new();
    }
    let place = |list: usize, more: u32| u32::try_from(list).unwrap_or(0).saturating_add(more);
    let half_edge = |more| HalfEdgePick::Live(place(on.half_edges().len(), more));
    let vertex = Corner::Isolated(VertexPick::Isolated(place(on.isolated().len(), 0)));
    vec![
        Op::AddIsolatedVertex { face: FacePick::Unbounded },
        Op::SplitVertex { from: vertex, to: SecondPick::Any(vertex) },
        Op::SplitEdge { half_edge: half_edge(0) },
        Op::Connect {
            from: Corner::At(half_edge(3)),
            to: SecondPick::Any(Corner::At(half_edge(0))),
            new_face: Side::Left,
            inner: InnerPick::default(),
        },
        Op::MeshSplitFace { half_edge: half_edge(0) },
    ]
}

/// An operator skipped this often is drawn rarely.
const SKIPPED_OFTEN: usize = 20;
/// An operator answered with [`Refusal::Unsupported`] this often is no longer drawn.
const SURELY_UNSUPPORTED: usize = 4;

/// Draws operators as often as [`Op::from_bytes`] does, and operators of meshes, which no bytes encode, as often as the most frequent
/// one. Unsupported operators are no longer drawn. Operators that never found anything to choose from, such as adding a vertex to a
/// missing unbounded face, are drawn seldom: they may become possible later.
fn generator_for(so_far: &ConformanceSummary) -> Generator {
    let most = OpKind::SHARES.iter().map(|(_, share)| *share).max().unwrap_or(1);
    let weight = |kind: OpKind, share| {
        let counts = so_far.of(kind.name()).unwrap_or_default();
        match (counts.is_supported(), counts.unsupported, counts.skipped) {
            (false, SURELY_UNSUPPORTED.., _) => 0,
            (false, 0, SKIPPED_OFTEN..) => 1,
            _ if share == 0 => most,
            _ => share,
        }
    };
    OpKind::SHARES.iter().fold(Program::generator(), |all, (kind, share)| all.weight(*kind, weight(*kind, *share)))
}
