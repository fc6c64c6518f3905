//! Counts the cycles of each component, for T3: those of `next`, one for each isolated vertex, and one for each border loop
//! that missing twins would make. Cycles of `next` without face are border loops, too.

use crate::validate::columns::{Components, NIL, column};
use crate::validate::expectation::Part;
use crate::validate::findings::{Flow, Halt};
use crate::validate::rule::Rule;
use crate::validate::run::Run;
use crate::validate::view::{Start, View};

/// Counts the cycles and the border loops of each component, and notes which components are open.
pub(in crate::validate) fn count<V: View + ?Sized>(run: &mut Run<'_, V>, components: &mut Components) -> Flow {
    if let Some(known) = &run.known.whole {
        if run.borders_broken().is_none() {
            run.counts.cycles = Some(known.cycles);
            run.counts.borders = Some(known.borders);
        }
        return Ok(());
    }
    let by_record = run.expect.has(Part::BoundaryComponents) && !run.expect.is_open();
    let [cycles, without_face] = if by_record && run.findings.broken(&[Rule::R1, Rule::B1]).is_none() {
        // B1 has shown that boundary components and cycles are the same.
        [boundaries_with_cycle(run, components), 0]
    } else {
        cycles_of_next(run, components)?
    };
    for component in &mut components.all {
        if component.paired + component.unpaired == 0 {
            component.cycles += 1;
        }
    }
    let without_twins = if run.expect.is_open() { borders(run, components)? } else { 0 };
    if run.borders_broken().is_none() {
        run.counts.cycles = Some(cycles);
        run.counts.borders = Some(without_face + without_twins);
    }
    Ok(())
}

fn boundaries_with_cycle<V: View + ?Sized>(run: &Run<'_, V>, components: &mut Components) -> usize {
    let mut cycles = 0;
    for b in 0..run.boundaries {
        if !run.live_boundary(b) {
            continue;
        }
        let start = run.view.boundary_start(b as usize).filter(|start| matches!(start, Start::HalfEdge(_)));
        if let Some(c) = run.component_of_start(components, start) {
            cycles += 1;
            components.all[c].cycles += 1;
        }
    }
    cycles
}

/// Returns how many cycles of `next` are no border loops, and how many are.
fn cycles_of_next<V: View + ?Sized>(run: &Run<'_, V>, components: &mut Components) -> Result<[usize; 2], Halt> {
    let mut seen = column(run.half_edges, false)?;
    let mut cycles = [0, 0];
    for start in 0..run.half_edges {
        if seen[start as usize] || !run.live_half_edge(start) {
            continue;
        }
        let mut h = start;
        while h != NIL && !seen[h as usize] {
            seen[h as usize] = true;
            h = run.next(h);
        }
        let is_border = run.expect.is_open() && run.lacks_face(start as usize);
        cycles[usize::from(is_border)] += 1;
        if let Some(component) = run.component_at(components, start) {
            component.cycles += 1;
            component.open |= is_border;
        }
    }
    Ok(cycles)
}

/// Half-edges without twin follow one another around each border loop: where V2 holds, one at most leaves a vertex.
/// Returns how many such loops there are.
fn borders<V: View + ?Sized>(run: &Run<'_, V>, components: &mut Components) -> Result<usize, Halt> {
    let mut border_at = column(run.vertices, NIL)?;
    for h in 0..run.half_edges {
        if !run.live_half_edge(h) || run.twin(h) != NIL {
            continue;
        }
        if let Some(entry) = border_at.get_mut(run.origin(h) as usize) {
            *entry = h;
        }
    }
    let mut borders = 0;
    for v in 0..run.vertices as usize {
        let mut h = core::mem::replace(&mut border_at[v], NIL);
        if h == NIL {
            continue;
        }
        borders += 1;
        if let Some(component) = run.component_at(components, h) {
            component.cycles += 1;
        }
        while h != NIL {
            let target = run.target_by_next(h);
            h = border_at.get_mut(target as usize).map_or(NIL, |entry| core::mem::replace(entry, NIL));
        }
    }
    Ok(borders)
}
