//! Locating a point in one face or on its boundary, by scanning the boundary.

use super::Located;
use crate::Embedding;
use crate::planar_map::PlanarMap;
use core::cmp::Ordering;
use twinedge::dcel::{Face, HalfEdge, Vertex};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::{Orientation, compare_lexicographic, orientation};

/// Returns the location of a point in this face or on its boundary, or `None` if it lies elsewhere. O(size of the boundary).
pub(crate) fn locate_in_face(map: &PlanarMap, face: Face<'_>, p: Point) -> Option<Located> {
    let mut scan = BoundaryScan { map, p, on: None, below: None };
    face.half_edges().for_each(|h| scan.at_edge(h));
    face.inner().filter_map(|b| b.isolated_vertex()).for_each(|v| scan.at_vertex(v));
    // The edge directly below belongs to the boundary of the point's face, so it decides.
    let is_inside = || scan.below.map_or(face.is_unbounded(), |(h, _)| h.face() == face);
    scan.on.or_else(|| is_inside().then(|| Located::Face(face.key())))
}

/// A scan of edges and isolated vertices around a point, in progress.
struct BoundaryScan<'a> {
    map: &'a PlanarMap,
    p: Point,
    on: Option<Located>,
    /// The first edge straight below the point (slightly to the right at a vertex), as the half-edge that runs to the right, and
    /// its ends.
    below: Option<(HalfEdge<'a>, [Point; 2])>,
}

impl<'a> BoundaryScan<'a> {
    fn at_vertex(&mut self, v: Vertex<'_>) {
        if self.map.point(v.index()) == self.p {
            self.on = Some(Located::Vertex(v.key()));
        }
    }

    fn at_edge(&mut self, h: HalfEdge<'a>) {
        let ends = [h.origin(), h.target()].map(|v| self.map.point(v.index()));
        let (h, [low, high]) = match compare_lexicographic(ends[0], ends[1]) {
            Ordering::Less => (h, ends),
            _ => (h.twin(), [ends[1], ends[0]]),
        };
        if self.p == low {
            self.on = Some(Located::Vertex(h.origin().key()));
        } else if self.p == high {
            self.on = Some(Located::Vertex(h.target().key()));
        } else if compare_lexicographic(low, self.p).is_lt() && compare_lexicographic(self.p, high).is_lt() {
            match orientation(low, high, self.p) {
                Orientation::Collinear => self.on = Some(Located::Edge(h.key())),
                Orientation::CounterClockwise => {
                    if self.below.is_none_or(|(_, other)| is_above([low, high], other)) {
                        self.below = Some((h, [low, high]));
                    }
                }
                Orientation::Clockwise => {}
            }
        }
    }
}

/// Returns true if an edge lies above another one. Both must rise, and extend to the left and right of one point.
fn is_above([low, high]: [Point; 2], [other_low, other_high]: [Point; 2]) -> bool {
    // The edge that starts further right starts above or below the other.
    let turn = if low == other_low {
        orientation(other_low, other_high, high)
    } else if compare_lexicographic(other_low, low).is_lt() {
        orientation(other_low, other_high, low)
    } else {
        return orientation(low, high, other_low) == Orientation::Clockwise;
    };
    turn == Orientation::CounterClockwise
}
