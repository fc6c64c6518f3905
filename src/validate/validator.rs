//! The rules R1 … T4 in order.

use super::expectation::Expectation;
use super::fast_path;
use super::findings::{Flow, Halt};
use super::passes;
use super::report::{Collect, Report, Unchecked};
use super::rule::Rule;
use super::rules::{bounds, cycle, euler, isolated, leaving, listed, live, nesting, outer, outside};
use super::run::Run;
use super::view::View;

/// The rules of this validator: all but the geometric ones.
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

/// Validates any half-edge structure: rules R1 … T4.
///
/// Cost: O(n) time and memory, n being the number of slots of all kinds: 12 bytes per vertex and 52 per component where
/// every part is there and right, at most about 9 more per half-edge and 8 per vertex elsewhere. It does not panic
/// unless the [`View`] does, and it always ends.
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
    let mut run = Run::new(view, *expectation, collect);
    let ended = run.measure().and_then(|()| {
        all_rules(&mut run).map_err(|halt| match halt {
            Halt::Found => Unchecked::Stopped,
            Halt::OutOfMemory => Unchecked::OutOfMemory,
        })
    });
    if let Err(why) = ended {
        for rule in TOPOLOGICAL {
            run.findings.not_checked_yet(*rule, why);
        }
    }
    let (outcomes, violations) = run.findings.into_parts(TOPOLOGICAL);
    Report { outcomes, violations, counts: run.counts, bounds: run.bounds }
}

fn all_rules<V: View + ?Sized>(run: &mut Run<'_, V>) -> Flow {
    let settled = fast_path::check(run);
    if !settled {
        live::check(run)?;
        passes::half_edges::check(run)?;
        leaving::check(run)?;
        passes::rotations::check(run)?;
        cycle::check(run)?;
        isolated::check(run)?;
        outer::check(run)?;
        listed::check(run)?;
    }
    if let Some(rule) = run.map_broken().or_else(|| run.findings.broken(&[Rule::V2])) {
        for waiting in TOPOLOGICAL.iter().filter(|waiting| **waiting >= Rule::T1) {
            run.findings.not_checked(*waiting, Unchecked::Broken(rule));
        }
        return Ok(());
    }
    let Some(mut components) = run.components.take() else { return Ok(()) };
    run.counts.components = Some(components.all.len());
    if !settled {
        passes::cycles::count(run, &mut components)?;
        outside::check(run, &mut components)?;
    }
    nesting::check(run, &components)?;
    if !settled {
        euler::check(run, &components)?;
    }
    bounds::check(run, &components)
}
