//! Where a point lies.
//!
//! No index is kept: with a hint, the face of the hint is looked at first; without one, or if the point does not lie there,
//! the whole map is.

use super::super::predicates::{Orientation, compare_lexicographic, in_range, on_segment, orientation};
use super::super::{PlanarMap, Point};
use super::{At, EditError};
use crate::dcel::{FaceKey, HalfEdge, HalfEdgeKey, Vertex, VertexKey};
use core::cmp::Ordering;

/// Where a point lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    /// At a vertex.
    Vertex(VertexKey),
    /// In the interior of the edge of this half-edge.
    Edge(HalfEdgeKey),
    /// In the interior of a face.
    Face(FaceKey),
}

impl PlanarMap {
    /// Refuses a map that is not plane.
    pub(super) fn editable(&self) -> Result<(), EditError> {
        if self.is_plane() { Ok(()) } else { Err(EditError::NotPlane) }
    }

    /// The point that is meant, in range, with no −0.
    pub(super) fn point_of(&self, at: At) -> Result<Point, EditError> {
        let Point { x, y } = match at {
            At::Point(p) | At::Near(p, _) => p,
            At::Vertex(v) => self.position(v)?,
        };
        if !x.is_finite() || !y.is_finite() {
            Err(EditError::NotFinite { x, y })
        } else if !in_range(Point { x, y }) {
            Err(EditError::OutOfRange { x, y })
        } else {
            Ok(Point { x: x + 0.0, y: y + 0.0 })
        }
    }

    /// Where the point that is meant lies. For the cost see [`place`](Self::place); O(1) for a vertex.
    pub(super) fn place_of(&self, at: At) -> Result<Place, EditError> {
        Ok(match at {
            At::Point(_) => self.place(self.point_of(at)?, None),
            At::Near(_, hint) => {
                let hint = self.dcel.half_edge(hint)?;
                self.place(self.point_of(at)?, Some(hint))
            }
            At::Vertex(v) => Place::Vertex(self.dcel.vertex(v)?.key()),
        })
    }

    /// Where a vertex of this map lies.
    pub(super) fn at(&self, vertex: Vertex<'_>) -> Point {
        self.points[vertex.index()]
    }

    /// Where a half-edge of this map starts and ends.
    pub(super) fn ends(&self, h: HalfEdge<'_>) -> [Point; 2] {
        [self.at(h.origin()), self.at(h.target())]
    }

    /// Where a point in range lies. O(size of the boundary of the hint's face) if it lies in that face or on its boundary,
    /// else O(n).
    pub(super) fn place(&self, p: Point, hint: Option<HalfEdge<'_>>) -> Place {
        if let Some(face) = hint.map(HalfEdge::face) {
            let mut look = Look::new(self, p);
            face.half_edges().for_each(|h| look.at_edge(h));
            face.inner().filter_map(|b| b.isolated_vertex()).for_each(|v| look.at_vertex(v));
            // All else lies beyond the boundary of the face, so what is seen of that face is what there is.
            match look.seen() {
                Place::Face(other) if other != face.key() => {}
                seen => return seen,
            }
        }
        let mut look = Look::new(self, p);
        self.dcel.edges().for_each(|h| look.at_edge(h));
        self.dcel.vertices().filter(|v| v.leaving().is_none()).for_each(|v| look.at_vertex(v));
        look.seen()
    }
}

/// What is seen from a point, after looking at some edges and isolated vertices.
struct Look<'a> {
    map: &'a PlanarMap,
    p: Point,
    on: Option<Place>,
    /// The edge that is met first going straight down from the point (or leaning to the right a little, if that meets a
    /// vertex), as the half-edge that runs to the right, and its ends.
    below: Option<(HalfEdge<'a>, [Point; 2])>,
}

impl<'a> Look<'a> {
    const fn new(map: &'a PlanarMap, p: Point) -> Self {
        Self { map, p, on: None, below: None }
    }

    fn at_vertex(&mut self, v: Vertex<'_>) {
        if self.map.at(v) == self.p {
            self.on = Some(Place::Vertex(v.key()));
        }
    }

    fn at_edge(&mut self, h: HalfEdge<'a>) {
        let ends = self.map.ends(h);
        let (h, [low, high]) = match compare_lexicographic(ends[0], ends[1]) {
            Ordering::Less => (h, ends),
            _ => (h.twin(), [ends[1], ends[0]]),
        };
        if self.p == low {
            self.on = Some(Place::Vertex(h.origin().key()));
        } else if self.p == high {
            self.on = Some(Place::Vertex(h.target().key()));
        } else if compare_lexicographic(low, self.p).is_lt() && compare_lexicographic(self.p, high).is_lt() {
            match orientation(low, high, self.p) {
                Orientation::Collinear => self.on = Some(Place::Edge(h.key())),
                Orientation::CounterClockwise => {
                    if self.below.is_none_or(|(_, other)| is_above([low, high], other)) {
                        self.below = Some((h, [low, high]));
                    }
                }
                Orientation::Clockwise => {}
            }
        }
    }

    fn seen(&self) -> Place {
        let face = || self.below.map_or(self.map.dcel.unbounded_face(), |(h, _)| h.face());
        self.on.unwrap_or_else(|| Place::Face(face().key()))
    }
}

/// Whether an edge lies above another, where both rise and have something to the left and to the right of one point.
fn is_above([low, high]: [Point; 2], [other_low, other_high]: [Point; 2]) -> bool {
    // The one that starts further right starts above or below the other.
    let turn = if low == other_low {
        orientation(other_low, other_high, high)
    } else if compare_lexicographic(other_low, low).is_lt() {
        orientation(other_low, other_high, low)
    } else {
        return orientation(low, high, other_low) == Orientation::Clockwise;
    };
    turn == Orientation::CounterClockwise
}

/// Whether, going on straight from `c`, `b` comes after `w`, or is it.
pub(super) fn on_the_way(w: Point, c: Point, b: Point) -> bool {
    w != c && on_segment(w, c, b)
}
