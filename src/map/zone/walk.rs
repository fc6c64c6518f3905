//! From face to face along a segment, without an index.

use super::follow::{ZoneStart, follow};
use super::line::{Line, LineEvent, LinePiece, LinePlace};
use super::query::{QueryLine, ZoneElement};
use crate::dcel::{Face, HalfEdgeKey, Vertex, VertexKey};
use crate::geometry::Point;
use crate::geometry::predicates::Orientation;
use crate::map::locate::in_face::locate_in_face;
use crate::map::locate::located::{LocateError, Located, check_range};
use crate::map::planar_map::PlanarMap;
use crate::validate::Embedding;
use core::cmp::Ordering;
use rustc_hash::FxHashSet;
use std::collections::BinaryHeap;

impl PlanarMap {
    /// Returns the location of a point, by walking there on a straight line from a face, edge or vertex: best from a near one,
    /// such as the last answer. Needs no index, so the map may change between two calls.
    ///
    /// O(boundary of the face of the hint), if the point lies in it. Otherwise also the boundaries of the faces that the line
    /// meets, each counted once however often it is entered, and O(k log k) for k edges and vertices on the way. On a map
    /// that is not plane the answer may be wrong; the cost is the same.
    ///
    /// ```
    /// use twinedge::geometry::Point;
    /// use twinedge::map::{Located, PlanarMap};
    ///
    /// let mut map = PlanarMap::new();
    /// let ring = map.insert_ring([[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]])?;
    /// let (outside, inside) = ring.faces_split[0];
    /// assert_eq!(map.locate_from(Point::new(1.0, 1.0), outside)?, Located::Face(inside));
    /// assert_eq!(map.locate_from(Point::new(0.0, 4.0), inside)?, Located::Vertex(ring.vertices[2]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`LocateError::OutOfRange`]. [`LocateError::Stale`], if the hint is. [`LocateError::NotPlane`], if the walk comes
    /// upon an edge from the wrong side.
    pub fn locate_from(&self, p: Point, hint: impl Into<Located>) -> Result<Located, LocateError> {
        check_range(p)?;
        let dcel = self.dcel();
        let (start, face) = match hint.into() {
            Located::Vertex(vertex) => (Some(dcel.vertex(vertex)?), None),
            Located::Edge(half_edge) => {
                let h = dcel.half_edge(half_edge)?;
                (Some(h.origin()), Some(h.face()))
            }
            Located::Face(face) => {
                let face = dcel.face(face)?;
                let on_boundary = face.boundaries().find_map(|b| b.start().map(|h| h.origin()).or(b.isolated_vertex()));
                (on_boundary, Some(face))
            }
        };
        if let Some(seen) = face.and_then(|face| locate_in_face(self, face, p)) {
            return Ok(seen);
        }
        let Some(start) = start else {
            // There is nothing in the map.
            return Ok(Located::Face(dcel.unbounded_face().key()));
        };
        let mut last = Located::Vertex(start.key());
        self.walk(start, p, |element| {
            last = match element {
                ZoneElement::Face(face) => Located::Face(face),
                ZoneElement::Edge(half_edge) | ZoneElement::Along(half_edge) => Located::Edge(half_edge),
                ZoneElement::Vertex(vertex) => Located::Vertex(vertex),
            };
        })?;
        Ok(last)
    }

    /// The elements that the segment from a vertex to a point meets, in order, the vertex first: as
    /// [`Locator::zone`](crate::map::Locator::zone) has it, but without an index. Nothing but the vertex, if the
    /// point is the vertex.
    ///
    /// Costs what [`PlanarMap::locate_from`] costs.
    ///
    /// ```
    /// use twinedge::geometry::Point;
    /// use twinedge::map::{PlanarMap, ZoneElement};
    ///
    /// let mut map = PlanarMap::new();
    /// let start = map.insert_point([0.0, 1.0])?.vertices[0];
    /// let wall = map.insert_segment([1.0, 0.0], [1.0, 2.0])?.way[0];
    /// let outside = map.dcel().unbounded_face().key();
    /// let zone = map.zone_from(start, Point::new(2.0, 1.0))?;
    /// assert_eq!(zone[..2], [ZoneElement::Vertex(start), ZoneElement::Face(outside)]);
    /// // The half-edge that comes from the left of the line.
    /// let from_the_left = map.dcel().half_edge(wall)?.twin().key();
    /// assert_eq!(zone[2..], [ZoneElement::Edge(from_the_left), ZoneElement::Face(outside)]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`PlanarMap::locate_from`].
    pub fn zone_from(&self, start: VertexKey, to: Point) -> Result<Vec<ZoneElement>, LocateError> {
        check_range(to)?;
        let mut all = Vec::new();
        self.walk(self.dcel().vertex(start)?, to, |element| all.push(element))?;
        Ok(all)
    }

    fn walk(&self, start: Vertex<'_>, to: Point, mut visit: impl FnMut(ZoneElement)) -> Result<(), LocateError> {
        let event = Line::at(self, start);
        let from = self.point(start.index());
        if from == to {
            visit(ZoneElement::Vertex(start.key()));
            return Ok(());
        }
        self.go(&Line { from, through: to }, Some(to), event, visit)
    }

    /// The elements that a line meets, given a half-edge whose edge it crosses or one of whose ends it meets: as
    /// [`Locator::zone`](crate::map::Locator::zone) has it, but without an index, by walking from there both ways.
    ///
    /// O(boundaries of the faces met), each counted twice at most, and O(k log k) for k edges and vertices on the way.
    ///
    /// ```
    /// use twinedge::geometry::Point;
    /// use twinedge::map::{Builder, ZoneElement, QueryLine};
    ///
    /// // A ladder: two rails, and four rungs with three faces between them.
    /// let mut builder = Builder::new();
    /// for x in [0.0, 1.0, 2.0, 3.0] {
    ///     builder.segment([x, 0.0], [x, 1.0])?;
    /// }
    /// for (x, y) in [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (0.0, 1.0), (1.0, 1.0), (2.0, 1.0)] {
    ///     builder.segment([x, y], [x + 1.0, y])?;
    /// }
    /// let map = builder.build()?;
    /// let rung = map.dcel().half_edges().next().unwrap().key();
    /// let line = QueryLine::Line(Point::new(0.0, 0.25), Point::new(3.0, 0.75));
    /// let faces = map.zone_through(rung, &line)?.into_iter().filter(|element| matches!(element, ZoneElement::Face(_)));
    /// assert_eq!(faces.count(), 5);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`LocateError::NotMet`], if it meets the edge nowhere, or only in the midst of a query that runs along it;
    /// [`LocateError::NoDirection`]; else as [`PlanarMap::locate_from`].
    pub fn zone_through(&self, half_edge: HalfEdgeKey, query: &QueryLine) -> Result<Vec<ZoneElement>, LocateError> {
        let (QueryLine::Segment(from, through) | QueryLine::Ray(from, through) | QueryLine::Line(from, through)) =
            *query;
        check_range(from)?;
        check_range(through)?;
        if from == through {
            return Err(LocateError::NoDirection(from));
        }
        let first = if let QueryLine::Line(..) = query { None } else { Some(from) };
        let last = if let QueryLine::Segment(..) = query { Some(through) } else { None };
        let h = self.dcel().half_edge(half_edge)?;
        let way_there = Line { from, through };
        let way_back = Line { from: through, through: from };
        let is_on = |event: &LineEvent<'_>| {
            first.is_none_or(|first| way_there.order(LinePlace::At(first), event.place).is_le())
                && last.is_none_or(|last| way_there.order(event.place, LinePlace::At(last)).is_le())
        };
        let [origin, target] = [h.origin(), h.target()].map(|v| {
            let p = self.point(v.index());
            (v, (p, way_there.side(p)))
        });
        let at_end = |(v, (_, side))| (side == Orientation::Collinear).then(|| Line::at(self, v));
        let events = [Line::crossing(h, origin.1, target.1), at_end(origin), at_end(target)];
        let Some(start) = events.into_iter().flatten().find(is_on) else {
            return Err(LocateError::NotMet(half_edge));
        };
        let mut zone = Vec::new();
        self.go(&way_back, first, start.turned(), |element| zone.push(element))?;
        zone.reverse();
        // The place from which both ways go.
        zone.pop();
        for element in &mut zone {
            if let ZoneElement::Edge(h) | ZoneElement::Along(h) = element {
                *h = self.dcel().half_edge(*h)?.twin().key();
            }
        }
        self.go(&way_there, last, start, |element| zone.push(element))?;
        Ok(zone)
    }

    fn go(
        &self,
        line: &Line,
        to: Option<Point>,
        start: LineEvent<'_>,
        visit: impl FnMut(ZoneElement),
    ) -> Result<(), LocateError> {
        let mut known = KnownEvents { map: self, line, to, scanned: FxHashSet::default(), ahead: BinaryHeap::new() };
        follow(self, line, to, ZoneStart::Event(start), |piece, at| known.next(piece, at), visit)
    }
}

/// The events ahead that are known so far: those on the boundaries of the faces entered.
struct KnownEvents<'m, 'l> {
    map: &'m PlanarMap,
    line: &'l Line,
    to: Option<Point>,
    scanned: FxHashSet<usize>,
    ahead: BinaryHeap<Ahead<'m, 'l>>,
}

impl<'m> KnownEvents<'m, '_> {
    /// The next event after a place, in a piece.
    fn next(&mut self, piece: LinePiece<'m>, at: Option<LinePlace>) -> Option<LineEvent<'m>> {
        match piece {
            LinePiece::Face(face) => {
                if self.scanned.insert(face.index()) {
                    self.scan(face, at);
                }
            }
            LinePiece::Along(h) => self.add(Line::at(self.map, h.target()), at),
        }
        // A face that was scanned later has seen again what is there.
        while let Some(Ahead { event, .. }) = self.ahead.pop() {
            if at.is_none_or(|at| self.line.order(at, event.place).is_lt()) {
                return Some(event);
            }
        }
        None
    }

    /// Takes note of where the line meets the boundary of a face.
    fn scan(&mut self, face: Face<'m>, at: Option<LinePlace>) {
        let (map, line) = (self.map, self.line);
        let sided = |vertex: Vertex<'_>| {
            let p = map.point(vertex.index());
            (p, line.side(p))
        };
        for boundary in face.boundaries() {
            if let Some(vertex) = boundary.isolated_vertex().filter(|v| sided(*v).1 == Orientation::Collinear) {
                self.add(Line::at(map, vertex), at);
            }
            let Some(start) = boundary.start() else { continue };
            let mut origin = sided(start.origin());
            for h in start.boundary_cycle() {
                let target = sided(h.target());
                if origin.1 == Orientation::Collinear {
                    self.add(Line::at(map, h.origin()), at);
                }
                if let Some(event) = Line::crossing(h, origin, target) {
                    self.add(event, at);
                }
                origin = target;
            }
        }
    }

    /// Takes note of an event, if it is ahead and not beyond the end.
    fn add(&mut self, event: LineEvent<'m>, at: Option<LinePlace>) {
        if at.is_none_or(|at| self.line.order(at, event.place).is_lt())
            && self.to.is_none_or(|to| self.line.order(event.place, LinePlace::At(to)).is_le())
        {
            self.ahead.push(Ahead { event, line: self.line });
        }
    }
}

/// An event in a heap, which gives the nearest first.
struct Ahead<'m, 'l> {
    event: LineEvent<'m>,
    line: &'l Line,
}

impl PartialEq for Ahead<'_, '_> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Ahead<'_, '_> {}

impl PartialOrd for Ahead<'_, '_> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Ahead<'_, '_> {
    fn cmp(&self, other: &Self) -> Ordering {
        self.line.order(other.event.place, self.event.place)
    }
}
