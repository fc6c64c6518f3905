//! `twinedge tables`: all tables of a few records, valid and invalid.

use crate::document::{Document, Nothing, Printed};
use crate::effort::Effort;
use crate::output::style::{BAD, GOOD};
use crate::output::{Format, counted};
use crate::print_rows::table;
use crate::print_tables::{Judge, Printer};
use crate::status::{Failure, Verdict};
use crate::tables_lazy::Size;
use std::fmt;
use std::time::Instant;
use twinedge_trials::tables::{TablesOutcome, TablesWork};
use twinedge_trials::{Outcome, tables};

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
  twinedge tables                         up to 4 half-edges: seconds
  twinedge tables --half-edges 6
  twinedge tables --half-edges 8 --force  an hour or more
  twinedge tables --half-edges 8 --shard 0/16 --format json > part-0.json
  twinedge tables --lazy --expect plane --parts prev,leaving --half-edges 4
  twinedge tables --lazy --expect 'surface asking simple sides 3' --vertices 3 --half-edges 6
  twinedge tables --lazy --parts places --half-edges 4 --boundaries 2 --faces 2 --vacant
  twinedge tables --lazy --certificates --expect plane --parts all --half-edges 2 --boundaries 1 --faces 1
  twinedge tables --half-edges 2 --print  each table, with the verdict of the validator

--print: one table on each line of standard output, as `twinedge audit` reads them, followed by `= ok` or `= R1`. Comment lines (`# expect: …`) say what the tables below them are held to. The summary goes to standard error.

Exit status: 0 all judges agree on all tables, and the counts are those of the formulas; 1 otherwise; 2 misuse, or the run would take too long; 130 interrupted (Ctrl-C), after printing what was covered.")]
pub(crate) struct Tables {
    /// Greatest number of half-edges; with --lazy the number of half-edges.
    #[arg(long, value_name = "N", default_value_t = 4, value_parser = clap::value_parser!(u8).range(0..=10))]
    half_edges: u8,

    #[command(flatten)]
    judge: Judge,

    /// Print each table and the verdict of the validator; the summary goes to standard error.
    #[arg(long, conflicts_with = "format")]
    print: bool,

    /// Go through all tables of one size, every field free, by runs that each stand for many.
    #[arg(long, conflicts_with_all = ["fast_path", "print"])]
    lazy: bool,

    #[command(flatten)]
    size: Size,

    #[command(flatten)]
    effort: Effort,

    /// Output format.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

impl Tables {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        if self.lazy {
            return self.size.run(self.half_edges, self.judge.is_by_certificates(), &self.effort, self.format);
        }
        let work = TablesWork { half_edges: self.half_edges.into() };
        self.effort.refuse_too_much(work.estimate(), self.format)?;
        let run = self.effort.start()?;
        let start = Instant::now();
        if self.print {
            let printer = Printer::new(self.judge);
            let document = Document::new(tables(work, &printer, &run), start);
            printer.finish(&document.text())?;
            return Ok(document.verdict());
        }
        let document = Document::new(tables(work, self.judge.checker(), &run), start);
        document.print(self.format)?;
        Ok(document.verdict())
    }
}

impl Printed for TablesOutcome {
    const COMMAND: &'static str = "tables";
    type Extra = Nothing;

    fn text(&self, _: &Nothing, seconds: f64) -> String {
        Text(self, seconds).to_string()
    }
}

struct Text<'a>(&'a TablesOutcome, f64);

impl fmt::Display for Text<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(outcome, seconds) = self;
        let is_whole = outcome.shard.is_whole();
        f.write_str(&table(&outcome.tables, is_whole))?;
        for finding in &outcome.findings {
            writeln!(f, "\n{BAD}disagreement{BAD:#}: {finding}")?;
        }
        let judged = counted(outcome.tables.iter().map(|row| row.judged).sum::<u64>() as usize, "table");
        if outcome.interrupted {
            return writeln!(f, "\n{BAD}not finished{BAD:#} ({seconds:.1} s)");
        }
        match (outcome.is_ok(), is_whole) {
            (true, true) => {
                writeln!(
                    f,
                    "\n{GOOD}agreed{GOOD:#}: on {judged}, and the counts are those of the formulas ({seconds:.1} s)"
                )
            }
            (true, false) => {
                writeln!(f, "\n{GOOD}agreed{GOOD:#}: on {judged}; `twinedge sum` compares the counts ({seconds:.1} s)")
            }
            (false, _) => writeln!(f, "\n{BAD}not agreed{BAD:#} ({seconds:.1} s)"),
        }
    }
}
