//! The walks around the vertices: V1, V2 and the vertices' half of B2.

use super::cycles::{Count, Cycles, Listed, Pass};
use super::extent::{Extent, existing, nils};
use super::links::Links;
use crate::validate::expectation::Part;
use crate::validate::view::{Start, View};
use alloc::vec::Vec;

/// What the walks around the vertices find.
pub(super) struct Rotations {
    pub(super) vertices: usize,
    pub(super) isolated: usize,
    /// How many of the isolated ones name a boundary component that starts at them; none if one names anything else, or a
    /// connected one does.
    pub(super) claimed: Option<usize>,
    /// How many half-edges were visited.
    pub(super) half_edges: usize,
    /// Per vertex the neighbour with the smallest number, or itself if that is smaller.
    pub(super) nearest: Vec<u32>,
    /// How many vertices are their own.
    pub(super) roots: usize,
    /// Whether there is neither a loop nor a pair of parallel edges.
    pub(super) simple: bool,
    /// The cycles, where there are no faces to list them.
    pub(super) cycles: Option<Cycles>,
}

/// Walks around every vertex, in order of their numbers. Where there are no faces, counts the cycles on the way.
pub(super) fn walk<V: View + ?Sized>(view: &V, extent: Extent, links: &Links) -> Option<Rotations> {
    if extent.has(Part::Faces) {
        return walk_and(view, extent, links, &mut Listed);
    }
    let mut cycles = Count::default();
    let mut found = walk_and(view, extent, links, &mut cycles)?;
    found.cycles = Some(cycles.all(view, extent, links.half_edges)?);
    Some(found)
}

/// Walks around every vertex, and counts of the cycles what is asked for.
#[inline(never)]
fn walk_and<V: View + ?Sized, P: Pass>(view: &V, extent: Extent, links: &Links, cycles: &mut P) -> Option<Rotations> {
    let mut found = Rotations {
        vertices: 0,
        isolated: 0,
        claimed: Some(0),
        half_edges: 0,
        nearest: nils(extent.vertices)?,
        roots: 0,
        simple: true,
        cycles: None,
    };
    // The last vertex from which a vertex was seen as a neighbour: seen twice from one means parallel edges.
    let mut seen_from = nils(extent.vertices)?;
    let names_boundary = extent.has(Part::BoundaryComponents) && extent.has(Part::Holes);
    for v in (0..extent.vertices).filter(|v| view.is_vertex(*v)) {
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
                let limit = links.half_edges - found.half_edges;
                // A loop leads to its own vertex twice.
                let simple = &mut found.simple;
                let see = |neighbour| {
                    let seen = seen_from.get_mut(neighbour)?;
                    *simple &= core::mem::replace(seen, v as u32) != v as u32;
                    nearest = nearest.min(neighbour);
                    Some(())
                };
                found.half_edges += match links.into(v) {
                    None => around(view, extent, start, limit, see, cycles)?,
                    Some(before) => across(view, extent, before, limit, see, cycles)?,
                };
            }
        }
        found.nearest[v] = nearest as u32;
        found.roots += usize::from(nearest == v);
    }
    (found.half_edges == links.half_edges).then_some(found)
}

/// Whether a half-edge that a vertex keeps is live and leaves it.
#[inline]
pub(super) fn leaves<V: View + ?Sized>(view: &V, extent: Extent, start: usize, v: usize) -> bool {
    start < extent.half_edges && view.is_half_edge(start) && view.origin(start) == Some(v)
}

/// Walks around one vertex, from a half-edge that leaves it, and returns how many half-edges it visited; none if it visits
/// more than `limit`.
#[inline]
pub(super) fn around<V: View + ?Sized>(
    view: &V,
    extent: Extent,
    start: usize,
    limit: usize,
    mut see: impl FnMut(usize) -> Option<()>,
    cycles: &mut impl Pass,
) -> Option<usize> {
    let mut h = start;
    for visited in 0..limit {
        let t = existing(view.twin(h), extent.half_edges)?;
        see(view.origin(t)?)?;
        h = existing(view.next(t), extent.half_edges)?;
        cycles.pass(view, extent, [t, h])?;
        if h == start {
            return Some(visited + 1);
        }
    }
    None
}

/// Walks across one vertex at an open boundary, from the half-edge after the one without twin that ends there to the one
/// without twin that leaves it.
fn across<V: View + ?Sized>(
    view: &V,
    extent: Extent,
    before: usize,
    limit: usize,
    mut see: impl FnMut(usize) -> Option<()>,
    cycles: &mut impl Pass,
) -> Option<usize> {
    see(view.origin(before)?)?;
    let mut h = existing(view.next(before), extent.half_edges)?;
    cycles.pass(view, extent, [before, h])?;
    for visited in 0..limit {
        let Some(t) = view.twin(h) else {
            let next = existing(view.next(h), extent.half_edges)?;
            see(view.origin(next)?)?;
            return Some(visited + 1);
        };
        let t = existing(Some(t), extent.half_edges)?;
        see(view.origin(t)?)?;
        h = existing(view.next(t), extent.half_edges)?;
        cycles.pass(view, extent, [t, h])?;
    }
    None
}

/// Half of B2: whether the isolated vertex names a boundary component, which then starts at it. It need not if it may lie in
/// an unbounded face that has no record.
pub(super) fn is_claimed<V: View + ?Sized>(view: &V, extent: Extent, v: usize) -> Option<bool> {
    let Some(b) = view.isolated(v) else {
        return (!extent.has(Part::UnboundedFace)).then_some(false);
    };
    let starts_here = b < extent.boundaries && view.is_boundary(b) && view.boundary_start(b) == Some(Start::Vertex(v));
    starts_here.then_some(true)
}
