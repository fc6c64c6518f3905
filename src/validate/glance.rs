//! The common case first: two walks that find nothing to report.
//!
//! Most structures that are validated are right. So where a structure has all links and a closed boundary, a first glance
//! goes once around every vertex and once along every boundary component, and settles R1 … T1 for all records or for
//! none: if anything at all is amiss, it says nothing, and the rules are run one by one by the files that are named after
//! them.
//!
//! ```text
//!   around v, from leaving(v):        along b, from start(b):
//!
//!        \   |   /                    ┌──► h ──► n ──► · ──┐    twin(twin(h)) = h, prev(n) = h,
//!     ◄── \  |  / ──►                 └────────────────────┘    origin(n) = origin(twin(h)),
//!   ─────── v ───────                   face(b) lists b         boundary(h) = b, all of them live
//! ```
//!
//! Little has to be remembered, because counting does the rest. Say that both walks return to where they set out, and
//! that each meets as many half-edges as there are.
//!
//! - Within one cycle `prev` undoes each step, and two cycles differ in their boundary component, so the second walk met
//!   no half-edge twice, hence each once. So `next` leads from half-edges to half-edges and is a permutation that `prev`
//!   undoes; then `prev` is live and `next` undoes it, too (R1, L1, L2, L3, B1).
//! - By L3 the origin stays the same around a vertex, and `leaving(v)` leaves v, so the first walk met every half-edge
//!   once, and each with its origin: that is V1 and V2.
//! - Each boundary component names one place in one face and stands there. As there are as many places as boundary
//!   components, no place holds anything else (F1, F2, and R1 of faces).
//! - Each isolated vertex names a boundary component that starts at it, and there are as many of these as of those (B2).

use super::components::{Component, Components};
use super::run::{NIL, Run};
use super::{BoundaryPlace, Part, Record, Rule, Start, Unchecked, View};
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

/// What the walk around every vertex finds.
struct Around {
    components: Components,
    vertices: usize,
    isolated: usize,
    half_edges: usize,
}

/// What the walk along every boundary component finds.
#[derive(Default)]
struct Along {
    boundaries: usize,
    at_vertex: usize,
    half_edges: usize,
}

/// What the faces list.
#[derive(Default)]
struct Listed {
    faces: usize,
    outer: usize,
    inner: usize,
}

impl<V: View + ?Sized> Run<'_, V> {
    /// Whether R1 … T1 hold. If so, they are done with.
    pub(super) fn glance(&mut self) -> bool {
        let links = [Part::Prev, Part::Leaving, Part::BoundaryComponents, Part::Places];
        if self.expect.is_open() || !links.into_iter().all(|part| self.expect.has(part)) {
            return false;
        }
        let extent = Extent {
            vertices: self.vertices as usize,
            half_edges: self.half_edges as usize,
            boundaries: self.boundaries as usize,
            faces: self.faces as usize,
            holes: self.expect.has(Part::Holes),
        };
        let half_edges = (0..self.half_edges).filter(|h| self.live_half_edge(*h)).count();
        let Some(mut around) = around_vertices(self.view, extent) else { return false };
        let Some(along) = along_boundaries(self.view, extent, &mut around.components) else { return false };
        let Some(listed) = listed(self.view, extent) else { return false };
        let unbounded = usize::from(self.expect.has(Part::UnboundedFace));
        let complete = around.half_edges == half_edges
            && along.half_edges == half_edges
            && (along.at_vertex == around.isolated || !extent.holes)
            && listed.outer.checked_add(listed.inner) == Some(along.boundaries)
            && listed.faces - listed.outer == unbounded;
        let outside = || around.components.all.iter().all(|component| component.outside.is_some());
        if !complete || extent.holes && !outside() {
            return false;
        }
        self.settle(&around, &along, &listed);
        self.components = Some(around.components);
        true
    }

    /// Enters what the rules would have counted one by one.
    fn settle(&mut self, around: &Around, along: &Along, listed: &Listed) {
        let (half_edges, components) = (along.half_edges, around.components.all.len());
        self.counts.vertices = around.vertices;
        self.counts.isolated_vertices = around.isolated;
        self.counts.half_edges = half_edges;
        self.counts.edges = half_edges / 2;
        self.counts.faces = listed.faces;
        self.counts.outer_boundaries = listed.outer;
        self.counts.inner_boundaries = listed.inner;
        self.counts.cycles = Some(along.boundaries - along.at_vertex);
        self.counts.borders = Some(0);
        let connected = around.vertices - around.isolated;
        let others = around.vertices + 2 * along.boundaries + listed.faces + listed.inner;
        self.findings.checked(Rule::R1, 5 * half_edges as u64 + others as u64);
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
            self.findings.checked(rule, checked as u64);
        }
        if self.expect.has(Part::Holes) {
            self.findings.checked(Rule::B2, around.vertices as u64);
        } else {
            self.findings.not_checked(Rule::B2, Unchecked::Lacks(Part::Holes));
        }
        match self.containment_unchecked() {
            None => self.findings.checked(Rule::T1, components as u64),
            Some(why) => self.findings.not_checked(Rule::T1, why),
        }
    }
}

/// The vertices in the order in which they are met.
struct Meeting {
    /// All that were met so far. The first to come goes first: by far the fewest cache misses where numbers follow places.
    order: Vec<u32>,
    /// Per vertex the last one from which it was seen as a neighbour, or nil if it was not met.
    seen_from: Vec<u32>,
    /// Whether none was seen twice from one vertex, or from itself: there are no parallel edges and no loops.
    simple: bool,
}

/// Walks around every vertex, from neighbour to neighbour.
#[inline(never)]
fn around_vertices<V: View + ?Sized>(view: &V, extent: Extent) -> Option<Around> {
    let mut meeting = Meeting { order: Vec::new(), seen_from: column(extent.vertices)?, simple: true };
    meeting.order.try_reserve_exact(extent.vertices).ok()?;
    let mut of = column(extent.vertices)?;
    let mut all: Vec<Component> = Vec::new();
    let (mut vertices, mut isolated, mut half_edges) = (0, 0, 0);
    for first in 0..extent.vertices {
        if meeting.seen_from[first] != NIL || !view.is_vertex(first) {
            continue;
        }
        let number = all.len() as u32;
        let (vertices_before, half_edges_before) = (vertices, half_edges);
        meeting.seen_from[first] = first as u32;
        meeting.order.push(first as u32);
        while let Some(v) = meeting.order.get(vertices).map(|v| *v as usize) {
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
            half_edges += around(view, extent, (v, start), extent.half_edges - half_edges, &mut meeting)?;
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
    let components = Components { of, all, simple: meeting.simple };
    Some(Around { components, vertices, isolated, half_edges })
}

/// Walks around one vertex, from a half-edge that leaves it, meeting no more half-edges than there is room for, and tells
/// how many it met.
#[inline(never)]
fn around<V: View + ?Sized>(
    view: &V,
    extent: Extent,
    (v, start): (usize, usize),
    room: usize,
    meeting: &mut Meeting,
) -> Option<usize> {
    let Meeting { order, seen_from, simple } = meeting;
    let (v, seen_from) = (v as u32, seen_from.as_mut_slice());
    let (mut h, mut met, mut twice) = (start, 0, false);
    while met < room {
        met += 1;
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
            return Some(met);
        }
    }
    None
}

/// A column of `n` nils, if there is memory for it.
fn column(n: usize) -> Option<Vec<u32>> {
    super::run::column(n as u32, NIL).ok()
}

/// Half of B2: whether the isolated vertex names a boundary component that starts at it.
fn names_its_boundary<V: View + ?Sized>(view: &V, extent: Extent, v: usize) -> bool {
    let named = view.isolated(v).filter(|b| *b < extent.boundaries && view.is_boundary(*b));
    named.is_some_and(|b| view.boundary_start(b) == Some(Start::Vertex(v)))
}

/// Walks along every boundary component, and notes the cycles and the outside of each component.
#[inline(never)]
fn along_boundaries<V: View + ?Sized>(view: &V, extent: Extent, components: &mut Components) -> Option<Along> {
    let mut along = Along::default();
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

/// Walks along one cycle, meeting no more half-edges than there is room for, and tells how many it met.
#[inline]
fn along_cycle<V: View + ?Sized>(view: &V, extent: Extent, b: usize, start: usize, room: usize) -> Option<usize> {
    let mut h = Some(start).filter(|h| *h < extent.half_edges)?;
    let mut met = 0;
    while met < room {
        met += 1;
        let t = view.twin(h).filter(|t| *t < extent.half_edges)?;
        let n = view.next(h).filter(|n| *n < extent.half_edges)?;
        let live = view.is_half_edge(h) && view.is_half_edge(t) && view.boundary(h) == Some(b);
        let mutual = live && t != h && view.twin(t) == Some(h) && view.prev(n) == Some(h);
        if !mutual || view.origin(n)? != view.origin(t)? {
            return None;
        }
        if n == start {
            return Some(met);
        }
        h = n;
    }
    None
}

/// Counts the faces and what they list.
#[inline(never)]
fn listed<V: View + ?Sized>(view: &V, extent: Extent) -> Option<Listed> {
    let mut listed = Listed::default();
    for f in (0..extent.faces).filter(|f| view.is_face(*f)) {
        listed.faces += 1;
        listed.outer += usize::from(view.outer(f).is_some());
        if extent.holes {
            listed.inner = listed.inner.checked_add(view.inner_count(f))?;
        }
    }
    Some(listed)
}
