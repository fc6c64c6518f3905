//! Tracing the way of a segment through the map, before anything is drawn.

use super::error::EditError;
use crate::index::{is_hub, is_small};
use crate::locate::Located;
use crate::planar_map::PlanarMap;
use crate::zone::QueryLine;
use crate::zone::line::{EventRecord, Line, LineEvent, LinePlace};
use crate::zone::selection::each_event;
use core::cmp::Ordering;
use rustc_hash::FxHashMap;
use std::collections::hash_map::Entry;
use twinedge::dcel::{Face, FaceKey, HalfEdge, Vertex, VertexKey};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::{
    Endpoint, Meeting, Orientation, compare_angle, compare_lexicographic, meeting, on_segment, orientation,
};

/// The way of a segment that crosses nothing.
pub(super) struct Trace {
    /// The vertices on it, in order, without its ends.
    pub(super) stops: Vec<VertexKey>,
    pub(super) end: Located,
}

/// The half-edge or corner of a vertex in the direction of a point.
pub(crate) enum Towards<'a> {
    /// A half-edge in exactly that direction.
    Along(HalfEdge<'a>),
    /// The corner of this half-edge contains the direction.
    Corner(HalfEdge<'a>),
    Isolated,
}

impl<'a> Towards<'a> {
    /// Returns the half-edge, or the half-edge of the corner.
    pub(super) const fn corner(self) -> Option<HalfEdge<'a>> {
        match self {
            Self::Along(h) | Self::Corner(h) => Some(h),
            Self::Isolated => None,
        }
    }
}

impl PlanarMap {
    /// Returns the half-edge or corner of a vertex towards another point. O(log degree), by the index at a high degree.
    pub(crate) fn towards<'a>(&'a self, v: Vertex<'a>, p: Point) -> Towards<'a> {
        if is_hub(v) {
            let found = self.index().towards(v, p).and_then(|h| self.dcel.half_edge_at(h));
            if let Some(h) = found {
                let along = compare_angle(self.at(v), self.at(h.target()), p).is_eq();
                return if along { Towards::Along(h) } else { Towards::Corner(h) };
            }
        }
        let at = self.at(v);
        let mut corner = None;
        for h in v.rotation() {
            let (from, to) = (self.at(h.target()), self.at(h.counter_clockwise().target()));
            let after = compare_angle(at, from, p);
            if after == Ordering::Equal {
                return Towards::Along(h);
            }
            let before = compare_angle(at, p, to);
            // The corner that spans the positive x axis is not ordered; the corner of a sole half-edge is the full turn.
            let inside = match compare_angle(at, from, to) {
                Ordering::Less => after.is_lt() && before.is_lt(),
                _ => after.is_lt() || before.is_lt(),
            };
            if inside {
                corner = Some(h);
            }
        }
        corner.map_or(Towards::Isolated, Towards::Corner)
    }

    /// Traces a segment from a point at a known location to another point. O(k log k) for k vertices and edges on it, plus the
    /// cost of finding them in the index, unless the faces on the way are small.
    pub(super) fn trace(&self, start: Located, from: Point, to: Point) -> Result<Trace, EditError> {
        let mut stops = Vec::new();
        let (mut place, mut at) = (start, from);
        let mut seen = Way::default();
        loop {
            let ahead = match place {
                Located::Vertex(key) => {
                    let v = self.dcel.vertex(key)?;
                    match self.towards(v, to) {
                        Towards::Along(h) => self.ahead_along(h, at, to),
                        Towards::Corner(h) => self.ahead_in(h.face(), at, to, &mut seen)?,
                        Towards::Isolated => match v.isolated() {
                            Some(b) => self.ahead_in(b.face(), at, to, &mut seen)?,
                            None => Ahead::End(place),
                        },
                    }
                }
                Located::Edge(key) => {
                    let h = self.dcel.half_edge(key)?;
                    let [tail, head] = self.ends(h);
                    match orientation(tail, head, to) {
                        Orientation::CounterClockwise => self.ahead_in(h.face(), at, to, &mut seen)?,
                        Orientation::Clockwise => self.ahead_in(h.twin().face(), at, to, &mut seen)?,
                        Orientation::Collinear => {
                            // Both half-edges lie along the way; the end beyond `to` is not reached.
                            let onwards = if compare_angle(at, head, to).is_eq() { h } else { h.twin() };
                            self.ahead_along(onwards, at, to)
                        }
                    }
                }
                Located::Face(key) => self.ahead_in(self.dcel.face(key)?, at, to, &mut seen)?,
            };
            match ahead {
                Ahead::End(end) => return Ok(Trace { stops, end }),
                Ahead::Vertex(v) => {
                    (place, at) = (Located::Vertex(v.key()), self.at(v));
                    if at == to {
                        return Ok(Trace { stops, end: place });
                    }
                    stops.push(v.key());
                }
            }
        }
    }

    /// Returns the next obstacle on the way along a half-edge.
    fn ahead_along<'a>(&self, h: HalfEdge<'a>, at: Point, to: Point) -> Ahead<'a> {
        let v = h.target();
        if on_the_way(self.at(v), at, to) { Ahead::Vertex(v) } else { Ahead::End(Located::Edge(h.key())) }
    }

    /// Returns the next obstacle on the way through a face. Each face is scanned once, even if the way enters it repeatedly. If a
    /// face is not small, all obstacles ahead are collected at once.
    fn ahead_in<'a>(&'a self, face: Face<'a>, at: Point, to: Point, way: &mut Way<'a>) -> Result<Ahead<'a>, EditError> {
        if way.all.is_none() && !is_small(face) {
            way.all = Some(self.seen_ahead(at, to)?);
        }
        let Obstacles { beyond, end } = match (&mut way.all, way.faces.entry(face.key())) {
            (Some(all), _) => all,
            (None, Entry::Occupied(entry)) => entry.into_mut(),
            (None, Entry::Vacant(entry)) => entry.insert(self.seen_in(face, at, to)?),
        };
        while let Some((v, w)) = beyond.last() {
            if on_the_way(*w, at, to) {
                return Ok(Ahead::Vertex(*v));
            }
            beyond.pop();
        }
        Ok(Ahead::End(end.unwrap_or(Located::Face(face.key()))))
    }

    /// Returns the vertices of a face on the way, or an error with the first edge that the way crosses there.
    fn seen_in<'a>(&self, face: Face<'a>, at: Point, to: Point) -> Result<Obstacles<'a>, EditError> {
        let line = Line { from: at, through: to };
        let mut sight = Sight::new(at, to);
        for h in face.half_edges() {
            let [tail, head] = self.ends(h);
            match meeting(at, to, tail, head) {
                Meeting::Disjoint => continue,
                Meeting::Cross | Meeting::Touch(Endpoint::B) => {
                    let [origin, target] = [tail, head].map(|p| (p, line.side(p)));
                    if let Some(event) = Line::crossing(h, origin, target) {
                        sight.meet(event);
                    }
                }
                Meeting::Touch(_) | Meeting::SharedEndpoint | Meeting::Overlap => {}
            }
            sight.pass(h.origin(), tail);
            sight.pass(h.target(), head);
        }
        face.inner().filter_map(|b| b.isolated_vertex()).for_each(|v| sight.pass(v, self.at(v)));
        sight.seen()
    }

    /// Returns all obstacles on the way, or an error with the first edge that it crosses.
    fn seen_ahead(&self, at: Point, to: Point) -> Result<Obstacles<'_>, EditError> {
        let mut sight = Sight::new(at, to);
        let line = Line { from: at, through: to };
        let ends = [Some(at), Some(to)];
        each_event(self, &line, &QueryLine::Segment(at, to), ends, |event| match event.record {
            EventRecord::Vertex(v) => sight.pass(v, self.at(v)),
            EventRecord::Edge(_) => sight.meet(event),
        });
        // An edge that leaves a hub at an end of the way meets the way only there, unless along it. Only the hub is ahead.
        if let Some(hub) = self.index().hub_at(to).and_then(|v| self.dcel.vertex_at(v)) {
            sight.pass(hub, to);
            if let Towards::Along(h) = self.towards(hub, at) {
                sight.pass(h.target(), self.at(h.target()));
            }
        }
        sight.seen()
    }
}

/// The part of the way of a segment that has been scanned.
#[derive(Default)]
struct Way<'a> {
    faces: FxHashMap<FaceKey, Obstacles<'a>>,
    /// The obstacles ahead, once a face was too large to be scanned.
    all: Option<Obstacles<'a>>,
}

/// A scan of the way of a segment, in progress.
struct Sight<'a> {
    at: Point,
    to: Point,
    line: Line,
    beyond: Vec<(Vertex<'a>, Point)>,
    end: Option<Located>,
    crossing: Option<LineEvent<'a>>,
}

impl<'a> Sight<'a> {
    const fn new(at: Point, to: Point) -> Self {
        Self { at, to, line: Line { from: at, through: to }, beyond: Vec::new(), end: None, crossing: None }
    }

    fn pass(&mut self, v: Vertex<'a>, w: Point) {
        if on_the_way(w, self.at, self.to) {
            self.beyond.push((v, w));
        }
    }

    /// Records an edge that crosses the line: on the way, at its end, or elsewhere.
    fn meet(&mut self, event: LineEvent<'a>) {
        let EventRecord::Edge(across) = event.record else { return };
        let after = |place: LinePlace| self.line.order(place, event.place);
        if after(LinePlace::At(self.at)).is_ge() {
            return;
        }
        match after(LinePlace::At(self.to)) {
            // The way meets the edge from the face before it.
            Ordering::Equal => self.end = Some(Located::Edge(across.twin().key())),
            Ordering::Greater if self.crossing.is_none_or(|first| after(first.place).is_gt()) => {
                self.crossing = Some(event);
            }
            Ordering::Less | Ordering::Greater => {}
        }
    }

    fn seen(mut self) -> Result<Obstacles<'a>, EditError> {
        if let Some(LineEvent { record: EventRecord::Edge(across), .. }) = self.crossing {
            return Err(EditError::Crosses(across.twin().key()));
        }
        self.beyond.sort_by(|(_, p), (_, q)| compare_lexicographic(*q, *p));
        if compare_lexicographic(self.to, self.at).is_lt() {
            self.beyond.reverse();
        }
        Ok(Obstacles { beyond: self.beyond, end: self.end })
    }
}

/// The result of a scan of the way of a segment.
struct Obstacles<'a> {
    /// The vertices, the furthest first; some appear twice.
    beyond: Vec<(Vertex<'a>, Point)>,
    /// The edge inside which the segment ends, if any.
    end: Option<Located>,
}

/// The next vertex on the way of a segment, or its end.
enum Ahead<'a> {
    Vertex(Vertex<'a>),
    /// The end of the segment comes next, at this location.
    End(Located),
}

/// Returns true if, on the straight way from `c`, `b` comes after `w` or equals `w`.
fn on_the_way(w: Point, c: Point, b: Point) -> bool {
    w != c && on_segment(w, c, b)
}

#[cfg(test)]
mod tests;
