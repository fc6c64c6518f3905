//! `twinedge-trials sample`: random tables, valid and invalid.

use crate::document::Printed;
use crate::effort::Effort;
use crate::judge::Judge;
use crate::output::style::BAD;
use crate::output::{Failure, Verdict, counted, grouped};
use std::fmt;
use twinedge_trials::corrupt::RuleRow;
use twinedge_trials::sample::{SampleResults, SampleWork};
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
  twinedge-trials sample                         100,000 tables: seconds
  twinedge-trials sample --tables 10000000 --seed 7
  twinedge-trials sample --tables 1000 --seed 7 --print
  twinedge-trials sample --seed 7 --shard 0/16 --format json > part-0.json

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

    #[command(flatten)]
    effort: Effort,
}

impl Sample {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        let work = SampleWork { tables: self.tables, seed: self.effort.seed(self.seed)? };
        self.judge.perform(&self.effort, work.estimate(), |checker, run, _| Ok(sample(work, checker, run)))
    }
}

impl Printed for SampleResults {
    const COMMAND: &'static str = "sample";

    fn describe(outcome: &Outcome<Self>, f: &mut fmt::Formatter<'_>) -> fmt::Result {
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
        Ok(())
    }

    fn verdict(outcome: &Outcome<Self>, is_ok: bool) -> (String, String) {
        if is_ok {
            return ("agreed".to_owned(), String::new());
        }
        ("not agreed".to_owned(), format!(": {}", counted(outcome.disagreements as usize, "disagreement")))
    }
}
