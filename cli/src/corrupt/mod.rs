//! `twinedge corrupt`: all single corruptions of all small maps, and pairs of them.

mod judge;
mod watch;

use crate::output::style::{BAD, GOOD, QUIET};
use crate::output::{Format, grouped, print, print_json};
use crate::random::seed_of_the_moment;
use crate::work::{self, Effort};
use crate::{Failure, Verdict};
use judge::{Form, Judge, Judged, Specimen, Tally};
use serde::Serialize;
use std::collections::BTreeMap;
use std::fmt;
use std::time::Instant;
use twinedge::program::census::{Census, Scope};
use watch::{HUNG, Watch};

/// Set every field of every record of every small map to every other value, and compare the validator with the reference.
///
/// The maps are all planar subdivisions of up to N edges and N + 1 vertices: of one component or several, nested, with
/// isolated vertices. Each is taken in two forms, with records for its boundary components and as the textbook's tables.
/// The values are nil, every slot of the kind of record that the field leads to, among them one that is vacant because its
/// record was retired, the one past the end, and the largest number. What is wrong says the reference validator, which is
/// written straight from the rules; what is caught says the fast one. Then pairs of such corruptions are sampled.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge corrupt                        maps of up to 2 edges: seconds
  twinedge corrupt --edges 3 --pairs 1000000 --seed 7
  twinedge corrupt --format json | jq '.fields[] | select(.missed > 0)'

Exit status: 0 nothing was missed, no alarm was false, no validation hung or panicked; 1 one did; 2 misuse;
130 interrupted (Ctrl-C), after printing what was covered.")]
pub(crate) struct Corrupt {
    /// Up to how many edges.
    #[arg(long, value_name = "N", default_value_t = 2, value_parser = clap::value_parser!(u8).range(0..=8))]
    edges: u8,

    /// How many pairs of corruptions to sample.
    #[arg(long, value_name = "P", default_value_t = 100_000)]
    pairs: u32,

    /// The seed of the sample; without it, one that is printed.
    #[arg(long, value_name = "X")]
    seed: Option<u64>,

    #[command(flatten)]
    effort: Effort,

    /// For whom to print.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

#[derive(Debug, Serialize)]
struct Outcome {
    maps: usize,
    fields: Vec<FieldRow>,
    pairs: PairsRow,
    hung: u64,
    panics: u64,
    findings: Vec<String>,
    interrupted: bool,
    ok: bool,
    elapsed_ms: f64,
}

#[derive(Debug, Serialize)]
struct FieldRow {
    form: Form,
    field: &'static str,
    #[serde(flatten)]
    tally: TallyRow,
}

#[derive(Debug, Serialize)]
struct PairsRow {
    seed: u64,
    #[serde(flatten)]
    tally: TallyRow,
}

#[derive(Debug, Serialize)]
struct TallyRow {
    corruptions: u64,
    wrong: u64,
    caught: u64,
    missed: u64,
    false_alarms: u64,
    slowest_us: f64,
}

impl From<&Tally> for TallyRow {
    fn from(tally: &Tally) -> Self {
        Self {
            corruptions: tally.corruptions,
            wrong: tally.wrong,
            caught: tally.caught,
            missed: tally.missed,
            false_alarms: tally.false_alarms,
            slowest_us: tally.slowest.as_secs_f64() * 1e6,
        }
    }
}

/// Pairs in one share of the work.
const SHARE: u32 = 1000;

/// Corruptions judged per second by one thread, about.
const PER_SECOND: u64 = 300_000;

impl Corrupt {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        let n = usize::from(self.edges);
        // About as many maps as a third of 12ⁿ, each with so many corruptions in its two forms.
        let maps = 12_u128.pow(self.edges.into()).div_ceil(3) + 1;
        let amount = maps * (200 + 220 * (n * n) as u128) + u128::from(self.pairs);
        self.effort.refuse_too_much(amount, "corruptions", PER_SECOND)?;
        work::stop_on_interrupt()?;
        let start = Instant::now();
        let seed = self.seed.unwrap_or_else(seed_of_the_moment);
        let specimens = collect(n);
        let threads = self.effort.threads();
        let watch = Watch::new();
        let judged = watch.during(|| {
            let judge = || Judge::new(&watch);
            let bar = work::bar(specimens.len(), "corruptions");
            let single =
                work::share(threads, specimens.len(), &bar, judge, |judge, number| judge.corrupt(&specimens[number]));
            let shares = self.pairs.div_ceil(SHARE);
            let bar = work::bar(shares as usize, "pairs of corruptions");
            let pairs = work::share(threads, shares as usize, &bar, judge, |judge, share| {
                let count = SHARE.min(self.pairs - share as u32 * SHARE);
                judge.corrupt_pairs(&specimens, seed, share as u64, count);
            });
            single.into_iter().chain(pairs).map(Judge::into_judged).collect::<Vec<_>>()
        });
        let outcome = Outcome::new(specimens.len() / 2, seed, judged, start);
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

/// All maps in both forms.
fn collect(edges: usize) -> Vec<Specimen> {
    let bar = work::bar(0, "maps");
    let mut specimens = Vec::new();
    for found in Census::new(Scope::Subdivisions { edges, vertices: edges + 1 }).take_while(|_| !work::stopped()) {
        specimens.extend([Form::Records, Form::Textbook].iter().filter_map(|form| Specimen::new(&found, *form)));
        bar.inc(1);
    }
    bar.finish_and_clear();
    specimens
}

impl Outcome {
    fn new(maps: usize, seed: u64, judged: Vec<Judged>, start: Instant) -> Self {
        let mut fields: BTreeMap<(Form, &'static str), Tally> = BTreeMap::new();
        let mut pairs = Tally::default();
        let mut findings = Vec::new();
        for judged in judged {
            for (field, tally) in judged.fields {
                fields.entry(field).or_default().add(&tally);
            }
            pairs.add(&judged.pairs);
            findings.extend(judged.findings);
        }
        findings.truncate(Judged::MOST_FINDINGS);
        let all: Vec<&Tally> = fields.values().chain([&pairs]).collect();
        let sum = |count: fn(&Tally) -> u64| all.iter().map(|tally| count(tally)).sum::<u64>();
        let (hung, panics) = (sum(|tally| tally.hung), sum(|tally| tally.panics));
        let interrupted = work::stopped();
        let short = sum(|tally| tally.missed + tally.false_alarms) + hung + panics;
        Self {
            maps,
            hung,
            panics,
            findings,
            interrupted,
            ok: short == 0 && !interrupted && sum(|tally| tally.caught) > 0,
            pairs: PairsRow { seed, tally: (&pairs).into() },
            fields: fields
                .iter()
                .map(|((form, field), tally)| FieldRow { form: *form, field, tally: tally.into() })
                .collect(),
            elapsed_ms: start.elapsed().as_secs_f64() * 1000.0,
        }
    }
}

/// A number that should be nought.
fn nought(found: u64) -> String {
    if found == 0 { "0".to_owned() } else { format!("{BAD}{}{BAD:#}", grouped(found)) }
}

fn write_row(f: &mut fmt::Formatter<'_>, form: &str, field: &str, row: &TallyRow) -> fmt::Result {
    writeln!(
        f,
        "{form:9} {field:26} {:>13} {:>13} {:>13} {:>7} {:>7} {:>9.0} µs",
        grouped(row.corruptions),
        grouped(row.wrong),
        grouped(row.caught),
        nought(row.missed),
        nought(row.false_alarms),
        row.slowest_us
    )
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.interrupted {
            writeln!(f, "{BAD}interrupted{BAD:#}: this is what was covered\n")?;
        }
        writeln!(f, "{} maps, each in two forms; wrong by the reference, caught by the validator", grouped(self.maps))?;
        writeln!(
            f,
            "{QUIET}{:9} {:26} {:>13} {:>13} {:>13} {:>7} {:>7} {:>12}{QUIET:#}",
            "form", "field", "corruptions", "wrong", "caught", "missed", "false", "slowest"
        )?;
        for row in &self.fields {
            write_row(f, row.form.name(), row.field, &row.tally)?;
        }
        write_row(f, "both", &format!("pairs, seed {}", self.pairs.seed), &self.pairs.tally)?;
        writeln!(f, "\nhung (over {} s): {}   panics: {}", HUNG.as_secs(), nought(self.hung), nought(self.panics))?;
        for finding in &self.findings {
            writeln!(f, "\n{BAD}disagreement{BAD:#}: {finding}")?;
        }
        let seconds = self.elapsed_ms / 1000.0;
        if self.ok {
            writeln!(f, "{GOOD}sound{GOOD:#}: all that is wrong was caught, and nothing else ({seconds:.1} s)")
        } else if self.interrupted {
            writeln!(f, "{BAD}not finished{BAD:#} ({seconds:.1} s)")
        } else {
            writeln!(f, "{BAD}not sound{BAD:#} ({seconds:.1} s)")
        }
    }
}
