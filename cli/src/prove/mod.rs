//! `twinedge prove`: all small maps, all operators, all arguments.

mod explore;
mod genus;
mod permutations;
mod recount;

use crate::counting;
use crate::output::style::{BAD, GOOD, QUIET};
use crate::output::{Format, grouped, print, print_json};
use crate::work::{self, Effort};
use crate::{Failure, Verdict};
use explore::{Explored, Tally};
use serde::Serialize;
use std::fmt::{self, Write as _};
use std::time::Instant;
use twinedge::program::census::Scope;

/// Grow every small planar map by the operators, and try every operator with every argument on each.
///
/// Connected maps are grown from one vertex, told apart by their canonical form, and counted against the published numbers of
/// maps: rooted (OEIS A000168), without root (A006384), and with one face distinguished as the outside (A103937), which is how
/// they are grown, for the operators know an outside. After each operator that is applied the validator checks every rule,
/// and the counts must have changed as the operator says; after each that is refused nothing may have changed; none may panic.
/// Arguments are all half-edges, corners, faces and boundary components, corners that do not fit among them, and of the handles
/// of what is gone the first half-edge, the first vertex and the first face.
///
/// That an operator does what it promises beyond the rules and the counts (that an edge turns the way it is told, that it
/// joins the corners it is told) is not checked here: `twinedge soak` compares with models.
///
/// Maps that are not connected, with isolated vertices and nested ones, get the same up to a smaller bound: up to N - 1 edges,
/// but no more than 4, and 2 vertices more than that. Their numbers are
/// counted a second time without making one map: what can lie in a face is a multiset of components, each with contents in
/// its bounded faces in turn, up to its symmetries; these come from all permutations of half-edges, and the rest is Pólya's
/// theorem.
///
/// Last, every permutation of up to 10 half-edges is shown to the validator as the rotation system of a map on whatever
/// surface, and those accepted are counted by genus (Walsh and Lehman).
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge prove                          maps of up to 5 edges: a few seconds
  twinedge prove --edges 7                67,086 maps, 94 million operators: a minute
  twinedge prove --edges 8                586,752 maps, a thousand million operators: ten minutes
  twinedge prove --edges 4 --format json | jq .ok

Exit status: 0 all counts are the published ones and no rule was broken; 1 something fell short; 2 misuse;
130 interrupted (Ctrl-C), after printing what was covered.")]
pub(crate) struct Prove {
    /// Up to how many edges.
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u8).range(0..=16))]
    edges: u8,

    #[command(flatten)]
    effort: Effort,

    /// For whom to print.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

/// A map on which something went wrong.
#[derive(Clone, Debug, Serialize)]
struct Finding {
    /// The text of the program that does it, for `twinedge replay`.
    program: String,
    /// Its last operator, if it is this one that goes wrong and not the map itself.
    operator: Option<String>,
    message: String,
}

#[derive(Debug, Serialize)]
struct Outcome {
    edges: Vec<EdgesRow>,
    genus: Vec<GenusRow>,
    nested: Vec<NestedRow>,
    findings: Vec<Finding>,
    interrupted: bool,
    ok: bool,
    elapsed_ms: f64,
}

#[derive(Debug, Serialize)]
struct EdgesRow {
    n: usize,
    rooted: u64,
    rooted_published: u64,
    sensed: u64,
    sensed_published: u64,
    plane: u64,
    plane_published: u64,
    applications: u64,
    refused: u64,
    violations: u64,
}

#[derive(Debug, Serialize)]
struct GenusRow {
    n: usize,
    by_genus: Vec<u64>,
    published: &'static [u64],
    refused: u64,
}

#[derive(Debug, Serialize)]
struct NestedRow {
    edges: usize,
    vertices: usize,
    maps: u64,
    recounted: u64,
    applications: u64,
    refused: u64,
    violations: u64,
}

/// Operators tried per second by one thread, about.
const PER_SECOND: u64 = 1_000_000;

impl Prove {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        let n = usize::from(self.edges);
        // The last edge makes nine tenths of the maps; each has 2n corners, so 4n² pairs of them, for `connect` on both sides
        // and for `split_vertex`, and as many wrong ones again.
        let maps: u128 = (0..=n).map(counting::plane).sum();
        self.effort.refuse_too_much(maps * 24 * (n * n) as u128, "operators to try", PER_SECOND, self.format)?;
        work::stop_on_interrupt()?;
        let start = Instant::now();
        let threads = self.effort.threads();
        let connected = explore::explore(Scope::Connected { edges: n }, threads, "connected maps");
        // There are many more of them for so many edges.
        let edges = n.saturating_sub(1).min(4);
        let vertices = edges + 2;
        let subdivisions = explore::explore(Scope::Subdivisions { edges, vertices }, threads, "all subdivisions");
        let mut outcome = Outcome {
            edges: (0..=n).map(|n| edges_row(n, &connected)).collect(),
            genus: genus_rows(n, threads),
            nested: nested_rows(edges, vertices, &subdivisions),
            findings: connected.findings.into_iter().chain(subdivisions.findings).collect(),
            interrupted: work::stopped(),
            ok: false,
            elapsed_ms: start.elapsed().as_secs_f64() * 1000.0,
        };
        outcome.ok = !outcome.interrupted && outcome.holds();
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

/// All maps with so many edges together.
fn edges_row(n: usize, explored: &Explored) -> EdgesRow {
    let mut sum = Tally::default();
    explored.tallies.iter().filter(|((edges, _), _)| *edges == n).for_each(|(_, tally)| sum.add(tally));
    let narrow = |published: u128| u64::try_from(published).unwrap_or(u64::MAX);
    EdgesRow {
        n,
        rooted: sum.rooted,
        rooted_published: narrow(counting::rooted(n)),
        sensed: sum.sensed,
        sensed_published: narrow(counting::sensed(n)),
        plane: sum.maps,
        plane_published: narrow(counting::plane(n)),
        applications: sum.applied,
        refused: sum.refused,
        violations: sum.violations,
    }
}

fn genus_rows(n: usize, threads: usize) -> Vec<GenusRow> {
    let mut rows = Vec::new();
    for (n, published) in counting::BY_GENUS.iter().enumerate().take(n.min(genus::MOST_EDGES) + 1) {
        let (by_genus, refused) = genus::histogram(n, threads);
        if work::stopped() {
            break;
        }
        rows.push(GenusRow { n, by_genus, published, refused });
    }
    rows
}

fn nested_rows(edges: usize, vertices: usize, explored: &Explored) -> Vec<NestedRow> {
    let none = Tally::default();
    let recounted = recount::subdivisions(edges, vertices);
    let row = |((edges, vertices), recounted)| {
        let tally = explored.tallies.get(&(edges, vertices)).unwrap_or(&none);
        NestedRow {
            edges,
            vertices,
            maps: tally.maps,
            recounted,
            applications: tally.applied,
            refused: tally.refused,
            violations: tally.violations,
        }
    };
    recounted.into_iter().map(row).collect()
}

impl EdgesRow {
    const fn holds(&self) -> bool {
        self.rooted == self.rooted_published
            && self.sensed == self.sensed_published
            && self.plane == self.plane_published
            && self.violations == 0
    }
}

impl GenusRow {
    fn holds(&self) -> bool {
        self.by_genus == self.published && self.refused == 0
    }
}

impl NestedRow {
    const fn holds(&self) -> bool {
        self.maps == self.recounted && self.violations == 0
    }
}

impl Outcome {
    fn holds(&self) -> bool {
        self.edges.iter().all(EdgesRow::holds)
            && self.genus.iter().all(GenusRow::holds)
            && self.nested.iter().all(NestedRow::holds)
            && self.findings.is_empty()
    }
}

/// A number beside the one that it should be.
fn beside(found: u64, published: u64) -> String {
    if found == published { grouped(found) } else { format!("{BAD}{}≠{}{BAD:#}", grouped(found), grouped(published)) }
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.interrupted {
            writeln!(f, "{BAD}interrupted{BAD:#}: this is what was covered\n")?;
        }
        writeln!(f, "Connected maps, grown from one vertex; each count is the published one, or both stand there")?;
        let head = ["edges", "rooted", "without root", "with an outside", "applied", "refused", "violations"];
        writeln!(
            f,
            "{QUIET}{:>5} {:>12} {:>14} {:>16} {:>15} {:>15} {:>10}{QUIET:#}",
            head[0], head[1], head[2], head[3], head[4], head[5], head[6]
        )?;
        for row in &self.edges {
            writeln!(
                f,
                "{:>5} {:>12} {:>14} {:>16} {:>15} {:>15} {:>10}",
                row.n,
                beside(row.rooted, row.rooted_published),
                beside(row.sensed, row.sensed_published),
                beside(row.plane, row.plane_published),
                grouped(row.applications),
                grouped(row.refused),
                beside(row.violations, 0),
            )?;
        }
        writeln!(
            f,
            "\nAll subdivisions, nested ones included; each count is that of the recount, or both stand there"
        )?;
        writeln!(
            f,
            "{QUIET}{:>5} {:>8} {:>12} {:>15} {:>15} {:>10}{QUIET:#}",
            "edges", "vertices", "maps", "applied", "refused", "violations"
        )?;
        for row in self.nested.iter().filter(|row| row.recounted + row.maps > 0) {
            writeln!(
                f,
                "{:>5} {:>8} {:>12} {:>15} {:>15} {:>10}",
                row.edges,
                row.vertices,
                beside(row.maps, row.recounted),
                grouped(row.applications),
                grouped(row.refused),
                beside(row.violations, 0),
            )?;
        }
        writeln!(
            f,
            "\nRooted maps by genus, from all permutations; each count is the published one, or both stand there"
        )?;
        for row in &self.genus {
            let mut line = format!("{:>5}", row.n);
            for genus in 0..row.by_genus.len().max(row.published.len()) {
                let count = |all: &[u64]| all.get(genus).copied().unwrap_or(0);
                write!(line, "   genus {genus}: {}", beside(count(&row.by_genus), count(row.published)))?;
            }
            writeln!(f, "{line}")?;
        }
        writeln!(f)?;
        for finding in &self.findings {
            let Finding { program, operator, message } = finding;
            let operator = operator.as_ref().map(|operator| format!("{operator}: ")).unwrap_or_default();
            writeln!(f, "{BAD}{operator}{message}{BAD:#}, by\n{program}")?;
        }
        let seconds = self.elapsed_ms / 1000.0;
        if self.ok {
            writeln!(f, "{GOOD}proved{GOOD:#}: all counts agree, and no operator broke a rule ({seconds:.1} s)")?;
            writeln!(f, "Whether operators do what they promise beyond rules and counts is for `twinedge soak` to say.")
        } else if self.interrupted {
            writeln!(f, "{BAD}not finished{BAD:#} ({seconds:.1} s)")
        } else {
            writeln!(f, "{BAD}not proved{BAD:#}: something falls short ({seconds:.1} s)")
        }
    }
}
