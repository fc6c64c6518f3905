//! One walk around every vertex, for V2, which finds the components on the way.

use crate::validate::columns::{Component, Components, NIL, column};
use crate::validate::fast_path::Facts;
use crate::validate::findings::{Findings, Halt};
use crate::validate::report::Unchecked;
use crate::validate::rule::Rule;
use crate::validate::rules::live::{Census, Fan};
use crate::validate::rules::rotation;
use crate::validate::structure::Part;
use crate::validate::subject::Subject;
use alloc::vec::Vec;

/// Runs V2. `before` has for each half-edge the one before it, if that is known where there is no `prev`. Returns the components, unless V2 is
/// settled or cannot be checked.
pub(crate) fn check(
    subject: Subject<'_>,
    facts: &Facts,
    census: &Census,
    before: Option<&[u32]>,
    findings: &mut Findings,
) -> Result<Option<Components>, Halt> {
    if let Some(rule) = census.map_broken(findings) {
        findings.not_checked(Rule::V2, Unchecked::Broken(rule));
        return Ok(None);
    }
    let found = if facts.rotations_hold() { None } else { Some(find(subject, census, before, findings)?) };
    findings.checked(Rule::V2, (census.vertices - census.isolated_vertices) as u64);
    Ok(found)
}

/// Walks around all vertices. They are visited in the order in which they are found, which causes by far the fewest cache misses
/// where neighbours have close numbers.
pub(crate) fn find(
    subject: Subject<'_>,
    census: &Census,
    before: Option<&[u32]>,
    findings: &mut Findings,
) -> Result<Components, Halt> {
    let fans = census.fans.get(subject)?;
    let derived;
    let before = match before {
        None if subject.is_open() && !subject.has(Part::Prev) => {
            derived = preceding(subject)?;
            Some(&derived[..])
        }
        before => before,
    };
    let walk = Walk { subject, before };
    let vertices = subject.extent.vertices.0;
    let mut of = column(vertices, NIL)?;
    // The last vertex from which a vertex was seen as a neighbour: seen twice from one means parallel edges.
    let mut seen_from = column(vertices, NIL)?;
    let mut found: Vec<u32> = Vec::new();
    let mut visited = 0;
    found.try_reserve_exact(vertices as usize).map_err(|_| Halt::OutOfMemory)?;
    let mut all: Vec<Component> = Vec::new();
    let mut simple = true;
    for first in 0..vertices {
        if of[first as usize] != NIL || !subject.is_live_vertex(first) {
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
            let fan = fans[v as usize];
            let reached = walk.around(fan, |h, t| {
                if t == NIL {
                    component.unpaired += 1;
                    neighbour(subject.target_by_next(h));
                } else {
                    component.paired += 1;
                    neighbour(subject.origin(t));
                }
                // A half-edge without twin that ends at `v` is reached from `v` only as the one before `h`.
                let before = if subject.is_open() { walk.before(h) } else { None };
                if let Some(before) = before.filter(|before| subject.twin(*before) == NIL) {
                    neighbour(subject.origin(before));
                }
            });
            rotation::check(v, fan, reached, findings)?;
        }
        component.open = component.unpaired > 0;
        all.try_reserve(1).map_err(|_| Halt::OutOfMemory)?;
        all.push(component);
    }
    Ok(Components { of, all, simple })
}

/// For each half-edge the one before it, as it follows from `next`.
fn preceding(subject: Subject<'_>) -> Result<Vec<u32>, Halt> {
    let mut before = column(subject.extent.half_edges.0, NIL)?;
    for h in subject.half_edges() {
        if let Some(before) = before.get_mut(subject.next(h) as usize) {
            *before = h;
        }
    }
    Ok(before)
}

/// The links that a walk around a vertex follows.
struct Walk<'a> {
    subject: Subject<'a>,
    /// For each half-edge the one before it, where there is no `prev` and it is needed.
    before: Option<&'a [u32]>,
}

impl Walk<'_> {
    /// The half-edge before `h` on its cycle.
    fn before(&self, h: u32) -> Option<u32> {
        let before = match self.before {
            _ if self.subject.has(Part::Prev) => self.subject.prev(h),
            before => before.and_then(|before| before.get(h as usize)).copied().unwrap_or(NIL),
        };
        (before != NIL).then_some(before)
    }

    /// Calls `visit` for each half-edge of a fan and its twin, in order of rotation. Stops when the walk returns or has
    /// reached as many half-edges as name the vertex as their origin, and returns how many it reached. At an open boundary it goes on
    /// from the start in the other direction.
    fn around(&self, Fan { degree, leaving: start }: Fan, mut visit: impl FnMut(u32, u32)) -> u32 {
        let subject = self.subject;
        let mut h = start;
        let mut reached = 0;
        while h != NIL && reached < degree {
            let t = subject.twin(h);
            visit(h, t);
            reached += 1;
            h = if t == NIL { NIL } else { subject.next(t) };
            if h == start {
                return reached;
            }
        }
        if !subject.is_open() {
            return reached;
        }
        let mut h = start;
        while reached < degree {
            h = self.before(h).map_or(NIL, |before| subject.twin(before));
            if h == NIL || h == start {
                break;
            }
            visit(h, subject.twin(h));
            reached += 1;
        }
        reached
    }
}
