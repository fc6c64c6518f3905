//! The check: everything that the changed records can break.

use super::column::Row;
use super::diff::{Diff, WriteSet};
use super::links::{HalfEdge, Label, LinkReader, OUTER, Vertex, index, link};
use crate::validate::expectation::Surface;
use crate::validate::structure::{Part, Start, View};
use alloc::vec::Vec;

/// Memory reused by the next check.
#[derive(Clone, Debug, Default)]
pub(super) struct Scratch {
    /// Half-edges that are new at a vertex, or have a new successor there.
    rotations: Members,
    /// Half-edges that are new on a label, or have a new `next`.
    cycles: Members,
    walks: Walks,
}

struct Check<'a, V: ?Sized> {
    diff: &'a mut Diff,
    now: &'a LinkReader<'a, V>,
    written: &'a WriteSet,
    scratch: &'a mut Scratch,
}

/// Computes the links after a change. `None` if a rule from R1 to F2 is broken, or the sum of Euler's formula.
pub(super) fn check<V: View + ?Sized>(
    diff: &mut Diff,
    now: &LinkReader<'_, V>,
    written: &WriteSet,
    scratch: &mut Scratch,
) -> Option<()> {
    diff.clear(now);
    scratch.rotations.clear();
    scratch.cycles.clear();
    let mut check = Check { diff, now, written, scratch };
    check.note_written();
    check.half_edges()?;
    check.neighbours()?;
    if !now.has(Part::Prev) {
        check.previous()?;
    }
    if now.has(Part::Faces) {
        check.labels()?;
    }
    if now.has(Part::BoundaryComponents) {
        check.faces()?;
    }
    check.vertices()?;
    check.euler()
}

impl<V: View + ?Sized> Check<'_, V> {
    /// Notes the written records before any of them is checked: a change at a place that is not in the cache then waits for all
    /// rows at once.
    fn note_written(&mut self) {
        let WriteSet { vertices, half_edges, boundaries, faces, .. } = self.written;
        self.diff.half_edges.note_all(half_edges);
        self.diff.vertices.note_all(vertices);
        if self.now.has(Part::BoundaryComponents) {
            self.diff.labels.note_all(boundaries);
            self.diff.faces.note_all(faces);
        } else {
            self.diff.labels.note_all(faces);
        }
    }

    /// R1 of half-edges, L1, L2, L3, and constant labels along `next`, for each half-edge that may differ.
    ///
    /// For L2 it is enough that `prev(next(h)) = h` for each: then no two have the same `next`, so each is the `next` of one half-edge,
    /// its `prev`.
    fn half_edges(&mut self) -> Option<()> {
        (0..self.diff.half_edges.len()).try_for_each(|position| self.half_edge(position))
    }

    fn half_edge(&mut self, position: usize) -> Option<()> {
        let now = self.now;
        let h = self.diff.half_edges.index(position);
        let (before, mut row) = (self.diff.half_edges.before(h), now.half_edge(h)?);
        if row.is_live() && !now.has(Part::Prev) {
            // Unchanged, unless another half-edge turns out to lead here.
            row.prev = before.prev;
        }
        self.diff.half_edges.put(position, row);
        let moves = before.origin != row.origin;
        if before.is_live() {
            if moves {
                self.diff.vertices.note(before.origin as usize);
            }
            if before.label != row.label {
                self.diff.labels.note(before.label as usize);
            }
        }
        if !row.is_live() {
            return Some(());
        }
        let (twin, next) = (row.twin as usize, row.next as usize);
        let mutual = twin != h && now.view.twin(twin) == Some(h);
        let joined = !now.has(Part::Prev) || now.view.prev(next) == Some(h);
        let meets = now.view.origin(next)? == now.view.origin(twin)?;
        let labelled = !now.has(Part::Faces) || now.label_of(next)? == row.label as usize;
        if !(mutual && joined && meets && labelled) {
            return None;
        }
        if moves || self.diff.clockwise_before(h) != now.view.next(twin)? {
            self.turns(row.origin, h, !moves);
        }
        let is_old = before.is_live() && before.label == row.label;
        if now.has(Part::Faces) && (!is_old || before.next != row.next) {
            self.diff.labels.note(row.label as usize);
            self.scratch.cycles.push(Member { of: row.label, half_edge: h as u32, is_old });
        }
        Some(())
    }

    /// Records that a half-edge has a new successor in a rotation.
    fn turns(&mut self, v: u32, h: usize, is_old: bool) {
        self.diff.vertices.note(v as usize);
        self.scratch.rotations.push(Member { of: v, half_edge: h as u32, is_old });
    }

    /// Checks these rules also for unchanged half-edges whose twin or `next` may differ. A vacant half-edge has no links, so links that
    /// still lead to it are found.
    fn neighbours(&mut self) -> Option<()> {
        for position in 0..self.diff.half_edges.len() {
            let half_edges = &self.diff.half_edges;
            let h = half_edges.index(position);
            let (before, row) = (half_edges.before(h), half_edges.after(h));
            if !before.is_live() {
                continue;
            }
            let origin = |h: u32| half_edges.after(h as usize).origin;
            let [twin, prev] = [before.twin, before.prev].map(|h| h as usize);
            if !half_edges.may_differ(prev) {
                let leads = half_edges.before(prev);
                let joined = row.prev as usize == prev;
                let labelled = leads.label == row.label;
                if !(joined && labelled && origin(leads.twin) == row.origin) {
                    return None;
                }
            }
            if !half_edges.may_differ(twin) {
                let leads = half_edges.before(twin);
                if !(row.twin as usize == twin && origin(leads.next) == row.origin) {
                    return None;
                }
                if before.next != row.next {
                    self.turns(leads.origin, twin, true);
                }
            }
        }
        Some(())
    }

    /// L2 without `prev`: no two half-edges have the same `next`.
    fn previous(&mut self) -> Option<()> {
        for position in 0..self.diff.half_edges.len() {
            let half_edges = &mut self.diff.half_edges;
            let h = half_edges.index(position);
            let row = half_edges.after(h);
            let next = row.next as usize;
            let before = half_edges.before(next).prev;
            if !row.is_live() || before as usize == h {
                continue;
            }
            // The half-edge that led there before, if any, must lead elsewhere.
            let is_free = index(before).is_none_or(|led| half_edges.after(led).next != row.next);
            let prev = &mut half_edges.change(next)?.prev;
            if *prev != before || !is_free {
                return None;
            }
            *prev = h as u32;
        }
        Some(())
    }

    /// Checks labels that may be invalid: labels that half-edges have joined or left, labels that may differ, labels of vertices that
    /// may differ, and former outer labels of faces that may differ.
    ///
    /// R1, B1, the labels' half of B2, and F2 of outer labels; [`Self::faces`] checks F2 of the others.
    fn labels(&mut self) -> Option<()> {
        let (diff, now, written) = (&mut *self.diff, self.now, self.written);
        if now.has(Part::BoundaryComponents) {
            for v in &written.vertices {
                let named = [index(diff.vertices.before(*v).isolated), now.isolated(*v).filter(|b| now.is_label(*b))];
                named.into_iter().flatten().for_each(|b| diff.labels.note(b));
            }
            let outer = |f: &usize| index(diff.faces.before(*f).outer);
            written.faces.iter().filter_map(outer).for_each(|b| diff.labels.note(b));
        }
        self.scratch.cycles.sort();
        for position in 0..self.diff.labels.len() {
            let row = self.label(self.diff.labels.index(position))?;
            self.diff.labels.put(position, row);
        }
        Some(())
    }

    fn label(&mut self, b: usize) -> Option<Label> {
        let (diff, now) = (&*self.diff, self.now);
        let first = match diff.labels.before(b).start() {
            Start::HalfEdge(h) => Some(h),
            Start::Vertex(_) => None,
        };
        let next = |h: usize| diff.half_edges.before(h).next as usize;
        let remains = diff.remaining(first, next, |row| row.label as usize == b).is_some();
        let row = now.label(b)?;
        if !row.is_live() {
            return (!remains).then_some(row);
        }
        let members = self.scratch.cycles.of(b);
        let has_it = |h: usize| now.label_of(h) == Some(b);
        let starts = match row.start() {
            Start::HalfEdge(h) => has_it(h),
            Start::Vertex(v) => {
                let is_listed = now.has(Part::Holes) && row.place != OUTER;
                is_listed && !remains && members.is_empty() && now.view.isolated(v) == Some(b)
            }
        };
        let is_listed = !now.has(Part::BoundaryComponents)
            || match row.inner() {
                None => now.view.outer(row.face as usize) == Some(b),
                Some(_) => now.has(Part::Holes),
            };
        (starts && is_listed).then_some(())?;
        self.scratch.walks.on_one(members, remains, now.half_edges, |h| now.next(h))?;
        Some(row)
    }

    /// R1 of faces, F1, and F2 of the lists: for faces that may differ, and faces with a boundary component that was added, removed or
    /// moved.
    ///
    /// For a list it is enough that each entry is a boundary component that claims this place, and that the length of the list is the
    /// number of boundary components that claim to be inner ones of the face: then no entry is missing or repeated.
    fn faces(&mut self) -> Option<()> {
        let (diff, now) = (&mut *self.diff, self.now);
        for (_, before, after) in diff.labels.changes().filter(|(_, a, b)| (a.face, a.place) != (b.face, b.place)) {
            for (label, gain) in [(before, u32::MAX), (after, 1)] {
                let Some(face) = index(label.face).and_then(|f| diff.faces.change(f)) else { continue };
                if let Some((f, i)) = label.inner() {
                    face.inner = face.inner.wrapping_add(gain);
                    entry(now, f, i)?;
                }
            }
        }
        self.written.listed.iter().try_for_each(|(f, i)| entry(now, *f, *i))?;
        for position in 0..diff.faces.len() {
            let f = diff.faces.index(position);
            // A label that a vacant face listed must be listed elsewhere, or be vacant too.
            let (named, row) = (diff.faces.after(f).inner, now.face(f)?);
            let is_outer = |b: usize| now.label(b).is_some_and(|row| row.face as usize == f && row.place == OUTER);
            if row.inner != named || !index(row.outer).is_none_or(is_outer) {
                return None;
            }
            diff.faces.put(position, row);
        }
        Some(())
    }

    /// V1, V2 and B2 of each vertex that may differ, that half-edges have joined or left or turn around differently, or that is or was
    /// the vertex of a changed label.
    fn vertices(&mut self) -> Option<()> {
        let diff = &mut *self.diff;
        for (_, before, after) in diff.labels.changes() {
            let isolated = [before, after].into_iter().filter_map(|label| label.vertex());
            isolated.for_each(|v| diff.vertices.note(v));
        }
        self.scratch.rotations.sort();
        for position in 0..self.diff.vertices.len() {
            let row = self.vertex(self.diff.vertices.index(position))?;
            self.diff.vertices.put(position, row);
        }
        Some(())
    }

    fn vertex(&mut self, v: usize) -> Option<Vertex> {
        let (diff, now) = (&*self.diff, self.now);
        let leaves = |row: HalfEdge| row.origin as usize == v;
        let remains = diff.remaining(index(diff.vertices.before(v).leaving), |h| diff.clockwise_before(h), leaves);
        if !now.is_vertex(v) {
            return remains.is_none().then_some(Vertex::VACANT);
        }
        let members = self.scratch.rotations.of(v);
        let connected = remains.or_else(|| members.first().map(|member| member.half_edge as usize));
        let mut leaving = connected;
        if now.has(Part::Leaving) {
            leaving = now.view.leaving(v);
            let leaves = |h: usize| now.view.origin(h) == Some(v);
            let agrees = leaving.map_or(connected.is_none(), |h| now.is_half_edge(h) && leaves(h));
            agrees.then_some(())?;
        }
        let isolated = now.isolated(v);
        if now.has(Part::BoundaryComponents) && now.has(Part::Holes) {
            let agrees = match isolated {
                Some(b) => connected.is_none() && now.is_label(b) && now.start(b) == Some(Start::Vertex(v)),
                None => connected.is_some(),
            };
            agrees.then_some(())?;
        }
        self.scratch.walks.on_one(members, remains.is_some(), now.half_edges, |h| now.clockwise(h))?;
        Some(Vertex { leaving: link(leaving), isolated: link(isolated) })
    }

    /// F1's one unbounded face, and Euler's formula for the whole: if every component has one inner boundary component and genus 0, `V
    /// − E + F = 1 + inner`.
    fn euler(&mut self) -> Option<()> {
        let now = self.now;
        if !now.has(Part::BoundaryComponents) {
            return Some(());
        }
        let sums = self.diff.add_up();
        let is_plane = now.expect.surface_kind() == Surface::Plane && now.has(Part::UnboundedFace);
        let one_unbounded = sums.unbounded == i64::from(now.has(Part::UnboundedFace));
        (one_unbounded && (!is_plane || sums.euler == 2)).then_some(())
    }
}

/// Checks an entry of a list, if the list is long enough.
fn entry<V: View + ?Sized>(now: &LinkReader<'_, V>, f: usize, i: usize) -> Option<()> {
    if !now.is_face(f) || i >= now.view.inner_count(f) {
        return Some(());
    }
    let row = now.label(now.view.inner(f, i)?)?;
    (row.inner() == Some((f, i))).then_some(())
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Member {
    /// The vertex or label of the orbit.
    pub(super) of: u32,
    pub(super) half_edge: u32,
    /// True if it belonged there before.
    pub(super) is_old: bool,
}

#[derive(Clone, Debug, Default)]
pub(super) struct Members(Vec<Member>);

impl Members {
    pub(super) fn clear(&mut self) {
        self.0.clear();
    }
    pub(super) fn push(&mut self, member: Member) {
        self.0.push(member);
    }
    pub(super) fn sort(&mut self) {
        self.0.sort_unstable();
    }
    pub(super) fn of(&self, orbit: usize) -> &[Member] {
        let from = self.0.partition_point(|member| (member.of as usize) < orbit);
        let rest = &self.0[from..];
        &rest[..rest.partition_point(|member| member.of as usize == orbit)]
    }
}

#[derive(Clone, Debug, Default)]
pub(super) struct Walks {
    /// The member where each unfinished walk began, and its current half-edge.
    under_way: Vec<(usize, usize)>,
    /// By member: the member that its walk has met.
    meets: Vec<Option<usize>>,
    is_met: Vec<bool>,
}

impl Walks {
    /// Checks that all members lie on one orbit of the permutation `step`, together with any earlier half-edges that remain. Members
    /// are sorted and distinct.
    ///
    /// ```text
    ///    a ──► · ──► b ──► c ──► · ──► · ──► · ──► …        a meets b, b meets c: c leads back to a
    /// ```
    ///
    /// The walks from all members advance in step, and each ends at the first member that it meets. One walk may be left unfinished:
    /// no two walks meet the same member, so if the others form one chain, the last one leads back to its beginning. Walks do not
    /// overlap, so the number of steps is at most the size of the orbit, and at most the number of members times the second largest
    /// distance between them.
    ///
    /// An orbit without members is an unchanged one. So if any earlier half-edge remains, a member must be an old one.
    ///
    /// Returns `None` if the members lie on several orbits, if a step leads nowhere, or after more than `limit` steps, which can
    /// happen if `step` is not a permutation.
    pub(super) fn on_one(
        &mut self,
        members: &[Member],
        remains: bool,
        limit: usize,
        step: impl Fn(usize) -> Option<usize>,
    ) -> Option<()> {
        let joins = !remains || members.iter().any(|member| member.is_old);
        if members.is_empty() || !joins {
            return members.is_empty().then_some(());
        }
        let Self { under_way, meets, is_met } = self;
        under_way.clear();
        under_way.extend(members.iter().map(|member| member.half_edge as usize).enumerate());
        meets.clear();
        meets.resize(members.len(), None);
        is_met.clear();
        is_met.resize(members.len(), false);
        let mut left = limit;
        while under_way.len() > 1 {
            left = left.checked_sub(under_way.len())?;
            let mut position = 0;
            while let Some((from, at)) = under_way.get_mut(position) {
                *at = step(*at)?;
                let Ok(met) = members.binary_search_by_key(at, |member| member.half_edge as usize) else {
                    position += 1;
                    continue;
                };
                if core::mem::replace(&mut is_met[met], true) {
                    return None;
                }
                meets[*from] = Some(met);
                under_way.swap_remove(position);
            }
        }
        // From the member that no walk has met, if there is one, the chain must contain all members.
        let first = is_met.iter().position(|met| !met).unwrap_or(0);
        let chain = core::iter::successors(Some(first), |at| meets.get(*at).copied()?.filter(|next| *next != first));
        (chain.take(members.len()).count() == members.len()).then_some(())
    }
}
