//! R1 … V2: links, and the combinatorial map that they make. R1 is checked in `live.rs`.
//!
//! L1, L2 and L3 share one pass over the half-edges, so that each link is read once for all three.

use super::live::{Census, Fan};
use crate::numbers::NIL;
use crate::validate::findings::{Findings, Flow, Halt, Pass};
use crate::validate::half_edges::HalfEdges;
use crate::validate::report::{Unchecked, Violation};
use crate::validate::rule::Rule;
use crate::validate::structure::Part;
use crate::validate::subject::{Component, Components, Subject, column};
use alloc::vec::Vec;

/// Runs L1, L2 and L3 on every half-edge with live links. At an open boundary without `prev`, returns the predecessor of each
/// half-edge, for V2.
pub(crate) fn half_edges<H: HalfEdges>(
    subject: Subject<'_>,
    half_edges: H,
    census: &Census,
    findings: &mut Findings,
) -> Result<Vec<u32>, Halt> {
    let has_prev = subject.has(Part::Prev);
    let mut before = Vec::new();
    if !has_prev {
        before = column(subject.extent.half_edges.count, NIL)?;
    }
    let Subject { view, extent } = subject;
    let vertices = extent.vertices;
    // The common case: if all three hold, the half-edge needs no closer look.
    let holds = |h: u32| {
        half_edges.twin_back(h).is_some_and(|t| {
            let (n, p, target) = (half_edges.next(h), half_edges.prev(h), half_edges.origin(t));
            half_edges.is_live(n)
                && half_edges.prev(n) == h
                && half_edges.is_live(p)
                && half_edges.next(p) == h
                && half_edges.origin(n) == target
                && vertices.is_live(target as usize, |v| view.is_vertex(v))
        })
    };
    let mut checked = [0; 3];
    let mut held = 0;
    let mut pass = findings.pass(Rule::L1);
    for h in subject.half_edges() {
        if has_prev && holds(h) {
            held += 1;
        } else {
            half_edge(subject, half_edges, h, &mut before, &mut checked, &mut pass)?;
        }
    }
    pass.end()?;
    for (rule, checked) in [Rule::L1, Rule::L2, Rule::L3].into_iter().zip(checked) {
        findings.checked(rule, held + checked);
        if !census.map_is_live {
            findings.not_checked(rule, Unchecked::Broken(Rule::R1));
        }
    }
    Ok(if subject.is_open() { before } else { Vec::new() })
}

/// Runs L1, L2 and L3 on one half-edge, and counts the rules that could be checked.
#[inline(never)]
fn half_edge<H: HalfEdges>(
    subject: Subject<'_>,
    half_edges: H,
    h: u32,
    before: &mut [u32],
    [twins, nexts, targets]: &mut [u64; 3],
    pass: &mut Pass<'_>,
) -> Flow {
    let live = |h: u32| half_edges.is_live(h).then_some(h);
    let (twin, next) = (live(half_edges.twin(h)), live(half_edges.next(h)));
    if let Some(t) = twin {
        *twins += 1;
        mutual(subject, half_edges, [h, t], pass)?;
    }
    let has_prev = subject.has(Part::Prev);
    if let Some(n) = next {
        *nexts += 1;
        if has_prev {
            prev_of_next(half_edges, [h, n], pass)?;
        } else {
            distinct([h, n], before, pass)?;
        }
    }
    if let Some(p) = if has_prev { live(half_edges.prev(h)) } else { None } {
        next_of_prev(half_edges, [h, p], pass)?;
    }
    if let (Some(t), Some(n)) = (twin, next) {
        *targets += u64::from(target(subject, half_edges, h, [t, n], pass)?);
    }
    Ok(())
}

/// L1 twin: `twin(twin(h)) = h` and `twin(h) ≠ h`.
///
/// Checks one half-edge and its twin. Here and below, dangling links are left to R1.
#[inline]
fn mutual<H: HalfEdges>(subject: Subject<'_>, half_edges: H, [h, t]: [u32; 2], pass: &mut Pass<'_>) -> Flow {
    let (half_edge, twin) = (h as usize, t as usize);
    if t == h {
        return pass.add(Violation::TwinIsSelf { half_edge });
    }
    let back = half_edges.twin(t);
    if back == h {
        return Ok(());
    }
    // At an open boundary nil is legal, but not for a half-edge named as a twin.
    if half_edges.is_live(back) || back == NIL && subject.is_open() {
        let found = (back != NIL).then_some(back as usize);
        return pass.add(Violation::TwinNotMutual { half_edge, twin, found });
    }
    Ok(())
}

/// L2 next/prev: `prev(next(h)) = h` and `next(prev(h)) = h`.
///
/// Checks `prev(next(h)) = h`.
#[inline]
fn prev_of_next<H: HalfEdges>(half_edges: H, [h, n]: [u32; 2], pass: &mut Pass<'_>) -> Flow {
    let back = half_edges.prev(n);
    if back == h || !half_edges.is_live(back) {
        return Ok(());
    }
    pass.add(Violation::PrevOfNext { half_edge: h as usize, next: n as usize, found: back as usize })
}

#[inline]
fn next_of_prev<H: HalfEdges>(half_edges: H, [h, p]: [u32; 2], pass: &mut Pass<'_>) -> Flow {
    let back = half_edges.next(p);
    if back == h || !half_edges.is_live(back) {
        return Ok(());
    }
    pass.add(Violation::NextOfPrev { half_edge: h as usize, prev: p as usize, found: back as usize })
}

/// Checks, without `prev`, that no earlier half-edge has the same next, and records `h` as the predecessor.
fn distinct([h, n]: [u32; 2], before: &mut [u32], pass: &mut Pass<'_>) -> Flow {
    let first = core::mem::replace(&mut before[n as usize], h);
    if first == NIL {
        return Ok(());
    }
    pass.add(Violation::NextShared { first: first as usize, second: h as usize, next: n as usize })
}

/// L3 target: `origin(next(h)) = origin(twin(h))`.
///
/// Checks one half-edge with its twin and its next, and returns true if both have a live origin.
#[inline]
fn target<H: HalfEdges>(
    subject: Subject<'_>,
    half_edges: H,
    h: u32,
    [t, n]: [u32; 2],
    pass: &mut Pass<'_>,
) -> Result<bool, Halt> {
    let (target, found) = (half_edges.origin(t), half_edges.origin(n));
    if !subject.is_live_vertex(target) {
        return Ok(false);
    }
    if target != found {
        if !subject.is_live_vertex(found) {
            return Ok(false);
        }
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
/// `before` contains the predecessor of each half-edge, if needed and not stored. Returns the components, unless V2 cannot be checked.
pub(crate) fn rotation<H: HalfEdges>(
    subject: Subject<'_>,
    half_edges: H,
    census: &Census,
    before: &[u32],
    findings: &mut Findings,
) -> Result<Option<Components>, Halt> {
    if let Some(rule) = census.map_broken(findings) {
        findings.not_checked(Rule::V2, Unchecked::Broken(rule));
        return Ok(None);
    }
    let found = rotations(Walk { subject, half_edges, before }, census, findings)?;
    findings.checked(Rule::V2, (census.vertices - census.isolated_vertices) as u64);
    Ok(Some(found))
}

/// Walks around all vertices. They are visited in the order of discovery, which causes by far the fewest cache misses if neighbours
/// have close numbers.
fn rotations<H: HalfEdges>(walk: Walk<'_, H>, census: &Census, findings: &mut Findings) -> Result<Components, Halt> {
    let Walk { subject, half_edges, .. } = walk;
    let vertices = subject.extent.vertices.count;
    // The component number of each visited vertex. A vertex that was found but not visited stores the vertex found after it, or itself.
    let mut of = column(vertices, NIL)?;
    // The last vertex that had a vertex as neighbour: seeing it twice from one vertex means parallel edges. On surfaces only M2 needs
    // this.
    let asks = subject.extent.is_plane() || subject.extent.expect.asks_for(Rule::M2);
    let mut seen_from = column(if asks { vertices } else { 0 }, NIL)?;
    let mut all: Vec<Component> = Vec::new();
    let mut simple = true;
    for first in 0..vertices {
        if of[first as usize] != NIL || !subject.is_live_vertex(first) {
            continue;
        }
        let is_open = subject.is_open();
        let number = all.len() as u32;
        let mut component = Component::at(first);
        of[first as usize] = first;
        let [mut v, mut last] = [first; 2];
        loop {
            component.vertices += 1;
            let mut neighbour = |u: u32| {
                let Some(found) = of.get_mut(u as usize) else { return };
                if let Some(seen) = seen_from.get_mut(u as usize) {
                    simple &= u != v && core::mem::replace(seen, v) != v;
                }
                if *found == NIL {
                    *found = u;
                    of[last as usize] = u;
                    last = u;
                }
            };
            let fan = census.fans[v as usize];
            let reached = walk.around(fan, |h, t| {
                if t == NIL {
                    component.unpaired += 1;
                    neighbour(half_edges.origin(half_edges.next(h)));
                } else {
                    component.paired += 1;
                    neighbour(half_edges.origin(t));
                }
                // A half-edge without twin that ends at `v` can only be reached from `v` as the predecessor of `h`.
                let before = if is_open { walk.before(h) } else { None };
                if let Some(before) = before.filter(|before| half_edges.twin(*before) == NIL) {
                    neighbour(half_edges.origin(before));
                }
            });
            whole_rotation(v, fan, reached, findings)?;
            let after = core::mem::replace(&mut of[v as usize], number);
            if after == v {
                break;
            }
            v = after;
        }
        component.open = component.unpaired > 0;
        all.try_reserve(1).map_err(|_| Halt::OutOfMemory)?;
        all.push(component);
    }
    Ok(Components { of, all, simple })
}

/// Checks one vertex, of whose half-edges the walk reached `reached`.
///
/// Where L holds, `next∘twin` permutes the half-edges that leave one vertex, so the rotation of a vertex contains all of them if and
/// only if the size of its orbit equals the degree of the vertex.
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

#[derive(Clone, Copy)]
struct Walk<'a, H> {
    subject: Subject<'a>,
    half_edges: H,
    /// The predecessor of each half-edge, if there is no `prev`.
    before: &'a [u32],
}

impl<H: HalfEdges> Walk<'_, H> {
    fn before(&self, h: u32) -> Option<u32> {
        let before = if self.subject.has(Part::Prev) {
            self.half_edges.prev(h)
        } else {
            self.before.get(h as usize).copied().unwrap_or(NIL)
        };
        self.half_edges.is_live(before).then_some(before)
    }

    /// Calls `visit` for each half-edge of a fan and its twin, in order of rotation. Stops when the walk returns, or after `degree`
    /// half-edges, and returns the number reached. At an open boundary it continues from the start in the other direction.
    #[inline(always)]
    #[allow(clippy::inline_always, reason = "`visit` is called for each half-edge")]
    fn around(&self, Fan { degree, leaving: start }: Fan, mut visit: impl FnMut(u32, u32)) -> u32 {
        let half_edges = self.half_edges;
        let mut h = start;
        let mut reached = 0;
        while h != NIL && reached < degree {
            let t = half_edges.twin(h);
            visit(h, t);
            reached += 1;
            h = if t == NIL { NIL } else { half_edges.next(t) };
            if h == start {
                return reached;
            }
        }
        if self.subject.is_open() { reached + self.back(start, degree - reached, &mut visit) } else { reached }
    }

    /// Continues from the start in the other direction, to at most `most` half-edges, and returns the number reached.
    #[inline(never)]
    fn back(&self, start: u32, most: u32, visit: &mut dyn FnMut(u32, u32)) -> u32 {
        let mut h = start;
        for reached in 0..most {
            h = self.before(h).map_or(NIL, |before| self.half_edges.twin(before));
            if h == NIL || h == start {
                return reached;
            }
            visit(h, self.half_edges.twin(h));
        }
        most
    }
}
