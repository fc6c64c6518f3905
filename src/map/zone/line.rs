//! A directed line, the places on it where it meets a map, and their order.
//!
//! Where a line crosses an edge is a point whose coordinates no double can hold. It is never computed: two places are
//! compared by asking on which side of one edge the ends of the other lie, which is exact.

use crate::dcel::{Face, HalfEdge, Vertex};
use crate::geometry::Point;
use crate::geometry::predicates::{Orientation, compare_lexicographic, orientation};
use crate::map::PlanarMap;
use crate::validate::Embedding;
use core::cmp::Ordering;

/// The line through two different points, directed from the one to the other.
#[derive(Clone, Copy)]
pub(super) struct Line {
    pub(super) from: Point,
    pub(super) through: Point,
}

/// A point of a line.
#[derive(Clone, Copy)]
pub(super) enum Place {
    /// This one, which lies on the line.
    At(Point),
    /// Where the segment from the first point, on the left of the line, to the second, on the right, crosses it.
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

/// Something that a line meets in one point.
#[derive(Clone, Copy)]
pub(super) struct Event<'m> {
    pub(super) what: What<'m>,
    pub(super) place: Place,
}

impl Event<'_> {
    /// The same, for the line in the other direction.
    pub(super) fn turned(self) -> Self {
        let what = match self.what {
            What::Edge(h) => What::Edge(h.twin()),
            vertex @ What::Vertex(_) => vertex,
        };
        let place = match self.place {
            Place::Crossing(left, right) => Place::Crossing(right, left),
            point @ Place::At(_) => point,
        };
        Self { what, place }
    }
}

/// What a line meets in one point.
#[derive(Clone, Copy)]
pub(super) enum What<'m> {
    Vertex(Vertex<'m>),
    /// An edge, by the half-edge that crosses from the left of the line to its right: its face is ahead.
    Edge(HalfEdge<'m>),
}

/// What a line goes through between two points.
#[derive(Clone, Copy)]
pub(super) enum Piece<'m> {
    Face(Face<'m>),
    /// An edge, by the half-edge in the direction of the line.
    Along(HalfEdge<'m>),
}

impl Line {
    #[inline]
    pub(super) fn side(&self, p: Point) -> Orientation {
        orientation(self.from, self.through, p)
    }

    /// Compares two places by how far along the line they are. Equal, if the one is the other, or if the map is not plane
    /// and neither is first.
    pub(super) fn order(&self, a: Place, b: Place) -> Ordering {
        match (a, b) {
            (Place::At(a), Place::At(b)) => self.order_points(a, b),
            (Place::At(p), Place::Crossing(left, right)) => Self::beside(left, right, p),
            (Place::Crossing(left, right), Place::At(p)) => Self::beside(left, right, p).reverse(),
            (Place::Crossing(a, b), Place::Crossing(left, right)) => {
                // Of two segments that do not cross, one lies on one side of the other.
                Self::both(Self::beside(left, right, a), Self::beside(left, right, b)).unwrap_or_else(|| {
                    Self::both(Self::beside(a, b, left), Self::beside(a, b, right))
                        .map_or(Ordering::Equal, Ordering::reverse)
                })
            }
        }
    }

    /// Compares two points of the line.
    fn order_points(&self, a: Point, b: Point) -> Ordering {
        let order = compare_lexicographic(a, b);
        if compare_lexicographic(self.from, self.through).is_lt() { order } else { order.reverse() }
    }

    /// Whether a point is behind (less) or ahead (greater) of a segment that crosses the line.
    fn beside(left: Point, right: Point, p: Point) -> Ordering {
        match orientation(left, right, p) {
            Orientation::Clockwise => Ordering::Less,
            Orientation::Collinear => Ordering::Equal,
            Orientation::CounterClockwise => Ordering::Greater,
        }
    }

    /// What both say, if they do not contradict each other.
    fn both(a: Ordering, b: Ordering) -> Option<Ordering> {
        if a == b || b == Ordering::Equal {
            Some(a)
        } else if a == Ordering::Equal {
            Some(b)
        } else {
            None
        }
    }

    /// The vertex as something that the line meets.
    pub(super) fn at<'m>(map: &PlanarMap, vertex: Vertex<'m>) -> Event<'m> {
        Event { what: What::Vertex(vertex), place: Place::At(map.point(vertex.index())) }
    }

    /// How the line crosses an edge, if it passes between its ends: these are given as the ends of one of the half-edges, with
    /// their sides.
    #[inline]
    pub(super) fn crossing(
        h: HalfEdge<'_>,
        origin: (Point, Orientation),
        target: (Point, Orientation),
    ) -> Option<Event<'_>> {
        match (origin, target) {
            ((left, Orientation::CounterClockwise), (right, Orientation::Clockwise)) => {
                Some(Event { what: What::Edge(h), place: Place::Crossing(left, right) })
            }
            ((right, Orientation::Clockwise), (left, Orientation::CounterClockwise)) => {
                Some(Event { what: What::Edge(h.twin()), place: Place::Crossing(left, right) })
            }
            _ => None,
        }
    }

    /// What the line goes through after something. O(degree).
    pub(super) fn after<'m>(&self, map: &'m PlanarMap, event: Event<'m>) -> Piece<'m> {
        let vertex = match event.what {
            What::Edge(h) => return Piece::Face(h.face()),
            What::Vertex(vertex) => vertex,
        };
        let center = map.point(vertex.index());
        // The last half-edge, turning counter-clockwise from the direction of the line: the line leaves between it and
        // the first.
        let mut last: Option<(u8, Point, HalfEdge<'m>)> = None;
        for h in vertex.rotation() {
            let head = map.point(h.target().index());
            let quarter = match self.side(head) {
                Orientation::CounterClockwise => 1,
                Orientation::Collinear if self.order_points(center, head).is_lt() => return Piece::Along(h),
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
            (Some((.., h)), _) => Piece::Face(h.face()),
            (None, Some(boundary)) => Piece::Face(boundary.face()),
            // A vertex without half-edges is isolated.
            (None, None) => Piece::Face(map.dcel().unbounded_face()),
        }
    }
}
