//! M3 sides: every bounded face has the expected number of sides.
//!
//! ```text
//!   ·──────·
//!   │    ╱  ╲    a triangle and a quadrilateral
//!   │  ╱     ╲
//!   ·────·────·
//! ```
//!
//! Checked if asked for. The sides of a face are all half-edges that bound it; without faces, they are those of a cycle.

use crate::validate::columns::{NIL, column};
use crate::validate::expectation::Part;
use crate::validate::findings::Flow;
use crate::validate::record::Record;
use crate::validate::rule::Rule;
use crate::validate::run::Run;
use crate::validate::view::View;
use crate::validate::violation::Violation;

/// Runs M3, which needs closed cycles, each with one face.
pub(in crate::validate) fn check<V: View + ?Sized>(run: &mut Run<'_, V>) -> Flow {
    let live = if run.map_is_live { None } else { Some(Rule::R1) };
    let broken = live.or_else(|| {
        let with_faces = run.expect.has(Part::Faces);
        let below: &[Rule] = if with_faces { &[Rule::R1, Rule::L2, Rule::B1, Rule::F1] } else { &[Rule::L2] };
        run.findings.broken(below)
    });
    if run.passes_over(Rule::M3, broken) {
        return Ok(());
    }
    if run.expect.has(Part::Faces) { faces(run) } else { cycles(run) }
}

/// One face, or one cycle.
fn one<V: View + ?Sized>(run: &mut Run<'_, V>, record: Record, sides: u32) -> Flow {
    run.findings.checked(Rule::M3, 1);
    let sides = sides as usize;
    match run.expect.expected_count(Rule::M3) {
        Some(expected) if sides != expected => run.findings.add(Violation::WrongSides { record, sides, expected }),
        _ => Ok(()),
    }
}

fn faces<V: View + ?Sized>(run: &mut Run<'_, V>) -> Flow {
    let by_record = run.expect.has(Part::BoundaryComponents);
    let mut sides = column(run.faces, 0)?;
    for h in (0..run.half_edges).filter(|h| run.live_half_edge(*h)) {
        let face = if by_record {
            let boundary = Some(run.boundary(h)).filter(|b| *b != NIL);
            boundary.and_then(|b| run.view.boundary_face(b as usize))
        } else {
            run.view.face(h as usize)
        };
        if let Some(sides) = face.and_then(|f| sides.get_mut(f)) {
            *sides += 1;
        }
    }
    for (f, sides) in sides.into_iter().enumerate() {
        let outer = |f| if by_record { run.view.outer(f) } else { run.view.outer_half_edge(f) };
        if run.view.is_face(f) && outer(f).is_some() {
            one(run, Record::Face(f), sides)?;
        }
    }
    Ok(())
}

fn cycles<V: View + ?Sized>(run: &mut Run<'_, V>) -> Flow {
    let mut seen = column(run.half_edges, false)?;
    for start in 0..run.half_edges {
        if seen[start as usize] || !run.live_half_edge(start) {
            continue;
        }
        let (mut h, mut sides) = (start, 0);
        while h != NIL && !core::mem::replace(&mut seen[h as usize], true) {
            sides += 1;
            h = run.next(h);
        }
        one(run, Record::HalfEdge(start as usize), sides)?;
    }
    Ok(())
}
