//! The half-edges that are in doubt, where something is wrong.

use super::links::{Links, MOST_DOUBTS};
use super::marks::Marks;
use crate::validate::structure::{Part, View};
use crate::validate::subject::Extent;
use alloc::vec::Vec;

/// The half-edges that are in doubt: all others keep their rules.
pub(crate) struct Doubts {
    /// In order of their numbers. All of them are live.
    pub(crate) half_edges: Vec<u32>,
    /// The number of live half-edges; `unpaired` of these have no twin.
    pub(crate) live: usize,
    pub(crate) unpaired: usize,
}

/// The rules that earlier steps have settled for all half-edges.
#[derive(Clone, Copy)]
pub(super) struct Assurances {
    /// Their origins are live.
    pub(super) origins: bool,
    /// The boundary components or faces that they name are live, and constant along `next`.
    pub(super) names: bool,
}

/// The half-edges that may break a rule: those at which the scan has found something wrong, and, by a second scan, those at which
/// something is wrong that nothing else has settled. None if they are too many.
pub(super) fn find<V: View + ?Sized>(view: &V, extent: Extent, links: &Links, settled: Assurances) -> Option<Doubts> {
    let mut half_edges = Vec::new();
    for h in &links.wrong {
        with_twin(view, extent, *h as usize, &mut half_edges)?;
    }
    scan_again(view, extent, links, settled, &mut half_edges)?;
    half_edges.sort_unstable();
    half_edges.dedup();
    Some(Doubts { half_edges, live: links.half_edges, unpaired: links.unpaired })
}

/// The second scan, over the half-edges at which the first has found nothing wrong.
fn scan_again<V: View + ?Sized>(
    view: &V,
    extent: Extent,
    links: &Links,
    settled: Assurances,
    half_edges: &mut Vec<u32>,
) -> Option<()> {
    let is_prev_settled = links.next_holds || !extent.has(Part::Prev);
    let are_names_settled = settled.names || !extent.has(Part::Faces);
    if is_prev_settled && settled.origins && are_names_settled {
        return Some(());
    }
    let most = half_edges.len() + MOST_DOUBTS;
    let mut wrong = links.wrong.iter().peekable();
    let mut led_to = Marks::default();
    if !is_prev_settled {
        led_to.make_room(extent.half_edges)?;
    }
    for h in extent.half_edges.all().filter(|h| view.is_half_edge(*h)) {
        if wrong.next_if_eq(&&(h as u32)).is_some() {
            continue;
        }
        let mut is_named = true;
        if !(is_prev_settled && are_names_settled) {
            let next = extent.half_edges.existing(view.next(h))?;
            if !is_prev_settled {
                led_to.mark(next)?;
            }
            is_named = are_names_settled || is_named_as(view, extent, h, next);
        }
        if is_named && (settled.origins || has_origin(view, extent, h)) {
            continue;
        }
        if half_edges.len() >= most {
            return None;
        }
        with_twin(view, extent, h, half_edges)?;
    }
    if !is_prev_settled {
        // As many as were wrong.
        let unled = led_to.rest(extent.half_edges).filter(|h| view.is_half_edge(*h));
        for h in unled.take(MOST_DOUBTS) {
            half_edges.try_reserve(1).ok()?;
            half_edges.push(h as u32);
        }
    }
    Some(())
}

/// Puts in doubt a half-edge and its twin, which may be the only witness, and whose target is the origin of this one.
fn with_twin<V: View + ?Sized>(view: &V, extent: Extent, h: usize, half_edges: &mut Vec<u32>) -> Option<()> {
    half_edges.try_reserve(2).ok()?;
    half_edges.push(h as u32);
    let twin = extent.half_edges.existing(view.twin(h)).filter(|t| view.is_half_edge(*t));
    half_edges.extend(twin.map(|t| t as u32));
    Some(())
}

#[inline]
fn has_origin<V: View + ?Sized>(view: &V, extent: Extent, h: usize) -> bool {
    view.origin(h).is_some_and(|v| extent.vertices.has(v) && view.is_vertex(v))
}

/// True if the half-edge names a live boundary component, or face, or may name none; and its next names the same.
#[inline]
fn is_named_as<V: View + ?Sized>(view: &V, extent: Extent, h: usize, next: usize) -> bool {
    let name = extent.name(view, h);
    let is_live = match name {
        None => extent.expect.is_open() && view.twin(h).is_some(),
        Some(b) if extent.has(Part::BoundaryComponents) => extent.boundaries.has(b) && view.is_boundary(b),
        Some(f) => extent.faces.has(f) && view.is_face(f),
    };
    is_live && extent.name(view, next) == name
}
