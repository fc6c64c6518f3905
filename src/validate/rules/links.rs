//! R1 … V2: links, and the combinatorial map that they make. R1 is checked in `live.rs`.
//!
//! L1, L2 and L3 share one pass over the half-edges, so that each link is read once for all three.

use super::live::{Census, Fan};
use crate::validate::columns::{Component, Components, NIL, column};
use crate::validate::findings::{Findings, Flow, Halt, Pass};
use crate::validate::report::{Unchecked, Violation};
use crate::validate::rule::Rule;
use crate::validate::structure::Part;
use crate::validate::subject::Subject;
use alloc::vec::Vec;

/// Runs L1, L2 and L3 on every half-edge whose links are live. Without `prev`, returns the predecessor of each half-edge.
pub(crate) fn half_edges(
    subject: Subject<'_>,
    census: &Census,
    findings: &mut Findings,
) -> Result<Option<Vec<u32>>, Halt> {
    let has_prev = subject.has(Part::Prev);
    let mut before = Vec::new();
    if !has_prev {
        before = column(subject.extent.half_edges.0, NIL)?;
    }
    // If R1 found every link live, a slot in range is live.
    let all_live = census.map_is_live;
    let [mut twins, mut nexts, mut targets] = [0; 3];
    let live = |h: u32| (h != NIL && (all_live || subject.is_live_half_edge(h))).then_some(h);
    let mut pass = findings.pass(Rule::L1);
    for h in subject.half_edges() {
        let (twin, next) = (live(subject.twin(h)), live(subject.next(h)));
        if let Some(t) = twin {
            twins += 1;
            mutual(subject, [h, t], all_live, &mut pass)?;
        }
        if let Some(n) = next {
            nexts += 1;
            if has_prev {
                prev_of_next(subject, [h, n], all_live, &mut pass)?;
            } else {
                distinct([h, n], &mut before, &mut pass)?;
            }
        }
        if let Some(p) = live(if has_prev { subject.prev(h) } else { NIL }) {
            next_of_prev(subject, [h, p], all_live, &mut pass)?;
        }
        if let (Some(t), Some(n)) = (twin, next) {
            targets += u64::from(target(subject, h, [t, n], all_live, &mut pass)?);
        }
    }
    pass.end()?;
    for (rule, checked) in [(Rule::L1, twins), (Rule::L2, nexts), (Rule::L3, targets)] {
        findings.checked(rule, checked);
        if !all_live {
            findings.not_checked(rule, Unchecked::Broken(Rule::R1));
        }
    }
    Ok((!has_prev).then_some(before))
}

/// L1 twin: `twin(twin(h)) = h` and `twin(h) ≠ h`.
///
/// Checks one half-edge and its twin. If not every link is live, dangling links are left to R1, here and below.
fn mutual(subject: Subject<'_>, [h, t]: [u32; 2], all_live: bool, pass: &mut Pass<'_>) -> Flow {
    let (half_edge, twin) = (h as usize, t as usize);
    if t == h {
        return pass.add(Violation::TwinIsSelf { half_edge });
    }
    let back = subject.twin(t);
    let found = if back == NIL {
        // At an open boundary nil is a legal link, but not for a half-edge that is named as a twin.
        if subject.view.twin(twin).is_some() || !subject.is_open() {
            return Ok(());
        }
        None
    } else if back == h || !(all_live || subject.is_live_half_edge(back)) {
        return Ok(());
    } else {
        Some(back as usize)
    };
    pass.add(Violation::TwinNotMutual { half_edge, twin, found })
}

/// L2 next/prev: `prev(next(h)) = h` and `next(prev(h)) = h`.
///
/// Checks `prev(next(h)) = h`.
fn prev_of_next(subject: Subject<'_>, [h, n]: [u32; 2], all_live: bool, pass: &mut Pass<'_>) -> Flow {
    let back = subject.prev(n);
    if back == h || back == NIL || !(all_live || subject.is_live_half_edge(back)) {
        return Ok(());
    }
    pass.add(Violation::PrevOfNext { half_edge: h as usize, next: n as usize, found: back as usize })
}

/// Checks `next(prev(h)) = h`.
fn next_of_prev(subject: Subject<'_>, [h, p]: [u32; 2], all_live: bool, pass: &mut Pass<'_>) -> Flow {
    let back = subject.next(p);
    if back == h || back == NIL || !(all_live || subject.is_live_half_edge(back)) {
        return Ok(());
    }
    pass.add(Violation::NextOfPrev { half_edge: h as usize, prev: p as usize, found: back as usize })
}

/// Checks, without `prev`, that no half-edge before `h` has the same next, and notes that `h` precedes it.
fn distinct([h, n]: [u32; 2], before: &mut [u32], pass: &mut Pass<'_>) -> Flow {
    let first = core::mem::replace(&mut before[n as usize], h);
    if first == NIL {
        return Ok(());
    }
    pass.add(Violation::NextShared { first: first as usize, second: h as usize, next: n as usize })
}

/// L3 target: `origin(next(h)) = origin(twin(h))`.
///
/// Checks one half-edge with its twin and its next, and returns whether both have a live origin.
fn target(subject: Subject<'_>, h: u32, [t, n]: [u32; 2], all_live: bool, pass: &mut Pass<'_>) -> Result<bool, Halt> {
    let (target, found) = (subject.origin(t), subject.origin(n));
    let are_live = || all_live || subject.is_live_vertex(target) && subject.is_live_vertex(found);
    if target == NIL || found == NIL || !are_live() {
        return Ok(false);
    }
    if target != found {
        let [half_edge, next, target, found] = [h, n, target, found].map(|i| i as usize);
        pass.add(Violation::Target { half_edge, next, target, found })?;
    }
    Ok(true)
}

/// V1 leaving: the half-edge kept by a vertex leaves that vertex.
pub(crate) fn leaving(subject: Subject<'_>, findings: &mut Findings) -> Flow {
    if !subject.has(Part::Leaving) {
        findings.not_checked(Rule::V1, Unchecked::Lacks(Part::Leaving));
        return Ok(());
    }
    let mut checked = 0;
    for vertex in subject.vertices() {
        let Some(half_edge) = subject.live_half_edge(subject.view.leaving(vertex)) else { continue };
        let origin = subject.origin(half_edge as u32);
        if !subject.is_live_vertex(origin) {
            continue;
        }
        checked += 1;
        let origin = origin as usize;
        if origin != vertex {
            findings.add(Violation::NotLeaving { vertex, half_edge, origin })?;
        }
    }
    findings.checked(Rule::V1, checked);
    Ok(())
}

/// V2 rotation: the rotation of a vertex is all half-edges with that origin.
///
/// `before` has the predecessor of each half-edge where there is no `prev`. Returns the components, unless V2 cannot be checked.
pub(crate) fn rotation(
    subject: Subject<'_>,
    census: &Census,
    before: Option<&[u32]>,
    findings: &mut Findings,
) -> Result<Option<Components>, Halt> {
    if let Some(rule) = census.map_broken(findings) {
        findings.not_checked(Rule::V2, Unchecked::Broken(rule));
        return Ok(None);
    }
    let found = rotations(subject, census, before, findings)?;
    findings.checked(Rule::V2, (census.vertices - census.isolated_vertices) as u64);
    Ok(Some(found))
}

/// Walks around all vertices. They are visited in the order in which they are found, which causes by far the fewest cache misses
/// where neighbours have close numbers.
fn rotations(
    subject: Subject<'_>,
    census: &Census,
    before: Option<&[u32]>,
    findings: &mut Findings,
) -> Result<Components, Halt> {
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
            let fan = census.fans[v as usize];
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
            whole_rotation(v, fan, reached, findings)?;
        }
        component.open = component.unpaired > 0;
        all.try_reserve(1).map_err(|_| Halt::OutOfMemory)?;
        all.push(component);
    }
    Ok(Components { of, all, simple })
}

/// Checks one vertex, where the walk around it reached `reached` of its half-edges.
///
/// Where L holds, `next∘twin` permutes the half-edges that leave one vertex, so the rotation of a vertex is all of them if
/// and only if its orbit is as long as the vertex has half-edges.
fn whole_rotation(v: u32, fan: Fan, reached: u32, findings: &mut Findings) -> Flow {
    if reached == fan.degree {
        return Ok(());
    }
    findings.add(Violation::SplitRotation {
        vertex: v as usize,
        half_edge: fan.leaving as usize,
        reached: reached as usize,
        degree: fan.degree as usize,
    })
}

/// The links that a walk around a vertex follows.
struct Walk<'a> {
    subject: Subject<'a>,
    /// The predecessor of each half-edge, where there is no `prev`.
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
