//! T1 … T4: containment and Euler's formula, and the required counts of cycles.

use crate::numbers::NIL;
use crate::validate::findings::{Findings, Flow, Halt};
use crate::validate::half_edges::HalfEdges;
use crate::validate::report::{Bounds, Record, Unchecked, Violation};
use crate::validate::rule::Rule;
use crate::validate::structure::{Part, Start, View};
use crate::validate::subject::{Components, Subject, column};
use alloc::vec::Vec;

/// Counts the cycles of each component for T3, and records which components are open.
///
/// Counts the cycles of `next`, one cycle for each isolated vertex, and one for each border loop that missing twins would
/// form. Cycles of `next` without face are also border loops.
pub(crate) fn count_cycles(
    subject: Subject<'_>,
    half_edges: impl HalfEdges,
    components: &mut Components,
    findings: &mut Findings,
) -> Flow {
    let by_record = subject.has(Part::BoundaryComponents) && !subject.is_open();
    let [cycles, without_face] = if by_record && findings.broken(&[Rule::R1, Rule::B1]).is_none() {
        // B1 has shown that boundary components correspond to cycles.
        [boundaries_with_cycle(subject, components), 0]
    } else {
        cycles_of_next(subject, half_edges, components)?
    };
    for component in &mut components.all {
        if component.paired + component.unpaired == 0 {
            component.cycles += 1;
        }
    }
    let without_twins = if subject.is_open() { borders(subject, components)? } else { 0 };
    if borders_broken(subject, findings).is_none() {
        (findings.counts.cycles, findings.counts.borders) = (Some(cycles), Some(without_face + without_twins));
    }
    Ok(())
}

fn boundaries_with_cycle(subject: Subject<'_>, components: &mut Components) -> usize {
    let mut cycles = 0;
    for b in subject.boundaries() {
        let start = subject.view.boundary_start(b).filter(|start| matches!(start, Start::HalfEdge(_)));
        if let Some(c) = subject.component_of_start(&components.of, start) {
            cycles += 1;
            components.all[c].cycles += 1;
        }
    }
    cycles
}

/// Returns the number of cycles of `next` that are not border loops, and the number of border loops among them.
fn cycles_of_next(
    subject: Subject<'_>,
    half_edges: impl HalfEdges,
    components: &mut Components,
) -> Result<[usize; 2], Halt> {
    let mut seen = column(subject.extent.half_edges.count, false)?;
    let mut cycles = [0, 0];
    for start in subject.half_edges() {
        if seen[start as usize] {
            continue;
        }
        let mut h = start;
        while let Some(false) = seen.get_mut(h as usize).map(|seen| core::mem::replace(seen, true)) {
            h = half_edges.next(h);
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

/// Returns the number of border loops of half-edges without twin. Where V2 holds, at most one such half-edge leaves a vertex,
/// so they follow one another.
fn borders(subject: Subject<'_>, components: &mut Components) -> Result<usize, Halt> {
    let mut border_at = column(subject.extent.vertices.count, NIL)?;
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

/// Returns the rule that ensures that the half-edges of a cycle either have one face or bound nothing, if it is broken: then
/// border loops at an open boundary cannot be recognised.
pub(crate) fn borders_broken(subject: Subject<'_>, findings: &Findings) -> Option<Rule> {
    if subject.is_open() { findings.broken(&[Rule::B1]) } else { None }
}

/// Returns the reason why T1 and T2 cannot be checked, if any.
fn containment_unchecked(subject: Subject<'_>, findings: &Findings) -> Option<Unchecked> {
    if !subject.has(Part::Holes) {
        return Some(Unchecked::Lacks(Part::Holes));
    }
    let below = [Rule::R1, Rule::V1, Rule::B1, Rule::B2, Rule::F1, Rule::F2];
    findings.broken(&below).map(Unchecked::Broken)
}

/// T1 outside: each component has exactly one inner boundary component, its outside.
///
/// Returns the face in which each component lies, or nil.
pub(crate) fn outside(
    subject: Subject<'_>,
    components: &Components,
    list_budget: usize,
    findings: &mut Findings,
) -> Result<Vec<u32>, Halt> {
    if let Some(why) = containment_unchecked(subject, findings) {
        findings.not_checked(Rule::T1, why);
        return Ok(Vec::new());
    }
    let count = components.all.len();
    let mut lies_in = column(count as u32, NIL)?;
    let mut outside: Vec<Option<Record>> = column(count as u32, None)?;
    let mut budget = list_budget;
    for f in subject.faces() {
        let listed = subject.view.inner_count(f).min(budget);
        budget -= listed;
        for i in 0..listed {
            let (start, record) = inner(subject, f, i);
            let (Some(c), Some(second)) = (subject.component_of_start(&components.of, start), record) else { continue };
            if let Some(first) = outside[c] {
                let vertex = components.all[c].vertex as usize;
                findings.add(Violation::TwoOutsides { vertex, first, second })?;
            } else {
                (outside[c], lies_in[c]) = (record, f as u32);
            }
        }
    }
    findings.checked(Rule::T1, count as u64);
    // A component in an unbounded face without a record has no inner boundary component.
    if subject.has(Part::UnboundedFace) {
        for (component, outside) in components.all.iter().zip(&outside) {
            if outside.is_none() && !component.open {
                findings.add(Violation::NoOutside { vertex: component.vertex as usize })?;
            }
        }
    }
    Ok(lies_in)
}

/// Returns the start of the inner boundary component at this position, and the record that names it in reports.
fn inner(subject: Subject<'_>, f: usize, i: usize) -> (Option<Start>, Option<Record>) {
    if subject.has(Part::BoundaryComponents) {
        let b = subject.extent.boundaries.existing(subject.view.inner(f, i));
        return (b.and_then(|b| subject.view.boundary_start(b)), b.map(Record::Boundary));
    }
    let start = subject.view.inner_start(f, i);
    let record = start.map(|start| match start {
        Start::HalfEdge(h) => Record::HalfEdge(h),
        Start::Vertex(v) => Record::Vertex(v),
    });
    (start, record)
}

/// T2 nesting: containment is a tree rooted at the unbounded face.
pub(crate) fn nesting(subject: Subject<'_>, components: &Components, lies_in: &[u32], findings: &mut Findings) -> Flow {
    let why = containment_unchecked(subject, findings);
    if let Some(why) = why.or_else(|| findings.broken(&[Rule::T1]).map(Unchecked::Broken)) {
        findings.not_checked(Rule::T2, why);
        return Ok(());
    }
    each_nested_in_itself(subject, &components.of, lies_in, |c, face| {
        findings.add(Violation::NestedInItself { vertex: components.all[c].vertex as usize, face })
    })?;
    findings.checked(Rule::T2, components.all.len() as u64);
    Ok(())
}

/// Calls `visit` with one component of each loop of containment, and the face in which it lies.
///
/// Walks from each component outwards, to the unbounded face or a component that was passed before.
pub(crate) fn each_nested_in_itself<V: View + ?Sized>(
    subject: Subject<'_, V>,
    of: &[u32],
    lies_in: &[u32],
    mut visit: impl FnMut(usize, usize) -> Flow,
) -> Flow {
    let count = lies_in.len() as u32;
    // The round in which a component was first passed; all earlier rounds ended well or were reported.
    let mut passed = column(count, NIL)?;
    for first in 0..count {
        let mut c = first as usize;
        loop {
            match passed[c] {
                NIL => passed[c] = first,
                round if round == first => {
                    visit(c, lies_in[c] as usize)?;
                    break;
                }
                _ => break,
            }
            match container(subject, of, lies_in[c]) {
                Some(outer) => c = outer,
                None => break,
            }
        }
    }
    Ok(())
}

/// Returns the component whose outer boundary component bounds this face; `None` for the unbounded face.
fn container<V: View + ?Sized>(subject: Subject<'_, V>, of: &[u32], face: u32) -> Option<usize> {
    let face = subject.extent.faces.existing(Some(face as usize))?;
    subject.component_of_start(of, subject.outer_start(face))
}

/// T3 Euler: per component `V − E + cycles = 2 − 2g`, with `g = 0` in the plane.
///
/// Adds up the genus.
pub(crate) fn euler(subject: Subject<'_>, components: &Components, findings: &mut Findings) -> Flow {
    let mut total = 0;
    for component in &components.all {
        let vertex = component.vertex as usize;
        let (vertices, edges, cycles) = (component.vertices as usize, component.edges(), component.cycles as usize);
        let handles = (2 + edges).checked_sub(vertices + cycles);
        match handles {
            Some(twice) if twice % 2 == 0 => {
                let genus = twice / 2;
                total += genus;
                if genus > 0 && subject.extent.is_plane() {
                    findings.add(Violation::Genus { vertex, vertices, edges, cycles, genus })?;
                }
            }
            _ => findings.add(Violation::NoSuchSurface { vertex, vertices, edges, cycles })?,
        }
    }
    findings.checked(Rule::T3, components.all.len() as u64);
    findings.counts.genus = Some(total);
    Ok(())
}

/// T4 bounds: a simple map with `V ≥ 3` has `E ≤ 3V − 6` and `F ≤ 2V − 4`.
///
/// Follows from the rules before it, so it cross-checks the counting.
pub(crate) fn bounds(is_simple: bool, findings: &mut Findings) -> Flow {
    let (vertices, edges, faces) = (findings.counts.vertices, findings.counts.edges, findings.counts.faces);
    if !is_simple || vertices < 3 {
        findings.not_checked(Rule::T4, Unchecked::NotSimple);
        return Ok(());
    }
    let most = Bounds { most_edges: 3 * vertices - 6, most_faces: 2 * vertices - 4 };
    findings.checked(Rule::T4, 1);
    if edges > most.most_edges {
        findings.add(Violation::TooManyEdges { vertices, edges })?;
    }
    if faces > most.most_faces {
        findings.add(Violation::TooManyFaces { vertices, faces })?;
    }
    findings.bounds = Some(most);
    Ok(())
}
