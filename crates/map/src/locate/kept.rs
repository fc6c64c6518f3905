//! Locating a point by the index that a map keeps.
//!
//! The index finds a nearby record. The first record met on the way from the point straight there, and a little further, bounds
//! the point's face. This step is exact, no matter which record is nearby.

use super::{LocateError, Located, check_range};
use crate::Embedding;
use crate::edit::trace::Towards;
use crate::index::{BoxedRecord, TreeRecord};
use crate::not_plane::NotPlane;
use crate::planar_map::PlanarMap;
use crate::zone::QueryLine;
use crate::zone::line::{EventRecord, Line, LineEvent, LinePlace};
use crate::zone::selection::each_event;
use twinedge::dcel::{Face, HalfEdge};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::{compare_lexicographic, in_range};

impl PlanarMap {
    /// Returns the location of a point. An edge is named by the half-edge that runs to the right, or straight
    /// up.
    ///
    /// The first call builds an index in O(n log n), which the map maintains through all [edits](crate::edit). With it, a query
    /// costs the search of an R-tree for the records between the point and a nearby record: O(log n) if boxes hardly overlap, as
    /// on most maps, and O(n) at worst, for example among long slanted parallels or between the spokes of a star.
    ///
    /// ```
    /// use twinedge_geometry::Point;
    /// use twinedge_map::{Located, PlanarMap};
    ///
    /// let mut map = PlanarMap::new();
    /// let ring = map.insert_ring([[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]])?;
    /// let inside = ring.faces_split[0].1;
    /// assert_eq!(map.locate(Point::new(1.0, 1.5))?, Located::Face(inside));
    /// map.insert_segment([0.0, 2.5], [2.5, 0.0])?;
    /// assert!(matches!(map.locate(Point::new(1.0, 1.5))?, Located::Edge(_)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`LocateError::OutOfRange`]; [`LocateError::NotPlane`].
    pub fn locate(&self, p: Point) -> Result<Located, LocateError> {
        check_range(p)?;
        self.plane()?;
        let Some(near) = self.index().near(p) else {
            return Ok(Located::Face(self.dcel().unbounded_face().key()));
        };
        let end = near.nearest_end(p);
        let found = if end == p {
            self.vertex_of(near, p)
        } else {
            // The segment to an end always meets something, but perhaps only after a long way.
            let across = near.across(p).filter(|q| in_range(*q) && *q != p);
            across.and_then(|q| self.first_met(p, q)).or_else(|| self.first_met(p, end))
        };
        found.ok_or_else(|| NotPlane::default().into())
    }

    /// Returns the face that contains a point, even if an isolated vertex lies there. Returns `None` on an edge, and on a map
    /// that is not plane. It costs as much as [`locate`](Self::locate).
    #[must_use]
    pub fn face_at(&self, p: Point) -> Option<Face<'_>> {
        match self.locate(p).ok()? {
            Located::Face(face) => self.dcel().face(face).ok(),
            Located::Vertex(vertex) => Some(self.dcel().vertex(vertex).ok()?.isolated()?.face()),
            Located::Edge(_) => None,
        }
    }

    /// Returns the end of a record at a point.
    fn vertex_of(&self, boxed: &BoxedRecord, p: Point) -> Option<Located> {
        let dcel = self.dcel();
        let ends = match boxed.record {
            TreeRecord::Edge(h) => {
                dcel.half_edge_at(h as usize).map_or([None; 2], |h| [h.origin(), h.target()].map(Some))
            }
            TreeRecord::Vertex(v) => [dcel.vertex_at(v as usize), None],
        };
        ends.into_iter().flatten().find(|v| self.point(v.index()) == p).map(|v| Located::Vertex(v.key()))
    }

    /// Returns the location of a point, derived from the first record on the segment to another point, or `None` without one.
    fn first_met(&self, p: Point, to: Point) -> Option<Located> {
        let line = Line { from: p, through: to };
        let mut first: Option<LineEvent<'_>> = None;
        each_event(self, &line, &QueryLine::Segment(p, to), [None; 2], |event| {
            // Ignore records beyond the segment: the search there is incomplete.
            let is_between =
                line.order(LinePlace::At(p), event.place).is_le() && line.order(event.place, LinePlace::At(to)).is_le();
            if is_between && first.is_none_or(|first| line.order(event.place, first.place).is_lt()) {
                first = Some(event);
            }
        });
        let LineEvent { record, place } = first?;
        let is_here = line.order(LinePlace::At(p), place).is_eq();
        Some(match record {
            EventRecord::Vertex(v) if is_here => Located::Vertex(v.key()),
            EventRecord::Vertex(v) => match self.towards(v, p) {
                Towards::Along(h) => Located::Edge(self.rising(h).key()),
                Towards::Corner(h) => Located::Face(h.face().key()),
                Towards::Isolated => Located::Face(v.isolated()?.face().key()),
            },
            EventRecord::Edge(across) if is_here => Located::Edge(self.rising(across).key()),
            EventRecord::Edge(across) => Located::Face(across.twin().face().key()),
        })
    }

    /// Returns the half-edge of an edge that runs to the right, or straight up.
    fn rising<'a>(&self, h: HalfEdge<'a>) -> HalfEdge<'a> {
        let [a, b] = [h.origin(), h.target()].map(|v| self.point(v.index()));
        if compare_lexicographic(a, b).is_lt() { h } else { h.twin() }
    }
}
