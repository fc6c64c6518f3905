//! Random programs: the operators, their frequencies, and the length.

use super::choose::{Bytes, Choose};
use super::language::Language;
use super::shrink::{candidates_from, shrink_from};
use alloc::vec::Vec;
use core::ops::RangeInclusive;

/// Describes random programs for every engine: the operators, their weights, the length, and the start.
///
/// | engine | how |
/// | --- | --- |
/// | quickcheck | `generator.generate(g)` in your own `Arbitrary`, with [`candidates`](Self::candidates) to shrink; `Program` itself for any program |
/// | proptest | the generator is a `Strategy`, which shrinks |
/// | cargo-fuzz | `generator.decode(bytes)` |
/// | arbitrary | `generator.generate(u)` for an `Unstructured` |
/// | others | an implementation of [`Choose`] |
///
/// ```
/// use twinedge::program::choose::Bytes;
/// use twinedge::program::{Op, OpKind, Program};
///
/// // A mesh that only flips and splits: nine flips to a split, exactly 20 operators.
/// let generator = Program::generator()
///     .only(&[OpKind::FlipEdge, OpKind::SplitEdge])
///     .weight(OpKind::FlipEdge, 9)
///     .weight(OpKind::SplitEdge, 1)
///     .length(20..=20);
/// let noise: Vec<u8> = (0..400_u32).map(|i| (i.wrapping_mul(2_654_435_769) >> 24) as u8).collect();
/// let program = generator.generate(&mut Bytes::new(&noise));
/// assert_eq!(program.0.len(), 20);
/// let flips = program.0.iter().filter(|op| matches!(op, Op::FlipEdge { .. })).count();
/// assert!((14..20).contains(&flips));
/// ```
#[derive(Clone, Debug)]
pub struct Generator<P: Language = crate::program::Program> {
    weights: Vec<(P::Kind, u32)>,
    length: RangeInclusive<usize>,
    pub(in crate::program) start: P::Start,
}

impl<P: Language> Default for Generator<P> {
    /// All operators, weighted as in [`Language::KINDS`]; up to 50 per program.
    fn default() -> Self {
        Self { weights: P::KINDS.to_vec(), length: 0..=50, start: P::Start::default() }
    }
}

impl<P: Language> Generator<P> {
    /// Restricts programs to these operators. Weights stay; operators with weight 0, such as the operators of meshes by default, get
    /// weight 1.
    #[must_use]
    pub fn only(mut self, kinds: &[P::Kind]) -> Self {
        for (kind, weight) in &mut self.weights {
            *weight = if kinds.contains(kind) { (*weight).max(1) } else { 0 };
        }
        self
    }

    /// Sets the weight of an operator, relative to the others. Weight 0 excludes it.
    #[must_use]
    pub fn weight(mut self, kind: P::Kind, weight: u32) -> Self {
        for (_, of_kind) in self.weights.iter_mut().filter(|(other, _)| *other == kind) {
            *of_kind = weight;
        }
        self
    }

    /// Sets the number of operators of a program. An empty range stands for its start.
    #[must_use]
    pub const fn length(mut self, length: RangeInclusive<usize>) -> Self {
        self.length = length;
        self
    }

    /// Draws one operator; `None` if all weights are 0. O(kinds).
    pub fn op(&self, source: &mut impl Choose) -> Option<P::Op> {
        let total: usize = self.weights.iter().map(|(_, weight)| *weight as usize).fold(0, usize::saturating_add);
        let mut chosen = source.choose(total);
        let of_kind = |(_, weight): &&(P::Kind, u32)| {
            let is_it = chosen < *weight as usize;
            chosen = chosen.saturating_sub(*weight as usize);
            is_it
        };
        let (kind, _) = self.weights.iter().find(of_kind)?;
        Some(P::op(*kind, source))
    }

    /// Draws a program. Empty if all weights are 0. O(operators).
    ///
    /// Topological programs begin by adding a vertex, unless that operator has weight 0.
    pub fn generate(&self, source: &mut impl Choose) -> P {
        let more = self.length.end().saturating_sub(*self.length.start());
        let count = self.length.start() + source.choose(more.saturating_add(1));
        let drawn = core::iter::from_fn(|| self.op(source));
        P::from_ops(self.first().into_iter().chain(drawn).take(count).collect())
    }

    /// Decodes a program: the bytes alone determine the number of operators, regardless of [`length`](Self::length). Each choice takes
    /// as few bytes as it needs. The first operator is as in [`generate`](Self::generate). O(bytes).
    ///
    /// ```
    /// use twinedge::program::{OpKind, Program};
    ///
    /// let flips = Program::generator().only(&[OpKind::MeshFlipEdge]);
    /// assert_eq!(flips.decode(&[0, 0, 7, 0, 0, 2]).to_string(), "twinedge program 1\nmesh_flip_edge h7\nmesh_flip_edge h2\n");
    /// ```
    #[must_use]
    pub fn decode(&self, bytes: &[u8]) -> P {
        let mut source = Bytes::new(bytes);
        let drawn = core::iter::from_fn(|| if source.rest().is_empty() { None } else { self.op(&mut source) });
        // An operator takes no byte if it is the only kind and has no arguments.
        P::from_ops(self.first().into_iter().chain(drawn.take(bytes.len())).collect())
    }

    /// Shrinks a failing program, as [`shrink`](crate::program::shrink()) does, from the start of this generator.
    pub fn shrink(&self, program: &P, fails: impl FnMut(&P) -> bool) -> P {
        shrink_from(program, &self.start, fails)
    }

    /// Returns slightly smaller programs, as [`candidates`](crate::program::candidates) does, from the start of this generator.
    pub fn candidates(&self, program: &P) -> impl Iterator<Item = P> + use<P> {
        candidates_from(program, &self.start)
    }

    fn first(&self) -> Option<P::Op> {
        let is_drawn = |kind| self.weights.iter().any(|(other, weight)| *other == kind && *weight > 0);
        P::first().and_then(|(kind, op)| is_drawn(kind).then_some(op))
    }
}

#[cfg(feature = "proptest")]
pub use with_proptest::ProgramTree;

#[cfg(feature = "proptest")]
mod with_proptest {
    use super::{Generator, Language, candidates_from};
    use alloc::boxed::Box;
    use core::fmt;
    use proptest::strategy::{NewTree, Strategy, ValueTree};
    use proptest::test_runner::TestRunner;

    /// A program with its shrinking candidates, those from [`Generator::candidates`]. Operators are dropped and simplified, and the
    /// rest keep their choices.
    pub struct ProgramTree<P: Language> {
        start: P::Start,
        current: P,
        /// The smallest known failing program.
        failing: P,
        smaller: Option<Box<dyn Iterator<Item = P>>>,
    }

    impl<P: Language> fmt::Debug for ProgramTree<P> {
        fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            let Self { current, failing, .. } = self;
            f.debug_struct("ProgramTree").field("current", current).field("failing", failing).finish_non_exhaustive()
        }
    }

    impl<P: Language> ProgramTree<P> {
        /// Creates the tree of an existing program that begins with the start of the generator.
        pub fn new(program: P, generator: &Generator<P>) -> Self {
            Self { start: generator.start.clone(), current: program.clone(), failing: program, smaller: None }
        }

        /// Advances to the next smaller program; returns to the smallest failing one if there is none.
        fn advance(&mut self) -> bool {
            let next = self.smaller.as_mut().and_then(|smaller| smaller.next());
            let advanced = next.is_some();
            self.current = next.unwrap_or_else(|| self.failing.clone());
            advanced
        }
    }

    impl<P: Language> ValueTree for ProgramTree<P> {
        type Value = P;

        fn current(&self) -> P {
            self.current.clone()
        }

        fn simplify(&mut self) -> bool {
            self.failing = self.current.clone();
            self.smaller = Some(Box::new(candidates_from(&self.failing, &self.start)));
            self.advance()
        }

        fn complicate(&mut self) -> bool {
            self.advance()
        }
    }

    impl<P: Language> Strategy for Generator<P> {
        type Tree = ProgramTree<P>;
        type Value = P;

        fn new_tree(&self, runner: &mut TestRunner) -> NewTree<Self> {
            Ok(ProgramTree::new(self.generate(runner), self))
        }
    }
}
