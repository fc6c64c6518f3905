//! Walks around the vertices, and where they start: R1 … V2 of half-edges and vertices, and constant names along `next`. Joins the components
//! edge by edge.

use crate::numbers::{NIL, Sets};
use crate::validate::half_edges::{Asked, HalfEdges, Lent};
use crate::validate::structure::{Part, Start, View};
use crate::validate::subject::{Extent, Subject};
use alloc::vec::Vec;

pub(super) struct Rotations {
    pub(super) vertices: usize,
    pub(super) isolated: usize,
    /// The number of isolated vertices that name a boundary component starting at them.
    pub(super) claimed: usize,
    /// True if there are neither loops nor parallel edges.
    pub(super) simple: bool,
    /// By vertex: the smallest number among its neighbours and itself.
    pub(super) nearest: Vec<u32>,
}

/// Walks around every vertex, in order of their numbers. `None` if a record breaks a rule, or if the walks miss a half-edge.
#[inline(never)]
pub(super) fn walk<V: View + ?Sized>(view: &V, extent: Extent, starts: &Starts) -> Option<Rotations> {
    let asked = Asked { view, extent };
    // Decided once instead of at each half-edge.
    match (extent.has(Part::Prev), extent.has(Part::Faces)) {
        (true, true) => match starts.first_live(view, extent).and_then(|first| Lent::of(view, extent, first)) {
            Some(lent) => walk_and::<V, _, true, true>(view, extent, starts, lent),
            None => walk_and::<V, _, true, true>(view, extent, starts, asked),
        },
        (true, false) => walk_and::<V, _, true, false>(view, extent, starts, asked),
        (false, true) => walk_and::<V, _, false, true>(view, extent, starts, asked),
        (false, false) => walk_and::<V, _, false, false>(view, extent, starts, asked),
    }
}

#[inline(always)]
#[allow(
    clippy::inline_always,
    reason = "where the columns are lent, their lengths are known to be the same in here only"
)]
fn walk_and<V: View + ?Sized, H: HalfEdges, const PREV: bool, const NAMES: bool>(
    view: &V,
    extent: Extent,
    starts: &Starts,
    half_edges: H,
) -> Option<Rotations> {
    let mut tally = Tally { left: starts.half_edges, simple: true };
    // By vertex: the last vertex that had it as a neighbour. Seeing it twice from one vertex means parallel edges.
    let mut seen_from = extent.vertices.nils()?;
    let mut nearest = extent.vertices.nils()?;
    let [mut vertices, mut isolated, mut claimed] = [0; 3];
    let names_boundary = extent.has(Part::BoundaryComponents) && extent.has(Part::Holes);
    for (v, nearest) in nearest.iter_mut().enumerate().filter(|(v, _)| view.is_vertex(*v)) {
        vertices += 1;
        *nearest = match starts.leaving(view, v) {
            None => {
                isolated += 1;
                if names_boundary {
                    claimed += usize::from(is_claimed(view, extent, v)?);
                }
                v as u32
            }
            Some(start) => {
                let start = extent.half_edges.number(Some(start));
                let leaves = half_edges.is_live(start) && half_edges.origin(start) == v as u32;
                let names_nothing = !names_boundary || view.isolated(v).is_none();
                (leaves && names_nothing).then_some(())?;
                match starts.into(v) {
                    None => around::<H, PREV, NAMES>(half_edges, v as u32, start, &mut seen_from, &mut tally)?,
                    Some(before) => {
                        across::<H, PREV, NAMES>(half_edges, v as u32, before as u32, &mut seen_from, &mut tally)?
                    }
                }
            }
        };
    }
    let Tally { left, simple } = tally;
    (left == 0).then_some(Rotations { vertices, isolated, claimed, simple, nearest })
}

#[derive(Clone, Copy)]
struct Tally {
    /// The number of half-edges still to visit.
    left: usize,
    simple: bool,
}

/// Walks around `v`, starting at a half-edge that leaves it, and returns the smallest number among `v` and its neighbours.
#[inline(always)]
#[allow(clippy::inline_always, reason = "a call for each vertex costs more than the checks of its half-edges")]
fn around<H: HalfEdges, const PREV: bool, const NAMES: bool>(
    half_edges: H,
    v: u32,
    start: u32,
    seen_from: &mut [u32],
    tally: &mut Tally,
) -> Option<u32> {
    let mut found = *tally;
    let mut nearest = v;
    let mut h = start;
    loop {
        let t = half_edges.twin_back(h)?;
        nearest = nearest.min(see(v, half_edges.origin(t), seen_from, &mut found)?);
        h = step::<H, PREV, NAMES>(half_edges, v, t, &mut found)?;
        if h == start {
            *tally = found;
            return Some(nearest);
        }
    }
}

/// Walks across `v` at an open boundary, from the half-edge without twin that ends there to the one that leaves it.
#[cold]
#[inline(never)]
fn across<H: HalfEdges, const PREV: bool, const NAMES: bool>(
    half_edges: H,
    v: u32,
    before: u32,
    seen_from: &mut [u32],
    tally: &mut Tally,
) -> Option<u32> {
    let mut nearest = v.min(see(v, half_edges.origin(before), seen_from, tally)?);
    let mut h = step::<H, PREV, NAMES>(half_edges, v, before, tally)?;
    while half_edges.twin(h) != NIL {
        let t = half_edges.twin_back(h)?;
        nearest = nearest.min(see(v, half_edges.origin(t), seen_from, tally)?);
        h = step::<H, PREV, NAMES>(half_edges, v, t, tally)?;
    }
    let next = half_edges.next(h);
    half_edges.is_live(next).then_some(())?;
    Some(nearest.min(see(v, half_edges.origin(next), seen_from, tally)?))
}

/// Steps from `t`, which ends at `v`, to its next half-edge: checks L2, L3, and that both have the same name.
#[inline(always)]
#[allow(clippy::inline_always, reason = "called for each half-edge")]
fn step<H: HalfEdges, const PREV: bool, const NAMES: bool>(
    half_edges: H,
    v: u32,
    t: u32,
    tally: &mut Tally,
) -> Option<u32> {
    tally.left = tally.left.checked_sub(1)?;
    let n = half_edges.next(t);
    let holds = half_edges.is_live(n)
        && half_edges.origin(n) == v
        && (!PREV || half_edges.prev(n) == t)
        && (!NAMES || half_edges.name(n) == half_edges.name(t));
    holds.then_some(n)
}

/// Records a neighbour of `v`. A loop sees its own vertex twice.
#[inline(always)]
#[allow(clippy::inline_always, reason = "called for each half-edge")]
fn see(v: u32, neighbour: u32, seen_from: &mut [u32], tally: &mut Tally) -> Option<u32> {
    let seen = seen_from.get_mut(neighbour as usize)?;
    tally.simple &= core::mem::replace(seen, v) != v;
    Some(neighbour)
}

/// Half of B2: whether the isolated vertex names a boundary component that starts at it. It is optional if the vertex can lie in an
/// unbounded face without a record.
fn is_claimed<V: View + ?Sized>(view: &V, extent: Extent, v: usize) -> Option<bool> {
    let Some(b) = view.isolated(v) else {
        return (!extent.has(Part::UnboundedFace)).then_some(false);
    };
    let starts_here =
        extent.boundaries.has(b) && view.is_boundary(b) && view.boundary_start(b) == Some(Start::Vertex(v));
    starts_here.then_some(true)
}

/// The number of the component of each vertex; nil if it is not live.
pub(super) struct ComponentNumbers {
    pub(super) of: Vec<u32>,
    pub(super) count: usize,
}

/// Joins vertices until `fewest` components are left, or every edge is used.
///
/// First each vertex joins its neighbour with the smallest number. Numbers fall along these steps, so they end, and if
/// neighbours have close numbers they end at one vertex of each component. The rest is joined edge by edge.
#[inline(never)]
pub(super) fn join<V: View + ?Sized>(
    view: &V,
    extent: Extent,
    around: Rotations,
    fewest: usize,
) -> Option<ComponentNumbers> {
    let (mut of, mut count) = (around.nearest, 0);
    for v in 0..of.len() {
        let nearest = of[v] as usize;
        if nearest == v {
            of[v] = count as u32;
            count += 1;
        } else if nearest < v {
            of[v] = of[nearest];
        }
    }
    if count <= fewest {
        return Some(ComponentNumbers { of, count });
    }
    let mut sets = Sets::try_new(count)?;
    for h in (Subject { view, extent }).half_edges() {
        if sets.count == fewest {
            break;
        }
        // Without twin the edge ends at the origin of the next half-edge.
        let t = match view.twin(h as usize) {
            Some(t) if t < h as usize => continue,
            Some(t) => extent.half_edges.existing(Some(t))?,
            None => extent.half_edges.existing(view.next(h as usize))?,
        };
        sets.join(*of.get(view.origin(h as usize)?)?, *of.get(view.origin(t)?)?);
    }
    let count = sets.count;
    let numbers = sets.numbered()?;
    for of in of.iter_mut().filter(|of| **of != NIL) {
        *of = *numbers.get(*of as usize)?;
    }
    Some(ComponentNumbers { of, count })
}

pub(super) struct Starts {
    pub(super) half_edges: usize,
    pub(super) unpaired: usize,
    /// By vertex: a half-edge that leaves it, or nil; only if vertices store none.
    leaving: Option<Vec<u32>>,
    /// By vertex: the half-edge without twin that ends there, or nil; empty if all half-edges have twins.
    pub(super) into: Vec<u32>,
}

/// Counts the half-edges, and records the starts that the structure does not store. `None` if two half-edges without twin end at one
/// vertex: two fans share it.
pub(super) fn find_starts<V: View + ?Sized>(view: &V, extent: Extent) -> Option<Starts> {
    let mut starts = Starts { half_edges: 0, unpaired: 0, leaving: None, into: Vec::new() };
    if !extent.has(Part::Leaving) {
        let mut leaving = extent.vertices.nils()?;
        for h in (Subject { view, extent }).half_edges() {
            if let Some(noted) = view.origin(h as usize).and_then(|v| leaving.get_mut(v)) {
                *noted = h;
            }
        }
        starts.leaving = Some(leaving);
    }
    if !extent.expect.is_open() {
        starts.half_edges = match view.half_edge_columns().and_then(|columns| columns.live_edges) {
            Some(live) => 2 * live.iter().map(|edge| (edge & 1) as usize).sum::<usize>(),
            None => extent.half_edges.all().map(|h| usize::from(view.is_half_edge(h))).sum(),
        };
        return Some(starts);
    }
    for h in (Subject { view, extent }).half_edges() {
        starts.half_edges += 1;
        if view.twin(h as usize).is_none() {
            starts.unpaired += 1;
            starts.note_end(view, extent, h)?;
        }
    }
    Some(starts)
}

impl Starts {
    /// Returns the first live half-edge, if all half-edges from there on are live.
    pub(super) fn first_live<V: View + ?Sized>(&self, view: &V, extent: Extent) -> Option<u32> {
        let first = extent.half_edges.count.checked_sub(self.half_edges as u32)?;
        (0..first).all(|h| !view.is_half_edge(h as usize)).then_some(first)
    }

    #[inline]
    pub(super) fn leaving<V: View + ?Sized>(&self, view: &V, v: usize) -> Option<usize> {
        match &self.leaving {
            None => view.leaving(v),
            Some(noted) => noted.get(v).copied().filter(|h| *h != NIL).map(|h| h as usize),
        }
    }

    #[inline]
    pub(super) fn into(&self, v: usize) -> Option<usize> {
        self.into.get(v).copied().filter(|h| *h != NIL).map(|h| h as usize)
    }

    fn note_end<V: View + ?Sized>(&mut self, view: &V, extent: Extent, h: u32) -> Option<()> {
        if self.into.is_empty() {
            self.into = extent.vertices.nils()?;
        }
        let next = extent.half_edges.existing(view.next(h as usize)).filter(|n| view.is_half_edge(*n))?;
        let into = self.into.get_mut(view.origin(next)?)?;
        (core::mem::replace(into, h) == NIL).then_some(())
    }
}
