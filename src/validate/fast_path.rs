//! The common case first: two walks that settle R1 … T1 at once.
//!
//! Most structures that are validated are valid. So where a structure has all links and a closed boundary, the fast path
//! walks once around every vertex and once along every boundary component, and settles R1 … T1 for all records;
//! otherwise it gives up, and the rules are checked one by one, each by the file that is named after it.
//!
//! ```text
//!   around v, from leaving(v):        along b, from start(b):
//!
//!        \   |   /                    ┌──► h ──► n ──► · ──┐    twin(twin(h)) = h, prev(n) = h,
//!     ◄── \  |  / ──►                 └────────────────────┘    origin(n) = origin(twin(h)),
//!   ─────── v ───────                   face(b) lists b         boundary(h) = b, all of them live
//! ```
//!
//! # Why this is enough
//!
//! The walks remember little, because they count. Say that both walks return to where they started, and that each visits
//! as many half-edges as there are.
//!
//! - Within one cycle `prev` undoes each step, and two cycles differ in their boundary component, so the second walk
//!   visits no half-edge twice, hence each once. So `next` leads from half-edges to half-edges and is a permutation that
//!   `prev` undoes; then `prev` is live and `next` undoes it, too (R1, L1, L2, L3, B1).
//! - By L3 the origin stays the same around a vertex, and `leaving(v)` leaves v, so the first walk visits every half-edge
//!   once, and each with its origin: that is V1 and V2.
//! - Each boundary component names one place in one face and stands there. As there are as many places as boundary
//!   components, no place holds anything else (F1, F2, and R1 of faces).
//! - Each isolated vertex names a boundary component that starts at it, and there are as many of these as of those (B2).

use super::columns::{Component, Components, NIL};
use super::expectation::Part;
use super::record::Record;
use super::report::Unchecked;
use super::rule::Rule;
use super::run::Run;
use super::view::{BoundaryPlace, Start, View};
use alloc::vec::Vec;

/// How many slots there are, and whether faces have holes.
#[derive(Clone, Copy)]
struct Extent {
    vertices: usize,
    half_edges: usize,
    boundaries: usize,
    faces: usize,
    holes: bool,
}

/// What the walks around the vertices find.
struct VertexTotals {
    components: Components,
    vertices: usize,
    isolated: usize,
    half_edges: usize,
}

/// What the walks along the boundary components find.
#[derive(Default)]
struct BoundaryTotals {
    boundaries: usize,
    at_vertex: usize,
    half_edges: usize,
}

/// What the faces list.
#[derive(Default)]
struct FaceTotals {
    faces: usize,
    outer: usize,
    inner: usize,
}

/// Whether R1 … T1 hold. If so, their outcomes are entered; if not, nothing is.
pub(super) fn check<V: View + ?Sized>(run: &mut Run<'_, V>) -> bool {
    let links = [Part::Prev, Part::Leaving, Part::BoundaryComponents, Part::Places];
    if run.expect.is_open() || !links.into_iter().all(|part| run.expect.has(part)) {
        return false;
    }
    let extent = Extent {
        vertices: run.vertices as usize,
        half_edges: run.half_edges as usize,
        boundaries: run.boundaries as usize,
        faces: run.faces as usize,
        holes: run.expect.has(Part::Holes),
    };
    let half_edges = (0..run.half_edges).filter(|h| run.live_half_edge(*h)).count();
    let Some(mut around) = around_vertices(run.view, extent) else { return false };
    let Some(along) = along_boundaries(run.view, extent, &mut around.components) else { return false };
    let Some(listed) = listed(run.view, extent) else { return false };
    let unbounded = usize::from(run.expect.has(Part::UnboundedFace));
    let complete = around.half_edges == half_edges
        && along.half_edges == half_edges
        && (along.at_vertex == around.isolated || !extent.holes)
        && listed.outer.checked_add(listed.inner) == Some(along.boundaries)
        && listed.faces - listed.outer == unbounded;
    let outside = || around.components.all.iter().all(|component| component.outside.is_some());
    if !complete || extent.holes && !outside() {
        return false;
    }
    settle(run, &around, &along, &listed);
    run.components = Some(around.components);
    true
}

/// Enters what the rules would have counted one by one.
fn settle<V: View + ?Sized>(run: &mut Run<'_, V>, around: &VertexTotals, along: &BoundaryTotals, listed: &FaceTotals) {
    let (half_edges, components) = (along.half_edges, around.components.all.len());
    run.counts.vertices = around.vertices;
    run.counts.isolated_vertices = around.isolated;
    run.counts.half_edges = half_edges;
    run.counts.edges = half_edges / 2;
    run.counts.faces = listed.faces;
    run.counts.outer_boundaries = listed.outer;
    run.counts.inner_boundaries = listed.inner;
    run.counts.cycles = Some(along.boundaries - along.at_vertex);
    run.counts.borders = Some(0);
    let connected = around.vertices - around.isolated;
    let others = around.vertices + 2 * along.boundaries + listed.faces + listed.inner;
    run.findings.checked(Rule::R1, 5 * half_edges as u64 + others as u64);
    for (rule, checked) in [
        (Rule::L1, half_edges),
        (Rule::L2, half_edges),
        (Rule::L3, half_edges),
        (Rule::V1, connected),
        (Rule::V2, connected),
        (Rule::B1, half_edges),
        (Rule::F1, listed.faces),
        (Rule::F2, along.boundaries),
    ] {
        run.findings.checked(rule, checked as u64);
    }
    if run.expect.has(Part::Holes) {
        run.findings.checked(Rule::B2, around.vertices as u64);
    } else {
        run.findings.not_checked(Rule::B2, Unchecked::Lacks(Part::Holes));
    }
    match run.containment_unchecked() {
        None => run.findings.checked(Rule::T1, components as u64),
        Some(why) => run.findings.not_checked(Rule::T1, why),
    }
}

/// The vertices found so far.
struct VertexQueue {
    /// In the order in which they were found, which is the order in which they are visited: by far the fewest cache misses
    /// where neighbours have close numbers.
    order: Vec<u32>,
    /// Per vertex the last one from which it was seen as a neighbour, or nil if it was not found.
    seen_from: Vec<u32>,
    /// Whether none was seen twice from one vertex, or from itself: there are no parallel edges and no loops.
    simple: bool,
}

/// Walks around every vertex, in the order in which neighbours are found.
#[inline(never)]
fn around_vertices<V: View + ?Sized>(view: &V, extent: Extent) -> Option<VertexTotals> {
    let mut queue = VertexQueue { order: Vec::new(), seen_from: column(extent.vertices)?, simple: true };
    queue.order.try_reserve_exact(extent.vertices).ok()?;
    let mut of = column(extent.vertices)?;
    let mut all: Vec<Component> = Vec::new();
    let (mut vertices, mut isolated, mut half_edges) = (0, 0, 0);
    for first in 0..extent.vertices {
        if queue.seen_from[first] != NIL || !view.is_vertex(first) {
            continue;
        }
        let number = all.len() as u32;
        let (vertices_before, half_edges_before) = (vertices, half_edges);
        queue.seen_from[first] = first as u32;
        queue.order.push(first as u32);
        while let Some(v) = queue.order.get(vertices).map(|v| *v as usize) {
            of[v] = number;
            vertices += 1;
            let Some(start) = view.leaving(v) else {
                if extent.holes && !names_its_boundary(view, extent, v) {
                    return None;
                }
                isolated += 1;
                continue;
            };
            let leaves = start < extent.half_edges && view.is_half_edge(start) && view.origin(start) == Some(v);
            if !leaves || extent.holes && view.isolated(v).is_some() {
                return None;
            }
            half_edges += around(view, extent, (v, start), extent.half_edges - half_edges, &mut queue)?;
        }
        all.try_reserve(1).ok()?;
        all.push(Component {
            vertices: (vertices - vertices_before) as u32,
            paired: (half_edges - half_edges_before) as u32,
            // An isolated vertex counts as a cycle.
            cycles: u32::from(half_edges == half_edges_before),
            ..Component::at(first as u32)
        });
    }
    let components = Components { of, all, simple: queue.simple };
    Some(VertexTotals { components, vertices, isolated, half_edges })
}

/// Walks around one vertex, from a half-edge that leaves it, and returns how many half-edges it visited; none if it visits
/// more than `limit`.
#[inline(never)]
fn around<V: View + ?Sized>(
    view: &V,
    extent: Extent,
    (v, start): (usize, usize),
    limit: usize,
    queue: &mut VertexQueue,
) -> Option<usize> {
    let VertexQueue { order, seen_from, simple } = queue;
    let (v, seen_from) = (v as u32, seen_from.as_mut_slice());
    let (mut h, mut visited, mut twice) = (start, 0, false);
    while visited < limit {
        visited += 1;
        let t = view.twin(h).filter(|t| *t < extent.half_edges)?;
        let neighbour = view.origin(t)?;
        let seen = seen_from.get_mut(neighbour)?;
        twice |= *seen == v;
        if core::mem::replace(seen, v) == NIL {
            if !view.is_vertex(neighbour) {
                return None;
            }
            order.push(neighbour as u32);
        }
        h = view.next(t).filter(|h| *h < extent.half_edges)?;
        if h == start {
            *simple &= !twice;
            return Some(visited);
        }
    }
    None
}

/// A column of `n` nils, if there is memory for it.
fn column(n: usize) -> Option<Vec<u32>> {
    super::columns::column(n as u32, NIL).ok()
}

/// Half of B2: whether the isolated vertex names a boundary component that starts at it.
fn names_its_boundary<V: View + ?Sized>(view: &V, extent: Extent, v: usize) -> bool {
    let named = view.isolated(v).filter(|b| *b < extent.boundaries && view.is_boundary(*b));
    named.is_some_and(|b| view.boundary_start(b) == Some(Start::Vertex(v)))
}

/// Walks along every boundary component, and notes the cycles and the outside of each component.
#[inline(never)]
fn along_boundaries<V: View + ?Sized>(view: &V, extent: Extent, components: &mut Components) -> Option<BoundaryTotals> {
    let mut along = BoundaryTotals::default();
    for b in 0..extent.boundaries {
        if !view.is_boundary(b) {
            continue;
        }
        along.boundaries += 1;
        let f = view.boundary_face(b).filter(|f| *f < extent.faces && view.is_face(*f))?;
        let place = view.boundary_place(b)?;
        let listed = match place {
            BoundaryPlace::Outer => view.outer(f),
            BoundaryPlace::Inner(i) if extent.holes && i < view.inner_count(f) => view.inner(f, i),
            BoundaryPlace::Inner(_) => None,
        };
        if listed != Some(b) {
            return None;
        }
        let (vertex, cycles) = match view.boundary_start(b)? {
            Start::HalfEdge(start) => {
                along.half_edges += along_cycle(view, extent, b, start, extent.half_edges - along.half_edges)?;
                (view.origin(start)?, 1)
            }
            Start::Vertex(_) if place == BoundaryPlace::Outer => return None,
            Start::Vertex(v) => {
                along.at_vertex += 1;
                (v, 0)
            }
        };
        let component = components.all.get_mut(*components.of.get(vertex)? as usize)?;
        component.cycles += cycles;
        if place != BoundaryPlace::Outer {
            if component.outside.is_some() {
                return None;
            }
            component.outside = Some(Record::Boundary(b));
            component.lies_in = f as u32;
        }
    }
    Some(along)
}

/// Walks along one cycle and returns how many half-edges it visited; none if it visits more than `limit`.
#[inline]
fn along_cycle<V: View + ?Sized>(view: &V, extent: Extent, b: usize, start: usize, limit: usize) -> Option<usize> {
    let mut h = Some(start).filter(|h| *h < extent.half_edges)?;
    let mut visited = 0;
    while visited < limit {
        visited += 1;
        let t = view.twin(h).filter(|t| *t < extent.half_edges)?;
        let n = view.next(h).filter(|n| *n < extent.half_edges)?;
        let live = view.is_half_edge(h) && view.is_half_edge(t) && view.boundary(h) == Some(b);
        let mutual = live && t != h && view.twin(t) == Some(h) && view.prev(n) == Some(h);
        if !mutual || view.origin(n)? != view.origin(t)? {
            return None;
        }
        if n == start {
            return Some(visited);
        }
        h = n;
    }
    None
}

/// Counts the faces and what they list.
#[inline(never)]
fn listed<V: View + ?Sized>(view: &V, extent: Extent) -> Option<FaceTotals> {
    let mut listed = FaceTotals::default();
    for f in (0..extent.faces).filter(|f| view.is_face(*f)) {
        listed.faces += 1;
        listed.outer += usize::from(view.outer(f).is_some());
        if extent.holes {
            listed.inner = listed.inner.checked_add(view.inner_count(f))?;
        }
    }
    Some(listed)
}
