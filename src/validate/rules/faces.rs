//! B1 … F2: boundary components and the faces that list them.

use super::live::{Census, Fan, list_too_long};
use crate::numbers::NIL;
use crate::validate::findings::{Findings, Flow, Halt};
use crate::validate::half_edges::HalfEdges;
use crate::validate::report::{Record, Unchecked, Violation};
use crate::validate::rule::Rule;
use crate::validate::structure::{BoundaryPlace, Part, Start};
use crate::validate::subject::{Subject, column};
use alloc::vec::Vec;

/// B1 cycle: the boundary component is constant along `next`, its start is on its own cycle, and it has one cycle.
///
/// Without records for boundary components: the face is constant along `next`, and a face lists only half-edges of its own.
pub(crate) fn cycle(
    subject: Subject<'_>,
    half_edges: impl HalfEdges,
    census: &Census,
    findings: &mut Findings,
) -> Flow {
    if !subject.has(Part::Faces) {
        findings.not_checked(Rule::B1, Unchecked::Lacks(Part::Faces));
        return Ok(());
    }
    if subject.has(Part::BoundaryComponents) {
        let sizes = boundary_constant(subject, half_edges, findings)?;
        one_cycle_each(subject, half_edges, &sizes, census, findings)
    } else {
        face_constant(subject, half_edges, census.list_budget, findings)
    }
}

/// Returns the number of half-edges that name each boundary component.
fn boundary_constant(
    subject: Subject<'_>,
    half_edges: impl HalfEdges,
    findings: &mut Findings,
) -> Result<Vec<u32>, Halt> {
    let mut sizes = column(subject.extent.boundaries.count, 0)?;
    let mut checked = 0;
    for h in subject.half_edges() {
        let (n, name) = (half_edges.next(h), half_edges.name(h));
        if let Some(size) = sizes.get_mut(name as usize) {
            *size += 1;
        }
        if !half_edges.is_live(n) {
            continue;
        }
        checked += 1;
        if half_edges.name(n) == name {
            continue;
        }
        let (half_edge, next) = (h as usize, n as usize);
        let (boundary, found) = (subject.view.boundary(half_edge), subject.view.boundary(next));
        // A dangling link breaks R1, not this rule. Nil meets a different link only at an open boundary.
        let dangles = |link: &Option<usize>| link.is_some_and(|b| !subject.extent.boundaries.has(b));
        let is_needed = !subject.is_open() && (boundary.is_none() || found.is_none());
        if boundary != found && ![boundary, found].iter().any(dangles) && !is_needed {
            findings.add(Violation::BoundaryChanges { half_edge, next, boundary, found })?;
        }
    }
    findings.checked(Rule::B1, checked);
    Ok(sizes)
}

fn one_cycle_each(
    subject: Subject<'_>,
    half_edges: impl HalfEdges,
    sizes: &[u32],
    census: &Census,
    findings: &mut Findings,
) -> Flow {
    let is_constant = findings.holds(Rule::B1);
    let walkable = census.map_is_live && findings.holds(Rule::L2) && is_constant;
    starts_and_sizes(subject, half_edges, sizes, walkable, findings)?;
    // Without these rules cycles cannot be walked.
    let broken = census.links_broken().or_else(|| findings.broken(&[Rule::L2]));
    if let Some(rule) = broken.filter(|_| is_constant) {
        findings.not_checked(Rule::B1, Unchecked::Broken(rule));
    }
    Ok(())
}

/// Checks that each start names its own boundary component, and if `walkable`, that its cycle contains all half-edges that name
/// it.
fn starts_and_sizes(
    subject: Subject<'_>,
    half_edges: impl HalfEdges,
    sizes: &[u32],
    walkable: bool,
    findings: &mut Findings,
) -> Flow {
    for b in subject.boundaries() {
        let Some(Start::HalfEdge(start)) = subject.view.boundary_start(b) else { continue };
        let Some(half_edge) = subject.live_half_edge(Some(start)) else { continue };
        let found = subject.view.boundary(half_edge);
        if found != Some(b) {
            findings.add(Violation::StartElsewhere { boundary: b, half_edge, found })?;
        } else if walkable {
            let cycle = cycle_length(half_edges, half_edge as u32, sizes[b]);
            if cycle < sizes[b] {
                second_cycle(b, cycle, sizes[b], findings)?;
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

fn second_cycle(boundary: usize, cycle: u32, half_edges: u32, findings: &mut Findings) -> Flow {
    findings.add(Violation::SecondCycle { boundary, cycle: cycle as usize, half_edges: half_edges as usize })
}

/// The length of the cycle through `start`, at most `limit`.
fn cycle_length(half_edges: impl HalfEdges, start: u32, limit: u32) -> u32 {
    let mut length = 0;
    let mut h = start;
    while h != NIL && length < limit {
        length += 1;
        h = half_edges.next(h);
        if h == start {
            break;
        }
    }
    length
}

fn face_constant(
    subject: Subject<'_>,
    half_edges: impl HalfEdges,
    list_budget: usize,
    findings: &mut Findings,
) -> Flow {
    let mut checked = 0;
    for h in subject.half_edges() {
        let n = half_edges.next(h);
        if !half_edges.is_live(n) {
            continue;
        }
        checked += 1;
        if half_edges.name(n) == half_edges.name(h) {
            continue;
        }
        let (half_edge, next) = (h as usize, n as usize);
        let (face, found) = (subject.view.face(half_edge), subject.view.face(next));
        if face != found && subject.is_sound_face_link(face) && subject.is_sound_face_link(found) {
            findings.add(Violation::FaceChanges { half_edge, next, face, found })?;
        }
    }
    findings.checked(Rule::B1, checked);
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

fn names_its_face(subject: Subject<'_>, face: usize, h: usize, findings: &mut Findings) -> Flow {
    let Some(half_edge) = subject.live_half_edge(Some(h)) else { return Ok(()) };
    let found = subject.view.face(half_edge);
    if found == Some(face) || !subject.is_sound_face_link(found) {
        return Ok(());
    }
    findings.add(Violation::ListedElsewhere { face, half_edge, found })
}

/// B2 isolated: a vertex has no half-edge if and only if exactly one boundary component starts at it, and they name each other.
///
/// Finds the boundary components that start at each vertex, then checks each vertex. Without records for boundary components,
/// the list entries of the faces take their place.
pub(crate) fn isolated(subject: Subject<'_>, census: &Census, findings: &mut Findings) -> Flow {
    for part in [Part::Faces, Part::Holes] {
        if !subject.has(part) {
            findings.not_checked(Rule::B2, Unchecked::Lacks(part));
            return Ok(());
        }
    }
    let by_record = subject.has(Part::BoundaryComponents);
    let started: Vec<u32> = column(subject.extent.vertices.count, NIL)?;
    let fans = &census.fans[..];
    let mut starts = StartsAtVertices { subject, fans, started, findings: &mut *findings };
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
            // Nothing can start at a vertex in an unbounded face without a record.
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

/// Boundary components that start at vertices, or faces that list vertices.
struct StartsAtVertices<'a, 'f> {
    subject: Subject<'a>,
    fans: &'f [Fan],
    started: Vec<u32>,
    findings: &'f mut Findings,
}

impl StartsAtVertices<'_, '_> {
    fn at(&mut self, vertex: usize, by: usize, kind: fn(usize) -> Record) -> Flow {
        if !self.subject.is_vertex(vertex) {
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

/// F1 outer: a bounded face has exactly one outer boundary component, a cycle; the one unbounded face has none.
///
/// Counts the outer boundary components.
pub(crate) fn outer(subject: Subject<'_>, findings: &mut Findings) -> Flow {
    if !subject.has(Part::Faces) {
        findings.not_checked(Rule::F1, Unchecked::Lacks(Part::Faces));
        return Ok(());
    }
    let has_unbounded = subject.has(Part::UnboundedFace);
    let (mut unbounded, mut checked) = (None, 0);
    for face in subject.faces() {
        checked += 1;
        match (subject.outer(face), unbounded) {
            (None, _) if !has_unbounded => findings.add(Violation::NoOuter { face })?,
            (None, None) => unbounded = Some(face),
            (None, Some(first)) => findings.add(Violation::SecondUnboundedFace { first, second: face })?,
            (Some(outer), _) => {
                findings.counts.outer_boundaries += 1;
                let boundary = subject.live_boundary(Some(outer));
                let start = boundary.and_then(|b| subject.view.boundary_start(b));
                if let (Some(boundary), Some(Start::Vertex(_))) = (boundary, start) {
                    findings.add(Violation::OuterIsVertex { face, boundary })?;
                }
            }
        }
    }
    findings.checked(Rule::F1, checked);
    if unbounded.is_none() && has_unbounded {
        findings.add(Violation::NoUnboundedFace)?;
    }
    Ok(())
}

/// F2 listed: every boundary component is listed exactly once, by the face it names, at the place it says.
///
/// Counts the inner boundary components. Without records for boundary components, each cycle with a face must be listed exactly
/// once; B1 checks that its own face lists it.
pub(crate) fn listed(subject: Subject<'_>, census: &Census, findings: &mut Findings) -> Flow {
    if !subject.has(Part::Faces) {
        findings.not_checked(Rule::F2, Unchecked::Lacks(Part::Faces));
        return Ok(());
    }
    let by_record = subject.has(Part::BoundaryComponents);
    let broken = census.links_broken().or_else(|| findings.broken(&[Rule::L2]));
    if let Some(rule) = broken.filter(|_| !by_record) {
        findings.not_checked(Rule::F2, Unchecked::Broken(rule));
        return Ok(());
    }
    if by_record {
        components_listed(subject, census.list_budget, findings)
    } else {
        cycles_listed(subject, census.list_budget, findings)
    }
}

fn components_listed(subject: Subject<'_>, mut budget: usize, findings: &mut Findings) -> Flow {
    let mut listed = column(subject.extent.boundaries.count, false)?;
    let mut is_cut_short = false;
    for f in subject.faces() {
        if let Some(b) = subject.view.outer(f) {
            check_entry(subject, &mut listed, f, (b, BoundaryPlace::Outer), findings)?;
        }
        let claimed = if subject.has(Part::Holes) { subject.view.inner_count(f) } else { 0 };
        let read = claimed.min(budget);
        budget -= read;
        findings.counts.inner_boundaries += read;
        for i in 0..read {
            if let Some(b) = subject.view.inner(f, i) {
                check_entry(subject, &mut listed, f, (b, BoundaryPlace::Inner(i)), findings)?;
            }
        }
        if read < claimed {
            is_cut_short = true;
            list_not_read(f, claimed, findings)?;
        }
    }
    let mut checked = 0;
    for boundary in subject.boundaries() {
        checked += 1;
        if !listed[boundary] && !is_cut_short {
            let face = subject.view.boundary_face(boundary);
            findings.add(Violation::NotListed { boundary, face })?;
        }
    }
    findings.checked(Rule::F2, checked);
    Ok(())
}

/// Checks one entry of a list. Dangling links are left to R1.
fn check_entry(
    subject: Subject<'_>,
    listed: &mut [bool],
    face: usize,
    (entry, place): (usize, BoundaryPlace),
    findings: &mut Findings,
) -> Flow {
    let Some(boundary) = subject.live_boundary(Some(entry)) else { return Ok(()) };
    if core::mem::replace(&mut listed[boundary], true) {
        findings.add(Violation::ListedTwice { record: Record::Boundary(boundary), face })?;
    }
    let found = subject.view.boundary_face(boundary);
    if found != Some(face) && found.is_some_and(|f| subject.is_face(f)) {
        findings.add(Violation::ListedByOther { boundary, face, found })?;
    }
    if subject.has(Part::Places) {
        let says = subject.view.boundary_place(boundary);
        if says != Some(place) {
            findings.add(Violation::WrongPlace { boundary, place: says, listed: place })?;
        }
    }
    Ok(())
}

fn cycles_listed(subject: Subject<'_>, list_budget: usize, findings: &mut Findings) -> Flow {
    let mut listed = column(subject.extent.half_edges.count, false)?;
    for f in subject.faces() {
        if let Some(h) = subject.view.outer_half_edge(f) {
            list_cycle(subject, &mut listed, f, h, findings)?;
        }
    }
    let mut entries = 0;
    subject.for_each_inner_start(list_budget, |f, _, start| {
        entries += 1;
        match start {
            Start::HalfEdge(h) => list_cycle(subject, &mut listed, f, h, findings),
            Start::Vertex(_) => Ok(()),
        }
    })?;
    findings.counts.inner_boundaries = entries;
    if subject.has(Part::Holes) {
        find_list_not_read(subject, list_budget, entries, findings)?;
    }
    let mut checked = (findings.counts.outer_boundaries + entries) as u64;
    for h in subject.half_edges() {
        let half_edge = h as usize;
        if !listed[half_edge] && subject.view.face(half_edge).is_some() {
            checked += 1;
            findings.add(Violation::CycleNotListed { half_edge })?;
            mark_cycle(subject, &mut listed, h);
        }
    }
    findings.checked(Rule::F2, checked);
    Ok(())
}

/// Records that the rest of a list is unknown. R1 has reported it, unless the list has grown since.
fn list_not_read(face: usize, claimed: usize, findings: &mut Findings) -> Flow {
    findings.not_checked(Rule::F2, Unchecked::ListTooLong);
    if findings.unchecked(Rule::R1).is_none() { list_too_long(face, claimed, findings) } else { Ok(()) }
}

/// Finds the face at which the budget for list entries ran out, if it did.
fn find_list_not_read(subject: Subject<'_>, budget: usize, entries: usize, findings: &mut Findings) -> Flow {
    if entries < budget {
        return Ok(());
    }
    let mut read = 0_usize;
    for f in subject.faces() {
        let claimed = subject.view.inner_count(f);
        read = read.saturating_add(claimed);
        if read > budget {
            return list_not_read(f, claimed, findings);
        }
    }
    Ok(())
}

fn list_cycle(subject: Subject<'_>, listed: &mut [bool], face: usize, h: usize, findings: &mut Findings) -> Flow {
    let Some(h) = subject.live_half_edge(Some(h)) else { return Ok(()) };
    if listed[h] {
        return findings.add(Violation::ListedTwice { record: Record::HalfEdge(h), face });
    }
    mark_cycle(subject, listed, h as u32);
    Ok(())
}

fn mark_cycle(subject: Subject<'_>, listed: &mut [bool], start: u32) {
    let mut h = start;
    while h != NIL && !core::mem::replace(&mut listed[h as usize], true) {
        h = subject.next(h);
    }
}
