//! `twinedge sample`: random tables, valid and invalid.

use crate::document::{Document, Nothing, Printed};
use crate::effort::{Effort, seed_of_the_moment};
use crate::output::style::{BAD, GOOD};
use crate::output::{Format, counted, grouped};
use crate::print_tables::{Judge, Printer};
use crate::status::{Failure, Verdict};
use std::fmt;
use std::time::Instant;
use twinedge_trials::corrupt::RuleRow;
use twinedge_trials::sample::{SampleOutcome, SampleWork};
use twinedge_trials::{Outcome, sample};

/// Judge random tables, right or wrong, by the validator and by the reference.
///
/// The tables are of maps with up to 40 edges: of several components, nested, with vacant rows, in random order. They are
/// made by random programs, and from random rotation systems with random containment, which breaks V2, T1, T2 and T3 as well.
/// Most of them are then damaged, mostly such that the counts stay the same: two cells, two records, two cycles or the lists of
/// two faces are exchanged. Validator and reference must find the same first broken rule, or none.
///
/// The output counts how often each rule was the first broken one. For T4 this is 0: it follows from the other rules.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge sample                         100,000 tables: seconds
  twinedge sample --tables 10000000 --seed 7
  twinedge sample --tables 1000 --seed 7 --print
  twinedge sample --seed 7 --shard 0/16 --format json > part-0.json

--print: one table on each line of standard output, as `twinedge audit` reads them, followed by `= ok` or `= R1`. The same seed \
prints the same tables, in the same order if there is one thread. The summary goes to standard error.

Exit status: 0 both agree on all tables; 1 otherwise; 2 misuse, or the run would take too long; 130 interrupted (Ctrl-C), after \
printing what was covered.")]
pub(crate) struct Sample {
    /// Number of tables.
    #[arg(long, value_name = "N", default_value_t = 100_000)]
    tables: u64,

    /// Seed of the tables. Default: the time of day; it is printed.
    #[arg(long, value_name = "X")]
    seed: Option<u64>,

    #[command(flatten)]
    judge: Judge,

    /// Print each table and the verdict of the validator; the summary goes to standard error.
    #[arg(long, conflicts_with = "format")]
    print: bool,

    #[command(flatten)]
    effort: Effort,

    /// Output format.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

impl Sample {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        self.effort.needs_seed(self.seed)?;
        let work = SampleWork { tables: self.tables, seed: self.seed.unwrap_or_else(seed_of_the_moment) };
        self.effort.refuse_too_much(work.estimate(), self.format)?;
        let run = self.effort.start()?;
        let start = Instant::now();
        if self.print {
            let printer = Printer::new(self.judge);
            let document = Document::new(sample(work, &printer, &run), start);
            printer.finish(&document.text())?;
            return Ok(document.verdict());
        }
        let document = Document::new(sample(work, self.judge.checker(), &run), start);
        document.print(self.format)?;
        Ok(document.verdict())
    }
}

impl Printed for SampleOutcome {
    const COMMAND: &'static str = "sample";
    type Extra = Nothing;

    fn text(&self, _: &Nothing, seconds: f64) -> String {
        Text(self, seconds).to_string()
    }
}

struct Text<'a>(&'a SampleOutcome, f64);

impl fmt::Display for Text<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(outcome, seconds) = self;
        let judged = counted(outcome.judged as usize, "table");
        writeln!(f, "{judged} judged, seed {}; {} right", outcome.work.seed, grouped(outcome.right))?;
        write!(f, "first broken rule, by the reference:")?;
        for RuleRow { rule, wrong } in &outcome.first_broken {
            write!(f, " {rule} {}", grouped(*wrong))?;
        }
        writeln!(f)?;
        for finding in &outcome.findings {
            writeln!(f, "\n{BAD}disagreement{BAD:#}: {finding}")?;
        }
        if outcome.interrupted {
            writeln!(f, "{BAD}not finished{BAD:#} ({seconds:.1} s)")
        } else if outcome.is_ok() {
            writeln!(f, "{GOOD}agreed{GOOD:#} ({seconds:.1} s)")
        } else {
            writeln!(
                f,
                "{BAD}not agreed{BAD:#}: {} ({seconds:.1} s)",
                counted(outcome.disagreements as usize, "disagreement")
            )
        }
    }
}
