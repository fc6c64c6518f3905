//! The scan over the half-edges: R1, L1, L2 where there is `prev`, L3, and that what a half-edge names is what the next names.

use super::extent::{Extent, existing, nils};
use crate::validate::columns::NIL;
use crate::validate::expectation::Part;
use crate::validate::view::{Link, View};
use alloc::vec::Vec;

/// With more half-edges in doubt than these, all are.
const MOST_DOUBTS: usize = 1024;

/// What the scan finds.
#[allow(clippy::struct_excessive_bools, reason = "each says one thing about all half-edges")]
pub(super) struct Links {
    /// How many half-edges are live.
    pub(super) half_edges: usize,
    /// How many of them have no twin.
    pub(super) unpaired: usize,
    /// How many of them name neither face nor boundary component, where there are such.
    pub(super) unnamed: usize,
    /// Per vertex a half-edge that leaves it, or nil, where vertices keep none.
    leaving: Option<Vec<u32>>,
    /// Per vertex a half-edge without twin that ends there, or nil; empty if all have one.
    pub(super) into: Vec<u32>,
    /// Whether no two half-edges without twin end at one vertex.
    pub(super) one_into_each: bool,
    /// The half-edges at which something is wrong, in order, and what of it.
    wrong: Vec<u32>,
    pub(super) next_holds: bool,
    pub(super) name_holds: bool,
    pub(super) twin_holds: bool,
}

/// The half-edges that are in doubt: all others keep their rules.
pub(in crate::validate) struct Doubts {
    /// In order of their numbers. All of them are live.
    pub(in crate::validate) half_edges: Vec<u32>,
    /// How many half-edges are live, and how many of these have no twin.
    pub(in crate::validate) live: usize,
    pub(in crate::validate) unpaired: usize,
}

impl Links {
    /// A half-edge that leaves the vertex.
    #[inline]
    pub(super) fn leaving<V: View + ?Sized>(&self, view: &V, v: usize) -> Option<usize> {
        match &self.leaving {
            None => view.leaving(v),
            Some(noted) => noted.get(v).copied().filter(|h| *h != NIL).map(|h| h as usize),
        }
    }

    /// A half-edge without twin that ends at the vertex.
    #[inline]
    pub(super) fn into(&self, v: usize) -> Option<usize> {
        self.into.get(v).copied().filter(|h| *h != NIL).map(|h| h as usize)
    }

    /// Notes a half-edge that leaves each vertex, in the place of those that vertices keep. None if that is done, or there is no
    /// memory for it.
    pub(super) fn note_leaving<V: View + ?Sized>(&mut self, view: &V, extent: Extent) -> Option<()> {
        if self.leaving.is_some() {
            return None;
        }
        let mut leaving = nils(extent.vertices)?;
        for h in (0..extent.half_edges).filter(|h| view.is_half_edge(*h)) {
            note(view, &mut leaving, h);
        }
        self.leaving = Some(leaving);
        Some(())
    }

    /// The half-edges that may break a rule: those at which something is wrong, their twins, of which they may be the only
    /// witness, and those to which no `prev` leads back. None if they are too many.
    pub(super) fn doubts<V: View + ?Sized>(&self, view: &V, extent: Extent) -> Option<Doubts> {
        let mut half_edges = Vec::new();
        half_edges.try_reserve_exact(3 * self.wrong.len()).ok()?;
        for h in &self.wrong {
            half_edges.push(*h);
            let twin = existing(view.twin(*h as usize), extent.half_edges).filter(|t| view.is_half_edge(*t));
            half_edges.extend(twin.map(|t| t as u32));
        }
        if !self.next_holds && extent.has(Part::Prev) {
            for h in (0..extent.half_edges).filter(|h| view.is_half_edge(*h)) {
                let before = existing(view.prev(h), extent.half_edges).filter(|p| view.is_half_edge(*p));
                if before.and_then(|p| view.next(p)) != Some(h) {
                    if half_edges.len() > 3 * MOST_DOUBTS {
                        return None;
                    }
                    half_edges.try_reserve(1).ok()?;
                    half_edges.push(h as u32);
                }
            }
        }
        half_edges.sort_unstable();
        half_edges.dedup();
        Some(Doubts { half_edges, live: self.half_edges, unpaired: self.unpaired })
    }
}

/// Puts in doubt every half-edge that names a boundary component, or a face, that is not live. None if they are too many.
///
/// Where the lists are right, all that is named is listed, and so it is live.
pub(super) fn doubt_names<V: View + ?Sized>(view: &V, extent: Extent, doubts: &mut Doubts) -> Option<()> {
    let by_record = extent.has(Part::BoundaryComponents);
    if !extent.has(Part::Faces) {
        return Some(());
    }
    let is_live = |name: usize| {
        if by_record {
            name < extent.boundaries && view.is_boundary(name)
        } else {
            name < extent.faces && view.is_face(name)
        }
    };
    let most = doubts.half_edges.len() + MOST_DOUBTS;
    for h in (0..extent.half_edges).filter(|h| view.is_half_edge(*h)) {
        let name = if by_record { view.boundary(h) } else { view.face(h) };
        if name.is_none_or(is_live) {
            continue;
        }
        if doubts.half_edges.len() == most {
            return None;
        }
        doubts.half_edges.try_reserve(1).ok()?;
        doubts.half_edges.push(h as u32);
    }
    doubts.half_edges.sort_unstable();
    doubts.half_edges.dedup();
    Some(())
}

/// Reads the links of every half-edge, in order of their numbers, so that none waits for another. None if too many are wrong.
#[inline(never)]
pub(super) fn scan<V: View + ?Sized>(view: &V, extent: Extent) -> Option<Links> {
    let mut links = Links {
        half_edges: 0,
        unpaired: 0,
        unnamed: 0,
        leaving: None,
        into: Vec::new(),
        one_into_each: true,
        wrong: Vec::new(),
        next_holds: true,
        name_holds: true,
        twin_holds: true,
    };
    if extent.has(Part::Leaving) {
        scan_and(view, extent, &mut links, |_| {})?;
    } else {
        let mut leaving = nils(extent.vertices)?;
        scan_and(view, extent, &mut links, |h| note(view, &mut leaving, h))?;
        links.leaving = Some(leaving);
    }
    Some(links)
}

/// Notes that the half-edge leaves its origin.
#[inline]
fn note<V: View + ?Sized>(view: &V, leaving: &mut [u32], h: usize) {
    if let Some(noted) = view.origin(h).and_then(|v| leaving.get_mut(v)) {
        *noted = h as u32;
    }
}

/// Scans, and tells `note` each half-edge.
#[inline(always)]
#[allow(clippy::inline_always, reason = "the scan is a loop over all half-edges")]
fn scan_and<V: View + ?Sized>(view: &V, extent: Extent, links: &mut Links, mut note: impl FnMut(usize)) -> Option<()> {
    let scan = Scan::new(view, extent);
    let mut live = 0;
    for h in 0..extent.half_edges {
        if !view.is_half_edge(h) {
            continue;
        }
        live += 1;
        if !scan.is_inside_and_holds(h) {
            at_border_or_wrong(view, extent, h, links)?;
        }
        note(h);
    }
    links.half_edges = live;
    Some(())
}

/// Looks at what may be at the border, notes what is, and what is wrong.
#[cold]
#[inline(never)]
fn at_border_or_wrong<V: View + ?Sized>(view: &V, extent: Extent, h: usize, links: &mut Links) -> Option<()> {
    let scan = Scan::new(view, extent);
    let twin = view.twin(h);
    let next = existing(view.next(h), extent.half_edges).filter(|n| view.is_half_edge(*n));
    let name = scan.name(h);
    let next_holds = next.is_some_and(|n| !scan.with_prev || view.prev(n) == Some(h));
    let name_holds = next.is_none_or(|n| scan.name(n) == name) && scan.may_be_named(name, twin);
    let twin_holds = scan.twin_holds(h, twin, next);
    if !(next_holds && name_holds && twin_holds) {
        links.doubt(h, [next_holds, name_holds, twin_holds])?;
    }
    if twin.is_none() {
        links.unpaired += 1;
        links.ends(scan.target(next), h, extent)?;
    }
    links.unnamed += usize::from(name.is_none());
    Some(())
}

impl Links {
    /// Notes a half-edge at which something is wrong.
    #[cold]
    fn doubt(&mut self, h: usize, [next_holds, name_holds, twin_holds]: [bool; 3]) -> Option<()> {
        self.next_holds &= next_holds;
        self.name_holds &= name_holds;
        self.twin_holds &= twin_holds;
        if self.wrong.len() == MOST_DOUBTS {
            return None;
        }
        self.wrong.try_reserve(1).ok()?;
        self.wrong.push(h as u32);
        Some(())
    }

    /// Notes that a half-edge without twin ends at a vertex.
    fn ends(&mut self, target: Option<usize>, h: usize, extent: Extent) -> Option<()> {
        if !extent.expect.is_open() {
            return Some(());
        }
        if self.into.is_empty() {
            self.into = nils(extent.vertices)?;
        }
        if let Some(into) = target.and_then(|v| self.into.get_mut(v)) {
            self.one_into_each &= *into == NIL;
            *into = h as u32;
        }
        Some(())
    }
}

/// What the scan asks of each half-edge.
#[allow(clippy::struct_excessive_bools, reason = "what is asked for, read once")]
struct Scan<'a, V: ?Sized> {
    view: &'a V,
    extent: Extent,
    with_prev: bool,
    by_record: bool,
    by_label: bool,
    open: bool,
}

#[allow(clippy::inline_always, reason = "the scan is a loop over all half-edges")]
impl<'a, V: View + ?Sized> Scan<'a, V> {
    #[inline(always)]
    fn new(view: &'a V, extent: Extent) -> Self {
        Self {
            view,
            extent,
            with_prev: extent.has(Part::Prev),
            by_record: extent.has(Part::BoundaryComponents),
            by_label: extent.has(Part::Faces) && !extent.has(Part::BoundaryComponents),
            open: extent.expect.is_open(),
        }
    }

    /// Whether nothing is wrong with a half-edge that has twin and face, as nearly all have.
    #[inline(always)]
    fn is_inside_and_holds(&self, h: usize) -> bool {
        let (view, half_edges) = (self.view, self.extent.half_edges);
        let (Some(t), Some(n)) = (existing(view.twin(h), half_edges), existing(view.next(h), half_edges)) else {
            return false;
        };
        let target = view.origin(t);
        let name = self.name(h);
        self.is_mutual(h, t)
            && view.is_half_edge(n)
            && view.origin(n) == target
            && self.is_vertex(target)
            && (!self.with_prev || view.prev(n) == Some(h))
            && (!self.by_record && !self.by_label || name.is_some() && self.name(n) == name)
    }

    /// The boundary component, or without records for these the face, that the half-edge names.
    #[inline(always)]
    fn name(&self, h: usize) -> Link {
        if self.by_record {
            self.view.boundary(h)
        } else if self.by_label {
            self.view.face(h)
        } else {
            None
        }
    }

    /// R1 of that name, but for what the name leads to.
    fn may_be_named(&self, name: Link, twin: Link) -> bool {
        name.is_some() || !self.by_record && !self.by_label || self.open && twin.is_some()
    }

    /// L1 and L3, and R1 of the origin of the twin. A half-edge without twin answers for its own.
    fn twin_holds(&self, h: usize, twin: Link, next: Link) -> bool {
        let view = self.view;
        let Some(t) = twin else { return self.open && self.is_vertex(view.origin(h)) };
        t < self.extent.half_edges && self.is_mutual(h, t) && {
            let target = view.origin(t);
            self.is_vertex(target) && next.is_none_or(|n| view.origin(n) == target)
        }
    }

    /// L1.
    #[inline(always)]
    fn is_mutual(&self, h: usize, t: usize) -> bool {
        t != h && self.view.is_half_edge(t) && self.view.twin(t) == Some(h)
    }

    #[inline(always)]
    fn is_vertex(&self, vertex: Link) -> bool {
        vertex.is_some_and(|v| v < self.extent.vertices && self.view.is_vertex(v))
    }

    /// The vertex where the next half-edge starts.
    fn target(&self, next: Link) -> Option<usize> {
        next.and_then(|n| existing(self.view.origin(n), self.extent.vertices))
    }
}
