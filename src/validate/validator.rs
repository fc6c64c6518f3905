//! The validator: the fast path, or else the rules R1 … T4 in order; then the requested rules of M1 … M8.

use super::expectation::{Expectation, Surface};
use super::fast_path::{self, Accepted};
use super::findings::{Findings, Flow, Halt};
use super::half_edges::{Asked, HalfEdges, Lent};
use super::report::{Collect, Report, Unchecked};
use super::rule::Rule;
use super::rules::live::{self, Census};
use super::rules::{faces, links, mesh, whole};
use super::structure::{Part, View};
use super::subject::{Components, Extent, Subject};
use alloc::vec::Vec;

/// The rules about topology. On surfaces B2, T1, T2 and T4 are not checked. M1 … M8 are checked on request, and G1 … G5 by
/// `twinedge-map`.
const TOPOLOGICAL: &[Rule] = &[
    Rule::R1,
    Rule::L1,
    Rule::L2,
    Rule::L3,
    Rule::V1,
    Rule::V2,
    Rule::B1,
    Rule::B2,
    Rule::F1,
    Rule::F2,
    Rule::T1,
    Rule::T2,
    Rule::T3,
    Rule::T4,
];

/// Validates any half-edge structure: rules R1 … T4, and the requested rules of M1 … M8.
///
/// Cost: O(n) time (up to the inverse of Ackermann's function) and memory, where n is the number of slots of all kinds. It does not
/// panic unless the [`View`] does, and it always terminates. At most this number of bytes is in use at a time, not counting kept
/// violations:
///
/// | structure | per vertex | per component | per half-edge | per boundary component |
/// | --- | --- | --- | --- | --- |
/// | valid | 16 | 20 | 1/8 | 1/8 |
/// | invalid | 16 | 72 | 4 | 4 |
///
/// A valid structure without border takes only 8 per vertex if neighbours have close numbers and vertices store a half-edge. A border
/// loop takes 12. In an invalid structure a component takes 24 bytes in a list that doubles: 72 while the list is copied, at most 50
/// after that. Components are only counted where V2 finds them. M2 and M3 take 4 more per half-edge, 8 per vertex and 4 per face.
///
/// ```
/// use twinedge::validate::{Collect, Expectation, Rule, Table, validate};
/// // An edge between two vertices, of which the second says that half-edge 0 leaves it.
/// let table: Table = "V 2 0 - 0 - H 2 0 1 1 1 0 1 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0".parse()?;
/// let report = validate(&table, &Expectation::plane(), Collect::All);
/// assert!(!report.is_valid());
/// assert_eq!(report.first().unwrap().rule(), Rule::V1);
/// # Ok::<(), twinedge::validate::ParseTableError>(())
/// ```
pub fn validate<V: View + ?Sized>(view: &V, expectation: &Expectation, collect: Collect) -> Report {
    judge(view, expectation, collect, fast_path::accept)
}

/// Returns true if [`validate`] finds nothing wrong: a verdict without a report.
///
/// It stops at the first broken record, so for an invalid structure it takes less time than [`validate`], which looks for the first
/// broken rule. For a valid structure it takes the same time.
///
/// Cost: O(n) time and memory, as [`validate`]. Returns false if memory runs out.
///
/// ```
/// use twinedge::validate::{Expectation, Table, accepts};
/// let edge: Table = "V 2 0 - 1 - H 2 0 1 1 1 0 1 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0".parse()?;
/// assert!(accepts(&edge, &Expectation::plane()));
/// assert!(!accepts(&edge, &Expectation::plane().triangles().components(2)));
/// # Ok::<(), twinedge::validate::ParseTableError>(())
/// ```
pub fn accepts<V: View + ?Sized>(view: &V, expectation: &Expectation) -> bool {
    let Ok(extent) = Extent::of(view, *expectation) else { return false };
    fast_path::accept(Subject { view, extent }).is_some_and(|accepted| {
        let mut findings = findings_of(expectation, Collect::First);
        report_accepted(Subject { view: &view, extent }, &accepted, &mut findings).is_ok()
    })
}

/// Validates without the fast path: every rule checks each record. The report is the same.
///
/// Only useful for comparing the two. O(n).
///
/// ```
/// use twinedge::validate::{Collect, Expectation, Table, reference, validate};
/// // An edge between two vertices, of which the second says that half-edge 0 leaves it.
/// let table: Table = "V 2 0 - 0 - H 2 0 1 1 1 0 1 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0".parse()?;
/// let expectation = Expectation::plane();
/// let report = reference::rule_by_rule(&table, &expectation, Collect::All);
/// assert_eq!(report, validate(&table, &expectation, Collect::All));
/// # Ok::<(), twinedge::validate::ParseTableError>(())
/// ```
pub fn rule_by_rule(view: &dyn View, expectation: &Expectation, collect: Collect) -> Report {
    judge(view, expectation, collect, |_| None)
}

/// Runs the rules, unless `accept` accepts the structure.
fn judge<V: View + ?Sized>(
    view: &V,
    expectation: &Expectation,
    collect: Collect,
    accept: impl FnOnce(Subject<'_, V>) -> Option<Accepted>,
) -> Report {
    let mut findings = findings_of(expectation, collect);
    let extent = match Extent::of(view, *expectation) {
        Ok(extent) => extent,
        Err(why) => return report(expectation, findings, Err(why)),
    };
    let subject = Subject { view, extent };
    let ended = match accept(subject) {
        Some(accepted) => report_accepted(Subject { view: &view, extent }, &accepted, &mut findings),
        None => all_rules(subject, &mut findings),
    };
    let ended = ended.map_err(|halt| match halt {
        Halt::Found => Unchecked::Stopped,
        Halt::OutOfMemory => Unchecked::OutOfMemory,
    });
    report(expectation, findings, ended)
}

/// Creates empty findings. On surfaces the rules of the plane are unchecked for that reason.
fn findings_of(expectation: &Expectation, collect: Collect) -> Findings {
    let mut findings = Findings::new(collect);
    for rule in TOPOLOGICAL.iter().filter(|rule| rule.is_planar() && expectation.surface_kind() != Surface::Plane) {
        findings.not_checked(*rule, Unchecked::PlaneOnly);
    }
    findings
}

/// Creates the report. If the run ended early, the reason is recorded for rules that were not reached.
fn report(expectation: &Expectation, mut findings: Findings, ended: Result<(), Unchecked>) -> Report {
    let asked = Rule::ALL.iter().filter(|rule| rule.is_optional() && expectation.asks_for(**rule));
    let rules: Vec<Rule> = TOPOLOGICAL.iter().chain(asked).copied().collect();
    if let Err(why) = ended {
        for rule in &rules {
            findings.not_checked_yet(*rule, why);
        }
    }
    findings.into_report(&rules)
}

/// Records the counts of rules R1 … T4, which hold, and runs M1 … M8.
fn report_accepted(subject: Subject<'_>, accepted: &Accepted, findings: &mut Findings) -> Flow {
    let Accepted { vertices, isolated, half_edges, unpaired, faces, outer, inner, components, .. } = *accepted;
    let edges = (half_edges - unpaired) / 2 + unpaired;
    let counts = &mut findings.counts;
    (counts.vertices, counts.isolated_vertices) = (vertices, isolated);
    (counts.half_edges, counts.edges) = (half_edges, edges);
    (counts.faces, counts.outer_boundaries, counts.inner_boundaries) = (faces, outer, inner);
    (counts.components, counts.genus) = (Some(components), Some(accepted.genus));
    (counts.cycles, counts.borders) = (Some(accepted.cycles), Some(accepted.borders));

    let has = |part| subject.has(part);
    let listed = outer + inner;
    let links = half_edges * (3 + usize::from(has(Part::Prev)) + usize::from(has(Part::Faces)))
        + vertices * usize::from(has(Part::Leaving) || has(Part::BoundaryComponents) && has(Part::Holes))
        + 2 * listed * usize::from(has(Part::BoundaryComponents))
        + (faces + inner);
    let connected = vertices - isolated;
    let (leaving, of_faces, holes) = (&[Part::Leaving][..], &[Part::Faces][..], &[Part::Holes][..]);
    for (rule, needs, checked) in [
        (Rule::R1, &[][..], links),
        (Rule::L1, &[], half_edges - unpaired),
        (Rule::L2, &[], half_edges),
        (Rule::L3, &[], half_edges - unpaired),
        (Rule::V1, leaving, connected),
        (Rule::V2, &[], connected),
        (Rule::B1, of_faces, half_edges),
        (Rule::B2, &[Part::Faces, Part::Holes], vertices),
        (Rule::F1, of_faces, faces),
        (Rule::F2, of_faces, listed),
        (Rule::T1, holes, components),
        (Rule::T2, holes, components),
        (Rule::T3, &[], components),
    ] {
        if rule.is_planar() && !subject.extent.is_plane() {
            continue;
        }
        match needs.iter().find(|part| !has(**part)) {
            Some(part) => findings.not_checked(rule, Unchecked::Lacks(*part)),
            None => findings.checked(rule, checked as u64),
        }
    }
    if subject.extent.is_plane() {
        whole::bounds(accepted.simple, findings)?;
    }
    if !Rule::ALL.iter().any(|rule| rule.is_optional() && subject.extent.expect.asks_for(*rule)) {
        return Ok(());
    }
    let census = Census {
        half_edges,
        edges,
        vertices,
        isolated_vertices: isolated,
        map_is_live: true,
        list_budget: 0,
        fans: Vec::new(),
    };
    mesh::mesh(subject, &census, accepted.simple, findings)
}

/// Runs every rule on every record. Half-edges are read from columns lent by the view if all are live from the first live one on, and
/// otherwise by calls; only the passes that make these calls are compiled for each type of view.
fn all_rules<V: View + ?Sized>(subject: Subject<'_, V>, findings: &mut Findings) -> Flow {
    let Subject { view, extent } = subject.surveyed();
    let subject: Subject<'_> = Subject { view: &view, extent };
    match extent.half_edges.live_from().and_then(|first| Lent::of(view, extent, first)) {
        Some(lent) => rules_of_lent(subject, lent, findings),
        None => every_rule(subject, Asked { view, extent }, findings),
    }
}

/// The rules on lent columns, compiled once.
fn rules_of_lent(subject: Subject<'_>, lent: Lent<'_>, findings: &mut Findings) -> Flow {
    every_rule(subject, lent, findings)
}

fn every_rule(subject: Subject<'_>, half_edges: impl HalfEdges, findings: &mut Findings) -> Flow {
    let mut census = live::live(subject, half_edges, findings)?;
    let before = links::half_edges(subject, half_edges, &census, findings)?;
    links::leaving(subject, findings)?;
    let components = links::rotation(subject, half_edges, &census, &before, findings)?;
    drop(before);
    faces::cycle(subject, half_edges, &census, findings)?;
    if subject.extent.is_plane() {
        faces::isolated(subject, &census, findings)?;
    }
    census.fans = Vec::new();
    faces::outer(subject, findings)?;
    faces::listed(subject, &census, findings)?;
    let components = components.filter(|_| findings.holds(Rule::V2));
    let is_simple = components.as_ref().is_some_and(|components| components.simple);
    if let Some(components) = components {
        whole_map(subject, half_edges, components, &census, findings)?;
    } else {
        let broken = census.rotations_broken(findings).unwrap_or(Rule::V2);
        for rule in TOPOLOGICAL.iter().filter(|rule| **rule >= Rule::T1) {
            findings.not_checked_yet(*rule, Unchecked::Broken(broken));
        }
    }
    mesh::mesh(subject, &census, is_simple, findings)
}

/// Runs T1 … T4, after computing the counts that they need.
fn whole_map(
    subject: Subject<'_>,
    half_edges: impl HalfEdges,
    mut components: Components,
    census: &Census,
    findings: &mut Findings,
) -> Flow {
    whole::count_cycles(subject, half_edges, &mut components, findings)?;
    findings.counts.components = Some(components.all.len());
    if subject.extent.is_plane() {
        let lies_in = whole::outside(subject, &components, census.list_budget, findings)?;
        whole::nesting(subject, &components, &lies_in, findings)?;
    }
    whole::euler(subject, &components, findings)?;
    if subject.extent.is_plane() {
        whole::bounds(components.simple, findings)?;
    }
    Ok(())
}
