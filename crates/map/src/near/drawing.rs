//! A drawing before and after a change, and the differences.

use super::drawn::{Drawn, InnerStart, Line, Update};
use crate::Embedding;
use crate::numbers::NIL;
use twinedge::validate::Start;
use twinedge::validate::near::changes::{Column, Diff, Face, HalfEdge, Label, Row, TIMES, Time, Vertex, index};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::in_range;

/// Links and coordinates before and after, and the records that may be drawn differently.
pub(super) struct Drawing<'a> {
    diff: &'a Diff,
    places: &'a Column<Place>,
    /// The half-edges whose links or coordinates may have changed, sorted.
    pub(super) half_edges: Vec<usize>,
    /// The labels that may differ, and the old and new labels of these half-edges, sorted.
    pub(super) labels: Vec<usize>,
}

pub(super) fn sorted<T: Ord>(mut list: Vec<T>) -> Vec<T> {
    list.sort_unstable();
    list.dedup();
    list
}

/// The coordinates of a vertex, or `None` if its slot is vacant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Place(Option<Point>);

impl Row for Place {
    const VACANT: Self = Self(None);
}

/// Reads the coordinates of the vertices that may differ. Returns `None` if a coordinate is out of range.
pub(super) fn read_places<E: Embedding + ?Sized>(places: &mut Column<Place>, diff: &Diff, embedding: &E) -> Option<()> {
    places.fit(embedding.vertex_slots());
    for (v, _, now) in diff.vertices.changes() {
        let place = now.is_live().then(|| embedding.point(v));
        if !place.is_none_or(in_range) {
            return None;
        }
        *places.change(v)? = Place(place);
    }
    Some(())
}

impl<'a> Drawing<'a> {
    /// Returns `None` if an edge has bends, or if the old links do not form a valid structure.
    pub(super) fn new<E: Embedding + ?Sized>(embedding: &E, diff: &'a Diff, places: &'a Column<Place>) -> Option<Self> {
        let mut drawing = Self { diff, places, half_edges: Vec::new(), labels: Vec::new() };
        let mut half_edges: Vec<usize> = diff.half_edges.changes().map(|(h, ..)| h).collect();
        for (v, before, after) in places.changes() {
            if before != after {
                // Half-edges that left the vertex before, and do not now, have changed links and are listed already.
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
        let mut labels: Vec<usize> = drawing.changed_labels().collect();
        for time in TIMES {
            labels.extend(half_edges.iter().filter_map(|h| drawing.label_of(time, *h)));
        }
        drawing.half_edges = half_edges;
        drawing.labels = sorted(labels);
        Some(drawing)
    }

    pub(super) fn row(&self, time: Time, h: usize) -> HalfEdge {
        self.diff.half_edges.at(time, h)
    }

    pub(super) fn vertex(&self, time: Time, v: usize) -> Vertex {
        self.diff.vertices.at(time, v)
    }

    pub(super) fn label(&self, time: Time, b: usize) -> Label {
        self.diff.labels.at(time, b)
    }

    pub(super) fn face(&self, time: Time, f: usize) -> Face {
        self.diff.faces.at(time, f)
    }

    pub(super) fn place(&self, time: Time, v: usize) -> Option<Point> {
        self.places.at(time, v).0
    }

    pub(super) fn is_unbounded(&self, time: Time, f: usize) -> bool {
        self.face(time, f).outer == NIL
    }

    pub(super) fn twin(&self, time: Time, h: usize) -> Option<usize> {
        Some(self.row(time, h)).filter(Row::is_live).map(|row| row.twin as usize)
    }

    pub(super) fn clockwise(&self, time: Time, h: usize) -> Option<usize> {
        self.twin(time, h).map(|twin| self.row(time, twin).next as usize)
    }

    pub(super) fn line(&self, time: Time, h: usize) -> Option<Line> {
        let row = self.row(time, h);
        let vertices = [row.origin, self.row(time, self.twin(time, h)?).origin];
        let points = [self.place(time, vertices[0] as usize)?, self.place(time, vertices[1] as usize)?];
        Some(Line { vertices, points })
    }

    /// Returns the ends of a half-edge, if they are unchanged.
    pub(super) fn kept(&self, h: usize) -> Option<[Point; 2]> {
        let [before, after] = TIMES.map(|time| self.line(time, h).map(|line| line.points));
        before.filter(|_| before == after)
    }

    pub(super) fn label_of(&self, time: Time, h: usize) -> Option<usize> {
        Some(self.row(time, h)).filter(Row::is_live).map(|row| row.label as usize)
    }

    pub(super) fn face_of(&self, time: Time, h: usize) -> Option<usize> {
        index(self.label(time, self.label_of(time, h)?).face)
    }

    /// Collects the half-edges that leave a vertex now.
    fn rotation(&self, v: usize, into: &mut Vec<usize>) -> Option<()> {
        let vertex = self.vertex(Time::After, v);
        if !vertex.is_live() || vertex.leaving == NIL {
            return Some(());
        }
        let first = vertex.leaving as usize;
        let mut h = first;
        // Only invalid links would make this loop endless.
        for _ in 0..=self.diff.half_edges.slots() {
            into.push(h);
            h = self.clockwise(Time::After, h)?;
            if h == first {
                return Some(());
            }
        }
        None
    }

    /// Returns an edge as stored in the trees, by the smaller of its half-edges.
    fn edge(&self, time: Time, h: usize) -> Option<Drawn> {
        self.twin(time, h).filter(|twin| h < *twin)?;
        self.line(time, h).map(|line| Drawn::edge(h, line))
    }

    /// Returns an isolated vertex as stored in the trees.
    fn isolated(&self, time: Time, v: usize) -> Option<Drawn> {
        let vertex = self.vertex(time, v);
        let place = self.place(time, v).filter(|_| vertex.isolated != NIL)?;
        Some(Drawn::vertex(v, place))
    }

    /// Returns the point where an inner boundary component starts.
    fn start(&self, time: Time, b: usize) -> Option<InnerStart> {
        let label = self.label(time, b);
        label.inner()?;
        let at = match label.start() {
            Start::HalfEdge(h) => self.line(time, h)?.points[0],
            Start::Vertex(v) => self.place(time, v)?,
        };
        Some(InnerStart::new(at.into(), b as u32))
    }

    /// Returns the entries to remove from the trees and to add. Returns `None` if an edge has no length.
    pub(super) fn update(&self) -> Option<Update> {
        let mut update = Update::default();
        for h in &self.half_edges {
            update.drawn.put(TIMES.map(|time| self.edge(time, *h)));
        }
        if update.drawn.come.iter().any(|edge| edge.ends[0] == edge.ends[1]) {
            return None;
        }
        for (v, ..) in self.diff.vertices.changes() {
            update.drawn.put(TIMES.map(|time| self.isolated(time, v)));
        }
        for b in &self.labels {
            update.starts.put(TIMES.map(|time| self.start(time, *b)));
        }
        Some(update)
    }

    /// Returns the boundary components whose records may differ.
    pub(super) fn changed_labels(&self) -> impl Iterator<Item = usize> + '_ {
        self.diff.labels.changes().map(|(b, ..)| b)
    }
}
