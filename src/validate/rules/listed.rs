//! F2 listed: every boundary component is listed exactly once, by the face it names, at the place it says.
//!
//! ```text
//!   face 2 ── outer ───► component 5 ── face ──► 2, place: outer
//!          └─ inner[0] ► component 8 ── face ──► 2, place: inner 0
//! ```
//!
//! Without records for boundary components: each cycle with a face is listed exactly once. That the face that lists it is
//! its own is part of B1.

use crate::validate::columns::{NIL, column};
use crate::validate::expectation::Part;
use crate::validate::findings::Flow;
use crate::validate::record::Record;
use crate::validate::report::Unchecked;
use crate::validate::rule::Rule;
use crate::validate::run::Run;
use crate::validate::view::{BoundaryPlace, Start, View};
use crate::validate::violation::Violation;

/// Runs F2, and counts the inner boundary components.
pub(in crate::validate) fn check<V: View + ?Sized>(run: &mut Run<'_, V>) -> Flow {
    if !run.expect.has(Part::Faces) {
        run.findings.not_checked(Rule::F2, Unchecked::Lacks(Part::Faces));
        return Ok(());
    }
    let by_record = run.expect.has(Part::BoundaryComponents);
    let broken = if run.map_is_live { run.findings.broken(&[Rule::L2]) } else { Some(Rule::R1) };
    if let Some(rule) = broken.filter(|_| !by_record) {
        run.findings.not_checked(Rule::F2, Unchecked::Broken(rule));
        return Ok(());
    }
    if let Some(lists) = run.known.lists {
        run.counts.inner_boundaries = lists.inner;
        run.findings.checked(Rule::F2, (lists.outer + lists.inner) as u64);
        return Ok(());
    }
    if by_record { components_listed(run) } else { cycles_listed(run) }
}

fn components_listed<V: View + ?Sized>(run: &mut Run<'_, V>) -> Flow {
    let mut listed = column(run.boundaries, false)?;
    let mut budget = run.list_budget;
    let mut cut_short = false;
    for f in 0..run.faces as usize {
        if !run.view.is_face(f) {
            continue;
        }
        if let Some(b) = run.view.outer(f) {
            check_entry(run, &mut listed, f, b, BoundaryPlace::Outer)?;
        }
        if !run.expect.has(Part::Holes) {
            continue;
        }
        let claimed = run.view.inner_count(f);
        let read = claimed.min(budget);
        budget -= read;
        run.counts.inner_boundaries += read;
        for i in 0..read {
            if let Some(b) = run.view.inner(f, i) {
                check_entry(run, &mut listed, f, b, BoundaryPlace::Inner(i))?;
            }
        }
        if read < claimed {
            cut_short = true;
            list_not_read(run, f, claimed)?;
        }
    }
    let mut checked = 0;
    for (b, listed) in listed.into_iter().enumerate() {
        if !run.view.is_boundary(b) {
            continue;
        }
        checked += 1;
        if !listed && !cut_short {
            let face = run.view.boundary_face(b);
            run.findings.add(Violation::NotListed { boundary: b, face })?;
        }
    }
    run.findings.checked(Rule::F2, checked);
    Ok(())
}

/// Checks one entry of a list. What dangles is left to R1.
fn check_entry<V: View + ?Sized>(
    run: &mut Run<'_, V>,
    listed: &mut [bool],
    f: usize,
    b: usize,
    place: BoundaryPlace,
) -> Flow {
    if b >= listed.len() || !run.view.is_boundary(b) {
        return Ok(());
    }
    if core::mem::replace(&mut listed[b], true) {
        run.findings.add(Violation::ListedTwice { record: Record::Boundary(b), face: f })?;
    }
    let names = run.view.boundary_face(b);
    if names != Some(f) && names.is_some_and(|g| g < run.faces as usize && run.view.is_face(g)) {
        run.findings.add(Violation::ListedByOther { boundary: b, face: f, found: names })?;
    }
    if run.expect.has(Part::Places) {
        let says = run.view.boundary_place(b);
        if says != Some(place) {
            run.findings.add(Violation::WrongPlace { boundary: b, place: says, listed: place })?;
        }
    }
    Ok(())
}

fn cycles_listed<V: View + ?Sized>(run: &mut Run<'_, V>) -> Flow {
    let mut listed = column(run.half_edges, false)?;
    for f in 0..run.faces as usize {
        if !run.view.is_face(f) {
            continue;
        }
        if let Some(h) = run.view.outer_half_edge(f) {
            list_cycle(run, &mut listed, f, h)?;
        }
    }
    let mut entries = 0;
    run.for_each_inner_start(|run, f, _, start| {
        entries += 1;
        match start {
            Start::HalfEdge(h) => list_cycle(run, &mut listed, f, h),
            Start::Vertex(_) => Ok(()),
        }
    })?;
    run.counts.inner_boundaries = entries;
    if run.expect.has(Part::Holes) {
        find_list_not_read(run, entries)?;
    }
    let mut checked = (run.counts.outer_boundaries + entries) as u64;
    for h in 0..run.half_edges {
        if listed[h as usize] || !run.live_half_edge(h) || run.view.face(h as usize).is_none() {
            continue;
        }
        checked += 1;
        run.findings.add(Violation::CycleNotListed { half_edge: h as usize })?;
        mark_cycle(run, &mut listed, h);
    }
    run.findings.checked(Rule::F2, checked);
    Ok(())
}

/// Notes that the rest of a list is not known. R1 has reported it, unless the list has grown since.
fn list_not_read<V: View + ?Sized>(run: &mut Run<'_, V>, face: usize, claimed: usize) -> Flow {
    run.findings.not_checked(Rule::F2, Unchecked::ListTooLong);
    if run.findings.unchecked(Rule::R1).is_none() { run.list_too_long(face, claimed) } else { Ok(()) }
}

/// Finds the face at which the budget for list entries was spent, if it was.
fn find_list_not_read<V: View + ?Sized>(run: &mut Run<'_, V>, entries: usize) -> Flow {
    if entries < run.list_budget {
        return Ok(());
    }
    let mut read = 0_usize;
    for f in 0..run.faces as usize {
        if !run.view.is_face(f) {
            continue;
        }
        let claimed = run.view.inner_count(f);
        read = read.saturating_add(claimed);
        if read > run.list_budget {
            return list_not_read(run, f, claimed);
        }
    }
    Ok(())
}

fn list_cycle<V: View + ?Sized>(run: &mut Run<'_, V>, listed: &mut [bool], f: usize, h: usize) -> Flow {
    if h >= listed.len() || !run.view.is_half_edge(h) {
        return Ok(());
    }
    if listed[h] {
        return run.findings.add(Violation::ListedTwice { record: Record::HalfEdge(h), face: f });
    }
    mark_cycle(run, listed, h as u32);
    Ok(())
}

fn mark_cycle<V: View + ?Sized>(run: &Run<'_, V>, listed: &mut [bool], start: u32) {
    let mut h = start;
    while h != NIL && !listed[h as usize] {
        listed[h as usize] = true;
        h = run.next(h);
    }
}
