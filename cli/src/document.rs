//! The JSON printed by the long commands and read by `twinedge sum`.

use crate::output::style::BAD;
use crate::output::{Format, part_line, print, print_json};
use crate::status::{Failure, Verdict};
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use std::time::Instant;
use twinedge_trials::Outcome;

/// A document printed by a long command.
pub(crate) trait Printed: Outcome + Serialize + DeserializeOwned {
    const COMMAND: &'static str;

    /// The entries specific to the command.
    type Extra: Default + Serialize + DeserializeOwned;

    fn text(&self, extra: &Self::Extra, seconds: f64) -> String;

    /// Returns true if the outcome has errors, even if the run was interrupted.
    fn is_wrong(&self) -> bool {
        !self.is_interrupted() && !self.is_ok()
    }
}

/// No further entries.
#[derive(Debug, Default, Serialize, Deserialize)]
pub(crate) struct Nothing {}

/// An outcome, with everything that identifies the work.
#[derive(Serialize, Deserialize)]
#[serde(bound = "")]
pub(crate) struct Document<O: Printed> {
    pub(crate) command: String,
    pub(crate) version: String,
    #[serde(flatten)]
    pub(crate) outcome: O,
    #[serde(flatten)]
    pub(crate) extra: O::Extra,
    ok: bool,
    pub(crate) elapsed_ms: f64,
}

impl<O: Printed> Document<O> {
    pub(crate) fn new(outcome: O, start: Instant) -> Self {
        Self::timed(outcome, start.elapsed().as_secs_f64() * 1000.0)
    }

    pub(crate) fn timed(outcome: O, elapsed_ms: f64) -> Self {
        Self {
            command: O::COMMAND.to_owned(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
            ok: outcome.is_ok(),
            outcome,
            extra: O::Extra::default(),
            elapsed_ms,
        }
    }

    pub(crate) fn text(&self) -> String {
        let interrupted = if self.outcome.is_interrupted() {
            format!("{BAD}interrupted{BAD:#}: this is what was covered\n\n")
        } else {
            String::new()
        };
        let text = self.outcome.text(&self.extra, self.elapsed_ms / 1000.0);
        interrupted + &part_line(self.outcome.shard()) + &text
    }

    pub(crate) fn print(&self, format: Format) -> Result<(), Failure> {
        match format {
            Format::Text => print(&self.text()),
            Format::Json => print_json(self),
        }
    }

    pub(crate) fn verdict(&self) -> Verdict {
        match (self.outcome.is_wrong(), self.outcome.is_interrupted()) {
            (true, _) => Verdict::Wrong,
            (false, true) => Verdict::Interrupted,
            (false, false) => Verdict::Sound,
        }
    }
}
