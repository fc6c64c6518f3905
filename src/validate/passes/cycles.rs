//! Counts the cycles of each component, for T3: those of `next`, one for each isolated vertex, and one for each border loop
//! that missing twins would make. Cycles of `next` without face are border loops, too.

use crate::validate::columns::{Components, NIL, column};
use crate::validate::findings::{Findings, Flow, Halt};
use crate::validate::rule::Rule;
use crate::validate::rules::borders_broken;
use crate::validate::structure::{Part, Start};
use crate::validate::subject::Subject;

/// Counts the cycles and the border loops of each component, and notes which components are open.
pub(crate) fn count(subject: Subject<'_>, components: &mut Components, findings: &mut Findings) -> Flow {
    let by_record = subject.has(Part::BoundaryComponents) && !subject.is_open();
    let [cycles, without_face] = if by_record && findings.broken(&[Rule::R1, Rule::B1]).is_none() {
        // B1 has shown that boundary components and cycles are the same.
        [boundaries_with_cycle(subject, components), 0]
    } else {
        cycles_of_next(subject, components)?
    };
    for component in &mut components.all {
        if component.paired + component.unpaired == 0 {
            component.cycles += 1;
        }
    }
    let without_twins = if subject.is_open() { borders(subject, components)? } else { 0 };
    enter(subject, [cycles, without_face + without_twins], findings);
    Ok(())
}

/// Enters the numbers of cycles and of border loops, if border loops can be told from other cycles.
pub(crate) fn enter(subject: Subject<'_>, [cycles, borders]: [usize; 2], findings: &mut Findings) {
    if borders_broken(subject, findings).is_none() {
        (findings.counts.cycles, findings.counts.borders) = (Some(cycles), Some(borders));
    }
}

fn boundaries_with_cycle(subject: Subject<'_>, components: &mut Components) -> usize {
    let mut cycles = 0;
    for b in subject.boundaries() {
        let start = subject.view.boundary_start(b).filter(|start| matches!(start, Start::HalfEdge(_)));
        if let Some(c) = subject.component_of_start(components, start) {
            cycles += 1;
            components.all[c].cycles += 1;
        }
    }
    cycles
}

/// Returns how many cycles of `next` are no border loops, and how many are.
fn cycles_of_next(subject: Subject<'_>, components: &mut Components) -> Result<[usize; 2], Halt> {
    let mut seen = column(subject.extent.half_edges.0, false)?;
    let mut cycles = [0, 0];
    for start in subject.half_edges() {
        if seen[start as usize] {
            continue;
        }
        let mut h = start;
        while h != NIL && !core::mem::replace(&mut seen[h as usize], true) {
            h = subject.next(h);
        }
        let is_border = subject.is_open() && subject.lacks_face(start as usize);
        cycles[usize::from(is_border)] += 1;
        if let Some(component) = subject.component_at(components, start) {
            component.cycles += 1;
            component.open |= is_border;
        }
    }
    Ok(cycles)
}

/// Half-edges without twin follow one another around each border loop: where V2 holds, one at most leaves a vertex.
/// Returns how many such loops there are.
fn borders(subject: Subject<'_>, components: &mut Components) -> Result<usize, Halt> {
    let mut border_at = column(subject.extent.vertices.0, NIL)?;
    for h in subject.half_edges().filter(|h| subject.twin(*h) == NIL) {
        if let Some(entry) = border_at.get_mut(subject.origin(h) as usize) {
            *entry = h;
        }
    }
    let mut borders = 0;
    for v in 0..border_at.len() {
        let mut h = core::mem::replace(&mut border_at[v], NIL);
        if h == NIL {
            continue;
        }
        borders += 1;
        if let Some(component) = subject.component_at(components, h) {
            component.cycles += 1;
        }
        while h != NIL {
            let target = subject.target_by_next(h);
            h = border_at.get_mut(target as usize).map_or(NIL, |entry| core::mem::replace(entry, NIL));
        }
    }
    Ok(borders)
}
