//! The walks around the vertices: V1, V2 and the vertices' half of B2.

use super::cycles::{Cycles, NoCount, Pass, Short};
use super::links::Links;
use crate::validate::structure::{Part, Start, View};
use crate::validate::subject::Extent;
use alloc::vec::Vec;

/// The result of the walks around the vertices.
pub(super) struct RotationWalk {
    pub(super) counted: VertexTally,
    /// Per vertex the neighbour with the smallest number, or itself if that is smaller.
    pub(super) nearest: Vec<u32>,
    /// The cycles, where there are no faces to list them.
    pub(super) cycles: Option<Cycles>,
}

/// The counts made at vertices.
#[derive(Clone, Copy)]
pub(super) struct VertexTally {
    pub(super) vertices: usize,
    pub(super) isolated: usize,
    /// The number of isolated vertices that name a boundary component that starts at them; none if one names anything else, or a
    /// connected one does.
    pub(super) claimed: Option<usize>,
    /// The number of half-edges visited.
    pub(super) half_edges: usize,
    /// The number of cycles counted on the way.
    pub(super) cycles: usize,
    /// The number of vertices whose number is smaller than that of each neighbour.
    pub(super) roots: usize,
    /// True if there is neither a loop nor a pair of parallel edges.
    pub(super) simple: bool,
}

impl VertexTally {
    pub(super) const NOTHING: Self =
        Self { vertices: 0, isolated: 0, claimed: Some(0), half_edges: 0, cycles: 0, roots: 0, simple: true };
}

/// Walks around every vertex, in order of their numbers. Where there are no faces, counts the cycles on the way.
pub(super) fn walk<V: View + ?Sized>(view: &V, extent: Extent, links: &Links) -> Option<RotationWalk> {
    let mut nearest = extent.vertices.nils()?;
    let mut short = Short::default();
    let are_listed = extent.has(Part::Faces);
    let counted = if are_listed {
        walk_from(view, extent, links, 0, &mut nearest, &mut NoCount)?
    } else {
        walk_from(view, extent, links, 0, &mut nearest, &mut short)?
    };
    (counted.half_edges == links.half_edges).then_some(())?;
    let cycles = if are_listed { None } else { Some(short.all(view, extent, counted.cycles, links.half_edges)?) };
    Some(RotationWalk { counted, nearest, cycles })
}

/// Walks around the vertices from `first` on, one for each entry of `nearest`, which it fills in, and counts of the cycles what is
/// asked for.
#[inline(never)]
pub(super) fn walk_from<V: View + ?Sized, P: Pass>(
    view: &V,
    extent: Extent,
    links: &Links,
    first: usize,
    nearest: &mut [u32],
    cycles: &mut P,
) -> Option<VertexTally> {
    let mut found = VertexTally::NOTHING;
    let mut steps = Steps { left: links.half_edges, cycles: 0 };
    // The last vertex from which a vertex was seen as a neighbour: seen twice from one means parallel edges.
    let mut seen_from = extent.vertices.nils()?;
    let names_boundary = extent.has(Part::BoundaryComponents) && extent.has(Part::Holes);
    for (v, nearest_to) in (first..).zip(nearest).filter(|(v, _)| view.is_vertex(*v)) {
        found.vertices += 1;
        let mut nearest = v;
        match links.leaving(view, v) {
            None => {
                found.isolated += 1;
                if names_boundary {
                    found.claimed = found.claimed.and_then(|all| Some(all + usize::from(is_claimed(view, extent, v)?)));
                }
            }
            Some(start) => {
                leaves(view, extent, start, v).then_some(())?;
                if names_boundary && view.isolated(v).is_some() {
                    found.claimed = None;
                }
                // A loop leads to its own vertex twice.
                let simple = &mut found.simple;
                let see = |neighbour| {
                    let seen = seen_from.get_mut(neighbour)?;
                    *simple &= core::mem::replace(seen, v as u32) != v as u32;
                    nearest = nearest.min(neighbour);
                    Some(())
                };
                match links.into(v) {
                    None => around(view, extent, start, &mut steps, see, cycles)?,
                    Some(before) => across(view, extent, before, &mut steps, see, cycles)?,
                }
            }
        }
        *nearest_to = nearest as u32;
        found.roots += usize::from(nearest == v);
    }
    found.half_edges = links.half_edges - steps.left;
    found.cycles = steps.cycles;
    Some(found)
}

/// True if a half-edge that a vertex keeps is live and leaves it.
#[inline]
pub(super) fn leaves<V: View + ?Sized>(view: &V, extent: Extent, start: usize, v: usize) -> bool {
    extent.half_edges.has(start) && view.is_half_edge(start) && view.origin(start) == Some(v)
}

/// The counters of the walks.
struct Steps {
    /// The number of half-edges left to visit.
    left: usize,
    cycles: usize,
}

impl Steps {
    /// Visits one more; none if none is left.
    #[inline]
    fn visit(&mut self) -> Option<()> {
        self.left = self.left.checked_sub(1)?;
        Some(())
    }
}

/// Walks around one vertex, from a half-edge that leaves it; none if no half-edge is left to visit before it returns.
#[inline]
fn around<V: View + ?Sized>(
    view: &V,
    extent: Extent,
    start: usize,
    steps: &mut Steps,
    mut see: impl FnMut(usize) -> Option<()>,
    cycles: &mut impl Pass,
) -> Option<()> {
    let mut h = start;
    loop {
        steps.visit()?;
        let t = extent.half_edges.existing(view.twin(h))?;
        see(view.origin(t)?)?;
        h = extent.half_edges.existing(view.next(t))?;
        steps.cycles += cycles.pass(view, extent, [t, h])?;
        if h == start {
            return Some(());
        }
    }
}

/// Walks across one vertex at an open boundary, from the half-edge after the one without twin that ends there to the one
/// without twin that leaves it.
fn across<V: View + ?Sized>(
    view: &V,
    extent: Extent,
    before: usize,
    steps: &mut Steps,
    mut see: impl FnMut(usize) -> Option<()>,
    cycles: &mut impl Pass,
) -> Option<()> {
    see(view.origin(before)?)?;
    let mut h = extent.half_edges.existing(view.next(before))?;
    steps.cycles += cycles.pass(view, extent, [before, h])?;
    loop {
        steps.visit()?;
        let Some(t) = view.twin(h) else {
            let next = extent.half_edges.existing(view.next(h))?;
            see(view.origin(next)?)?;
            return Some(());
        };
        let t = extent.half_edges.existing(Some(t))?;
        see(view.origin(t)?)?;
        h = extent.half_edges.existing(view.next(t))?;
        steps.cycles += cycles.pass(view, extent, [t, h])?;
    }
}

/// Half of B2: whether the isolated vertex names a boundary component, which then starts at it. It need not if it may lie in
/// an unbounded face that has no record.
pub(super) fn is_claimed<V: View + ?Sized>(view: &V, extent: Extent, v: usize) -> Option<bool> {
    let Some(b) = view.isolated(v) else {
        return (!extent.has(Part::UnboundedFace)).then_some(false);
    };
    let starts_here =
        extent.boundaries.has(b) && view.is_boundary(b) && view.boundary_start(b) == Some(Start::Vertex(v));
    starts_here.then_some(true)
}
