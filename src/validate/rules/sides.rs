//! M3 sides: every bounded face has the expected number of sides.
//!
//! Checked if asked for. The sides of a face are all half-edges that bound it; without faces, they are those of a cycle.

use super::live::Census;
use super::passes_over;
use crate::validate::columns::{NIL, column};
use crate::validate::findings::{Findings, Flow};
use crate::validate::report::{Record, Violation};
use crate::validate::rule::Rule;
use crate::validate::structure::Part;
use crate::validate::subject::Subject;

/// Runs M3, which needs closed cycles, each with one face.
pub(crate) fn check(subject: Subject<'_>, census: &Census, findings: &mut Findings) -> Flow {
    let has_faces = subject.has(Part::Faces);
    let below: &[Rule] = if has_faces { &[Rule::R1, Rule::L2, Rule::B1, Rule::F1] } else { &[Rule::L2] };
    let broken = census.links_broken().or_else(|| findings.broken(below));
    if passes_over(subject, Rule::M3, broken, findings) {
        return Ok(());
    }
    if has_faces { faces(subject, findings) } else { cycles(subject, findings) }
}

/// One face, or one cycle.
fn one(subject: Subject<'_>, record: Record, sides: u32, findings: &mut Findings) -> Flow {
    findings.checked(Rule::M3, 1);
    let sides = sides as usize;
    match subject.extent.expect.expected_count(Rule::M3) {
        Some(expected) if sides != expected => findings.add(Violation::WrongSides { record, sides, expected }),
        _ => Ok(()),
    }
}

fn faces(subject: Subject<'_>, findings: &mut Findings) -> Flow {
    let by_record = subject.has(Part::BoundaryComponents);
    let mut sides = column(subject.extent.faces.0, 0)?;
    for h in subject.half_edges() {
        let name = subject.extent.name(subject.view, h as usize);
        let face = if by_record {
            subject.extent.boundaries.existing(name).and_then(|b| subject.view.boundary_face(b))
        } else {
            name
        };
        if let Some(sides) = face.and_then(|f| sides.get_mut(f)) {
            *sides += 1;
        }
    }
    for f in subject.faces().filter(|f| subject.outer(*f).is_some()) {
        one(subject, Record::Face(f), sides[f], findings)?;
    }
    Ok(())
}

fn cycles(subject: Subject<'_>, findings: &mut Findings) -> Flow {
    let mut seen = column(subject.extent.half_edges.0, false)?;
    for start in subject.half_edges() {
        let (mut h, mut sides) = (start, 0);
        while h != NIL && !core::mem::replace(&mut seen[h as usize], true) {
            sides += 1;
            h = subject.next(h);
        }
        if sides > 0 {
            one(subject, Record::HalfEdge(start as usize), sides, findings)?;
        }
    }
    Ok(())
}
