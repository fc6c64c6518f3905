//! The fast pass: whether all tests pass. It notes no failures, and reads half-edges from columns if the structure lends them.
//!
//! It runs fewer tests than the [check](super::check()): the others follow (`proofs/coq/certificates/Fewer.v`). `next(prev(h)) = h` follows from
//! `prev(next(h)) = h` by counting. In the plane, and for genus 0, if the sums fit, a vertex keeps a half-edge of each rotation, and a boundary
//! component starts with one of each cycle: so the origin of a half-edge keeps one, and its boundary component starts with one. As different
//! boundary components have different places, faces list nothing else if there are no more entries than boundary components.

use super::answers::Answers;
use super::storage::Columns;
use super::sums::Sums;
use crate::NIL;
use twinedge::validate::{HalfEdgeColumns, Link, Part, View};

/// Returns the sums of a structure in the plane, if its labels pass.
#[inline(always)]
pub(super) fn plane<V: View + ?Sized, C: Columns>(s: &Answers<'_, V, C>) -> Option<Sums> {
    s.readable().then_some(())?;
    let half_edges = match Lent::of(s, s.by_record()) {
        Some(lent) => plane_half_edges(s, lent)?,
        None => plane_half_edges(s, Asked { s, name: |h| s.boundary(h) })?,
    };
    let mut sums = Sums { half_edges, ..Sums::default() };
    for v in (0..s.vertices).filter(|v| s.is_vertex(*v)) {
        sums.rotations += usize::from(s.leaving(v).is_some());
        s.vertex_ok(v).then_some(())?;
    }
    // The number of entries of faces that may follow.
    let mut entries = 0_usize;
    for b in (0..s.boundaries).filter(|b| s.is_boundary(*b)) {
        let is_cycle = s.cycle_start(b).is_some();
        sums.cycles += usize::from(is_cycle);
        sums.roots += usize::from(is_cycle && s.is_inner(b));
        entries += 1;
        (s.start_ok(b) && s.place_ok(b)).then_some(())?;
    }
    for f in (0..s.faces).filter(|f| s.is_face(*f)) {
        let is_unbounded = s.outer(f).is_none();
        sums.unbounded += usize::from(is_unbounded);
        entries = entries.checked_sub(usize::from(!is_unbounded))?.checked_sub(s.inner_count(f))?;
        (!s.by_name() || s.face_starts_ok(f)).then_some(())?;
    }
    (sums.unbounded == 1 && sums.fit(0)).then_some(sums)
}

/// Returns the number of half-edges.
#[inline(always)]
fn plane_half_edges<V: View + ?Sized, C: Columns>(s: &Answers<'_, V, C>, links: impl HalfEdges) -> Option<usize> {
    let mut count = 0;
    for h in (0..s.half_edges).filter(|h| links.is_live(*h)) {
        let star = links.star(h)?;
        count += 1;
        let is_root = || s.boundary(h).is_some_and(|b| s.is_root(h, b));
        (s.is_ranked(h, star) || is_root()).then_some(())?;
        (!s.by_name() || s.face_name_ok(h, s.boundary(h))).then_some(())?;
    }
    Some(count)
}

impl<V: View + ?Sized, C: Columns> Answers<'_, V, C> {
    /// Returns true if one of these half-edges has a lower rank than `h`.
    #[inline(always)]
    pub(super) fn is_ranked(&self, h: usize, (t, n, p): Star) -> bool {
        self.is_lower(p, h) || self.is_lower(Some(t), h) || self.is_lower(Some(n), h)
    }
}

/// The twin, the next and the previous half-edge.
pub(super) type Star = (usize, usize, Link);

/// The links of half-edges as numbers. Links that are nil or lead to no slot become numbers that are no slots.
pub(super) trait HalfEdges: Copy {
    fn is_live(self, h: usize) -> bool;
    /// Like the methods below, of live half-edges only.
    fn origin(self, h: usize) -> usize;
    /// Returns the twin, if it is another live half-edge, whose twin is `h`.
    fn twin_back(self, h: usize) -> Option<usize>;
    fn next(self, h: usize) -> usize;
    fn prev(self, h: usize) -> Link;
    /// Returns the boundary component, or the face that serves as one.
    fn name(self, h: usize) -> usize;

    /// Runs the tests of the links of a live half-edge. Returns the twin, the next and the previous half-edge if all pass.
    #[inline(always)]
    fn star(self, h: usize) -> Option<Star> {
        let (t, n) = (self.twin_back(h)?, self.next(h));
        let passes = self.is_live(n)
            && self.prev(n) == Some(h)
            && self.origin(n) == self.origin(t)
            && self.name(n) == self.name(h);
        passes.then(|| (t, n, self.prev(h)))
    }
}

/// Half-edges as the structure and the labels answer.
pub(super) struct Asked<'a, V: ?Sized, C, N> {
    pub(super) s: &'a Answers<'a, V, C>,
    pub(super) name: N,
}

impl<V: ?Sized, C, N: Copy> Clone for Asked<'_, V, C, N> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<V: ?Sized, C, N: Copy> Copy for Asked<'_, V, C, N> {}

impl<V: View + ?Sized, C: Columns, N: Fn(usize) -> Option<usize> + Copy> HalfEdges for Asked<'_, V, C, N> {
    #[inline(always)]
    fn is_live(self, h: usize) -> bool {
        self.s.is_half_edge(h)
    }
    #[inline(always)]
    fn origin(self, h: usize) -> usize {
        self.s.view.origin(h).unwrap_or(usize::MAX)
    }
    #[inline(always)]
    fn twin_back(self, h: usize) -> Option<usize> {
        let is_twin = |t: usize| t != h && self.is_live(t) && self.s.view.twin(t) == Some(h);
        self.s.view.twin(h).filter(|t| is_twin(*t))
    }
    #[inline(always)]
    fn next(self, h: usize) -> usize {
        self.s.view.next(h).unwrap_or(usize::MAX)
    }
    #[inline(always)]
    fn prev(self, h: usize) -> Link {
        self.s.prev(h)
    }
    #[inline(always)]
    fn name(self, h: usize) -> usize {
        (self.name)(h).unwrap_or(usize::MAX)
    }
}

/// Half-edges in columns that the structure lends, all of them live from the first live one on. Columns have equal lengths.
#[derive(Clone, Copy)]
pub(super) struct Lent<'a> {
    origin: &'a [u32],
    next: &'a [u32],
    prev: &'a [u32],
    name: &'a [u32],
    first: usize,
}

impl<'a> Lent<'a> {
    /// `are_named`: whether the structure stores what names their cycles.
    #[inline(always)]
    pub(super) fn of<V: View + ?Sized, C: Columns>(s: &Answers<'a, V, C>, are_named: bool) -> Option<Self> {
        let HalfEdgeColumns { origin, next, prev, boundary, face, live_edges } = s.view.half_edge_columns()?;
        let name = if s.by_name() { face } else { boundary };
        let n = s.half_edges;
        let is_vacant = |edge: &u32| edge % 2 == 0;
        let vacant = live_edges.map_or(0, |edges| edges.iter().take_while(|edge| is_vacant(edge)).count());
        let all_live = live_edges.is_none_or(|edges| edges.len() == n / 2 && !edges[vacant..].iter().any(is_vacant));
        (are_named && all_live && n % 2 == 0 && s.stores(Part::Prev)).then_some(())?;
        Some(Self {
            origin: origin.get(..n)?,
            next: next.get(..n)?,
            prev: prev.get(..n)?,
            name: name.get(..n)?,
            first: 2 * vacant,
        })
    }
}

#[inline(always)]
fn entry(column: &[u32], h: usize) -> usize {
    column.get(h).copied().unwrap_or(NIL) as usize
}

impl HalfEdges for Lent<'_> {
    #[inline(always)]
    fn is_live(self, h: usize) -> bool {
        self.first <= h && h < self.next.len()
    }
    #[inline(always)]
    fn origin(self, h: usize) -> usize {
        entry(self.origin, h)
    }
    #[inline(always)]
    fn twin_back(self, h: usize) -> Option<usize> {
        Some(h ^ 1)
    }
    #[inline(always)]
    fn next(self, h: usize) -> usize {
        entry(self.next, h)
    }
    #[inline(always)]
    fn prev(self, h: usize) -> Link {
        Some(entry(self.prev, h))
    }
    #[inline(always)]
    fn name(self, h: usize) -> usize {
        entry(self.name, h)
    }
}
