//! A program run on a structure in step with the reference, as `soak` and `replay` do it.

use crate::caught::caught;
use crate::subjects::{Indexed, Task};
use crate::work;
use twinedge::program::Program;
use twinedge::program::conformance::{ConformanceSummary, InStep};
use twinedge::validate::Expectation;

/// Running a program in step with the reference, until told to stop.
pub(crate) struct Trial<'a>(pub(crate) &'a Program);

/// What came of it.
#[derive(Debug)]
pub(crate) struct Tried {
    /// What the operators came to, up to the end.
    pub(crate) summary: ConformanceSummary,
    pub(crate) end: End,
}

/// How a run ended.
#[derive(Debug)]
pub(crate) enum End {
    Finished,
    Interrupted,
    /// The structure differs from the reference, or panicked.
    Failed {
        /// How many operators were run before the one that did it.
        before: usize,
        message: String,
    },
}

impl Tried {
    /// Why the structure fails, if it does.
    pub(crate) fn failure(self) -> Option<String> {
        match self.end {
            End::Failed { message, .. } => Some(message),
            End::Finished | End::Interrupted => None,
        }
    }
}

impl Task for Trial<'_> {
    type Result = Tried;

    fn run<K: Indexed>(self, make: fn() -> K, expectation: Expectation) -> Tried {
        let failed = |summary, before, message| Tried { summary, end: End::Failed { before, message } };
        let mut pair = match caught(|| InStep::new(make(), &expectation)) {
            Ok(Ok(pair)) => pair,
            Ok(Err(failure)) => return failed(ConformanceSummary::default(), 0, failure.to_string()),
            Err(panic) => return failed(ConformanceSummary::default(), 0, format!("at the start: panicked: {panic}")),
        };
        for (before, op) in self.0.0.iter().enumerate() {
            if work::stopped() {
                return Tried { summary: pair.summary(), end: End::Interrupted };
            }
            let message = match caught(|| pair.step(*op)) {
                Ok(Ok(_)) => continue,
                Ok(Err(failure)) => failure.to_string(),
                Err(panic) => format!("in operator {}, `{op}`: panicked: {panic}", before + 1),
            };
            return failed(pair.summary(), before, message);
        }
        Tried { summary: pair.summary(), end: End::Finished }
    }
}
