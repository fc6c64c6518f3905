//! B1 cycle: the boundary component is constant along `next`, its start is on its own cycle, and it has one cycle.
//!
//! Without records for boundary components: the face is constant along `next`, and a face keeps half-edges of its own.

use super::live::Census;
use crate::validate::columns::{NIL, column};
use crate::validate::fast_path::Facts;
use crate::validate::findings::{Findings, Flow, Halt};
use crate::validate::passes::half_edges::{checked, to_check};
use crate::validate::report::{Unchecked, Violation};
use crate::validate::rule::Rule;
use crate::validate::structure::{Part, Start};
use crate::validate::subject::Subject;
use alloc::vec::Vec;

/// Runs B1.
pub(crate) fn check(subject: Subject<'_>, facts: &Facts, census: &Census, findings: &mut Findings) -> Flow {
    if !subject.has(Part::Faces) {
        findings.not_checked(Rule::B1, Unchecked::Lacks(Part::Faces));
        return Ok(());
    }
    let by_record = subject.has(Part::BoundaryComponents);
    if facts.lists.is_some_and(|lists| lists.cycles_hold) {
        findings.checked(Rule::B1, census.half_edges as u64);
        if by_record {
            not_walked(census, findings);
        }
        return Ok(());
    }
    if by_record {
        constant_along_next(subject, facts, findings)?;
        components_have_one_cycle(subject, facts, census, findings)
    } else {
        cycles_have_one_face(subject, facts, census.list_budget, findings)
    }
}

/// For each boundary component the number of half-edges that name it.
fn sizes(subject: Subject<'_>) -> Result<Vec<u32>, Halt> {
    let mut sizes = column(subject.extent.boundaries.0, 0)?;
    for h in subject.half_edges() {
        if let Some(size) = sizes.get_mut(subject.boundary(h) as usize) {
            *size += 1;
        }
    }
    Ok(sizes)
}

fn constant_along_next(subject: Subject<'_>, facts: &Facts, findings: &mut Findings) -> Flow {
    let mut checked = checked(subject, facts);
    for h in to_check(subject, facts) {
        let n = subject.next(h);
        if !subject.is_live_half_edge(n) {
            continue;
        }
        checked += 1;
        let (half_edge, next) = (h as usize, n as usize);
        let (boundary, found) = (subject.view.boundary(half_edge), subject.view.boundary(next));
        if boundary == found {
            continue;
        }
        // A dangling link breaks R1, not this rule. Nil meets something else only at an open boundary.
        let dangles = |link: &Option<usize>| link.is_some_and(|b| !subject.extent.boundaries.has(b));
        let is_needed = !subject.is_open() && (boundary.is_none() || found.is_none());
        if ![boundary, found].iter().any(dangles) && !is_needed {
            findings.add(Violation::BoundaryChanges { half_edge, next, boundary, found })?;
        }
    }
    findings.checked(Rule::B1, checked);
    Ok(())
}

fn components_have_one_cycle(subject: Subject<'_>, facts: &Facts, census: &Census, findings: &mut Findings) -> Flow {
    let constant_along_next = findings.holds(Rule::B1);
    let walkable = census.map_is_live && findings.holds(Rule::L2) && constant_along_next;
    // The starts on half-edges may be settled already; then only those at vertices are checked.
    if walkable || facts.lists.is_none_or(|lists| lists.at_vertex > 0) {
        starts_and_sizes(subject, walkable, findings)?;
    }
    if constant_along_next {
        not_walked(census, findings);
    }
    Ok(())
}

/// Checks that each start names its own boundary component, and where `walkable`, that its cycle has all half-edges that do.
fn starts_and_sizes(subject: Subject<'_>, walkable: bool, findings: &mut Findings) -> Flow {
    let sizes = sizes(subject)?;
    for b in subject.boundaries() {
        let Some(Start::HalfEdge(start)) = subject.view.boundary_start(b) else { continue };
        let Some(half_edge) = subject.live_half_edge(Some(start)) else { continue };
        let found = subject.view.boundary(half_edge);
        if found != Some(b) {
            findings.add(Violation::StartElsewhere { boundary: b, half_edge, found })?;
        } else if walkable {
            let half_edges = sizes[b];
            let cycle = cycle_length(subject, half_edge as u32, half_edges);
            if cycle < half_edges {
                second_cycle(b, cycle, half_edges, findings)?;
            }
        }
    }
    // A component that starts at a vertex has no half-edges of its own.
    for b in subject.boundaries().filter(|b| sizes[*b] > 0) {
        if let Some(Start::Vertex(_)) = subject.view.boundary_start(b) {
            second_cycle(b, 0, sizes[b], findings)?;
        }
    }
    Ok(())
}

/// Notes that no cycle can be walked along, if so.
fn not_walked(census: &Census, findings: &mut Findings) {
    if let Some(rule) = census.links_broken().or_else(|| findings.broken(&[Rule::L2])) {
        findings.not_checked(Rule::B1, Unchecked::Broken(rule));
    }
}

fn second_cycle(boundary: usize, cycle: u32, half_edges: u32, findings: &mut Findings) -> Flow {
    findings.add(Violation::SecondCycle { boundary, cycle: cycle as usize, half_edges: half_edges as usize })
}

/// The length of the cycle through `start`, walking no further than `limit`.
fn cycle_length(subject: Subject<'_>, start: u32, limit: u32) -> u32 {
    let mut length = 0;
    let mut h = start;
    while h != NIL && length < limit {
        length += 1;
        h = subject.next(h);
        if h == start {
            break;
        }
    }
    length
}

fn cycles_have_one_face(subject: Subject<'_>, facts: &Facts, list_budget: usize, findings: &mut Findings) -> Flow {
    let mut checked = checked(subject, facts);
    for h in to_check(subject, facts) {
        let (half_edge, next) = (h as usize, subject.next(h));
        if !subject.is_live_half_edge(next) {
            continue;
        }
        checked += 1;
        let next = next as usize;
        let (face, found) = (subject.view.face(half_edge), subject.view.face(next));
        if face != found && subject.is_sound_face_link(face) && subject.is_sound_face_link(found) {
            findings.add(Violation::FaceChanges { half_edge, next, face, found })?;
        }
    }
    findings.checked(Rule::B1, checked);
    // The half-edges that the faces list may be known to name these faces.
    if facts.lists.is_some() {
        return Ok(());
    }
    for f in subject.faces() {
        if let Some(h) = subject.view.outer_half_edge(f) {
            names_its_face(subject, f, h, findings)?;
        }
    }
    subject.for_each_inner_start(list_budget, |f, _, start| match start {
        Start::HalfEdge(h) => names_its_face(subject, f, h, findings),
        Start::Vertex(_) => Ok(()),
    })
}

/// Checks that a half-edge that a face lists names that face.
fn names_its_face(subject: Subject<'_>, face: usize, h: usize, findings: &mut Findings) -> Flow {
    let Some(half_edge) = subject.live_half_edge(Some(h)) else { return Ok(()) };
    let found = subject.view.face(half_edge);
    if found == Some(face) || !subject.is_sound_face_link(found) {
        return Ok(());
    }
    findings.add(Violation::ListedElsewhere { face, half_edge, found })
}
