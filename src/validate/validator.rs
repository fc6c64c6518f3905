//! The rules R1 … T4 in order, and M1 … M8 where they are asked for.

use super::columns::Components;
use super::expectation::{Expectation, Surface};
use super::fast_path::{self, Facts, Rotations, Stop, Whole};
use super::findings::{Findings, Flow, Halt};
use super::passes;
use super::report::{Collect, Report, Unchecked};
use super::rule::Rule;
use super::rules::live::{self, Census};
use super::rules::{
    borders, bounds, closed, connected, cycle, euler, genus, isolated, kept, leaving, listed, nesting, outer, outside,
    sides, simple, used,
};
use super::structure::View;
use super::subject::{Extent, Subject};
use alloc::vec::Vec;

/// The rules of this validator: all but the geometric ones, and those that must be asked for.
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

/// Validates any half-edge structure: rules R1 … T4, and those of M1 … M8 that the expectation asks for.
///
/// Cost: O(n) time (but for the inverse of Ackermann's function) and memory, n being the number of slots of all kinds. It
/// does not panic unless the [`View`] does, and it always ends. At most so many bytes are in use at a time, besides the violations that are kept:
///
/// | | per vertex | per component | per half-edge | per boundary component |
/// | --- | --- | --- | --- | --- |
/// | right | 16 | 40 | 1 | 1 |
/// | elsewhere | 24 | 72 | 5 | 4 |
///
/// A structure without border that is right takes 8 per vertex where neighbours have close numbers and vertices keep a
/// half-edge. Where the table says 1, it is one bit. A border loop takes 12. Elsewhere a component takes 24 bytes in a list that doubles: 72 while the list is
/// copied to twice its size, at most 50 after that. The components are counted only where they are found, by V2. M2 and M3
/// take 4 more per half-edge, 8 per vertex and 4 per face for themselves.
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
    judge(view, expectation, collect, |subject| fast_path::settle(subject, stop(collect)))
}

/// True if [`validate`] finds nothing wrong: a verdict without a report.
///
/// It stops at the first record that is wrong, so it takes less time for a wrong structure than [`validate`], which looks for the rule that is
/// broken first. For a right structure it takes the same.
///
/// Cost: O(n) time and memory, as [`validate`]. False if there is no memory for it.
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
    fast_path::settle_all(Subject { view, extent })
        .is_some_and(|facts| run(Subject { view: &view, extent }, facts, Collect::First).is_valid())
}

/// The place where the fast path can stop if so much is collected.
const fn stop(collect: Collect) -> Stop {
    if matches!(collect, Collect::First) { Stop::AfterRule } else { Stop::Never }
}

/// The same report without the fast path: every rule asks each record.
///
/// Nobody needs it but to compare the two. O(n), and three to ten times as long.
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
pub fn rule_by_rule<V: View + ?Sized>(view: &V, expectation: &Expectation, collect: Collect) -> Report {
    judge(view, expectation, collect, |_| Facts::default())
}

/// Settles what `settle` can, and runs the rules on the rest. Only the former is compiled for each type of view.
fn judge<V: View + ?Sized>(
    view: &V,
    expectation: &Expectation,
    collect: Collect,
    settle: impl FnOnce(Subject<'_, V>) -> Facts,
) -> Report {
    let extent = match Extent::of(view, *expectation) {
        Ok(extent) => extent,
        Err(why) => return report(expectation, findings_of(expectation, collect), Err(why)),
    };
    let facts = settle(Subject { view, extent });
    run(Subject { view: &view, extent }, facts, collect)
}

/// No findings yet. On surfaces the rules of the plane have their reason, before any other.
fn findings_of(expectation: &Expectation, collect: Collect) -> Findings {
    let mut findings = Findings::new(collect);
    for rule in TOPOLOGICAL.iter().filter(|rule| rule.is_planar() && expectation.surface_kind() != Surface::Plane) {
        findings.not_checked(*rule, Unchecked::PlaneOnly);
    }
    findings
}

/// Runs the rules.
fn run(subject: Subject<'_>, facts: Facts, collect: Collect) -> Report {
    let mut findings = findings_of(&subject.extent.expect, collect);
    let ended = all_rules(subject, facts, &mut findings).map_err(|halt| match halt {
        Halt::Found => Unchecked::Stopped,
        Halt::OutOfMemory => Unchecked::OutOfMemory,
    });
    report(&subject.extent.expect, findings, ended)
}

/// The report of these findings. What was not reached, if the run ended early, has the reason.
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

fn all_rules(subject: Subject<'_>, facts: Facts, findings: &mut Findings) -> Flow {
    let census = live::check(subject, &facts, findings)?;
    let before = passes::half_edges::check(subject, &facts, &census, findings)?;
    leaving::check(subject, &facts, findings)?;
    let walked = passes::rotations::check(subject, &facts, &census, before.as_deref(), findings)?;
    cycle::check(subject, &facts, &census, findings)?;
    if subject.extent.is_plane() {
        isolated::check(subject, &facts, &census, findings)?;
    }
    outer::check(subject, &facts, findings)?;
    listed::check(subject, &facts, &census, findings)?;
    let is_simple = if let Some(rule) = census.rotations_broken(findings) {
        for waiting in TOPOLOGICAL.iter().filter(|waiting| **waiting >= Rule::T1) {
            findings.not_checked_yet(*waiting, Unchecked::Broken(rule));
        }
        false
    } else {
        let whole = match (facts.rotations, walked) {
            (Rotations::Whole(whole), _) => Ok(whole),
            (_, Some(components)) => Err(components),
            _ => Err(passes::rotations::find(subject, &census, before.as_deref(), findings)?),
        };
        drop(before);
        whole_map(subject, whole, &census, findings)?
    };
    used::check(subject, &census, findings)?;
    simple::check(subject, &census, is_simple, findings)?;
    sides::check(subject, &census, findings)?;
    closed::check(subject, &census, findings)?;
    connected::check(subject, &census, findings)?;
    borders::check(subject, &census, findings)?;
    genus::check(subject, &census, findings)?;
    kept::check(subject, &census, findings)
}

/// T1 … T4, and the counts that they need: from the whole as it is settled, or from the components. Returns whether there is neither a
/// loop nor a pair of parallel edges.
fn whole_map(
    subject: Subject<'_>,
    whole: Result<Whole, Components>,
    census: &Census,
    findings: &mut Findings,
) -> Result<bool, Halt> {
    let (components, lies_in, genus) = match whole {
        Ok(Whole { components, lies_in, genus, cycles, borders }) => {
            passes::cycles::enter(subject, [cycles, borders], findings);
            (components, lies_in, Some(genus))
        }
        Err(mut components) => {
            passes::cycles::count(subject, &mut components, findings)?;
            (components, None, None)
        }
    };
    findings.counts.components = Some(components.all.len());
    if subject.extent.is_plane() {
        let lies_in = outside::check(subject, &components, lies_in, census.list_budget, findings)?;
        nesting::check(subject, &components, &lies_in, findings)?;
    }
    euler::check(subject, &components, genus, findings)?;
    if subject.extent.is_plane() {
        bounds::check(components.simple, findings)?;
    }
    Ok(components.simple)
}
