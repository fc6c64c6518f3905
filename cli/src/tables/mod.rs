//! `twinedge tables`: tables of a few records, right or wrong.

mod formulas;
mod jobs;

use crate::judgement::{in_words, judgement};
use crate::output::style::{BAD, GOOD, QUIET};
use crate::output::{Format, grouped, print, print_json};
use crate::work::{self, Effort};
use crate::{Failure, Verdict};
use jobs::{Job, Share, derive_origins, jobs};
use serde::Serialize;
use std::fmt;
use std::time::Instant;
use twinedge::validate::enumerate::for_each_assignment;
use twinedge::validate::reference::first_broken_rule;
use twinedge::validate::{Expectation, Table};

/// Judge tables of up to N half-edges, right or wrong, by the validator and by the reference.
///
/// Some fields are free: they are set to everything, in all combinations. Both must find the same first broken rule, or none;
/// and as many tables must be right as the formulas for maps on half-edges with names say. Which fields are free, and which
/// are given, goes by the size.
///
/// No half-edge: two isolated vertices in one face, all fields but leaving, nil included.
///
/// 2 half-edges on 2 vertices without faces: origin, twin, next, prev and leaving, nil included, and from N = 4 on dangling.
/// With faces, from N = 4 on: every field, leaving included, of two vertices and one face and of one vertex and two faces, as
/// in textbooks, and of two vertices, one boundary component and one face; the links between half-edges are live then. A loop
/// with two boundary components has its links given, and all else free.
///
/// 4 half-edges without faces and leaving: origin, twin and next on 2 vertices; twin and next; next and prev for every pairing
/// of twins; twin or nil, and next, where borders are open. Origin, twin, next, prev and leaving are not all free together.
/// In the last three, origins are what twin and next demand.
///
/// 6 half-edges and more: next, for every pairing of twins. Origins follow, and there is no prev, leaving or face.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge tables                         up to 4 half-edges: seconds
  twinedge tables --half-edges 6
  twinedge tables --half-edges 8 --force  an hour or more

Exit status: 0 both agree on all these tables, and the counts are those of the formulas; 1 not so; 2 misuse;
130 interrupted (Ctrl-C), after printing what was covered.")]
pub(crate) struct Tables {
    /// Up to how many half-edges.
    #[arg(long, value_name = "N", default_value_t = 4, value_parser = clap::value_parser!(u8).range(0..=10))]
    half_edges: u8,

    #[command(flatten)]
    effort: Effort,

    /// For whom to print.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

#[derive(Debug, Serialize)]
struct Outcome {
    tables: Vec<Row>,
    findings: Vec<String>,
    interrupted: bool,
    ok: bool,
    elapsed_ms: f64,
}

#[derive(Debug, Serialize)]
struct Row {
    half_edges: usize,
    free: &'static str,
    judged: u64,
    right: u64,
    right_by_formula: u64,
    disagreements: u64,
    done: bool,
}

/// Tables judged per second by one thread, about.
const PER_SECOND: u64 = 500_000;

impl Tables {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        let n = u32::from(self.half_edges);
        // Nearly all of them are those of the last two jobs; beyond that, listing the shares would take memory.
        let amount = 5_000_000 + 2 * formulas::pairings(u128::from(n / 2)) * u128::from(n).pow(n);
        self.effort.refuse_too_much(amount, "tables", PER_SECOND, self.format)?;
        work::stop_on_interrupt()?;
        let start = Instant::now();
        let mut rows = Vec::new();
        let mut findings = Vec::new();
        for job in jobs(self.half_edges.into()) {
            let (row, found) = judge(&job, self.effort.threads());
            rows.push(row);
            findings.extend(found);
            if work::stopped() {
                break;
            }
        }
        findings.truncate(10);
        let interrupted = work::stopped();
        let outcome = Outcome {
            ok: !interrupted && rows.iter().all(Row::holds),
            tables: rows,
            findings,
            interrupted,
            elapsed_ms: start.elapsed().as_secs_f64() * 1000.0,
        };
        match self.format {
            Format::Text => print(&outcome.to_string())?,
            Format::Json => print_json(&outcome)?,
        }
        Ok(match (outcome.interrupted, outcome.ok) {
            (true, _) => Verdict::Interrupted,
            (false, true) => Verdict::Sound,
            (false, false) => Verdict::Wrong,
        })
    }
}

/// What one thread found.
#[derive(Debug, Default)]
struct Judged {
    tables: u64,
    right: u64,
    disagreements: u64,
    finding: Option<String>,
}

fn judge(job: &Job, threads: usize) -> (Row, Option<String>) {
    let shares: Vec<Share> = job.shares.iter().flat_map(Share::split).collect();
    let bar = work::bar(shares.len(), format!("{} half-edges: {}", job.half_edges, job.name));
    let found = work::share(threads, shares.len(), &bar, Judged::default, |judged, number| {
        let share = &shares[number];
        for_each_assignment(&mut share.table.clone(), &share.cells, |table| {
            if work::stopped() {
                return;
            }
            if job.derive_origins {
                let mut table = table.clone();
                derive_origins(&mut table);
                judged.compare(&table, job.expectation);
            } else {
                judged.compare(table, job.expectation);
            }
        });
    });
    let sum = |count: fn(&Judged) -> u64| found.iter().map(count).sum();
    let row = Row {
        half_edges: job.half_edges,
        free: job.name,
        judged: sum(|judged| judged.tables),
        right: sum(|judged| judged.right),
        right_by_formula: u64::try_from(job.right).unwrap_or(u64::MAX),
        disagreements: sum(|judged| judged.disagreements),
        done: job.shares.iter().map(Share::len).sum::<u128>() == u128::from(sum(|judged| judged.tables)),
    };
    (row, found.into_iter().find_map(|judged| judged.finding))
}

impl Judged {
    fn compare(&mut self, table: &Table, expectation: Expectation) {
        let (valid, fast) = judgement(table, expectation);
        let slow = first_broken_rule(table, &expectation);
        self.tables += 1;
        self.right += u64::from(valid);
        if fast != slow || valid != slow.is_none() {
            self.disagreements += 1;
            self.finding.get_or_insert_with(|| {
                format!("{} to the validator, {} to the reference:\n{table:#?}", in_words(fast), in_words(slow))
            });
        }
    }
}

impl Row {
    const fn holds(&self) -> bool {
        self.done && self.right == self.right_by_formula && self.disagreements == 0
    }
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.interrupted {
            writeln!(f, "{BAD}interrupted{BAD:#}: this is what was covered\n")?;
        }
        writeln!(
            f,
            "{QUIET}{:>10}  {:52} {:>13} {:>9} {:>10} {:>13}{QUIET:#}",
            "half-edges", "free", "tables", "right", "formula", "disagreements"
        )?;
        for row in &self.tables {
            let style = if row.holds() { anstyle::Style::new() } else { BAD };
            writeln!(
                f,
                "{:>10}  {:52} {:>13} {style}{:>9} {:>10} {:>13}{style:#}",
                row.half_edges,
                row.free,
                grouped(row.judged),
                grouped(row.right),
                grouped(row.right_by_formula),
                grouped(row.disagreements)
            )?;
        }
        for finding in &self.findings {
            writeln!(f, "\n{BAD}disagreement{BAD:#}: {finding}")?;
        }
        let seconds = self.elapsed_ms / 1000.0;
        if self.ok {
            let judged = grouped(self.tables.iter().map(|row| row.judged).sum::<u64>());
            writeln!(
                f,
                "\n{GOOD}agreed{GOOD:#}: on these {judged} tables, and the counts are those of the formulas ({seconds:.1} s)"
            )
        } else if self.interrupted {
            writeln!(f, "\n{BAD}not finished{BAD:#} ({seconds:.1} s)")
        } else {
            writeln!(f, "\n{BAD}not agreed{BAD:#} ({seconds:.1} s)")
        }
    }
}
