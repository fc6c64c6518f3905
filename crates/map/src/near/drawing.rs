//! A drawing before a change and after it, and what differs.

use super::drawn::{Drawn, InnerStart, Line, Update};
use crate::Embedding;
use crate::numbers::NIL;
use twinedge::validate::Start;
use twinedge::validate::near::changes::{Column, Diff, Face, HalfEdge, Label, Row, TIMES, Time, Vertex, index};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::in_range;

/// Links and places before and after, and what may be drawn elsewhere.
pub(super) struct Drawing<'a> {
    diff: &'a Diff,
    places: &'a Column<Place>,
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

/// The place of a vertex; none if its slot is vacant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Place(Option<Point>);

impl Row for Place {
    const VACANT: Self = Self(None);
}

/// Reads where the vertices that may differ lie. Nothing if a coordinate is out of range.
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
    /// Nothing if an edge has bends, or if the links before are not those of a structure that was right.
    pub(super) fn new<E: Embedding + ?Sized>(embedding: &E, diff: &'a Diff, places: &'a Column<Place>) -> Option<Self> {
        let mut drawing = Self { diff, places, half_edges: Vec::new(), labels: Vec::new() };
        let mut half_edges: Vec<usize> = diff.half_edges.changes().map(|(h, ..)| h).collect();
        for (v, before, after) in places.changes() {
            if before != after {
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

    /// Returns true for the unbounded face.
    pub(super) fn is_unbounded(&self, time: Time, f: usize) -> bool {
        self.face(time, f).outer == NIL
    }

    pub(super) fn twin(&self, time: Time, h: usize) -> Option<usize> {
        Some(self.row(time, h)).filter(Row::is_live).map(|row| row.twin as usize)
    }

    /// The half-edge that follows clockwise in the rotation.
    pub(super) fn clockwise(&self, time: Time, h: usize) -> Option<usize> {
        self.twin(time, h).map(|twin| self.row(time, twin).next as usize)
    }

    pub(super) fn line(&self, time: Time, h: usize) -> Option<Line> {
        let row = self.row(time, h);
        let vertices = [row.origin, self.row(time, self.twin(time, h)?).origin];
        let points = [self.place(time, vertices[0] as usize)?, self.place(time, vertices[1] as usize)?];
        Some(Line { vertices, points })
    }

    /// The ends of a half-edge, if that is the same before and after.
    pub(super) fn kept(&self, h: usize) -> Option<[Point; 2]> {
        let [before, after] = TIMES.map(|time| self.line(time, h).map(|line| line.points));
        before.filter(|_| before == after)
    }

    pub(super) fn label_of(&self, time: Time, h: usize) -> Option<usize> {
        Some(self.row(time, h)).filter(Row::is_live).map(|row| row.label as usize)
    }

    /// The face to the left of a half-edge.
    pub(super) fn face_of(&self, time: Time, h: usize) -> Option<usize> {
        index(self.label(time, self.label_of(time, h)?).face)
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
        for _ in 0..=self.diff.half_edges.slots() {
            into.push(h);
            h = self.clockwise(Time::After, h)?;
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

    /// The place where an inner boundary component starts.
    fn start(&self, time: Time, b: usize) -> Option<InnerStart> {
        let label = self.label(time, b);
        label.inner()?;
        let at = match label.start() {
            Start::HalfEdge(h) => self.line(time, h)?.points[0],
            Start::Vertex(v) => self.place(time, v)?,
        };
        Some(InnerStart::new(at.into(), b as u32))
    }

    /// The entries that the trees have to take off and to add. Nothing if an edge has no length.
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

    /// The boundary components whose records may differ.
    pub(super) fn changed_labels(&self) -> impl Iterator<Item = usize> + '_ {
        self.diff.labels.changes().map(|(b, ..)| b)
    }
}
