//! Programs for the crate `proptest`, which shrink operator by operator.

use super::generator::Generator;
use super::script::Language;
use super::shrink::candidates_from;
use alloc::boxed::Box;
use core::fmt;
use proptest::strategy::{NewTree, Strategy, ValueTree};
use proptest::test_runner::TestRunner;

/// A program, and the smaller ones that are tried when it fails: those of [`Generator::candidates`], by which [`Generator::shrink`]
/// goes, too. Operators are dropped and simplified, and the others go on choosing what they chose.
pub struct ProgramTree<P: Language> {
    start: P::Start,
    current: P,
    /// The smallest that is known to fail.
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
    /// The tree of a program that exists already, and begins as those of the generator do.
    pub fn new(program: P, generator: &Generator<P>) -> Self {
        Self { start: generator.start.clone(), current: program.clone(), failing: program, smaller: None }
    }

    /// On to the next smaller program; back to the smallest that fails if there is none.
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
