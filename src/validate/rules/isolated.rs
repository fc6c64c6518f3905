//! B2 isolated: a vertex has no half-edge if and only if exactly one boundary component starts at it, and they name
//! each other.
//!
//! Without records for boundary components, entries of the lists of the faces stand for them.

use super::live::{Census, Fan};
use crate::validate::columns::{NIL, column};
use crate::validate::fast_path::Facts;
use crate::validate::findings::{Findings, Flow};
use crate::validate::report::{Record, Unchecked, Violation};
use crate::validate::rule::Rule;
use crate::validate::structure::{Part, Start};
use crate::validate::subject::Subject;
use alloc::vec::Vec;

/// Runs B2: the boundary components that start at each vertex are found first, then each vertex is checked.
pub(crate) fn check(subject: Subject<'_>, facts: &Facts, census: &Census, findings: &mut Findings) -> Flow {
    for part in [Part::Faces, Part::Holes] {
        if !subject.has(part) {
            findings.not_checked(Rule::B2, Unchecked::Lacks(part));
            return Ok(());
        }
    }
    if facts.lists.is_some_and(|lists| lists.isolated_hold) || each_is_claimed(subject, facts) {
        findings.checked(Rule::B2, census.vertices as u64);
        return Ok(());
    }
    let fans = census.fans.get(subject)?;
    let by_record = subject.has(Part::BoundaryComponents);
    let started: Vec<u32> = column(subject.extent.vertices.0, NIL)?;
    let mut starts = Starts { subject, fans, started, findings: &mut *findings };
    if by_record {
        for b in subject.boundaries() {
            if let Some(Start::Vertex(v)) = subject.view.boundary_start(b) {
                starts.at(v, b, Record::Boundary)?;
            }
        }
    } else {
        subject.for_each_inner_start(census.list_budget, |f, _, start| match start {
            Start::Vertex(v) => starts.at(v, f, Record::Face),
            Start::HalfEdge(_) => Ok(()),
        })?;
    }
    let started = starts.started;
    let mut checked = 0;
    for vertex in subject.vertices() {
        checked += 1;
        let start = started[vertex];
        let names = if by_record { subject.view.isolated(vertex) } else { None };
        if fans[vertex].degree > 0 {
            if let Some(boundary) = names {
                findings.add(Violation::ConnectedNamesBoundary { vertex, boundary })?;
            }
        } else if start == NIL {
            // Nothing can start at a vertex in the unbounded face if that has no record.
            if names.is_some() || subject.has(Part::UnboundedFace) {
                findings.add(Violation::IsolatedUnclaimed { vertex })?;
            }
        } else if by_record && names != Some(start as usize) {
            findings.add(Violation::IsolatedMismatch { vertex, boundary: start as usize, found: names })?;
        }
    }
    findings.checked(Rule::B2, checked);
    Ok(())
}

/// True if the number of boundary components that start at vertices is that of isolated vertices known to name one.
fn each_is_claimed(subject: Subject<'_>, facts: &Facts) -> bool {
    let Some(known) = facts.vertices.filter(|_| subject.has(Part::BoundaryComponents)) else { return false };
    let starts_at_vertex = |b: &usize| matches!(subject.view.boundary_start(*b), Some(Start::Vertex(_)));
    let at_vertex = facts.lists.map(|lists| lists.at_vertex);
    at_vertex.unwrap_or_else(|| subject.boundaries().filter(starts_at_vertex).count()) == known.claimed
}

/// The boundary components that start at vertices, or the faces that list vertices.
struct Starts<'a, 'f> {
    subject: Subject<'a>,
    fans: &'f [Fan],
    /// For each vertex the first of them.
    started: Vec<u32>,
    findings: &'f mut Findings,
}

impl Starts<'_, '_> {
    /// Notes one that starts at this vertex.
    fn at(&mut self, vertex: usize, by: usize, kind: fn(usize) -> Record) -> Flow {
        if !(self.subject.extent.vertices.has(vertex) && self.subject.view.is_vertex(vertex)) {
            return Ok(());
        }
        let record = kind(by);
        if self.fans[vertex].degree > 0 {
            return self.findings.add(Violation::StartsAtConnected { record, vertex });
        }
        let first = &mut self.started[vertex];
        if *first == NIL {
            *first = by as u32;
            return Ok(());
        }
        let first = kind(*first as usize);
        self.findings.add(Violation::IsolatedTwice { vertex, first, second: record })
    }
}
