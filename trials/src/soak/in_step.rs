//! A program run on a structure in step with the reference.

use crate::panics::catch;
use crate::progress::Progress;
use crate::structure::Structure;
use twinedge::program::conformance::{ConformanceSummary, InStep};
use twinedge::program::{Program, Subject};

/// The outcome of a program that was run in step with the reference.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Comparison {
    /// The numbers of operators that were applied, refused and so on, up to the end.
    pub summary: ConformanceSummary,
    /// The end.
    pub end: End,
}

/// The end of a program.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum End {
    /// The structure did as the reference does, up to the last operator.
    Finished,
    /// The run was stopped.
    Interrupted,
    /// The structure differs from the reference, or panicked.
    Failed {
        /// The number of operators that were run before the one that did it.
        before: usize,
        /// The event, in one line.
        message: String,
    },
}

impl Comparison {
    /// The event, if the structure failed.
    #[must_use]
    pub fn failure(&self) -> Option<&str> {
        match &self.end {
            End::Failed { message, .. } => Some(message),
            End::Finished | End::Interrupted => None,
        }
    }
}

/// A structure of any type that programs can be compared on.
pub trait Comparable: Sync {
    /// The name of the structure.
    fn name(&self) -> &'static str;

    /// Runs a program on the structure and on the reference,
    /// [`PointerModel`](twinedge::program::PointerModel), and compares them after each operator, as
    /// [`conformance::run`](twinedge::program::conformance::run) does. A panic is caught. Costs what is said there.
    fn compare(&self, program: &Program, progress: &dyn Progress) -> Comparison;

    /// A regression test of this program, or the program as a Rust expression if the structure has no
    /// [`source`](Structure::source).
    fn to_rust(&self, message: &str, program: &Program) -> String;
}

impl<K: Subject> Comparable for Structure<K> {
    fn name(&self) -> &'static str {
        Self::name(self)
    }

    fn compare(&self, program: &Program, progress: &dyn Progress) -> Comparison {
        let failed = |summary, before, message| Comparison { summary, end: End::Failed { before, message } };
        let mut pair = match catch(|| InStep::new(self.make(), &self.expectation())) {
            Ok(Ok(pair)) => pair,
            Ok(Err(failure)) => return failed(ConformanceSummary::default(), 0, failure.to_string()),
            Err(panic) => return failed(ConformanceSummary::default(), 0, format!("at the start: panicked: {panic}")),
        };
        for (before, op) in program.0.iter().enumerate() {
            if progress.is_stopped() {
                return Comparison { summary: pair.summary(), end: End::Interrupted };
            }
            let message = match catch(|| pair.step(*op)) {
                Ok(Ok(_)) => continue,
                Ok(Err(failure)) => failure.to_string(),
                Err(panic) => format!("in operator {}, `{op}`: panicked: {panic}", before + 1),
            };
            return failed(pair.summary(), before, message);
        }
        Comparison { summary: pair.summary(), end: End::Finished }
    }

    fn to_rust(&self, message: &str, program: &Program) -> String {
        self.test_source().map_or_else(|| program.to_rust(), |source| source.test(message, program))
    }
}
