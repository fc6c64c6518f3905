//! The check itself: everything that the records which have changed can break.

use super::mirror::{HalfEdge, Label, Mirror, Now, OUTER, Vertex};
use super::orbits;
use super::touched::Touched;
use crate::validate::columns::NIL;
use crate::validate::expectation::{Part, Surface};
use crate::validate::view::{Start, View};
use alloc::vec::Vec;

/// How many records there are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Counts {
    pub(super) vertices: usize,
    pub(super) half_edges: usize,
    pub(super) faces: usize,
    pub(super) unbounded: usize,
    pub(super) inner: usize,
}

/// What has changed since, for the mirror to follow.
#[derive(Debug, Default)]
pub(super) struct Changes {
    pub(super) half_edges: Vec<(usize, HalfEdge)>,
    /// Half-edges that have not changed, with the one that leads to each now.
    pub(super) followed: Vec<(usize, u32)>,
    pub(super) vertices: Vec<(usize, Vertex)>,
    pub(super) labels: Vec<(usize, Label)>,
    /// Faces, and what they have, unless they are vacant: the outer boundary component, and how many inner ones.
    pub(super) faces: Vec<(usize, Option<(u32, usize)>)>,
    /// Entries of lists: the face, the position, and the boundary component.
    pub(super) entries: Vec<(usize, usize, u32)>,
    pub(super) counts: Counts,
}

impl Changes {
    /// Of a structure that has come since there was nothing.
    #[cfg(feature = "geometry")]
    pub(super) fn all_of(mirror: &Mirror, counts: Counts) -> Self {
        let faces = mirror.faces.iter().map(|face| face.is_live().then_some((face.outer, face.inner.len())));
        Self {
            half_edges: mirror.half_edges.iter().copied().enumerate().collect(),
            vertices: mirror.vertices.iter().copied().enumerate().collect(),
            labels: mirror.labels.iter().copied().enumerate().collect(),
            faces: faces.enumerate().collect(),
            counts,
            ..Self::default()
        }
    }
}

/// A member of a vertex or label that has come or turned: the group, the half-edge, and whether it belonged there before.
type Member = (usize, usize, bool);

/// What is being checked: the structure as it was and is, and which records may differ, sorted.
pub(super) struct Check<'a, V: ?Sized> {
    was: &'a Mirror,
    now: &'a Now<'a, V>,
    half_edges: Vec<usize>,
    changes: Changes,
}

/// Sorts, and drops what occurs twice.
fn sorted<T: Ord>(mut list: Vec<T>) -> Vec<T> {
    list.sort_unstable();
    list.dedup();
    list
}

/// The link of a column.
fn index(link: u32) -> Option<usize> {
    (link < NIL - 1).then_some(link as usize)
}

/// The part of a list of members that is of this group.
fn of_group(members: &[Member], group: usize) -> &[Member] {
    let from = members.partition_point(|member| member.0 < group);
    let len = members[from..].partition_point(|member| member.0 == group);
    &members[from..from + len]
}

/// Everything that has changed, if no rule from R1 to F2 is broken, nor the sum of Euler's formula.
pub(super) fn changes<'a, V: View + ?Sized>(
    was: &'a Mirror,
    now: &'a Now<'a, V>,
    counts: Counts,
    touched: &Touched,
) -> Option<Changes> {
    let half_edges = sorted(touched.half_edges.clone());
    let mut check = Check { was, now, half_edges, changes: Changes { counts, ..Changes::default() } };
    let (turned, relabelled) = check.links()?;
    let labels = check.labels_to_see(touched);
    check.vertices(touched, &labels, &turned)?;
    if now.has(Part::Faces) {
        check.labels(&labels, &relabelled)?;
        check.faces(touched, &labels)?;
    }
    check.euler()?;
    Some(check.changes)
}

impl<V: View + ?Sized> Check<'_, V> {
    fn may_differ(&self, h: usize) -> bool {
        self.half_edges.binary_search(&h).is_ok()
    }

    /// R1 of half-edges, L1, L2, L3, and the labels along `next`: of each half-edge that may differ, and of those that it was
    /// linked to. Gives the half-edges that are new at their vertex or turn elsewhere, and those that are new on their label or
    /// lead elsewhere.
    fn links(&mut self) -> Option<(Vec<Member>, Vec<Member>)> {
        let (was, now) = (self.was, self.now);
        let mut around = self.half_edges.clone();
        for h in &self.half_edges {
            let row = was.half_edge(*h);
            around.extend([row.twin, row.next, row.prev].into_iter().filter_map(index));
        }
        let (mut turned, mut relabelled, mut follows) = (Vec::new(), Vec::new(), Vec::new());
        for h in sorted(around) {
            let (before, row) = (was.half_edge(h), now.half_edge(h)?);
            if self.may_differ(h) {
                self.changes.counts.half_edges += usize::from(row.is_live());
                self.changes.counts.half_edges -= usize::from(before.is_live());
                self.changes.half_edges.push((h, row));
            }
            if !row.is_live() {
                continue;
            }
            let (twin, next) = (row.twin as usize, row.next as usize);
            let mutual = twin != h && now.view.twin(twin) == Some(h);
            let joined =
                !now.has(Part::Prev) || now.view.prev(next) == Some(h) && now.view.next(row.prev as usize) == Some(h);
            let meets = now.view.origin(next)? == now.view.origin(twin)?;
            let labelled = !now.has(Part::Faces) || now.label_of(next)? == row.label as usize;
            if !(mutual && joined && meets && labelled) {
                return None;
            }
            follows.push((next, h));
            let is_old = before.is_live() && before.origin == row.origin;
            if !is_old || was.turned(h) != now.view.next(twin)? {
                turned.push((row.origin as usize, h, is_old));
            }
            let is_old = before.is_live() && before.label == row.label;
            if !is_old || before.next != row.next {
                relabelled.push((row.label as usize, h, is_old));
            }
        }
        self.follow(sorted(follows))?;
        Some((sorted(turned), sorted(relabelled)))
    }

    /// L2 where there is no `prev`: no two half-edges lead to the same.
    fn follow(&mut self, follows: Vec<(usize, usize)>) -> Option<()> {
        let twice = follows.windows(2).any(|pair| pair[0].0 == pair[1].0);
        let free = |(next, h): &(usize, usize)| {
            let led = index(self.was.half_edge(*next).prev);
            led.is_none_or(|led| led == *h || self.may_differ(led))
        };
        if twice || !follows.iter().all(free) {
            return None;
        }
        for (next, h) in follows {
            // The list is sorted by half-edge, as those that may differ are.
            if let Ok(position) = self.changes.half_edges.binary_search_by_key(&next, |row| row.0) {
                self.changes.half_edges[position].1.prev = h as u32;
            } else {
                self.changes.followed.push((next, h as u32));
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
        stays: impl Fn(usize) -> bool,
    ) -> Option<usize> {
        let orbit = core::iter::successors(first, |h| Some(step(*h)).filter(|next| Some(*next) != first));
        // No longer than there are some that may differ, in case the baseline is not right because something was not named.
        orbit.take(self.half_edges.len() + 1).find(|h| !self.may_differ(*h) || self.now.is_half_edge(*h) && stays(*h))
    }

    /// The labels that may be wrong: those that may differ, those of half-edges and vertices that may, and those that were, or
    /// are, where a face's list was written.
    fn labels_to_see(&self, touched: &Touched) -> Vec<usize> {
        if !self.now.has(Part::Faces) {
            return Vec::new();
        }
        let has_records = self.now.has(Part::BoundaryComponents);
        let mut labels = if has_records { touched.boundaries.clone() } else { touched.faces.clone() };
        for (h, row) in &self.changes.half_edges {
            labels.extend([self.was.half_edge(*h).label, row.label].into_iter().filter_map(index));
        }
        if !has_records {
            return sorted(labels);
        }
        for v in &touched.vertices {
            labels.extend(index(self.was.vertex(*v).isolated));
            labels.extend(self.isolated(*v));
        }
        let listed = touched.listed.iter().map(|(f, _)| f);
        for f in touched.faces.iter().chain(listed) {
            labels.extend(self.was.faces.get(*f).and_then(|face| index(face.outer)));
        }
        for (f, position) in &touched.listed {
            labels.extend(self.was.faces.get(*f).and_then(|face| face.inner.get(*position)).map(|b| *b as usize));
        }
        sorted(labels)
    }

    /// The live boundary component that an isolated vertex names.
    fn isolated(&self, v: usize) -> Option<usize> {
        let names = self.now.has(Part::BoundaryComponents) && self.now.has(Part::Holes) && self.now.is_vertex(v);
        // A vacant slot is not asked.
        let named = if names { self.now.view.isolated(v) } else { None };
        named.filter(|b| self.now.is_label(*b))
    }

    /// V1, V2 and B2 of each vertex that may differ, of those where half-edges start or started that may, and of those that the
    /// labels are or were.
    fn vertices(&mut self, touched: &Touched, labels: &[usize], turned: &[Member]) -> Option<()> {
        let mut vertices = touched.vertices.clone();
        for (h, row) in &self.changes.half_edges {
            vertices.extend([self.was.half_edge(*h).origin, row.origin].into_iter().filter_map(index));
        }
        vertices.extend(turned.iter().map(|member| member.0));
        for b in labels {
            let before = Some(self.was.label(*b)).filter(Label::is_live).map(|row| row.start);
            let starts = [before, if self.now.is_label(*b) { self.now.start(*b) } else { None }];
            vertices.extend(starts.into_iter().flatten().filter_map(|start| match start {
                Start::Vertex(v) => Some(v),
                Start::HalfEdge(_) => None,
            }));
        }
        for v in sorted(vertices) {
            let row = self.vertex(v, of_group(turned, v))?;
            self.changes.counts.vertices += usize::from(row.is_live());
            self.changes.counts.vertices -= usize::from(self.was.vertex(v).is_live());
            self.changes.vertices.push((v, row));
        }
        Some(())
    }

    fn vertex(&self, v: usize, members: &[Member]) -> Option<Vertex> {
        let (was, now) = (self.was, self.now);
        let leaves = |h: usize| now.view.origin(h) == Some(v);
        let first = index(was.vertex(v).leaving);
        let remains = self.remaining(first, |h| was.turned(h), leaves);
        if !now.is_vertex(v) {
            return remains.is_none().then_some(Vertex::VACANT);
        }
        let connected = remains.or_else(|| members.first().map(|member| member.1));
        let mut leaving = connected;
        if now.has(Part::Leaving) {
            leaving = now.view.leaving(v);
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
    fn one_orbit(&self, members: &[Member], remains: bool, step: impl Fn(usize) -> Option<usize>) -> Option<()> {
        if members.is_empty() {
            return Some(());
        }
        let half_edges: Vec<usize> = members.iter().map(|member| member.1).collect();
        let is_one = !remains || members.iter().any(|member| member.2);
        is_one.then_some(())?;
        orbits::on_one(&half_edges, self.now.half_edges, step)
    }

    /// R1, B1, and the labels' half of B2 and F2.
    fn labels(&mut self, labels: &[usize], relabelled: &[Member]) -> Option<()> {
        for b in labels {
            let row = self.label(*b, of_group(relabelled, *b))?;
            self.changes.labels.push((*b, row));
        }
        Some(())
    }

    fn label(&self, b: usize, members: &[Member]) -> Option<Label> {
        let (was, now) = (self.was, self.now);
        let first = match was.label(b) {
            Label { start: Start::HalfEdge(h), .. } => Some(h),
            _ => None,
        };
        let has_it = |h: usize| now.label_of(h) == Some(b);
        let remains = self.remaining(first, |h| was.half_edge(h).next as usize, has_it);
        let row = now.label(b)?;
        if !row.is_live() {
            return remains.is_none().then_some(row);
        }
        let starts = match row.start {
            Start::HalfEdge(h) => has_it(h),
            Start::Vertex(v) => {
                let is_listed = now.has(Part::Holes) && row.place != OUTER;
                is_listed && remains.is_none() && members.is_empty() && now.view.isolated(v) == Some(b)
            }
        };
        let is_listed = !now.has(Part::BoundaryComponents)
            || match row.inner() {
                None => now.view.outer(row.face as usize) == Some(b),
                Some((f, i)) => now.has(Part::Holes) && i < now.view.inner_count(f) && now.view.inner(f, i) == Some(b),
            };
        (starts && is_listed).then_some(())?;
        self.one_orbit(members, remains.is_some(), |h| now.view.next(h))?;
        Some(row)
    }

    /// R1 of faces, F1, and the faces' half of F2.
    fn faces(&mut self, touched: &Touched, labels: &[usize]) -> Option<()> {
        let now = self.now;
        if !now.has(Part::BoundaryComponents) {
            // Each label is a face, with one cycle.
            for (b, row) in &self.changes.labels {
                self.changes.counts.faces += usize::from(row.is_live());
                self.changes.counts.faces -= usize::from(self.was.label(*b).is_live());
            }
            return Some(());
        }
        let (mut faces, mut entries) = (touched.faces.clone(), touched.listed.clone());
        let (mut gained, mut lost) = (Vec::new(), Vec::new());
        faces.extend(entries.iter().map(|entry| entry.0));
        for (b, row) in &self.changes.labels {
            let before = self.was.label(*b);
            faces.extend([before.face, row.face].into_iter().filter_map(index));
            gained.extend(row.inner().map(|entry| entry.0));
            lost.extend(before.inner().map(|entry| entry.0));
            entries.extend(row.inner().into_iter().chain(before.inner()));
        }
        gained.sort_unstable();
        lost.sort_unstable();
        for f in sorted(faces) {
            let count = |list: &[usize]| list.partition_point(|g| *g <= f) - list.partition_point(|g| *g < f);
            self.face(f, count(&gained), count(&lost), labels)?;
        }
        for (f, i) in sorted(entries) {
            if !now.is_face(f) || i >= now.view.inner_count(f) {
                continue;
            }
            let b = now.view.inner(f, i)?;
            let row = now.label(b)?;
            if row.inner() != Some((f, i)) {
                return None;
            }
            self.changes.entries.push((f, i, b as u32));
        }
        Some(())
    }

    fn face(&mut self, f: usize, gained: usize, lost: usize, labels: &[usize]) -> Option<()> {
        let (was, now) = (self.was, self.now);
        let counts = &mut self.changes.counts;
        let before = was.faces.get(f).filter(|face| face.is_live());
        let listed = before.map_or(&[][..], |face| &face.inner);
        counts.faces -= usize::from(before.is_some());
        counts.unbounded -= usize::from(before.is_some_and(|face| face.outer == NIL));
        counts.inner -= listed.len();
        if !now.is_face(f) {
            // Whatever it listed must have changed, and is looked at.
            let is_seen = |b: u32| index(b).is_none_or(|b| labels.binary_search(&b).is_ok());
            self.changes.faces.push((f, None));
            return (before.is_none_or(|face| is_seen(face.outer)) && listed.iter().all(|b| is_seen(*b))).then_some(());
        }
        counts.faces += 1;
        let outer = now.view.outer(f);
        match outer {
            None => counts.unbounded += 1,
            Some(b) => {
                let row = now.label(b)?;
                let is_outer = row.is_live() && row.face as usize == f && row.place == OUTER;
                is_outer.then_some(())?;
            }
        }
        let mut inner = 0;
        if now.has(Part::Holes) {
            inner = (listed.len() + gained).checked_sub(lost)?;
            (now.view.inner_count(f) == inner).then_some(())?;
            counts.inner += inner;
        }
        self.changes.faces.push((f, Some((outer.map_or(NIL, |b| b as u32), inner))));
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
