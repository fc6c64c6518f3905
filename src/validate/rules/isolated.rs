//! B2 isolated: a vertex has no half-edge if and only if exactly one boundary component starts at it, and they name
//! each other.
//!
//! ```text
//!   ·v    isolated(v) = 7 ◄──► start(7) = v
//! ```
//!
//! Without records for boundary components, entries of the lists of the faces stand for them.

use crate::validate::columns::{NIL, column};
use crate::validate::expectation::Part;
use crate::validate::findings::Flow;
use crate::validate::record::Record;
use crate::validate::report::Unchecked;
use crate::validate::rule::Rule;
use crate::validate::run::Run;
use crate::validate::view::{Start, View};
use crate::validate::violation::Violation;
use alloc::vec::Vec;

/// Runs B2: the boundary components that start at each vertex are found first, then each vertex is checked.
pub(in crate::validate) fn check<V: View + ?Sized>(run: &mut Run<'_, V>) -> Flow {
    for part in [Part::Faces, Part::Holes] {
        if !run.expect.has(part) {
            run.findings.not_checked(Rule::B2, Unchecked::Lacks(part));
            return Ok(());
        }
    }
    if run.known.isolated || each_is_claimed(run) {
        run.findings.checked(Rule::B2, run.counts.vertices as u64);
        return Ok(());
    }
    run.count_fans()?;
    let by_record = run.expect.has(Part::BoundaryComponents);
    // The boundary component, or the face, that starts at a vertex or lists it as isolated.
    let mut started: Vec<u32> = column(run.vertices, NIL)?;
    if by_record {
        for b in 0..run.boundaries {
            if !run.live_boundary(b) {
                continue;
            }
            if let Some(Start::Vertex(v)) = run.view.boundary_start(b as usize) {
                starts_at(run, &mut started, v, b, Record::Boundary)?;
            }
        }
    } else {
        run.for_each_inner_start(|run, f, _, start| match start {
            Start::Vertex(v) => starts_at(run, &mut started, v, f as u32, Record::Face),
            Start::HalfEdge(_) => Ok(()),
        })?;
    }
    let mut checked = 0;
    for v in 0..run.vertices {
        if !run.live_vertex(v) {
            continue;
        }
        checked += 1;
        let vertex = v as usize;
        let start = started[vertex];
        let names = if by_record { run.view.isolated(vertex) } else { None };
        if run.fans[vertex].degree > 0 {
            if let Some(boundary) = names {
                run.findings.add(Violation::ConnectedNamesBoundary { vertex, boundary })?;
            }
        } else if start == NIL {
            // Where the unbounded face is no record, nothing can start at a vertex that lies in it.
            if names.is_none() && !run.expect.has(Part::UnboundedFace) {
                continue;
            }
            run.findings.add(Violation::IsolatedUnclaimed { vertex })?;
        } else if by_record && names != Some(start as usize) {
            run.findings.add(Violation::IsolatedMismatch { vertex, boundary: start as usize, found: names })?;
        }
    }
    run.findings.checked(Rule::B2, checked);
    Ok(())
}

/// Whether as many boundary components start at vertices as isolated vertices are known to name.
fn each_is_claimed<V: View + ?Sized>(run: &Run<'_, V>) -> bool {
    let Some(known) = run.known.vertices.filter(|_| run.expect.has(Part::BoundaryComponents)) else { return false };
    let starts_at_vertex =
        |b: &u32| run.live_boundary(*b) && matches!(run.view.boundary_start(*b as usize), Some(Start::Vertex(_)));
    let at_vertex = run.known.lists.map(|lists| lists.at_vertex);
    at_vertex.unwrap_or_else(|| (0..run.boundaries).filter(starts_at_vertex).count()) == known.claimed
}

/// Notes that a boundary component starts at a vertex, or that a face lists it.
fn starts_at<V: View + ?Sized>(
    run: &mut Run<'_, V>,
    started: &mut [u32],
    v: usize,
    by: u32,
    kind: fn(usize) -> Record,
) -> Flow {
    if v >= started.len() || !run.view.is_vertex(v) {
        return Ok(());
    }
    let record = kind(by as usize);
    if run.fans[v].degree > 0 {
        run.findings.add(Violation::StartsAtConnected { record, vertex: v })
    } else if started[v] == NIL {
        started[v] = by;
        Ok(())
    } else {
        let first = kind(started[v] as usize);
        run.findings.add(Violation::IsolatedTwice { vertex: v, first, second: record })
    }
}
