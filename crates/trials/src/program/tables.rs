//! `twinedge-trials tables`: all tables of a few records, valid and invalid.

use crate::document::{IN_THIS_PART, Printed};
use crate::effort::{BARS, Effort};
use crate::judge::Judge;
use crate::output::style::BAD;
use crate::output::{Failure, Verdict, counted, table};
use std::fmt;
use twinedge::validate::{Expectation, ParseExpectationError, Part, Parts};
use twinedge_trials::lazy::{LazyResults, LazyWork};
use twinedge_trials::tables::{TablesResults, TablesWork};
use twinedge_trials::{Outcome, Progress as _, Validator, lazy, tables};

/// Judge tables of up to N half-edges, right or wrong, by the validator and by the reference.
///
/// Some fields are free: they are set to everything, in all combinations. Validator and reference must find the same first broken
/// rule, or none, and the number of valid tables must match the formulas for maps on labelled half-edges. The free fields depend on
/// the size:
///
/// No half-edge: two isolated vertices in one face. All fields but leaving are free, nil included.
///
/// 2 half-edges on 2 vertices, no faces: origin, twin, next, prev and leaving, nil included; dangling links as well if N >= 4.
/// With faces, if N >= 4: every field, leaving included, of an edge and of a loop, as in textbooks, and of an edge with a record
/// for its boundary component; the links between half-edges are live. With one face and an open border: every field of a loop. Of a loop with two boundary components, the links between
/// half-edges are given, and all other fields are free.
///
/// 4 half-edges, no faces, no leaving: origin, twin and next on 2 vertices; twin and next; next and prev for every pairing of
/// twins; twin or nil, and next, with open borders, also for a square or a torus. Origin, twin, next, prev and leaving are not all free together. In the last
/// five, origins are what twin and next demand.
///
/// 6 half-edges and more: next, for every pairing of twins. Origins follow; there is no prev, leaving or face.
///
/// With --lazy every field of tables of one size is free, dangling links included. A run of the validator stands for all tables
/// that agree in the fields that it has read, and so does one of the reference. Each table that one of both accepts is judged by the other. The runs
/// stand for all tables, and the number of accepted tables is compared with a recount on closed surfaces and in the plane without holes, under
/// any expectation. The number of runs and the time are estimated first, from some thousand random runs, and printed on standard error;
/// estimates are usually within a factor of two. A mesh is described in words: `surface asking simple sides 3 genus 0`.
///
/// With --lazy --certificates the labels of certificates are free as well, and so are the lengths of their columns: ranks and positions from 0 to the number of half-edges less 1, or nil. A run stands for all that are in the same order. The reference goes through
/// all tables, and each accepted table must pass with the labels that are made for it. The checker goes through all tables with all labels, and the
/// reference judges the tables that pass. Both together go through them again, and must accept the same number. Where tables store no boundary components or faces, labels have up to --boundaries and --faces of them. Certificates
/// are of the plane, or of closed surfaces of a genus: `surface asking genus 1`.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge-trials tables                         up to 4 half-edges: seconds
  twinedge-trials tables --half-edges 6
  twinedge-trials tables --half-edges 8 --force  an hour or more
  twinedge-trials tables --half-edges 8 --shard 0/16 --format json > part-0.json
  twinedge-trials tables --lazy --expect plane --parts prev,leaving --half-edges 4
  twinedge-trials tables --lazy --expect 'surface asking simple sides 3' --vertices 3 --half-edges 6
  twinedge-trials tables --lazy --parts places --half-edges 4 --boundaries 2 --faces 2 --vacant
  twinedge-trials tables --lazy --certificates --expect plane --parts all --half-edges 2 --boundaries 1 --faces 1
  twinedge-trials tables --half-edges 2 --print  each table, with the verdict of the validator

--print: one table on each line of standard output, as `twinedge audit` reads them, followed by `= ok` or `= R1`. Comment lines (`# expect: …`) say what the tables below them are held to. The summary goes to standard error.

Exit status: 0 all judges agree on all tables, and the counts are those of the formulas; 1 otherwise; 2 misuse, or the run would take too long; 130 interrupted (Ctrl-C), after printing what was covered.")]
pub(crate) struct Tables {
    /// Greatest number of half-edges; with --lazy the number of half-edges.
    #[arg(long, value_name = "N", default_value_t = 4, value_parser = clap::value_parser!(u8).range(0..=10))]
    half_edges: u8,

    #[command(flatten)]
    judge: Judge,

    /// Go through all tables of one size, every field free, by runs that each stand for many.
    #[arg(long, conflicts_with_all = ["fast_path", "print"])]
    lazy: bool,

    #[command(flatten)]
    size: Size,

    #[command(flatten)]
    effort: Effort,
}

/// The tables that `--lazy` goes through.
#[derive(Clone, Copy, Debug, clap::Args)]
struct Size {
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

impl Tables {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        if self.lazy {
            return self.run_lazily();
        }
        let work = TablesWork { half_edges: self.half_edges.into() };
        self.judge.perform(&self.effort, work.estimate(), |checker, run, _| Ok(tables(work, checker, run)))
    }

    fn run_lazily(&self) -> Result<Verdict, Failure> {
        let Size { expect, parts, vertices, boundaries, faces, vacant } = self.size;
        let work = LazyWork {
            expectation: expect,
            parts,
            vertices: vertices.into(),
            half_edges: self.half_edges.into(),
            boundaries: boundaries.into(),
            faces: faces.into(),
            vacant,
            certificates: self.judge.certificates,
        };
        self.effort.run()?;
        BARS.begin("estimating", None);
        let estimate = work.estimate(&Validator);
        BARS.end();
        let estimate = estimate?;
        self.effort.perform(estimate, |run| {
            eprintln!("estimated: {}", self.effort.said(estimate));
            Ok(lazy(work, &Validator, run)?)
        })
    }
}

impl Printed for TablesResults {
    const COMMAND: &'static str = "tables";

    fn describe(outcome: &Outcome<Self>, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&table(&outcome.tables, outcome.is_complete()))?;
        for finding in &outcome.findings {
            writeln!(f, "\n{BAD}disagreement{BAD:#}: {finding}")?;
        }
        writeln!(f)
    }

    fn verdict(outcome: &Outcome<Self>, is_ok: bool) -> (String, String) {
        if !is_ok {
            return ("not agreed".to_owned(), String::new());
        }
        let judged = counted(outcome.tables.iter().map(|row| row.judged).sum::<u64>() as usize, "table");
        let rest = if outcome.shard.is_whole() { ", and the counts are those of the formulas" } else { IN_THIS_PART };
        ("agreed".to_owned(), format!(": on {judged}{rest}"))
    }
}

impl Printed for LazyResults {
    const COMMAND: &'static str = "tables --lazy";

    fn describe(outcome: &Outcome<Self>, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &outcome.with_labels {
            None => writeln!(f, "Tables: {}\n", outcome.tables)?,
            Some(all) => writeln!(f, "Tables: {}, with labels {all}\n", outcome.tables)?,
        }
        f.write_str(&table(&outcome.judges, outcome.is_complete()))?;
        for finding in &outcome.findings {
            writeln!(f, "\n{BAD}difference{BAD:#}: {finding}")?;
        }
        writeln!(f)
    }

    fn verdict(outcome: &Outcome<Self>, is_ok: bool) -> (String, String) {
        if !is_ok {
            return ("not agreed".to_owned(), String::new());
        }
        let rest = match (outcome.shard.is_whole(), &outcome.with_labels) {
            (false, _) => IN_THIS_PART,
            (true, Some(_)) => ": the tables that have labels that pass are those that the reference accepts",
            (true, None) => ": both accept the same tables of all",
        };
        ("agreed".to_owned(), rest.to_owned())
    }
}
