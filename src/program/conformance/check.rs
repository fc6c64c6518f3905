//! Runs one program, or many random ones, as the settings ask.

use super::difference::{Counterexample, Difference, Failure, Words};
use super::in_step::InStep;
use super::settings::{Conformance, Coverage};
use super::summary::{ConformanceSummary, OperatorCounts};
use super::words;
use crate::dcel::{Corner, Side};
use crate::program::language::choose::Random;
use crate::program::language::generator::Generator;
use crate::program::language::shrink::shrink_from;
use crate::program::operators::{FacePick, HalfEdgePick, InnerPick, Op, OpKind, Program, SecondPick, VertexPick};
use crate::program::panics::catch;
use crate::program::run::every::{every_mesh_op, every_op};
use crate::program::run::named::Start;
use crate::program::run::runner::Runner;
use crate::program::subject::Subject;
use alloc::boxed::Box;
use alloc::vec;
use alloc::vec::Vec;

impl Conformance {
    /// Begins a comparison, to be continued operator by operator.
    ///
    /// # Errors
    /// Those of [`run`](super::run) before the first operator.
    pub fn begin<K: Subject>(self, subject: K) -> Result<InStep<K>, Failure> {
        InStep::with(subject, self)
    }

    /// Runs a program, as [`run`](super::run) does.
    ///
    /// # Errors
    /// Those of [`run`](super::run).
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

    /// Runs a program, as [`run`](super::run) does, and makes it small if it fails: what a fuzz target is made of. `make` gives the
    /// structure with which it begins, each time the same.
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
    /// Those of [`check`](super::check).
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
            // Operators that random arguments seldom suit are tried with all. Those of meshes get a mesh to be tried on.
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

    /// Makes a program small that fails, and says what it does.
    fn smallest<K: Subject>(self, program: Program, failure: Failure, make: &mut impl FnMut() -> K) -> Counterexample {
        if failure.is_coverage() {
            return Counterexample::of(program, failure);
        }
        // A start that cannot be read costs no more than larger counterexamples.
        let start = catch(|| Start::of(&make(), &self.expectation)).ok().and_then(Result::ok).unwrap_or_default();
        let small = shrink_from(&program, &start, |program| self.compare(program, make()).is_err());
        // A subject that does something else each time fails as it did the first time.
        self.explain(small, make()).unwrap_or_else(|| Counterexample::of(program, failure))
    }

    /// Runs a program that fails, and notes what its operators choose.
    fn explain<K: Subject>(self, program: Program, subject: K) -> Option<Counterexample> {
        let mut pair = match self.begin(subject) {
            Err(failure) => return Some(Counterexample::of(program, failure)),
            Ok(pair) => pair,
        };
        let mut calls = Vec::new();
        let failure = program.0.iter().find_map(|op| {
            calls.push(words::call(pair.subject(), *op));
            pair.step(*op).err()
        })?;
        let places = words::places(pair.subject(), &failure.difference);
        Some(Counterexample { program, failure: Box::new(failure), words: Box::new(Words { places, calls }) })
    }

    /// Every argument of the operators that the subject has and that were not applied so far.
    fn rest<K: Subject>(pair: &InStep<K>, sum: &ConformanceSummary) -> Vec<Op> {
        let mut all = *sum;
        all.add(&pair.summary());
        let is_left = |op: &Op| all.of(op.name()).is_some_and(|counts| counts.is_supported() && counts.applied == 0);
        let mut ops = every_mesh_op(pair.subject());
        ops.extend(every_op(pair.subject()));
        ops.retain(is_left);
        ops
    }

    /// Compares and does not ask what was covered.
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

/// A triangle with a vertex inside, if an operator of meshes is among those that are left and the structure has a face to put it in: an
/// edge of a random map seldom has triangles on both sides.
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

/// So often an operator is drawn that finds nothing to choose from, before it becomes a rare one.
const SKIPPED_OFTEN: usize = 20;
/// So often an operator is drawn that the subject says it does not have, before it is drawn no more.
const SURELY_UNSUPPORTED: usize = 4;

/// Operators as often as in any bytes, and those of meshes, which are in no bytes, as often as the most frequent one. One that
/// the subject has only ever answered by not having it is drawn no more. One for which there was never anything to choose from,
/// such as adding a vertex to the unbounded face of a structure without it, is drawn seldom: there may be later.
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
