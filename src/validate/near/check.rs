//! The check itself: everything that the records which have changed can break.

use super::changes::{Changes, Counts, SeenFace, SeenGroup, SeenHalfEdge};
use super::column::Row;
use super::mirror::{Face, HalfEdge, Label, Mirror, Now, OUTER, Vertex};
use super::touched::Touched;
use crate::validate::columns::NIL;
use crate::validate::expectation::Surface;
use crate::validate::structure::{Part, Start, View};

/// What is being checked: the structure as it was and is, and what differs.
struct Check<'a, V: ?Sized> {
    /// Only the marks change.
    was: &'a mut Mirror,
    now: &'a Now<'a, V>,
    changes: &'a mut Changes,
}

/// The link of a column.
fn index(link: u32) -> Option<usize> {
    (link < NIL - 1).then_some(link as usize)
}

/// Finds everything that has changed. Nothing if a rule from R1 to F2 is broken, or the sum of Euler's formula.
pub(super) fn find_changes<V: View + ?Sized>(
    was: &mut Mirror,
    now: &Now<'_, V>,
    counts: Counts,
    touched: &Touched,
    changes: &mut Changes,
) -> Option<()> {
    changes.clear(was, counts);
    was.fit(now);
    let mut check = Check { was, now, changes };
    check.half_edges(touched)?;
    check.neighbours()?;
    if !now.has(Part::Prev) {
        check.led()?;
    }
    if now.has(Part::Faces) {
        check.see_labels(touched);
        check.labels()?;
        check.faces(touched)?;
    }
    check.vertices(touched)?;
    check.euler()
}

impl<V: View + ?Sized> Check<'_, V> {
    /// The links of a half-edge that may differ, as they are now.
    #[inline]
    fn changed(&self, h: usize) -> Option<HalfEdge> {
        let position = self.was.half_edges.position(h)?;
        (position < self.changes.touched).then(|| self.changes.half_edges.at(position).row)
    }

    fn see_vertex(&mut self, v: usize) {
        let seen = SeenGroup { row: Vertex::VACANT, first: 0 };
        self.changes.vertices.see(&mut self.was.vertices, v, seen);
    }

    fn see_label(&mut self, b: usize) {
        let seen = SeenGroup { row: Label::VACANT, first: 0 };
        self.changes.labels.see(&mut self.was.labels, b, seen);
    }

    fn see_face(&mut self, f: usize) -> Option<&mut SeenFace> {
        let position = self.changes.faces.see(&mut self.was.faces, f, SeenFace::new(Face::VACANT))?;
        Some(self.changes.faces.at_mut(position))
    }

    /// A half-edge is new at its vertex, or followed by another one there.
    fn turned(&mut self, v: u32, h: usize, is_old: bool) {
        let seen = SeenGroup { row: Vertex::VACANT, first: 0 };
        if let Some(position) = self.changes.vertices.see(&mut self.was.vertices, v as usize, seen) {
            let first = &mut self.changes.vertices.at_mut(position).first;
            *first = self.changes.members.push(h, is_old, *first);
        }
    }

    /// A half-edge is new on its label, or leads to another one.
    fn relabelled(&mut self, b: u32, h: usize, is_old: bool) {
        let seen = SeenGroup { row: Label::VACANT, first: 0 };
        if let Some(position) = self.changes.labels.see(&mut self.was.labels, b as usize, seen) {
            let first = &mut self.changes.labels.at_mut(position).first;
            *first = self.changes.members.push(h, is_old, *first);
        }
    }

    /// R1 of half-edges, L1, L2, L3, and the labels along `next`: of each half-edge that may differ.
    ///
    /// Of L2 it is enough that `prev` of each one's `next` is that one: no two have the same `next` then, so each is the `next` of one,
    /// and that is its `prev`.
    fn half_edges(&mut self, touched: &Touched) -> Option<()> {
        for h in &touched.half_edges {
            let vacant = SeenHalfEdge { row: HalfEdge::VACANT, is_led: false };
            self.changes.half_edges.see(&mut self.was.half_edges, *h, vacant);
        }
        self.changes.touched = self.changes.half_edges.len();
        for position in 0..self.changes.touched {
            self.half_edge(position)?;
        }
        Some(())
    }

    fn half_edge(&mut self, position: usize) -> Option<()> {
        let now = self.now;
        let h = self.changes.half_edges.slot(position);
        let (before, mut row) = (self.was.half_edge(h), now.half_edge(h)?);
        if row.is_live() && !now.has(Part::Prev) {
            // As before, unless another one is found that leads here.
            row.prev = before.prev;
        }
        self.changes.half_edges.at_mut(position).row = row;
        self.changes.counts.half_edges += usize::from(row.is_live());
        self.changes.counts.half_edges -= usize::from(before.is_live());
        let moves = before.origin != row.origin;
        if before.is_live() {
            if moves {
                self.see_vertex(before.origin as usize);
            }
            if before.label != row.label {
                self.see_label(before.label as usize);
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
        if moves || self.was.turned(h) != now.view.next(twin)? {
            self.turned(row.origin, h, !moves);
        }
        let is_old = before.is_live() && before.label == row.label;
        if now.has(Part::Faces) && (!is_old || before.next != row.next) {
            self.relabelled(row.label, h, is_old);
        }
        Some(())
    }

    /// The same rules of the half-edges that lead to those that may differ, as their twins or their `next`, and do not differ
    /// themselves. A half-edge that is vacant now has no links, so what still leads to it is found.
    fn neighbours(&mut self) -> Option<()> {
        for position in 0..self.changes.touched {
            let h = self.changes.half_edges.slot(position);
            let (before, row) = (self.was.half_edge(h), self.changes.half_edges.at(position).row);
            if !before.is_live() {
                continue;
            }
            let [twin, prev] = [before.twin, before.prev].map(|h| h as usize);
            if self.changed(twin).is_none() {
                let meets = self.now_origin(self.was.half_edge(twin).next as usize) == row.origin;
                if !(row.twin as usize == twin && meets) {
                    return None;
                }
                if before.next != row.next {
                    self.turned(self.was.half_edge(twin).origin, twin, true);
                }
            }
            if self.changed(prev).is_none() {
                let leads = self.was.half_edge(prev);
                let joined = row.prev as usize == prev;
                let meets = self.now_origin(leads.twin as usize) == row.origin;
                let labelled = leads.label == row.label;
                if !(joined && meets && labelled) {
                    return None;
                }
            }
        }
        Some(())
    }

    /// Where a half-edge starts now.
    fn now_origin(&self, h: usize) -> u32 {
        self.changed(h).unwrap_or_else(|| self.was.half_edge(h)).origin
    }

    /// L2 where there is no `prev`: no two half-edges lead to the same.
    fn led(&mut self) -> Option<()> {
        for position in 0..self.changes.touched {
            let h = self.changes.half_edges.slot(position);
            let row = self.changes.half_edges.at(position).row;
            let next = row.next as usize;
            let before = self.was.half_edge(next);
            if !row.is_live() || before.prev as usize == h {
                continue;
            }
            // Which led there before, if any, must lead elsewhere.
            let is_free =
                index(before.prev).is_none_or(|led| self.changed(led).is_some_and(|led| led.next != row.next));
            let seen = SeenHalfEdge { row: before, is_led: false };
            let position = self.changes.half_edges.see(&mut self.was.half_edges, next, seen)?;
            let seen = self.changes.half_edges.at_mut(position);
            let twice = core::mem::replace(&mut seen.is_led, true);
            seen.row.prev = h as u32;
            if twice || !is_free {
                return None;
            }
        }
        Some(())
    }

    /// The half-edges that still have this origin, or label, of those that had it: one of them. It costs a step for each that has
    /// not, and these may all differ.
    fn remaining(
        &self,
        first: Option<usize>,
        step: impl Fn(usize) -> usize,
        stays: impl Fn(HalfEdge) -> bool,
    ) -> Option<usize> {
        let orbit = core::iter::successors(first, |h| Some(step(*h)).filter(|next| Some(*next) != first));
        // No longer than there are some that may differ, in case the baseline is not right because something was not named.
        orbit.take(self.changes.touched + 1).find(|h| self.changed(*h).is_none_or(&stays))
    }

    /// Sees the labels that may be wrong: beside those that half-edges have come to or gone from, those that may differ, those of vertices
    /// that may, and those that were the outer ones of faces that may.
    fn see_labels(&mut self, touched: &Touched) {
        if !self.now.has(Part::BoundaryComponents) {
            touched.faces.iter().for_each(|f| self.see_label(*f));
            return;
        }
        touched.boundaries.iter().for_each(|b| self.see_label(*b));
        for v in &touched.vertices {
            let before = index(self.was.vertex(*v).isolated);
            for b in before.into_iter().chain(self.isolated(*v)) {
                self.see_label(b);
            }
        }
        for f in &touched.faces {
            if let Some(b) = index(self.was.face(*f).outer) {
                self.see_label(b);
            }
        }
    }

    /// The live boundary component that an isolated vertex names.
    fn isolated(&self, v: usize) -> Option<usize> {
        let names = self.now.has(Part::BoundaryComponents) && self.now.has(Part::Holes) && self.now.is_vertex(v);
        // A vacant slot is not asked.
        let named = if names { self.now.view.isolated(v) } else { None };
        named.filter(|b| self.now.is_label(*b))
    }

    /// V1, V2 and B2 of each vertex that may differ, of those that half-edges have come to or gone from, or turn elsewhere, and of
    /// those that the labels are or were.
    fn vertices(&mut self, touched: &Touched) -> Option<()> {
        touched.vertices.iter().for_each(|v| self.see_vertex(*v));
        for position in 0..self.changes.labels.len() {
            let before = self.was.label(self.changes.labels.slot(position));
            for row in [before, self.changes.labels.at(position).row] {
                if let Some(v) = row.vertex() {
                    self.see_vertex(v);
                }
            }
        }
        for position in 0..self.changes.vertices.len() {
            let v = self.changes.vertices.slot(position);
            let row = self.vertex(v, self.changes.vertices.at(position).first)?;
            self.changes.counts.vertices += usize::from(row.is_live());
            self.changes.counts.vertices -= usize::from(self.was.vertex(v).is_live());
            self.changes.vertices.at_mut(position).row = row;
        }
        Some(())
    }

    fn vertex(&mut self, v: usize, members: usize) -> Option<Vertex> {
        let (was, now) = (&*self.was, self.now);
        let first = index(was.vertex(v).leaving);
        let remains = self.remaining(first, |h| was.turned(h), |row| row.origin as usize == v);
        if !now.is_vertex(v) {
            return remains.is_none().then_some(Vertex::VACANT);
        }
        let connected = remains.or_else(|| self.changes.members.list(members).next().map(|member| member.half_edge));
        let mut leaving = connected;
        if now.has(Part::Leaving) {
            leaving = now.view.leaving(v);
            let leaves = |h: usize| now.view.origin(h) == Some(v);
            let agrees = leaving.map_or(connected.is_none(), |h| now.is_half_edge(h) && leaves(h));
            if !agrees {
                return None;
            }
        }
        let mut isolated = None;
        if now.has(Part::BoundaryComponents) && now.has(Part::Holes) {
            isolated = now.view.isolated(v);
            let agrees = match isolated {
                Some(b) => connected.is_none() && now.is_label(b) && now.start(b) == Some(Start::Vertex(v)),
                None => connected.is_some(),
            };
            if !agrees {
                return None;
            }
        }
        self.one_orbit(members, remains.is_some(), |h| now.view.next(now.view.twin(h)?))?;
        let link = |link: Option<usize>| link.map_or(NIL, |i| i as u32);
        Some(Vertex { leaving: link(leaving), isolated: link(isolated) })
    }

    /// Whether the members, and what remains of those that were there before, lie on one orbit.
    ///
    /// An orbit without member is one of before, all of it. So if any half-edge remains, a member must be an old one.
    fn one_orbit(&mut self, first: usize, remains: bool, step: impl Fn(usize) -> Option<usize>) -> Option<()> {
        let Changes { members, group, walks, .. } = &mut *self.changes;
        group.clear();
        group.extend(members.list(first).map(|member| member.half_edge));
        if group.is_empty() {
            return Some(());
        }
        let is_one = !remains || members.list(first).any(|member| member.is_old);
        is_one.then_some(())?;
        group.sort_unstable();
        walks.on_one(group, self.now.half_edges, step)
    }

    /// R1, B1, the labels' half of B2, and F2 of those that say that they are outer ones; of the others, see [`Self::faces`].
    fn labels(&mut self) -> Option<()> {
        for position in 0..self.changes.labels.len() {
            let b = self.changes.labels.slot(position);
            let row = self.label(b, self.changes.labels.at(position).first)?;
            self.changes.labels.at_mut(position).row = row;
        }
        Some(())
    }

    fn label(&mut self, b: usize, members: usize) -> Option<Label> {
        let (was, now) = (&*self.was, self.now);
        let first = match was.label(b).start() {
            Start::HalfEdge(h) => Some(h),
            Start::Vertex(_) => None,
        };
        let remains = self.remaining(first, |h| was.half_edge(h).next as usize, |row| row.label as usize == b);
        let row = now.label(b)?;
        if !row.is_live() {
            return remains.is_none().then_some(row);
        }
        let has_it = |h: usize| now.label_of(h) == Some(b);
        let starts = match row.start() {
            Start::HalfEdge(h) => has_it(h),
            Start::Vertex(v) => {
                let is_listed = now.has(Part::Holes) && row.place != OUTER;
                is_listed && remains.is_none() && members == 0 && now.view.isolated(v) == Some(b)
            }
        };
        let is_listed = !now.has(Part::BoundaryComponents)
            || match row.inner() {
                None => now.view.outer(row.face as usize) == Some(b),
                Some(_) => now.has(Part::Holes),
            };
        (starts && is_listed).then_some(())?;
        self.one_orbit(members, remains.is_some(), |h| now.view.next(h))?;
        Some(row)
    }

    /// R1 of faces, F1, and F2 of the lists: of those that may differ, and of those of which a boundary component has come, gone, or
    /// got another place.
    ///
    /// Of a list it is enough that each entry is a boundary component that says so, and that the list is as long as there are some that
    /// name the face and say that they are inner ones: then no entry is missing, and none is there twice.
    fn faces(&mut self, touched: &Touched) -> Option<()> {
        if !self.now.has(Part::BoundaryComponents) {
            // Each label is a face, with one cycle.
            for (b, seen) in self.changes.labels.iter() {
                self.changes.counts.faces += usize::from(seen.row.is_live());
                self.changes.counts.faces -= usize::from(self.was.label(b).is_live());
            }
            return Some(());
        }
        for f in &touched.faces {
            self.see_face(*f);
        }
        for position in 0..self.changes.labels.len() {
            let before = self.was.label(self.changes.labels.slot(position));
            let row = self.changes.labels.at(position).row;
            if (before.face, before.place) == (row.face, row.place) {
                continue;
            }
            for (label, is_now) in [(before, false), (row, true)] {
                let Some(face) = index(label.face).and_then(|f| self.see_face(f)) else { continue };
                if let Some((f, i)) = label.inner() {
                    face.gained += usize::from(is_now);
                    face.lost += usize::from(!is_now);
                    self.entry(f, i)?;
                }
            }
        }
        for (f, i) in &touched.listed {
            self.entry(*f, *i)?;
        }
        for position in 0..self.changes.faces.len() {
            self.face(position)?;
        }
        Some(())
    }

    /// The entry of a list, if it is that long.
    fn entry(&self, f: usize, i: usize) -> Option<()> {
        let now = self.now;
        if !now.is_face(f) || i >= now.view.inner_count(f) {
            return Some(());
        }
        let row = now.label(now.view.inner(f, i)?)?;
        (row.inner() == Some((f, i))).then_some(())
    }

    fn face(&mut self, position: usize) -> Option<()> {
        let now = self.now;
        let Changes { counts, faces, .. } = &mut *self.changes;
        let f = faces.slot(position);
        let face = faces.at_mut(position);
        let (before, row) = (self.was.face(f), now.face(f)?);
        // What a face listed that is vacant now must be listed elsewhere, or be no more.
        let named = (before.inner as usize + face.gained).checked_sub(face.lost)?;
        let is_outer = |b: usize| now.label(b).is_some_and(|label| label.face as usize == f && label.place == OUTER);
        if row.inner as usize != named || !index(row.outer).is_none_or(is_outer) {
            return None;
        }
        counts.faces += usize::from(row.is_live());
        counts.faces -= usize::from(before.is_live());
        counts.unbounded += usize::from(row.outer == NIL);
        counts.unbounded -= usize::from(before.outer == NIL);
        counts.inner += row.inner as usize;
        counts.inner -= before.inner as usize;
        face.row = row;
        Some(())
    }

    /// F1's one unbounded face, and Euler's formula for the whole: where every component has one inner boundary component and
    /// genus 0, `V − E + F = 1 + inner`.
    fn euler(&self) -> Option<()> {
        let Counts { vertices, half_edges, faces, unbounded, inner } = self.changes.counts;
        if !self.now.has(Part::BoundaryComponents) {
            return Some(());
        }
        let is_plane = self.now.expect.surface_kind() == Surface::Plane && self.now.has(Part::UnboundedFace);
        let right = unbounded == usize::from(self.now.has(Part::UnboundedFace))
            && (!is_plane || vertices + faces == 1 + inner + half_edges / 2);
        right.then_some(())
    }
}
