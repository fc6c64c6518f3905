//! All small maps, all operators, all arguments.
//!
//! Maps are grown from the smallest one by the operators, told apart by their canonical form, and counted against published
//! numbers. On each of them every operator is tried with every argument: all half-edges, corners, faces and boundary components,
//! including corners that do not fit, plus one stale handle of each kind.
//!
//! Three things are counted:
//!
//! - **Connected maps** with up to N edges: rooted (OEIS A000168), without root (A006384), and with one face distinguished as the
//!   outside (A103937).
//! - **All subdivisions** with up to min(N − 1, 4) edges and two more vertices, including nested ones. Their numbers are also
//!   counted without making any map: see `recount.rs`.
//! - **Rooted maps by genus**: every permutation of up to 10 half-edges is given to the validator as a rotation system (Walsh and
//!   Lehman, *Counting rooted maps by genus*, 1972).
//!
//! After each applied operator, the validator checks every rule, the counts must have changed as the operator promises, and the
//! result must be one of the grown maps. After each refused one, the structure must be unchanged.
//!
//! The effect of an operator beyond rules and counts (for example the direction in which an edge turns) is not checked here:
//! [`soak()`](crate::soak()) compares with a reference.

mod explore;
mod genus;
mod grow;
mod outcome;
mod recount;

pub use outcome::{EdgesRow, Finding, GenusRow, NestedRow, ProveResults, ProveWork};

use crate::census::Scope;
use crate::outcome::Outcome;
use crate::published;
use crate::rows::narrow;
use crate::run::Run;
use crate::structure::{Structure, StructureError};
use explore::explore;
use grow::{Exploration, Tally};
use std::collections::BTreeSet;
use twinedge::program::Subject;

/// Grows every small map of a structure and tries every operator with every argument on each.
///
/// A panic of the structure is caught and reported; meanwhile the process has a silent panic hook. Time and memory grow about
/// ninefold with each edge; see [`ProveWork::estimate`]. All parts grow the same maps, in about a tenth of the time.
///
/// # Errors
/// [`StructureError::Lacks`], if maps cannot be told apart; [`StructureError::InvalidStart`], if the empty map breaks a rule.
///
/// # Incomplete structures
/// Maps are grown by `add_isolated_vertex`, `connect` and `split_vertex`. If one of them answers
/// [`Refusal::Unsupported`](twinedge::program::Refusal::Unsupported), maps are missing, and the counts show it. `soak` and
/// [`conformance`](twinedge::program::conformance) skip operators that the structure does not have.
///
/// # Examples
/// ```
/// use twinedge::dcel::Dcel;
/// use twinedge::validate::Expectation;
/// use twinedge_trials::prove::ProveWork;
/// use twinedge_trials::{Run, Structure, prove};
/// let mine = Structure::new("mine", Dcel::new, Expectation::plane());
/// let proof = prove(&mine, ProveWork { edges: 2 }, &Run::default())?.into_result()?;
/// // Tutte, *A census of planar maps*, 1963.
/// assert_eq!(proof.edges.iter().map(|row| row.rooted).collect::<Vec<_>>(), [1, 2, 9]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn prove<K: Subject + Clone>(
    structure: &Structure<K>,
    work: ProveWork,
    run: &Run<'_>,
) -> Result<Outcome<ProveResults>, StructureError> {
    structure.can_be_told_apart()?;
    structure.starts_valid()?;
    let n = work.edges;
    let connected = explore(structure, Scope::Connected { edges: n }, run, "connected maps");
    let (edges, vertices) = work.nested();
    let subdivisions = explore(structure, Scope::Subdivisions { edges, vertices }, run, "all subdivisions");
    let results = ProveResults {
        on: structure.name().to_owned(),
        edges: (0..=n).map(|n| edges_row(n, &connected)).collect(),
        genus: genus_rows(n, run),
        nested: nested_rows(edges, vertices, &subdivisions),
        unsupported: unsupported(&[&connected, &subdivisions]),
        findings: connected.findings.into_iter().chain(subdivisions.findings).collect(),
    };
    Ok(Outcome::new(work, run, results))
}

/// Returns the names of the operators that were refused as unsupported, each once, in alphabetical order.
fn unsupported(explored: &[&Exploration]) -> Vec<String> {
    let names: BTreeSet<&str> = explored.iter().flat_map(|explored| explored.unsupported.iter().copied()).collect();
    names.into_iter().map(str::to_owned).collect()
}

fn edges_row(n: usize, explored: &Exploration) -> EdgesRow {
    let mut sum = Tally::default();
    explored.tallies.iter().filter(|((edges, _), _)| *edges == n).for_each(|(_, tally)| sum.add(tally));
    EdgesRow {
        n,
        rooted: sum.rooted,
        rooted_published: narrow(published::rooted(n)),
        sensed: sum.sensed,
        sensed_published: narrow(published::sensed(n)),
        plane: sum.maps,
        plane_published: narrow(published::plane(n)),
        applications: sum.applied,
        refused: sum.refused,
        violations: sum.violations,
    }
}

fn genus_rows(n: usize, run: &Run<'_>) -> Vec<GenusRow> {
    let mut rows = Vec::new();
    for (n, published) in published::BY_GENUS.iter().enumerate().take(n.min(genus::MOST_EDGES) + 1) {
        let (labelled, refused) = genus::labelled(n, run);
        if run.is_stopped() {
            break;
        }
        let by_genus = genus::rooted(n, &labelled);
        rows.push(GenusRow { n, by_genus, published: published.to_vec(), refused, labelled });
    }
    rows
}

fn nested_rows(edges: usize, vertices: usize, explored: &Exploration) -> Vec<NestedRow> {
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
