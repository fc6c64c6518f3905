//! A directed line, the places on it where it meets a map, and their order.
//!
//! The crossing of a line and an edge has coordinates that doubles cannot represent. It is never computed: two places are
//! compared exactly, by finding the side of one edge on which the ends of the other lie.

use crate::Embedding;
use crate::planar_map::PlanarMap;
use core::cmp::Ordering;
use twinedge::dcel::{Face, HalfEdge, Vertex};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::{Orientation, compare_lexicographic, orientation};

/// The line through two different points, directed from the first to the second.
#[derive(Clone, Copy)]
pub(crate) struct Line {
    pub(crate) from: Point,
    pub(crate) through: Point,
}

#[derive(Clone, Copy)]
pub(crate) enum LinePlace {
    At(Point),
    /// The point where the segment from the first point, on the left of the line, to the second, on the right, crosses it.
    ///
    /// ```text
    ///               first
    ///                 \
    ///   line ----------\---------->
    ///          behind   \   ahead
    ///                  second
    /// ```
    Crossing(Point, Point),
}

/// A record that a line meets in one point, and the place.
#[derive(Clone, Copy)]
pub(crate) struct LineEvent<'m> {
    pub(crate) record: EventRecord<'m>,
    pub(crate) place: LinePlace,
}

/// The record that a line meets in one point.
#[derive(Clone, Copy)]
pub(crate) enum EventRecord<'m> {
    Vertex(Vertex<'m>),
    /// An edge, by the half-edge that crosses from the left of the line to the right: its face is ahead.
    Edge(HalfEdge<'m>),
}

/// The record that a line passes through between two events.
#[derive(Clone, Copy)]
pub(crate) enum LinePiece<'m> {
    Face(Face<'m>),
    /// An edge, by the half-edge in the direction of the line.
    Along(HalfEdge<'m>),
}

impl Line {
    #[inline]
    pub(crate) fn side(&self, p: Point) -> Orientation {
        orientation(self.from, self.through, p)
    }

    /// Compares two places along the line. They are equal if they coincide, or if the map is not plane and neither is first.
    pub(crate) fn order(&self, a: LinePlace, b: LinePlace) -> Ordering {
        match (a, b) {
            (LinePlace::At(a), LinePlace::At(b)) => self.order_points(a, b),
            (LinePlace::At(p), LinePlace::Crossing(left, right)) => Self::beside(left, right, p),
            (LinePlace::Crossing(left, right), LinePlace::At(p)) => Self::beside(left, right, p).reverse(),
            (LinePlace::Crossing(a, b), LinePlace::Crossing(left, right)) => {
                // If two segments do not cross, one lies on one side of the other.
                Self::both(Self::beside(left, right, a), Self::beside(left, right, b)).unwrap_or_else(|| {
                    Self::both(Self::beside(a, b, left), Self::beside(a, b, right))
                        .map_or(Ordering::Equal, Ordering::reverse)
                })
            }
        }
    }

    /// Compares two points on the line.
    fn order_points(&self, a: Point, b: Point) -> Ordering {
        let order = compare_lexicographic(a, b);
        if compare_lexicographic(self.from, self.through).is_lt() { order } else { order.reverse() }
    }

    /// Compares a point with a segment that crosses the line: behind it (less) or ahead of it (greater).
    fn beside(left: Point, right: Point, p: Point) -> Ordering {
        match orientation(left, right, p) {
            Orientation::Clockwise => Ordering::Less,
            Orientation::Collinear => Ordering::Equal,
            Orientation::CounterClockwise => Ordering::Greater,
        }
    }

    /// Returns the order on which both agree, where equal agrees with either, or `None` if they contradict each other.
    fn both(a: Ordering, b: Ordering) -> Option<Ordering> {
        if a == b || b == Ordering::Equal {
            Some(a)
        } else if a == Ordering::Equal {
            Some(b)
        } else {
            None
        }
    }

    pub(crate) fn at<'m>(map: &PlanarMap, vertex: Vertex<'m>) -> LineEvent<'m> {
        LineEvent { record: EventRecord::Vertex(vertex), place: LinePlace::At(map.point(vertex.index())) }
    }

    /// Returns the crossing of the line with an edge, if it passes between its ends. These are given with their sides.
    #[inline]
    pub(crate) fn crossing(
        h: HalfEdge<'_>,
        origin: (Point, Orientation),
        target: (Point, Orientation),
    ) -> Option<LineEvent<'_>> {
        match (origin, target) {
            ((left, Orientation::CounterClockwise), (right, Orientation::Clockwise)) => {
                Some(LineEvent { record: EventRecord::Edge(h), place: LinePlace::Crossing(left, right) })
            }
            ((right, Orientation::Clockwise), (left, Orientation::CounterClockwise)) => {
                Some(LineEvent { record: EventRecord::Edge(h.twin()), place: LinePlace::Crossing(left, right) })
            }
            _ => None,
        }
    }

    /// Returns the piece that follows an event. O(degree).
    pub(crate) fn after<'m>(&self, map: &'m PlanarMap, event: LineEvent<'m>) -> LinePiece<'m> {
        let vertex = match event.record {
            EventRecord::Edge(h) => return LinePiece::Face(h.face()),
            EventRecord::Vertex(vertex) => vertex,
        };
        let center = map.point(vertex.index());
        // The last half-edge counter-clockwise from the direction of the line: the line leaves between it and the first.
        let mut last: Option<(u8, Point, HalfEdge<'m>)> = None;
        for h in vertex.rotation() {
            let head = map.point(h.target().index());
            let quarter = match self.side(head) {
                Orientation::CounterClockwise => 1,
                Orientation::Collinear if self.order_points(center, head).is_lt() => return LinePiece::Along(h),
                Orientation::Collinear => 2,
                Orientation::Clockwise => 3,
            };
            let later = last.is_none_or(|(other, point, _)| {
                quarter > other || quarter == other && orientation(center, point, head) == Orientation::CounterClockwise
            });
            if later {
                last = Some((quarter, head, h));
            }
        }
        match (last, vertex.isolated()) {
            (Some((.., h)), _) => LinePiece::Face(h.face()),
            (None, Some(boundary)) => LinePiece::Face(boundary.face()),
            // A vertex without half-edges is isolated.
            (None, None) => LinePiece::Face(map.dcel().unbounded_face()),
        }
    }
}
