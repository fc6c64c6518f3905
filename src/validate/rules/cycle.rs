//! B1 cycle: the boundary component is constant along `next`, its start is on its own cycle, and it has one cycle.
//!
//! ```text
//!   ┌──► 4 ──► 4 ──► 4 ──┐ start of 4
//!   └────────────────────┘
//!   component 4 all along the cycle, and no other cycle of component 4
//! ```
//!
//! Without records for boundary components: the face is constant along `next`, and a face keeps half-edges of its own.

use crate::validate::columns::{NIL, column};
use crate::validate::expectation::Part;
use crate::validate::findings::{Flow, Halt};
use crate::validate::report::Unchecked;
use crate::validate::rule::Rule;
use crate::validate::run::Run;
use crate::validate::view::{Start, View};
use crate::validate::violation::Violation;
use alloc::vec::Vec;

/// Runs B1.
pub(in crate::validate) fn check<V: View + ?Sized>(run: &mut Run<'_, V>) -> Flow {
    if !run.expect.has(Part::Faces) {
        run.findings.not_checked(Rule::B1, Unchecked::Lacks(Part::Faces));
        return Ok(());
    }
    if run.known.lists.is_some_and(|lists| lists.walked) {
        run.findings.checked(Rule::B1, run.counts.half_edges as u64);
        if run.expect.has(Part::BoundaryComponents) {
            not_walked(run);
        }
        return Ok(());
    }
    if run.expect.has(Part::BoundaryComponents) {
        constant_along_next(run)?;
        components_have_one_cycle(run)
    } else {
        cycles_have_one_face(run)
    }
}

/// Per boundary component, how many half-edges name it.
fn sizes<V: View + ?Sized>(run: &Run<'_, V>) -> Result<Vec<u32>, Halt> {
    let mut sizes = column(run.boundaries, 0)?;
    for h in (0..run.half_edges).filter(|h| run.live_half_edge(*h)) {
        if let Some(size) = sizes.get_mut(run.boundary(h) as usize) {
            *size += 1;
        }
    }
    Ok(sizes)
}

fn constant_along_next<V: View + ?Sized>(run: &mut Run<'_, V>) -> Flow {
    let mut checked = run.beyond_doubt() as u64;
    for i in 0..run.in_doubt() {
        let Some(h) = run.doubtful(i) else { continue };
        let (b, n) = (run.boundary(h), run.next(h));
        if !run.live_half_edge(n) {
            continue;
        }
        checked += 1;
        let of_next = run.boundary(n);
        if b == of_next {
            continue;
        }
        let (boundary, found) = (run.view.boundary(h as usize), run.view.boundary(n as usize));
        // What dangles is left to R1; nil meets something else only at an open boundary.
        let dangles = [(boundary, b), (found, of_next)].iter().any(|(link, slot)| link.is_some() && *slot == NIL);
        let needed = !run.expect.is_open() && (boundary.is_none() || found.is_none());
        if !dangles && !needed {
            let (half_edge, next) = (h as usize, n as usize);
            run.findings.add(Violation::BoundaryChanges { half_edge, next, boundary, found })?;
        }
    }
    run.findings.checked(Rule::B1, checked);
    Ok(())
}

fn components_have_one_cycle<V: View + ?Sized>(run: &mut Run<'_, V>) -> Flow {
    let constant_along_next = run.findings.holds(Rule::B1);
    let walkable = run.map_is_live && run.findings.holds(Rule::L2) && constant_along_next;
    // Where each start is known to name its own, those that start at a vertex are left.
    if walkable || run.known.lists.is_none_or(|lists| lists.at_vertex > 0) {
        starts_and_sizes(run, walkable)?;
    }
    if constant_along_next {
        not_walked(run);
    }
    Ok(())
}

/// Checks that each start names its own boundary component, and where `walkable`, that its cycle has all half-edges that do.
fn starts_and_sizes<V: View + ?Sized>(run: &mut Run<'_, V>, walkable: bool) -> Flow {
    let sizes = sizes(run)?;
    for b in 0..run.boundaries {
        if !run.live_boundary(b) {
            continue;
        }
        let Some(Start::HalfEdge(start)) = run.view.boundary_start(b as usize) else {
            continue;
        };
        if start >= run.half_edges as usize || !run.view.is_half_edge(start) {
            continue;
        }
        if run.boundary(start as u32) != b {
            run.findings.add(Violation::StartElsewhere {
                boundary: b as usize,
                half_edge: start,
                found: run.view.boundary(start),
            })?;
        } else if walkable {
            let half_edges = sizes[b as usize];
            let cycle = cycle_length(run, start as u32, half_edges);
            if cycle < half_edges {
                second_cycle(run, b, cycle, half_edges)?;
            }
        }
    }
    // A component that starts at a vertex has no half-edges of its own.
    for b in 0..run.boundaries {
        let half_edges = sizes[b as usize];
        if half_edges == 0 || !run.live_boundary(b) {
            continue;
        }
        if let Some(Start::Vertex(_)) = run.view.boundary_start(b as usize) {
            second_cycle(run, b, 0, half_edges)?;
        }
    }
    Ok(())
}

/// Notes that no cycle can be walked along, if so.
fn not_walked<V: View + ?Sized>(run: &mut Run<'_, V>) {
    if !run.map_is_live {
        run.findings.not_checked(Rule::B1, Unchecked::Broken(Rule::R1));
    } else if !run.findings.holds(Rule::L2) {
        run.findings.not_checked(Rule::B1, Unchecked::Broken(Rule::L2));
    }
}

fn second_cycle<V: View + ?Sized>(run: &mut Run<'_, V>, b: u32, cycle: u32, half_edges: u32) -> Flow {
    let (boundary, cycle, half_edges) = (b as usize, cycle as usize, half_edges as usize);
    run.findings.add(Violation::SecondCycle { boundary, cycle, half_edges })
}

/// The length of the cycle through `start`, walking no further than `limit`.
fn cycle_length<V: View + ?Sized>(run: &Run<'_, V>, start: u32, limit: u32) -> u32 {
    let mut length = 0;
    let mut h = start;
    while h != NIL && length < limit {
        length += 1;
        h = run.next(h);
        if h == start {
            break;
        }
    }
    length
}

fn cycles_have_one_face<V: View + ?Sized>(run: &mut Run<'_, V>) -> Flow {
    let mut checked = run.beyond_doubt() as u64;
    for i in 0..run.in_doubt() {
        let Some(h) = run.doubtful(i).map(|h| h as usize) else { continue };
        let n = run.next(h as u32);
        if !run.live_half_edge(n) {
            continue;
        }
        checked += 1;
        let (face, found) = (run.view.face(h), run.view.face(n as usize));
        if face != found && run.is_sound_face_link(face) && run.is_sound_face_link(found) {
            run.findings.add(Violation::FaceChanges { half_edge: h, next: n as usize, face, found })?;
        }
    }
    run.findings.checked(Rule::B1, checked);
    // What the faces list is known to name them.
    if run.known.lists.is_some() {
        return Ok(());
    }
    for f in 0..run.faces as usize {
        if !run.view.is_face(f) {
            continue;
        }
        if let Some(h) = run.view.outer_half_edge(f) {
            names_its_face(run, f, h)?;
        }
    }
    run.for_each_inner_start(|run, f, _, start| match start {
        Start::HalfEdge(h) => names_its_face(run, f, h),
        Start::Vertex(_) => Ok(()),
    })
}

/// Checks that a half-edge that a face lists names that face.
fn names_its_face<V: View + ?Sized>(run: &mut Run<'_, V>, f: usize, h: usize) -> Flow {
    if h >= run.half_edges as usize || !run.view.is_half_edge(h) {
        return Ok(());
    }
    let found = run.view.face(h);
    if found == Some(f) || !run.is_sound_face_link(found) {
        return Ok(());
    }
    run.findings.add(Violation::ListedElsewhere { face: f, half_edge: h, found })
}
