//! `twinedge-trials corrupt`: all single corruptions of all small maps, and pairs of them.

use crate::document::Printed;
use crate::effort::Effort;
use crate::judge::Judge;
use crate::output::style::{BAD, QUIET};
use crate::output::{self, Failure, Verdict, counted, grouped, zero};
use crate::structures::{StructureName, Task};
use std::fmt;
use twinedge_trials::corrupt::{CorruptResults, CorruptWork, HUNG, RuleRow, Tally};
use twinedge_trials::replay::Indexed;
use twinedge_trials::{Checker, Outcome, Run, Structure, StructureError, corrupt};

/// Set every field of every small map to every value, and compare the validator with the reference.
///
/// The maps are all planar subdivisions of up to N edges and N + 1 vertices: of one component or several, nested, with isolated
/// vertices. Each is judged in two forms: with records for its boundary components, and as textbook tables without them.
///
/// The values are nil, every slot of the kind of record that the field leads to (one of them vacant), the slot past the end, and
/// the largest number. The reference validator, which is written straight from the rules, decides whether
/// a table is valid and which rule it breaks first; the fast validator must say the same.
///
/// Then follow corruptions that keep the counts. Two cells of a kind exchange their contents, and so do two whole records, two cycles and
/// the lists of two faces (with and without the links that lead there), twins, and the successors of half-edges. Two cycles become one boundary
/// component, outer ones become inner ones, a loop becomes a single half-edge that is its own twin, and a face lists an entry again.
///
/// Maps of up to two edges and two vertices are also judged in every form: as each of the 112 distinct expectations has them (plane
/// or surface, closed or open, with or without each part), and as three have them that ask for M1 ... M8. Each rule that an
/// expectation checks must be the first broken one there.
///
/// Then pairs of single corruptions follow: all of them on the maps of at most one edge and two vertices, and a sample of them on
/// all maps.
///
/// The output counts how often each rule was the first broken one. For T4 this is 0: it follows from the other rules.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge-trials corrupt                        maps of up to 2 edges: seconds
  twinedge-trials corrupt --edges 3 --pairs 1000000 --seed 7
  twinedge-trials corrupt --on pointers          the tables of another structure
  twinedge-trials corrupt --edges 3 --seed 7 --shard 0/16 --format json > part-0.json
  twinedge-trials corrupt --edges 1 --print      each table, with the verdict of the validator
  twinedge-trials corrupt --format json | jq '.fields[] | select(.missed > 0)'

--print: one table on each line of standard output, as `twinedge audit` reads them, followed by `= ok` or `= R1`. Comment lines \
(`# expect: …`) say what the tables below them are held to. The summary goes to standard error.

Exit status: 0 validator and reference always found the same rule broken first, or none, and no validation hung or panicked; \
1 otherwise; 2 misuse, or the run would take too long; 130 interrupted (Ctrl-C), after printing what was covered.")]
pub(crate) struct Corrupt {
    /// Greatest number of edges.
    #[arg(long, value_name = "N", default_value_t = 2, value_parser = clap::value_parser!(u8).range(0..=8))]
    edges: u8,

    /// Number of pairs of corruptions to sample.
    #[arg(long, value_name = "P", default_value_t = 100_000)]
    pairs: u32,

    /// Seed of the sample. Default: the time of day; it is printed.
    #[arg(long, value_name = "X")]
    seed: Option<u64>,

    /// The structure whose tables are corrupted.
    #[arg(long, value_enum, value_name = "STRUCTURE", default_value_t)]
    on: StructureName,

    #[command(flatten)]
    judge: Judge,

    #[command(flatten)]
    effort: Effort,
}

struct Corrupting<'a> {
    work: CorruptWork,
    checker: &'a dyn Checker,
    run: &'a Run<'a>,
    hangs: &'a (dyn Fn(&Outcome<CorruptResults>) + Sync),
}

impl Task for Corrupting<'_> {
    type Result = Result<Outcome<CorruptResults>, StructureError>;

    fn run<K: Indexed + Clone>(self, structure: Structure<K>) -> Self::Result {
        corrupt(&structure, self.work, self.checker, self.run, self.hangs)
    }
}

impl Corrupt {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        let seed = self.effort.seed(self.seed)?;
        let work = CorruptWork { edges: self.edges.into(), pairs: self.pairs, seed };
        self.judge.perform(&self.effort, work.estimate(), |checker, run, print| {
            let hangs = |outcome: &Outcome<CorruptResults>| {
                // The hanging thread cannot be stopped. Print the findings so far, if possible.
                let _ = print(outcome);
                std::process::exit(1);
            };
            Ok(self.on.with(Corrupting { work, checker, run, hangs: &hangs })?)
        })
    }
}

impl Printed for CorruptResults {
    const COMMAND: &'static str = "corrupt";

    fn describe(outcome: &Outcome<Self>, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "{} of {} judged, made by {}; wrong by the reference, caught by the validator",
            grouped(outcome.maps as u64),
            counted(outcome.maps_found, "map"),
            outcome.on
        )?;
        writeln!(f, "{QUIET}{:9} {:26}{QUIET:#} {}", "form", "field or exchange", output::head::<Tally>())?;
        let sampled = format!("pairs, seed {}", outcome.pairs.seed);
        let fields = outcome.fields.iter().map(|row| (row.form.name(), row.field.as_str(), &row.tally));
        let pairs = [("all pairs, smallest maps", &outcome.small_pairs), (&sampled, &outcome.pairs.tally)];
        for (form, field, tally) in fields.chain(pairs.map(|(field, tally)| ("all", field, tally))) {
            writeln!(f, "{form:9} {field:26} {}", output::line(tally, outcome.is_complete()))?;
        }
        write!(f, "\nfirst broken rule, by the reference:")?;
        for RuleRow { rule, wrong } in &outcome.first_broken {
            write!(f, " {rule} {}", grouped(*wrong))?;
        }
        if !outcome.expectations.is_empty() {
            let never = outcome.never_first_broken().count();
            let judged = outcome.expectations.iter().filter(|row| row.corruptions > 0).count();
            write!(f, "\nin every form: {}; rules never first broken: {never}", counted(judged, "expectation"))?;
        }
        writeln!(f, "\nhung (over {} s): {}   panics: {}", HUNG.as_secs(), zero(outcome.hung), zero(outcome.panics))?;
        if outcome.unusable > 0 {
            writeln!(f, "{BAD}not made by the structure{BAD:#}: {}", counted(outcome.unusable, "map"))?;
        }
        for finding in &outcome.findings {
            writeln!(f, "\n{BAD}finding{BAD:#}: {finding}")?;
        }
        Ok(())
    }

    fn verdict(_: &Outcome<Self>, is_ok: bool) -> (String, String) {
        if is_ok {
            let rest = ": everything wrong was caught, by the right rule, and there was no false alarm";
            return ("sound".to_owned(), rest.to_owned());
        }
        ("not sound".to_owned(), String::new())
    }
}
