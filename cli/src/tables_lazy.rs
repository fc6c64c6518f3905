//! `twinedge tables --lazy`: all tables of a size, every cell free.

use crate::document::{Document, Nothing, Printed};
use crate::effort::Effort;
use crate::output::Format;
use crate::output::style::{BAD, GOOD};
use crate::print_rows::table;
use crate::progress::busy;
use crate::status::{Failure, Verdict};
use std::fmt;
use std::time::Instant;
use twinedge::validate::{Expectation, ParseExpectationError, Part, Parts};
use twinedge_trials::lazy::{LazyOutcome, LazyWork};
use twinedge_trials::{Outcome, Validator, lazy};

/// The tables that `--lazy` goes through.
#[derive(Debug, clap::Args)]
pub(crate) struct Size {
    /// With --lazy: the expectation of the tables, as in `surface open asking closed genus 0`.
    #[arg(long, value_name = "CLAIMS", default_value = "surface", requires = "lazy", value_parser = expectation)]
    expect: Expectation,

    /// With --lazy: the parts that the tables store, with commas: `prev`, `leaving`, `faces`, `boundary_components`, `places`, `holes`, `unbounded_face`; or
    /// none, or all. Each brings those on which it depends.
    #[arg(long, value_name = "PARTS", default_value = "none", requires = "lazy", value_parser = parts)]
    parts: Parts,

    /// With --lazy: the number of vertices.
    #[arg(long, value_name = "N", default_value_t = 2, requires = "lazy", value_parser = slots())]
    vertices: u8,

    /// With --lazy: the number of boundary components, where there are records for these. With --certificates also the most in labels.
    #[arg(long, value_name = "N", default_value_t = 0, requires = "lazy", value_parser = slots())]
    boundaries: u8,

    /// With --lazy: the number of faces, where there are faces. With --certificates also the most in labels.
    #[arg(long, value_name = "N", default_value_t = 0, requires = "lazy", value_parser = slots())]
    faces: u8,

    /// With --lazy: each slot can also be vacant.
    #[arg(long, requires = "lazy")]
    vacant: bool,
}

fn slots() -> clap::builder::RangedI64ValueParser<u8> {
    clap::value_parser!(u8).range(0..=10)
}

fn expectation(text: &str) -> Result<Expectation, ParseExpectationError> {
    text.parse()
}

fn parts(text: &str) -> Result<Parts, String> {
    match text {
        "none" => Ok(Parts::NONE),
        "all" => Ok(Parts::ALL),
        words => {
            words.split(',').map(|word| Part::from_word(word).ok_or_else(|| format!("`{word}` is no part"))).collect()
        }
    }
}

impl Size {
    pub(crate) fn run(
        &self,
        half_edges: u8,
        certificates: bool,
        effort: &Effort,
        format: Format,
    ) -> Result<Verdict, Failure> {
        let work = LazyWork {
            expectation: self.expect,
            parts: self.parts,
            vertices: self.vertices.into(),
            half_edges: half_edges.into(),
            boundaries: self.boundaries.into(),
            faces: self.faces.into(),
            vacant: self.vacant,
            certificates,
        };
        let run = effort.start()?;
        let estimate = busy(|stage| {
            stage("estimating");
            work.estimate(&Validator)
        })?;
        effort.refuse_too_much(estimate, format)?;
        effort.say(estimate);
        let start = Instant::now();
        let outcome = lazy(work, &Validator, &run)?;
        let document = Document::new(outcome, start);
        document.print(format)?;
        Ok(document.verdict())
    }
}

impl Printed for LazyOutcome {
    const COMMAND: &'static str = "tables --lazy";
    type Extra = Nothing;

    fn text(&self, _: &Nothing, seconds: f64) -> String {
        Text(self, seconds).to_string()
    }
}

struct Text<'a>(&'a LazyOutcome, f64);

impl fmt::Display for Text<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(outcome, seconds) = self;
        let is_whole = outcome.shard.is_whole();
        match &outcome.with_labels {
            None => writeln!(f, "Tables: {}\n", outcome.tables)?,
            Some(all) => writeln!(f, "Tables: {}, with labels {all}\n", outcome.tables)?,
        }
        f.write_str(&table(&outcome.judges, is_whole))?;
        for finding in &outcome.findings {
            writeln!(f, "\n{BAD}difference{BAD:#}: {finding}")?;
        }
        match (outcome.interrupted, outcome.is_ok(), is_whole) {
            (true, ..) => writeln!(f, "\n{BAD}not finished{BAD:#} ({seconds:.1} s)"),
            (_, true, true) => {
                let what = if outcome.with_labels.is_some() {
                    "the tables that have labels that pass are those that the reference accepts"
                } else {
                    "both accept the same tables of all"
                };
                writeln!(f, "\n{GOOD}agreed{GOOD:#}: {what} ({seconds:.1} s)")
            }
            (_, true, false) => {
                writeln!(f, "\n{GOOD}agreed{GOOD:#}: in this part; `twinedge sum` compares the counts ({seconds:.1} s)")
            }
            _ => writeln!(f, "\n{BAD}not agreed{BAD:#} ({seconds:.1} s)"),
        }
    }
}
