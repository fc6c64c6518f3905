//! The zone of a line, using the index that a map keeps.

use super::follow::{ZoneStart, follow};
use super::line::{Line, LinePiece, LinePlace};
use super::selection::each_event;
use super::{QueryLine, ZoneElement};
use crate::Embedding;
use crate::locate::{LocateError, Located, check_range};
use crate::planar_map::PlanarMap;

impl PlanarMap {
    /// Returns the elements along a line, in order. A face is listed again each time the line enters it.
    ///
    /// The R-tree of the map's index yields the edges, so edges elsewhere cost nothing, even a thousand islands in the same face.
    /// If the query meets m boxes of the tree, and k edges and vertices, this takes O(m + k log k), plus O(degree) for each
    /// vertex. The first call builds the index in O(n log n). On maps, m is typically a few times the square root of the number
    /// of edges; but if boxes fit their edges badly, as with long slanted parallels, m may be as large as the map.
    ///
    /// ```
    /// use twinedge_geometry::Point;
    /// use twinedge_map::{PlanarMap, QueryLine, ZoneElement};
    ///
    /// let mut map = PlanarMap::new();
    /// let line = QueryLine::Segment(Point::new(-1.0, 1.0), Point::new(1.0, 1.0));
    /// map.insert_ring([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]])?;
    /// assert!(matches!(map.zone(&line)?[..], [ZoneElement::Face(_), ZoneElement::Edge(_), ZoneElement::Face(_)]));
    /// map.insert_point([0.0, 1.0])?;
    /// assert!(matches!(map.zone(&line)?[..], [ZoneElement::Face(_), ZoneElement::Vertex(_), ZoneElement::Face(_)]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`LocateError::OutOfRange`]; [`LocateError::NotPlane`]. [`LocateError::NoDirection`] if both points are equal; use
    /// [`locate`](Self::locate) then.
    pub fn zone(&self, query: &QueryLine) -> Result<Vec<ZoneElement>, LocateError> {
        self.plane()?;
        let (QueryLine::Segment(from, through) | QueryLine::Ray(from, through) | QueryLine::Line(from, through)) =
            *query;
        check_range(from)?;
        check_range(through)?;
        if from == through {
            return Err(LocateError::NoDirection(from));
        }
        let line = Line { from, through };
        let first = match query {
            QueryLine::Line(..) => None,
            QueryLine::Segment(..) | QueryLine::Ray(..) => Some(LinePlace::At(from)),
        };
        let to = if let QueryLine::Segment(..) = query { Some(through) } else { None };

        let mut events = Vec::new();
        each_event(self, &line, query, [None; 2], |event| {
            if first.is_none_or(|first| line.order(first, event.place).is_lt())
                && to.is_none_or(|to| line.order(event.place, LinePlace::At(to)).is_le())
            {
                events.push(event);
            }
        });
        events.sort_by(|a, b| line.order(a.place, b.place));
        events.dedup_by(|a, b| line.order(a.place, b.place).is_eq());

        let start = match first {
            None => ZoneStart::Piece(LinePiece::Face(self.dcel().unbounded_face()), None),
            Some(_) => begin(self, &line, self.locate(from)?)?,
        };
        let mut zone = Vec::with_capacity(2 * events.len() + 2);
        let mut events = events.into_iter();
        follow(self, &line, to, start, |_, _| events.next(), |element| zone.push(element))?;
        Ok(zone)
    }
}

/// Returns the event or piece in which a line begins.
fn begin<'m>(map: &'m PlanarMap, line: &Line, located: Located) -> Result<ZoneStart<'m>, LocateError> {
    let dcel = map.dcel();
    let at = LinePlace::At(line.from);
    Ok(match located {
        Located::Face(face) => ZoneStart::Piece(LinePiece::Face(dcel.face(face)?), Some(at)),
        Located::Vertex(vertex) => ZoneStart::Event(Line::at(map, dcel.vertex(vertex)?)),
        Located::Edge(half_edge) => {
            let h = dcel.half_edge(half_edge)?;
            let [origin, target] = [h.origin(), h.target()].map(|v| {
                let p = map.point(v.index());
                (p, line.side(p))
            });
            match Line::crossing(h, origin, target) {
                Some(event) => ZoneStart::Event(event),
                None if line.order(at, LinePlace::At(target.0)).is_lt() => {
                    ZoneStart::Piece(LinePiece::Along(h), Some(at))
                }
                None => ZoneStart::Piece(LinePiece::Along(h.twin()), Some(at)),
            }
        }
    })
}
