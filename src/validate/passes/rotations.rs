//! One walk around every vertex, for V2, which finds the components on the way.

use crate::validate::columns::{Component, Components, Fan, NIL, column};
use crate::validate::findings::{Flow, Halt};
use crate::validate::report::Unchecked;
use crate::validate::rule::Rule;
use crate::validate::rules::rotation;
use crate::validate::run::Run;
use crate::validate::view::View;
use alloc::vec::Vec;

/// Runs V2, and finds the components. Vertices are visited in the order in which they are found, which causes by far the
/// fewest cache misses where neighbours have close numbers.
pub(in crate::validate) fn check<V: View + ?Sized>(run: &mut Run<'_, V>) -> Flow {
    if let Some(rule) = run.map_broken() {
        run.findings.not_checked(Rule::V2, Unchecked::Broken(rule));
        return Ok(());
    }
    if run.known.rotations_hold() {
        run.findings.checked(Rule::V2, (run.counts.vertices - run.counts.isolated_vertices) as u64);
        return Ok(());
    }
    find(run)?;
    run.findings.checked(Rule::V2, (run.counts.vertices - run.counts.isolated_vertices) as u64);
    Ok(())
}

/// Walks around all vertices.
pub(in crate::validate) fn find<V: View + ?Sized>(run: &mut Run<'_, V>) -> Flow {
    run.count_fans()?;
    run.derive_prev()?;
    let mut of = column(run.vertices, NIL)?;
    // The last vertex from which a vertex was seen as a neighbour: seen twice from one means parallel edges.
    let mut seen_from = column(run.vertices, NIL)?;
    let mut found: Vec<u32> = Vec::new();
    let mut visited = 0;
    found.try_reserve_exact(run.vertices as usize).map_err(|_| Halt::OutOfMemory)?;
    let mut all: Vec<Component> = Vec::new();
    let mut simple = true;
    let open = run.expect.is_open();
    for first in 0..run.vertices {
        if of[first as usize] != NIL || !run.live_vertex(first) {
            continue;
        }
        let number = all.len() as u32;
        let mut component = Component::at(first);
        of[first as usize] = number;
        found.push(first);
        while let Some(v) = found.get(visited).copied() {
            visited += 1;
            component.vertices += 1;
            let mut neighbour = |u: u32| {
                let Some(component) = of.get_mut(u as usize) else { return };
                simple &= u != v && core::mem::replace(&mut seen_from[u as usize], v) != v;
                if *component == NIL {
                    *component = number;
                    found.push(u);
                }
            };
            let reached = around(run, v, |h, t| {
                if t == NIL {
                    component.unpaired += 1;
                    neighbour(run.target_by_next(h));
                } else {
                    component.paired += 1;
                    neighbour(run.origin(t));
                }
                // A half-edge without twin that ends at `v` is reached from `v` only as the one before `h`.
                let before = if open { run.before(h) } else { None };
                if let Some(before) = before.filter(|before| run.twin(*before) == NIL) {
                    neighbour(run.origin(before));
                }
            });
            rotation::check(run, v, reached)?;
        }
        component.open = component.unpaired > 0;
        all.try_reserve(1).map_err(|_| Halt::OutOfMemory)?;
        all.push(component);
    }
    run.components = Some(Components { of, all, simple });
    Ok(())
}

/// Calls `visit` for each half-edge leaving `v` and its twin, in order of rotation. Stops when the walk returns or has
/// reached as many half-edges as name `v` as their origin, and returns how many it reached. At an open boundary it goes on
/// from the start in the other direction.
#[inline]
fn around<V: View + ?Sized>(run: &Run<'_, V>, v: u32, mut visit: impl FnMut(u32, u32)) -> u32 {
    let Fan { degree, leaving: start } = run.fans[v as usize];
    let mut h = start;
    let mut reached = 0;
    while h != NIL && reached < degree {
        let t = run.twin(h);
        visit(h, t);
        reached += 1;
        h = if t == NIL { NIL } else { run.next(t) };
        if h == start {
            return reached;
        }
    }
    if !run.expect.is_open() {
        return reached;
    }
    let mut h = start;
    while reached < degree {
        h = run.before(h).map_or(NIL, |before| run.twin(before));
        if h == NIL || h == start {
            break;
        }
        visit(h, run.twin(h));
        reached += 1;
    }
    reached
}
