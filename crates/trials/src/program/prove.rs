//! `twinedge-trials prove`: all small maps, all operators, all arguments.

use crate::document::{IN_THIS_PART, Printed};
use crate::effort::Effort;
use crate::output::style::BAD;
use crate::output::{Failure, Verdict, beside, counted, table};
use crate::structures::{StructureName, Task};
use std::fmt;
use twinedge::dcel::Dcel;
use twinedge::validate::Expectation;
use twinedge_trials::meshes::{MeshStructure, MeshesResults, MeshesWork};
use twinedge_trials::prove::{Finding, ProveResults, ProveWork};
use twinedge_trials::replay::Indexed;
use twinedge_trials::{Outcome, Run, Structure, StructureError, meshes, prove};

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
/// Not checked here: effects of an operator beyond rules and counts, for example the direction in which an edge turns. `twinedge-trials soak` compares the structure with a reference.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge-trials prove                          maps of up to 5 edges: a few seconds
  twinedge-trials prove --edges 7                67,086 maps, 94 million operators: a minute
  twinedge-trials prove --edges 8                586,752 maps, a thousand million operators: ten minutes
  twinedge-trials prove --on pointers            on another structure
  twinedge-trials prove --meshes 5               triangulated discs of up to 5 vertices
  twinedge-trials prove --edges 9 --shard 0/16 --format json > part-0.json
  twinedge-trials prove --meshes 6 --shard 0/16 --format json > part-0.json
  twinedge-trials prove --edges 4 --format json | jq .ok

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
}

struct Proving<'a>(ProveWork, &'a Run<'a>);

impl Task for Proving<'_> {
    type Result = Result<Outcome<ProveResults>, StructureError>;

    fn run<K: Indexed + Clone>(self, structure: Structure<K>) -> Self::Result {
        prove(&structure, self.0, self.1)
    }
}

struct Trying<'a>(MeshesWork, &'a Run<'a>);

impl Task for Trying<'_> {
    type Result = Outcome<MeshesResults>;

    fn run<K: Indexed + Clone + 'static>(self, structure: Structure<K>) -> Self::Result {
        meshes(&MeshStructure::plane(structure), self.0, self.1)
    }
}

impl Prove {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        if let Some(vertices) = self.meshes {
            let work = MeshesWork { vertices: vertices.into() };
            return self.effort.perform(work.estimate(), |run| Ok(self.on.with(Trying(work, run))));
        }
        let work = ProveWork { edges: self.edges.into() };
        self.effort.perform(work.estimate(), |run| {
            Ok(match self.on {
                // Dispatching through pointers would take a sixth longer.
                StructureName::Slots => {
                    prove(&Structure::new(self.on.name(), Dcel::new, Expectation::plane()), work, run)
                }
                other => other.with(Proving(work, run)),
            }?)
        })
    }
}

impl Printed for ProveResults {
    const COMMAND: &'static str = "prove";

    fn describe(outcome: &Outcome<Self>, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (is_whole, is_complete) = (outcome.shard.is_whole(), outcome.is_complete());
        writeln!(f, "Structure: {}\n", outcome.on)?;
        writeln!(f, "Connected maps, grown from one vertex. A wrong count stands beside the published one.")?;
        f.write_str(&table(&outcome.edges, is_complete))?;
        writeln!(f, "\nAll subdivisions, nested ones included. A wrong count stands beside the recount.")?;
        let nested = outcome.nested.iter().filter(|row| row.recounted + row.maps > 0);
        f.write_str(&table(nested, is_complete))?;
        writeln!(f, "\nRooted maps by genus, from all permutations. A wrong count stands beside the published one.")?;
        for row in &outcome.genus {
            write!(f, "{:>5}", row.n)?;
            let genera = if is_whole { row.by_genus.len().max(row.published.len()) } else { row.labelled.len() };
            for genus in 0..genera {
                let count = |all: &[u64]| all.get(genus).copied().unwrap_or(0);
                let found = count(if is_whole { &row.by_genus } else { &row.labelled });
                let expected = if is_complete { count(&row.published) } else { found };
                write!(f, "   genus {genus}: {}", beside(found, expected))?;
                f.write_str(if is_whole { "" } else { " labelled" })?;
            }
            writeln!(f)?;
        }
        writeln!(f)?;
        for Finding { program, operator, message } in &outcome.findings {
            let operator = operator.as_ref().map(|operator| format!("{operator}: ")).unwrap_or_default();
            writeln!(f, "{BAD}{operator}{message}{BAD:#}, by\n{program}")?;
        }
        if !outcome.unsupported.is_empty() {
            let names = outcome.unsupported.join(", ");
            writeln!(f, "The structure refused as unsupported: {names}. Maps that need these operators are missing.")?;
        }
        Ok(())
    }

    fn verdict(outcome: &Outcome<Self>, is_ok: bool) -> (String, String) {
        let (verdict, rest) = match (is_ok, outcome.shard.is_whole()) {
            (true, true) => {
                let rest = ": all counts agree, and no operator broke a rule";
                return (format!("exhausted up to {}", counted(outcome.work.edges, "edge")), rest.to_owned());
            }
            (true, false) => ("no violation", IN_THIS_PART),
            (false, _) => ("wrong", ": a count differs or a rule is broken"),
        };
        (verdict.to_owned(), rest.to_owned())
    }
}

impl Printed for MeshesResults {
    const COMMAND: &'static str = "prove --meshes";

    fn describe(outcome: &Outcome<Self>, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "Structure: {}\n", outcome.on)?;
        writeln!(
            f,
            "Triangulated discs, by vertices on the border + inside. A wrong count stands beside the published one."
        )?;
        // Every part counts all triangulations.
        f.write_str(&table(&outcome.rows, true))?;
        writeln!(f)?;
        f.write_str(&table(&outcome.operators, true))?;
        writeln!(f)?;
        for finding in &outcome.findings {
            writeln!(f, "{BAD}{finding}{BAD:#}")?;
        }
        Ok(())
    }

    fn verdict(outcome: &Outcome<Self>, is_ok: bool) -> (String, String) {
        if is_ok {
            let rest = ": every operator does what its definition says";
            return (format!("exhausted up to {}", counted(outcome.work.vertices, "vertex")), rest.to_owned());
        }
        ("not as defined".to_owned(), ": a count or an operator differs, or nothing was applied".to_owned())
    }
}
