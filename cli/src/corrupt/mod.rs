//! `twinedge corrupt`: all single corruptions of all small maps, and pairs of them.

mod judge;
mod watch;

use crate::output::style::{BAD, GOOD, QUIET};
use crate::output::{Format, grouped, print, print_json};
use crate::random::seed_of_the_moment;
use crate::work::{self, Effort};
use crate::{Failure, Verdict};
use judge::{Corruption, Form, Judge, Judged, Specimen, Tally};
use serde::Serialize;
use std::fmt;
use std::time::Instant;
use twinedge::program::census::{Census, Scope};
use twinedge::validate::Rule;
use watch::{HUNG, Watch};

/// Set every field of every record of every small map to every other value, and compare the validator with the reference.
///
/// The maps are all planar subdivisions of up to N edges and N + 1 vertices: of one component or several, nested, with
/// isolated vertices. Each is taken in two forms, with records for its boundary components and as the textbook's tables.
/// The values are nil, every slot of the kind of record that the field leads to, among them one that is vacant because its
/// record was retired, the one past the end, and the largest number. What is wrong, and by which rule first, says the
/// reference validator, which is written straight from the rules; the fast one must say the same. Then come pairs of such
/// corruptions: all of them on the maps of one edge and two vertices at most, and a sample of them on all maps.
///
/// How often each rule was the first broken one is counted. T1 to T4 never are: T4 follows from the others, and to break T1, T2
/// or T3 and none of those before takes more than two fields. `twinedge tables` does that.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge corrupt                        maps of up to 2 edges: seconds
  twinedge corrupt --edges 3 --pairs 1000000 --seed 7
  twinedge corrupt --format json | jq '.fields[] | select(.missed > 0)'

Exit status: 0 both always found the same rule broken first, or none, and no validation hung or panicked; 1 not so; 2 misuse;
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
    /// Of which all single corruptions were judged.
    maps: usize,
    maps_found: usize,
    fields: Vec<FieldRow>,
    small_pairs: TallyRow,
    pairs: PairsRow,
    /// How often each rule was the first broken one, by the reference.
    first_broken: Vec<RuleRow>,
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
struct RuleRow {
    rule: &'static str,
    wrong: u64,
}

#[derive(Debug, Serialize)]
struct TallyRow {
    corruptions: u64,
    wrong: u64,
    caught: u64,
    missed: u64,
    false_alarms: u64,
    other_rule: u64,
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
            other_rule: tally.other_rule,
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
        self.effort.refuse_too_much(amount, "corruptions", PER_SECOND, self.format)?;
        work::stop_on_interrupt()?;
        let start = Instant::now();
        let seed = self.seed.unwrap_or_else(seed_of_the_moment);
        let maps = collect(n)?;
        let specimens: Vec<&Specimen> = maps.iter().flatten().collect();
        let threads = self.effort.threads();
        let watch = Watch::default();
        let outcome = |hangs| Outcome::new(maps.len(), seed, watch.judged(), hangs, start);
        let work = || {
            let judge = || Judge::new(&watch);
            let bar = work::bar(maps.len(), "corruptions");
            work::share(threads, maps.len(), &bar, judge, |judge, number| judge.corrupt(&maps[number]));
            let shares = self.pairs.div_ceil(SHARE);
            let bar = work::bar(shares as usize, "pairs of corruptions");
            work::share(threads, shares as usize, &bar, judge, |judge, share| {
                let count = SHARE.min(self.pairs - share as u32 * SHARE);
                judge.corrupt_pairs(&specimens, seed, share as u64, count);
            });
        };
        watch.during(work, |corruption| {
            // What was found is not lost, if only it can be printed.
            let _ = self.print(&outcome(Some(corruption)));
            std::process::exit(1);
        });
        let outcome = outcome(None);
        self.print(&outcome)?;
        Ok(match (outcome.interrupted, outcome.ok) {
            (true, _) => Verdict::Interrupted,
            (false, true) => Verdict::Sound,
            (false, false) => Verdict::Wrong,
        })
    }

    fn print(&self, outcome: &Outcome) -> Result<(), Failure> {
        match self.format {
            Format::Text => print(&outcome.to_string()),
            Format::Json => print_json(outcome),
        }
    }
}

/// All maps in both forms.
fn collect(edges: usize) -> Result<Vec<[Specimen; 2]>, Failure> {
    let spinner = work::spinner("maps");
    let census = Census::new(Scope::Subdivisions { edges, vertices: edges + 1 });
    let maps = census.take_while(|_| !work::stopped()).map(|found| {
        spinner.inc(1);
        Specimen::all(&found)
    });
    let maps: Option<Vec<_>> = maps.collect();
    spinner.finish_and_clear();
    maps.ok_or_else(|| Failure("not enough memory for the maps".to_owned()))
}

impl Outcome {
    fn new(found: usize, seed: u64, judged: Judged, hangs: Option<Corruption<'_>>, start: Instant) -> Self {
        let Judged { maps, fields, small_pairs, pairs, first_broken, mut findings } = judged;
        if let Some(corruption) = hangs {
            findings.insert(0, format!("the validator does not return: {corruption}"));
        }
        let all: Vec<&Tally> = fields.values().chain([&small_pairs, &pairs]).collect();
        let sum = |count: fn(&Tally) -> u64| all.iter().map(|tally| count(tally)).sum::<u64>();
        let interrupted = work::stopped();
        let sound = sum(Tally::disagreements) == 0 && hangs.is_none() && sum(|tally| tally.caught) > 0;
        let rules = Rule::ALL.iter().filter(|rule| !rule.is_geometric());
        let row = |rule: &Rule| RuleRow { rule: rule.id(), wrong: first_broken.get(rule).copied().unwrap_or(0) };
        Self {
            maps,
            maps_found: found,
            hung: sum(|tally| tally.hung) + u64::from(hangs.is_some()),
            panics: sum(|tally| tally.panics),
            findings,
            interrupted,
            ok: sound && !interrupted,
            small_pairs: (&small_pairs).into(),
            pairs: PairsRow { seed, tally: (&pairs).into() },
            first_broken: rules.map(row).collect(),
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
        "{form:9} {field:26} {:>13} {:>13} {:>13} {:>7} {:>7} {:>10} {:>9.0} µs",
        grouped(row.corruptions),
        grouped(row.wrong),
        grouped(row.caught),
        nought(row.missed),
        nought(row.false_alarms),
        nought(row.other_rule),
        row.slowest_us
    )
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.interrupted {
            writeln!(f, "{BAD}interrupted{BAD:#}: this is what was covered\n")?;
        }
        writeln!(
            f,
            "{} of {} maps judged, each in two forms; wrong by the reference, caught by the validator",
            grouped(self.maps),
            grouped(self.maps_found)
        )?;
        writeln!(
            f,
            "{QUIET}{:9} {:26} {:>13} {:>13} {:>13} {:>7} {:>7} {:>10} {:>12}{QUIET:#}",
            "form", "field", "corruptions", "wrong", "caught", "missed", "false", "other rule", "slowest"
        )?;
        for row in &self.fields {
            write_row(f, row.form.name(), row.field, &row.tally)?;
        }
        write_row(f, "both", "all pairs, smallest maps", &self.small_pairs)?;
        write_row(f, "both", &format!("pairs, seed {}", self.pairs.seed), &self.pairs.tally)?;
        write!(f, "\nfirst broken rule, by the reference:")?;
        for RuleRow { rule, wrong } in &self.first_broken {
            write!(f, " {rule} {}", grouped(*wrong))?;
        }
        writeln!(f, "\nhung (over {} s): {}   panics: {}", HUNG.as_secs(), nought(self.hung), nought(self.panics))?;
        for finding in &self.findings {
            writeln!(f, "\n{BAD}disagreement{BAD:#}: {finding}")?;
        }
        let seconds = self.elapsed_ms / 1000.0;
        if self.ok {
            writeln!(
                f,
                "{GOOD}sound{GOOD:#}: all that is wrong was caught, by the right rule, and nothing else ({seconds:.1} s)"
            )
        } else if self.interrupted {
            writeln!(f, "{BAD}not finished{BAD:#} ({seconds:.1} s)")
        } else {
            writeln!(f, "{BAD}not sound{BAD:#} ({seconds:.1} s)")
        }
    }
}
