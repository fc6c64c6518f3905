//! A drawing before a change and after it, and what differs.

use super::drawn::{Drawn, Line, Start as DrawnStart, Update};
use crate::geometry::Point;
use crate::geometry::predicates::in_range;
use crate::validate::columns::NIL;
use crate::validate::near::changes::Changes;
use crate::validate::near::mirror::{Face, HalfEdge, Label, Mirror, Vertex};
use crate::validate::structure::{Embedding, Start};

/// Before the change, or after it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Time {
    Before,
    After,
}

/// Both, in order.
pub(super) const TIMES: [Time; 2] = [Time::Before, Time::After];

/// The links and places as they were, and what has changed since.
pub(super) struct Drawing<'a> {
    was: &'a Mirror,
    points: &'a [Point],
    changes: &'a Changes,
    /// The places of the vertices that may differ, in their order; of those that are vacant, none.
    placed: Vec<Option<Point>>,
    /// The half-edges that may have other links, or be drawn elsewhere, sorted.
    pub(super) half_edges: Vec<usize>,
    /// The labels that may differ, and those that these half-edges have or had, sorted.
    pub(super) labels: Vec<usize>,
}

/// Sorts, and drops what occurs twice.
pub(super) fn sorted<T: Ord>(mut list: Vec<T>) -> Vec<T> {
    list.sort_unstable();
    list.dedup();
    list
}

impl<'a> Drawing<'a> {
    /// Nothing if a coordinate is out of range or an edge has bends, or if the links before are not those of a structure that was
    /// right.
    pub(super) fn new<E: Embedding + ?Sized>(
        embedding: &E,
        was: &'a Mirror,
        points: &'a [Point],
        changes: &'a Changes,
    ) -> Option<Self> {
        let seen = changes.vertices.iter();
        let placed: Vec<_> = seen.map(|(v, seen)| seen.row.is_live().then(|| embedding.point(v))).collect();
        if !placed.iter().flatten().all(|p| in_range(*p)) {
            return None;
        }
        let mut drawing = Self { was, points, changes, placed, half_edges: Vec::new(), labels: Vec::new() };
        let mut half_edges: Vec<usize> = changes.touched().map(|(h, _)| h).collect();
        for (v, _) in changes.vertices.iter() {
            if drawing.place(Time::Before, v) != drawing.place(Time::After, v) {
                // Those that left it before, and do not now, may have other links.
                drawing.rotation(v, &mut half_edges)?;
            }
        }
        let twins: Vec<usize> = half_edges.iter().filter_map(|h| drawing.twin(Time::After, *h)).collect();
        half_edges.extend(twins);
        let half_edges = sorted(half_edges);
        let straight = |h: &usize| {
            let twin = drawing.twin(Time::After, *h);
            twin.is_none_or(|twin| twin < *h || embedding.bends(*h) == 0)
        };
        if !half_edges.iter().all(straight) {
            return None;
        }
        let mut labels: Vec<usize> = changes.labels.iter().map(|(b, _)| b).collect();
        for time in TIMES {
            labels.extend(half_edges.iter().filter_map(|h| drawing.label_of(time, *h)));
        }
        drawing.half_edges = half_edges;
        drawing.labels = sorted(labels);
        Some(drawing)
    }

    /// The places of the vertices that may differ, by index.
    pub(super) fn placed(&self) -> impl Iterator<Item = (usize, Point)> + '_ {
        self.changes.vertices.iter().zip(&self.placed).filter_map(|((v, _), place)| Some((v, (*place)?)))
    }

    pub(super) fn row(&self, time: Time, h: usize) -> HalfEdge {
        match time {
            Time::Before => self.was.half_edge(h),
            Time::After => self.changes.half_edge(self.was, h),
        }
    }

    pub(super) fn vertex(&self, time: Time, v: usize) -> Vertex {
        let now = if time == Time::After { self.changes.vertices.find(&self.was.vertices, v) } else { None };
        now.map_or_else(|| self.was.vertex(v), |seen| seen.row)
    }

    pub(super) fn label(&self, time: Time, b: usize) -> Label {
        let now = if time == Time::After { self.changes.labels.find(&self.was.labels, b) } else { None };
        now.map_or_else(|| self.was.label(b), |seen| seen.row)
    }

    pub(super) fn face(&self, time: Time, f: usize) -> Face {
        let now = if time == Time::After { self.changes.faces.find(&self.was.faces, f) } else { None };
        now.map_or_else(|| self.was.face(f), |seen| seen.row)
    }

    /// Whether it is the unbounded face.
    pub(super) fn is_unbounded(&self, time: Time, f: usize) -> bool {
        self.face(time, f).outer == NIL
    }

    pub(super) fn place(&self, time: Time, v: usize) -> Option<Point> {
        let seen = if time == Time::After { self.was.vertices.position(v) } else { None };
        match seen {
            Some(position) => self.placed.get(position).copied().flatten(),
            None => self.points.get(v).copied().filter(|_| self.was.vertex(v).is_live()),
        }
    }

    pub(super) fn twin(&self, time: Time, h: usize) -> Option<usize> {
        Some(self.row(time, h)).filter(HalfEdge::is_live).map(|row| row.twin as usize)
    }

    /// The half-edge that follows clockwise in the rotation.
    pub(super) fn turned(&self, time: Time, h: usize) -> Option<usize> {
        self.twin(time, h).map(|twin| self.row(time, twin).next as usize)
    }

    pub(super) fn line(&self, time: Time, h: usize) -> Option<Line> {
        let row = self.row(time, h);
        let vertices = [row.origin, self.row(time, self.twin(time, h)?).origin];
        let points = [self.place(time, vertices[0] as usize)?, self.place(time, vertices[1] as usize)?];
        Some(Line { vertices, points })
    }

    /// Where a half-edge is drawn, if that is the same before and after.
    pub(super) fn kept(&self, h: usize) -> Option<[Point; 2]> {
        let [before, after] = TIMES.map(|time| self.line(time, h).map(|line| line.points));
        before.filter(|_| before == after)
    }

    pub(super) fn label_of(&self, time: Time, h: usize) -> Option<usize> {
        Some(self.row(time, h)).filter(HalfEdge::is_live).map(|row| row.label as usize)
    }

    /// The face to the left of a half-edge.
    pub(super) fn face_of(&self, time: Time, h: usize) -> Option<usize> {
        let label = self.label(time, self.label_of(time, h)?);
        label.is_live().then_some(label.face as usize)
    }

    /// The half-edges that leave a vertex now.
    fn rotation(&self, v: usize, into: &mut Vec<usize>) -> Option<()> {
        let vertex = self.vertex(Time::After, v);
        if !vertex.is_live() || vertex.leaving == NIL {
            return Some(());
        }
        let first = vertex.leaving as usize;
        let mut h = first;
        // Only links that are not right lead around for ever.
        for _ in 0..=self.was.half_edges.len() + self.changes.half_edges.len() {
            into.push(h);
            h = self.turned(Time::After, h)?;
            if h == first {
                return Some(());
            }
        }
        None
    }

    /// An edge as the index has it, by the smaller of its half-edges.
    fn edge(&self, time: Time, h: usize) -> Option<Drawn> {
        self.twin(time, h).filter(|twin| h < *twin)?;
        self.line(time, h).map(|line| Drawn::edge(h, line))
    }

    /// An isolated vertex as the index has it.
    fn isolated(&self, time: Time, v: usize) -> Option<Drawn> {
        let vertex = self.vertex(time, v);
        let place = self.place(time, v).filter(|_| vertex.isolated != NIL)?;
        Some(Drawn::vertex(v, place))
    }

    /// Where an inner boundary component starts.
    fn start(&self, time: Time, b: usize) -> Option<DrawnStart> {
        let label = self.label(time, b);
        label.inner()?;
        let at = match label.start() {
            Start::HalfEdge(h) => self.line(time, h)?.points[0],
            Start::Vertex(v) => self.place(time, v)?,
        };
        Some(DrawnStart { label: b as u32, at })
    }

    /// What an index has to take off and to add. Nothing if an edge has no length.
    pub(super) fn update(&self) -> Option<Update> {
        fn put<T: PartialEq>(pair: [Option<T>; 2], gone: &mut Vec<T>, come: &mut Vec<T>) {
            if pair[0] != pair[1] {
                let [before, after] = pair;
                gone.extend(before);
                come.extend(after);
            }
        }
        let mut update = Update::default();
        for h in &self.half_edges {
            put(TIMES.map(|time| self.edge(time, *h)), &mut update.gone, &mut update.come);
        }
        if update.come.iter().any(|edge| edge.ends[0] == edge.ends[1]) {
            return None;
        }
        for (v, _) in self.changes.vertices.iter() {
            put(TIMES.map(|time| self.isolated(time, v)), &mut update.gone, &mut update.come);
        }
        for b in &self.labels {
            put(TIMES.map(|time| self.start(time, *b)), &mut update.starts_gone, &mut update.starts_come);
        }
        Some(update)
    }

    /// The boundary components whose records may differ.
    pub(super) fn changed_labels(&self) -> impl Iterator<Item = usize> + '_ {
        self.changes.labels.iter().map(|(b, _)| b)
    }
}
