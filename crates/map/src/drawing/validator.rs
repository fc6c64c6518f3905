//! The rules G1 … G5 in order: do these coordinates draw that topology?

use super::columns::Columns;
use super::components::Components;
use super::lists::Lists;
use super::segments::Segments;
use crate::Embedding;
use crate::drawing::rules::{Inside, angles, disjoint, finite, winding};
use twinedge::validate::{Collect, Expectation, Findings, Flow, Part, Report, Rule, Unchecked, validate};

const GEOMETRIC: &[Rule] = &[Rule::G1, Rule::G2, Rule::G3, Rule::G4, Rule::G5];

/// Validates any half-edge structure with coordinates: rules R1 … T4, and M1 … M8 if requested, as [`validate`], then G1 … G5.
///
/// A G rule is checked if the topological rules that it builds on hold, and otherwise reported as not checked. If edges clash,
/// all clashes are found and counted in O(n log n + p) for p pairs of edges whose bounding boxes meet; otherwise the cost is O(n
/// log n). Like [`validate`], it always terminates, and panics only if the [`Embedding`] does.
///
/// Edges may have [bends](Embedding::bends). The verdict equals that of the map with a vertex at each bend, and n counts bends.
///
/// Without an unbounded face ([`Part::UnboundedFace`]), outermost components must lie in no face, and faces must list all in
/// them.
///
/// ```
/// use twinedge_map::{Builder, validate_embedding};
/// use twinedge::validate::{Collect, Expectation, Rule};
///
/// let mut builder = Builder::new();
/// builder.segment([0.0, 0.0], [2.0, 2.0])?;
/// builder.segment([0.0, 2.0], [2.0, 0.0])?;
/// let map = builder.build()?;
/// let report = validate_embedding(&map, &Expectation::plane(), Collect::All);
/// assert_eq!(report.first().unwrap().rule(), Rule::G4);
/// # Ok::<(), twinedge_map::BuildError>(())
/// ```
pub fn validate_embedding<E: Embedding + ?Sized>(embedding: &E, expectation: &Expectation, collect: Collect) -> Report {
    let mut report = validate(embedding, expectation, collect);
    let mut findings = Findings::new(collect);
    if report.violation_count() > 0 && collect == Collect::First {
        for rule in GEOMETRIC {
            findings.not_checked(*rule, Unchecked::Stopped);
        }
    } else if all_rules(embedding, *expectation, &mut findings, &report).is_err() {
        for rule in GEOMETRIC {
            findings.not_checked_yet(*rule, Unchecked::Stopped);
        }
    }
    report.append(findings.into_report(GEOMETRIC), collect);
    report
}

fn all_rules<E: Embedding + ?Sized>(
    embedding: &E,
    expectation: Expectation,
    findings: &mut Findings,
    topology: &Report,
) -> Flow {
    let links = [Rule::R1, Rule::L1, Rule::L2, Rule::L3];
    let why = first_broken(topology, &links);
    let columns = match why.map_or_else(|| Columns::read(embedding), Err) {
        Ok(columns) => columns,
        Err(why) => {
            for rule in GEOMETRIC {
                findings.not_checked(*rule, why);
            }
            return Ok(());
        }
    };
    finite(findings, &columns)?;
    if let Some(rule) = findings.broken(&[Rule::G1]) {
        for later in &GEOMETRIC[1..] {
            findings.not_checked(*later, Unchecked::Broken(rule));
        }
        return Ok(());
    }
    match first_broken(topology, &[Rule::V1, Rule::V2]) {
        Some(why) => findings.not_checked(Rule::G2, why),
        None => angles(findings, &columns)?,
    }
    let segments = Segments::of(&columns);
    let components = match Components::of(&columns) {
        Ok(components) => components,
        Err(why) => {
            for rule in &GEOMETRIC[3..] {
                findings.not_checked_yet(*rule, why);
            }
            return Ok(());
        }
    };
    let below = disjoint(findings, &columns, &segments, &components)?;
    let faces =
        first_broken(topology, &[Rule::V2, Rule::B1, Rule::B2, Rule::F1, Rule::F2, Rule::T1, Rule::T2, Rule::T3]);
    let why = faces.or_else(|| findings.broken(&[Rule::G4]).map(Unchecked::Broken));
    let (None, Some(below)) = (why, below) else {
        let why = why.unwrap_or(Unchecked::TooLarge);
        findings.not_checked(Rule::G3, why);
        findings.not_checked(Rule::G5, why);
        return Ok(());
    };
    let parts = expectation.looks_at(embedding.parts());
    let lists = Lists::of(embedding, parts, &columns);
    winding(findings, &columns, &lists)?;
    if let Some(rule) = findings.broken(&[Rule::G2, Rule::G3]) {
        findings.not_checked(Rule::G5, Unchecked::Broken(rule));
        return Ok(());
    }
    let inside = Inside {
        embedding,
        parts,
        columns: &columns,
        components: &components,
        segments: &segments,
        below: &below,
        lists: &lists,
    };
    inside.check(findings)
}

/// Returns the reason why a dependent rule cannot be checked, if one of these rules is broken or was not checked.
fn first_broken(topology: &Report, rules: &[Rule]) -> Option<Unchecked> {
    rules.iter().find_map(|rule| {
        let outcome = topology.outcome(*rule)?;
        match outcome.unchecked {
            _ if outcome.violations > 0 => Some(Unchecked::Broken(*rule)),
            Some(Unchecked::Lacks(Part::Leaving)) | None => None,
            Some(why) => Some(why),
        }
    })
}
