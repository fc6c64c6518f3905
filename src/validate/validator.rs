//! The rules R1 … T4 in order, and M1 … M8 where they are asked for.

use super::columns::Components;
use super::expectation::Expectation;
use super::fast_path;
use super::findings::{Flow, Halt};
use super::passes;
use super::report::{Collect, Report, Unchecked};
use super::rule::Rule;
use super::rules::{
    borders, bounds, closed, connected, cycle, euler, genus, isolated, kept, leaving, listed, live, nesting, outer,
    outside, sides, simple, used,
};
use super::run::Run;
use super::view::View;
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
/// | right | 16 | 68 | 1 | 1 |
/// | elsewhere | 24 | 144 | 5 | 4 |
///
/// A structure without border that is right takes 8 per vertex where neighbours have close numbers and vertices keep a
/// half-edge. Where the table says 1, it is one bit. A border loop takes 12. Elsewhere a component takes 48 bytes in a list that doubles: 144 while the list is
/// copied to twice its size, at most 100 after that. The components are counted only where they are found, by V2. M2 and M3
/// take 4 more per half-edge, 8 per vertex and 4 per face for themselves.
///
/// ```
/// use twinedge::validate::{Collect, Expectation, Rule, Table, validate};
/// // An edge between two vertices, of which the second says that half-edge 0 leaves it.
/// let table: Table = "V 2 0 - 0 - H 2 0 1 1 1 0 1 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0".parse()?;
/// let report = validate(&table, &Expectation::plane(), Collect::All);
/// assert!(!report.is_valid());
/// assert_eq!(report.violations()[0].rule(), Rule::V1);
/// # Ok::<(), twinedge::validate::ParseTableError>(())
/// ```
pub fn validate<V: View + ?Sized>(view: &V, expectation: &Expectation, collect: Collect) -> Report {
    report(view, expectation, collect, |run| {
        fast_path::look(run);
        all_rules(run)
    })
}

/// The same report as that of [`validate`], by all threads of the current pool of `rayon`.
///
/// Structures are read in parts if they are closed and have records of boundary components with their places, and vertices that
/// keep a half-edge, as a `Dcel` has. Where all of R1 … F2 holds, the half-edges, the vertices and the faces are each divided
/// among the threads. Others, and what is broken, are validated as by [`validate`], after one more look in parts at most.
///
/// Cost: O(n) time in each thread and O(n) memory: beyond that of [`validate`], 4 bytes per vertex in each thread.
///
/// ```
/// use twinedge::validate::{Collect, Expectation, Table, validate, validate_parallel};
/// let table: Table = "V 2 0 - 1 - H 2 0 1 1 1 0 1 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0".parse()?;
/// let expectation = Expectation::plane();
/// let report = validate_parallel(&table, &expectation, Collect::All);
/// assert!(report.is_valid());
/// assert_eq!(report, validate(&table, &expectation, Collect::All));
/// # Ok::<(), twinedge::validate::ParseTableError>(())
/// ```
#[cfg(feature = "rayon")]
pub fn validate_parallel<V: View + Sync + ?Sized>(view: &V, expectation: &Expectation, collect: Collect) -> Report {
    report(view, expectation, collect, |run| {
        if !fast_path::parallel::look(run) {
            fast_path::look(run);
        }
        all_rules(run)
    })
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
    report(view, expectation, collect, all_rules)
}

fn report<'a, V: View + ?Sized>(
    view: &'a V,
    expectation: &Expectation,
    collect: Collect,
    rules_of: impl FnOnce(&mut Run<'a, V>) -> Flow,
) -> Report {
    let mut run = Run::new(view, *expectation, collect);
    let rules: Vec<Rule> =
        TOPOLOGICAL.iter().chain(Rule::ALL.iter().filter(|r| is_asked(&run, **r))).copied().collect();
    let ended = run.measure().and_then(|()| {
        rules_of(&mut run).map_err(|halt| match halt {
            Halt::Found => Unchecked::Stopped,
            Halt::OutOfMemory => Unchecked::OutOfMemory,
        })
    });
    if let Err(why) = ended {
        for rule in &rules {
            run.findings.not_checked_yet(*rule, why);
        }
    }
    let (outcomes, violations) = run.findings.into_parts(&rules);
    Report { outcomes, violations, counts: run.counts, bounds: run.bounds }
}

/// Whether this is a rule that must be asked for, and was.
fn is_asked<V: View + ?Sized>(run: &Run<'_, V>, rule: Rule) -> bool {
    rule.is_optional() && run.expect.asks_for(rule)
}

fn all_rules<V: View + ?Sized>(run: &mut Run<'_, V>) -> Flow {
    live::check(run)?;
    passes::half_edges::check(run)?;
    leaving::check(run)?;
    passes::rotations::check(run)?;
    cycle::check(run)?;
    isolated::check(run)?;
    outer::check(run)?;
    listed::check(run)?;
    let components = whole(run)?;
    asked(run, components.as_ref())
}

/// T1 … T4, and the counts that they need. Returns the components, if they can be known.
fn whole<V: View + ?Sized>(run: &mut Run<'_, V>) -> Result<Option<Components>, Halt> {
    if let Some(rule) = run.rotations_broken() {
        for waiting in TOPOLOGICAL.iter().filter(|waiting| **waiting >= Rule::T1) {
            run.findings.not_checked(*waiting, Unchecked::Broken(rule));
        }
        return Ok(None);
    }
    fast_path::whole(run);
    if run.known.whole.is_none() && run.components.is_none() {
        passes::rotations::find(run)?;
    }
    let known = run.known.whole.as_mut().map(|known| core::mem::take(&mut known.components));
    let Some(mut components) = known.or_else(|| run.components.take()) else { return Ok(None) };
    run.counts.components = Some(components.all.len());
    passes::cycles::count(run, &mut components)?;
    outside::check(run, &mut components)?;
    nesting::check(run, &components)?;
    euler::check(run, &components)?;
    bounds::check(run, &components)?;
    Ok(Some(components))
}

/// M1 … M8, each if it is asked for.
fn asked<V: View + ?Sized>(run: &mut Run<'_, V>, components: Option<&Components>) -> Flow {
    used::check(run)?;
    simple::check(run, components)?;
    sides::check(run)?;
    closed::check(run)?;
    connected::check(run)?;
    borders::check(run)?;
    genus::check(run)?;
    kept::check(run)
}
