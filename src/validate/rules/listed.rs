//! F2 listed: every boundary component is listed exactly once, by the face it names, at the place it says.
//!
//! Without records for boundary components: each cycle with a face is listed exactly once. That the face that lists it is
//! its own is part of B1.

use super::live::{Census, list_too_long};
use crate::validate::columns::{NIL, column};
use crate::validate::fast_path::Facts;
use crate::validate::findings::{Findings, Flow};
use crate::validate::report::{Record, Unchecked, Violation};
use crate::validate::rule::Rule;
use crate::validate::structure::{BoundaryPlace, Part, Start};
use crate::validate::subject::Subject;

/// Runs F2, and counts the inner boundary components.
pub(crate) fn check(subject: Subject<'_>, facts: &Facts, census: &Census, findings: &mut Findings) -> Flow {
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
    if let Some(lists) = facts.lists {
        findings.counts.inner_boundaries = lists.inner;
        findings.checked(Rule::F2, (lists.outer + lists.inner) as u64);
        return Ok(());
    }
    if by_record {
        components_listed(subject, census.list_budget, findings)
    } else {
        cycles_listed(subject, census.list_budget, findings)
    }
}

fn components_listed(subject: Subject<'_>, mut budget: usize, findings: &mut Findings) -> Flow {
    let mut listed = column(subject.extent.boundaries.0, false)?;
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

/// Checks one entry of a list. What dangles is left to R1.
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
    let is_live = |f: usize| subject.extent.faces.has(f) && subject.view.is_face(f);
    if found != Some(face) && found.is_some_and(is_live) {
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
    let mut listed = column(subject.extent.half_edges.0, false)?;
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

/// Notes that the rest of a list is not known. R1 has reported it, unless the list has grown since.
fn list_not_read(face: usize, claimed: usize, findings: &mut Findings) -> Flow {
    findings.not_checked(Rule::F2, Unchecked::ListTooLong);
    if findings.unchecked(Rule::R1).is_none() { list_too_long(face, claimed, findings) } else { Ok(()) }
}

/// Finds the face at which the budget for list entries was spent, if it was.
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
