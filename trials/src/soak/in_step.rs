//! A program run on a structure in step with the reference.

use crate::progress::Progress;
use crate::structure::Structure;
use twinedge::program::conformance::{ConformanceSummary, InStep};
use twinedge::program::panics::catch;
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
    /// The structure agreed with the reference, up to the last operator.
    Finished,
    /// The run was stopped.
    Interrupted,
    /// The structure differs from the reference, or panicked.
    Failed {
        /// The number of operators before the failing one.
        before: usize,
        /// The failure, in one line.
        message: String,
    },
}

impl Comparison {
    /// Returns the failure, if the structure failed.
    #[must_use]
    pub fn failure(&self) -> Option<&str> {
        match &self.end {
            End::Failed { message, .. } => Some(message),
            End::Finished | End::Interrupted => None,
        }
    }
}

/// A structure of any type on which programs can be compared.
pub trait Comparable: Sync {
    /// Returns the name of the structure.
    fn name(&self) -> &'static str;

    /// Runs a program on the structure and on the reference, [`PointerModel`](twinedge::program::PointerModel), and compares them
    /// after each operator, like [`conformance::run`](twinedge::program::conformance::run). A panic is caught. Costs as there.
    fn compare(&self, program: &Program, progress: &dyn Progress) -> Comparison;

    /// Returns a regression test of this program, or the program as a Rust expression if the structure has no
    /// [`source`](Structure::source).
    fn to_rust(&self, message: &str, program: &Program) -> String;
}

impl<K: Subject> Comparable for Structure<K> {
    fn name(&self) -> &'static str {
        Self::name(self)
    }

    fn compare(&self, program: &Program, progress: &dyn Progress) -> Comparison {
        let failed = |summary, before, message| Comparison { summary, end: End::Failed { before, message } };
        let begun = catch(|| self.make()).map_err(|panic| format!("at the start: panicked: {panic}"));
        let begun =
            begun.and_then(|subject| InStep::new(subject, &self.expectation()).map_err(|failure| failure.to_string()));
        let mut pair = match begun {
            Ok(pair) => pair,
            Err(message) => return failed(ConformanceSummary::default(), 0, message),
        };
        for (before, op) in program.0.iter().enumerate() {
            if progress.is_stopped() {
                return Comparison { summary: pair.summary(), end: End::Interrupted };
            }
            if let Err(failure) = pair.step(*op) {
                return failed(pair.summary(), before, failure.to_string());
            }
        }
        Comparison { summary: pair.summary(), end: End::Finished }
    }

    fn to_rust(&self, message: &str, program: &Program) -> String {
        self.test_source().map_or_else(|| program.to_rust(), |source| source.test(message, program))
    }
}
