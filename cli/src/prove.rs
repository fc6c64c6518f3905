//! `twinedge prove`: all small maps, all operators, all arguments.

use crate::document::{Document, Nothing, Printed};
use crate::effort::Effort;
use crate::output::style::{BAD, GOOD};
use crate::output::{Format, counted, grouped};
use crate::print_rows::table;
use crate::prove_meshes;
use crate::status::{Failure, Verdict};
use crate::structures::{StructureName, Task};
use std::fmt::{self, Write as _};
use std::time::Instant;
use twinedge::dcel::Dcel;
use twinedge::validate::Expectation;
use twinedge_trials::prove::{Finding, ProveOutcome, ProveWork};
use twinedge_trials::replay::Indexed;
use twinedge_trials::{Outcome, Run, Structure, StructureError, prove};

/// Grow every small planar map by the operators, and try every operator with every argument on each.
///
/// Connected maps grow from one vertex. They are distinguished by their canonical form and counted against published numbers of
/// maps: rooted (OEIS A000168), without root (A006384), and with one face distinguished as the outside (A103937).
///
/// After each operator that is applied, the validator checks every rule, the counts must have changed as the operator promises,
/// and the result must be one of the maps that were grown. After each operator that is refused, nothing may have changed. No
/// operator may panic.
///
/// Arguments: all half-edges, corners, faces and boundary components, including arguments that the operator must refuse, plus one stale
/// key of each kind.
///
/// Disconnected maps: up to min(N - 1, 4) edges, and two more vertices. Isolated vertices and nested components are included.
/// Their numbers are computed a second time without making a map, by Pólya's theorem.
///
/// Genus: every permutation of up to 10 half-edges is shown to the validator as a rotation system. Those accepted are counted by
/// genus (Walsh and Lehman). This part tests the validator, not the structure.
///
/// Not checked here: effects of an operator beyond rules and counts, for example the direction in which an edge turns. `twinedge soak` compares the structure with a reference.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge prove                          maps of up to 5 edges: a few seconds
  twinedge prove --edges 7                67,086 maps, 94 million operators: a minute
  twinedge prove --edges 8                586,752 maps, a thousand million operators: ten minutes
  twinedge prove --on pointers            on another structure
  twinedge prove --meshes 5               triangulated discs of up to 5 vertices
  twinedge prove --edges 9 --shard 0/16 --format json > part-0.json
  twinedge prove --meshes 6 --shard 0/16 --format json > part-0.json
  twinedge prove --edges 4 --format json | jq .ok

Exit status: 0 all counts are the published ones, no rule was broken and no operator differs; 1 otherwise; 2 misuse, or the run would take too long;
130 interrupted (Ctrl-C), after printing what was covered.")]
pub(crate) struct Prove {
    /// Greatest number of edges.
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u8).range(0..=16))]
    edges: u8,

    /// Try triangulated discs of up to N vertices instead, operators of meshes among the others, and compare each result with
    /// the definition by steps. Their numbers are compared with the published ones (Brown). Spheres are for structures of your own:
    /// all structures here are plane, and `meshes` of the crate `twinedge-trials` takes any.
    #[arg(long, value_name = "N", conflicts_with = "edges", value_parser = clap::value_parser!(u8).range(3..=9))]
    meshes: Option<u8>,

    /// The structure whose operators are tried.
    #[arg(long, value_enum, value_name = "STRUCTURE", default_value_t)]
    on: StructureName,

    #[command(flatten)]
    effort: Effort,

    /// Output format.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

struct Proving<'a>(ProveWork, &'a Run<'a>);

impl Task for Proving<'_> {
    type Result = Result<ProveOutcome, StructureError>;

    fn run<K: Indexed + Clone>(self, structure: Structure<K>) -> Self::Result {
        prove(&structure, self.0, self.1)
    }
}

impl Prove {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        if let Some(vertices) = self.meshes {
            return prove_meshes::run(vertices.into(), self.on, &self.effort, self.format);
        }
        let work = ProveWork { edges: self.edges.into() };
        self.effort.refuse_too_much(work.estimate(), self.format)?;
        let run = self.effort.start()?;
        let start = Instant::now();
        let outcome = match self.on {
            // Dispatching through pointers would take a sixth longer.
            StructureName::Slots => prove(&Structure::new(self.on.name(), Dcel::new, Expectation::plane()), work, &run),
            other => other.with(Proving(work, &run)),
        };
        let document = Document::new(outcome?, start);
        document.print(self.format)?;
        Ok(document.verdict())
    }
}

impl Printed for ProveOutcome {
    const COMMAND: &'static str = "prove";
    type Extra = Nothing;

    fn text(&self, _: &Nothing, seconds: f64) -> String {
        Text(self, seconds).to_string()
    }
}

struct Text<'a>(&'a ProveOutcome, f64);

impl Text<'_> {
    /// Returns true if everything was counted. Counts of a part of the work, or of interrupted work, differ from the published ones.
    const fn is_comparable(&self) -> bool {
        self.0.shard.is_whole() && !self.0.interrupted
    }

    /// Formats a count, with the published number if everything was counted and the two differ.
    fn beside(&self, found: u64, published: u64) -> String {
        if found == published || !self.is_comparable() {
            grouped(found)
        } else {
            format!("{BAD}{}≠{}{BAD:#}", grouped(found), grouped(published))
        }
    }
}

impl fmt::Display for Text<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(outcome, seconds) = self;
        writeln!(f, "Structure: {}\n", outcome.on)?;
        let is_whole = outcome.shard.is_whole();
        writeln!(f, "Connected maps, grown from one vertex. A wrong count stands beside the published one.")?;
        f.write_str(&table(&outcome.edges, self.is_comparable()))?;
        writeln!(f, "\nAll subdivisions, nested ones included. A wrong count stands beside the recount.")?;
        let nested = outcome.nested.iter().filter(|row| row.recounted + row.maps > 0);
        f.write_str(&table(nested, self.is_comparable()))?;
        writeln!(f, "\nRooted maps by genus, from all permutations. A wrong count stands beside the published one.")?;
        for row in &outcome.genus {
            let mut line = format!("{:>5}", row.n);
            if is_whole {
                for genus in 0..row.by_genus.len().max(row.published.len()) {
                    let count = |all: &[u64]| all.get(genus).copied().unwrap_or(0);
                    write!(line, "   genus {genus}: {}", self.beside(count(&row.by_genus), count(&row.published)))?;
                }
            } else {
                for (genus, labelled) in row.labelled.iter().enumerate() {
                    write!(line, "   genus {genus}: {} labelled", grouped(*labelled))?;
                }
            }
            writeln!(f, "{line}")?;
        }
        writeln!(f)?;
        for finding in &outcome.findings {
            let Finding { program, operator, message } = finding;
            let operator = operator.as_ref().map(|operator| format!("{operator}: ")).unwrap_or_default();
            writeln!(f, "{BAD}{operator}{message}{BAD:#}, by\n{program}")?;
        }
        if outcome.interrupted {
            return writeln!(f, "{BAD}not finished{BAD:#} ({seconds:.1} s)");
        }
        match (outcome.is_ok(), is_whole) {
            (true, true) => {
                writeln!(
                    f,
                    "{GOOD}exhausted up to {}{GOOD:#}: all counts agree, and no operator broke a rule ({seconds:.1} s)",
                    counted(outcome.work.edges, "edge")
                )?;
                writeln!(f, "`twinedge soak` checks whether operators do what they promise beyond rules and counts.")
            }
            (true, false) => {
                writeln!(
                    f,
                    "{GOOD}no violation{GOOD:#} in this part; `twinedge sum` compares the counts ({seconds:.1} s)"
                )
            }
            (false, _) => {
                if !outcome.unsupported.is_empty() {
                    let names = outcome.unsupported.join(", ");
                    writeln!(
                        f,
                        "The structure refused as unsupported: {names}. Maps that need these operators are missing."
                    )?;
                }
                writeln!(f, "{BAD}wrong{BAD:#}: a count differs or a rule is broken ({seconds:.1} s)")
            }
        }
    }
}
