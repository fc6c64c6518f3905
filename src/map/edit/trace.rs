//! The way of a segment through the map, before anything is drawn.

use super::error::EditError;
use crate::dcel::{Face, FaceKey, HalfEdge, Vertex, VertexKey};
use crate::geometry::Point;
use crate::geometry::predicates::{
    Endpoint, Meeting, Orientation, compare_angle, compare_lexicographic, meeting, on_segment, orientation,
};
use crate::map::locate::located::Located;
use crate::map::planar_map::PlanarMap;
use core::cmp::Ordering;
use rustc_hash::FxHashMap;
use std::collections::hash_map::Entry;

/// The way of a segment that crosses nothing.
pub(super) struct Trace {
    /// The vertices that it passes through, in order, without its ends.
    pub(super) stops: Vec<VertexKey>,
    /// Where it ends.
    pub(super) end: Located,
}

/// What leaves a vertex towards a point.
pub(super) enum Towards<'a> {
    /// This half-edge, in exactly that direction.
    Along(HalfEdge<'a>),
    /// Nothing: the direction is in the corner of this half-edge.
    Corner(HalfEdge<'a>),
    /// Nothing: the vertex is isolated.
    Isolated,
}

impl<'a> Towards<'a> {
    /// The half-edge whose corner it is.
    pub(super) const fn corner(self) -> Option<HalfEdge<'a>> {
        match self {
            Self::Along(h) | Self::Corner(h) => Some(h),
            Self::Isolated => None,
        }
    }
}

impl PlanarMap {
    /// What leaves a vertex towards a point elsewhere. O(degree).
    pub(super) fn towards<'a>(&self, v: Vertex<'a>, p: Point) -> Towards<'a> {
        let at = self.at(v);
        let mut corner = None;
        for h in v.rotation() {
            let (from, to) = (self.at(h.target()), self.at(h.counter_clockwise().target()));
            let after = compare_angle(at, from, p);
            if after == Ordering::Equal {
                return Towards::Along(h);
            }
            let before = compare_angle(at, p, to);
            // The corner that spans the positive x axis is not ordered; that of an only half-edge is all around.
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

    /// The way of a segment from a point in a known place to another point. O(sizes of the faces that it passes and
    /// degrees of the vertices that it passes), and a factor of log for sorting the vertices.
    pub(super) fn trace(&self, start: Located, from: Point, to: Point) -> Result<Trace, EditError> {
        let mut stops = Vec::new();
        let (mut place, mut at) = (start, from);
        let mut seen = FxHashMap::default();
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
                            // Either way leads along the edge; the end that lies beyond `to` is not reached.
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

    /// What lies ahead on the way along a half-edge.
    fn ahead_along<'a>(&self, h: HalfEdge<'a>, at: Point, to: Point) -> Ahead<'a> {
        let v = h.target();
        if on_the_way(self.at(v), at, to) { Ahead::Vertex(v) } else { Ahead::End(Located::Edge(h.key())) }
    }

    /// What lies ahead on the way through a face. Each face is looked at once, however often the way comes to it.
    fn ahead_in<'a>(
        &self,
        face: Face<'a>,
        at: Point,
        to: Point,
        seen: &mut FxHashMap<FaceKey, Seen<'a>>,
    ) -> Result<Ahead<'a>, EditError> {
        let Seen { beyond, end } = match seen.entry(face.key()) {
            Entry::Occupied(entry) => entry.into_mut(),
            Entry::Vacant(entry) => entry.insert(self.seen_in(face, at, to)?),
        };
        while let Some((v, w)) = beyond.last() {
            if on_the_way(*w, at, to) {
                return Ok(Ahead::Vertex(*v));
            }
            beyond.pop();
        }
        Ok(Ahead::End(*end))
    }

    /// What there is of a face on the way; an error if that crosses an edge there.
    fn seen_in<'a>(&self, face: Face<'a>, at: Point, to: Point) -> Result<Seen<'a>, EditError> {
        let mut beyond = Vec::new();
        let mut look_at = |v: Vertex<'a>| {
            let w = self.at(v);
            if on_the_way(w, at, to) {
                beyond.push((v, w));
            }
        };
        let mut end = Located::Face(face.key());
        for h in face.half_edges() {
            let [tail, head] = self.ends(h);
            match meeting(at, to, tail, head) {
                Meeting::Disjoint => continue,
                Meeting::Cross => return Err(EditError::Crosses(h.key())),
                Meeting::Touch(Endpoint::B) => end = Located::Edge(h.key()),
                Meeting::Touch(_) | Meeting::SharedEndpoint | Meeting::Overlap => {}
            }
            look_at(h.origin());
            look_at(h.target());
        }
        face.inner().filter_map(|b| b.isolated_vertex()).for_each(look_at);
        beyond.sort_unstable_by(|(_, p), (_, q)| compare_lexicographic(*q, *p));
        if compare_lexicographic(to, at).is_lt() {
            beyond.reverse();
        }
        Ok(Seen { beyond, end })
    }
}

/// What there is of a face on the way of a segment.
struct Seen<'a> {
    /// The vertices, the furthest first; some of them twice.
    beyond: Vec<(Vertex<'a>, Point)>,
    /// Where the segment ends, if in this face and not at a vertex.
    end: Located,
}

/// What lies ahead on the way of a segment.
enum Ahead<'a> {
    /// This vertex, and nothing before it.
    Vertex(Vertex<'a>),
    /// Nothing but the end of the segment, which is there.
    End(Located),
}

/// Whether, going on straight from `c`, `b` comes after `w`, or is it.
fn on_the_way(w: Point, c: Point, b: Point) -> bool {
    w != c && on_segment(w, c, b)
}

#[cfg(test)]
mod tests {
    use crate::geometry::predicates::steps_of;
    use crate::map::planar_map::PlanarMap;

    #[test]
    fn a_face_is_looked_at_once_however_many_vertices_are_on_the_way() {
        const POINTS: u32 = 1000;
        let mut map = PlanarMap::new();
        for i in 0..POINTS {
            map.insert_point([f64::from(i), 0.0]).unwrap();
        }
        let (edited, steps) = steps_of(|| map.insert_segment([-1.0, 0.0], [f64::from(POINTS), 0.0]));
        assert_eq!(edited.map(|edited| edited.way.len()), Ok(POINTS as usize + 1));
        assert!(steps < 50 * u64::from(POINTS), "{steps}");
    }
}
