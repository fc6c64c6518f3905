//! What a line meets: the faces, edges and vertices of its zone, in order.
//!
//! ```text
//!        ____________
//!       |      b     |           from a to d, the segment meets
//!   a---|------o-----|---c===d   face, edge, face, vertex, face, edge, face, vertex, along an edge, vertex
//!       |____________|
//! ```
//!
//! | | needs | time |
//! | --- | --- | --- |
//! | [`Locator::zone`] | the index | what an R-tree takes to find the edges, and O(k log k) to sort the k that are met |
//! | [`PlanarMap::zone_from`] | nothing | the boundaries of the faces met |
//!
//! Both are exact, through vertices and along edges too: no intersection is ever computed, nor is there a tolerance.

mod boxes;
mod line;
mod walk;

pub(super) use boxes::Boxes;

use super::locate::check;
use super::{LocateError, Located, Locator, PlanarMap};
use crate::dcel::{FaceKey, HalfEdgeKey, VertexKey};
use crate::geometry::Point;
use crate::validate::Embedding;
use line::{Event, Line, Piece, Place, What};

/// A straight way through the plane, with a direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum QueryLine {
    /// From the first point to the second, both included.
    Segment(Point, Point),
    /// From the first point, included, through the second and on for ever.
    Ray(Point, Point),
    /// Through both points, in the direction from the first to the second, without beginning or end.
    Line(Point, Point),
}

/// Something that a stretch meets.
///
/// A face or the course along an edge is always followed by an edge or a vertex, and an edge or a vertex by a face or the
/// course along an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum ZoneElement {
    /// It goes through this face.
    Face(FaceKey),
    /// It crosses the edge of this half-edge, or begins or ends inside it, not along it. The half-edge comes from the
    /// left of the stretch: its face is ahead, that of its twin behind.
    Edge(HalfEdgeKey),
    /// It goes along the edge of this half-edge, or a part of it. The half-edge has the direction of the stretch.
    Along(HalfEdgeKey),
    /// It meets this vertex.
    Vertex(VertexKey),
}

impl Locator<'_> {
    /// What a stretch meets, in order. A face is listed again whenever it is entered again.
    ///
    /// The edges that it meets come from an R-tree, so what stands elsewhere costs nothing, were it a thousand islands in
    /// the same face. For m boxes of the tree that the stretch meets, and k edges and vertices that it meets, this takes
    /// O(m + k log k), and O(degree) for each vertex. On maps, m is a few times the square root of the number of edges;
    /// but where boxes hardly fit their edges, as with long slanted parallels, m may be as large as the map.
    ///
    /// # Errors
    /// [`LocateError::OutOfRange`]. [`LocateError::NoDirection`], if both points are the same; what is there,
    /// [`Locator::locate`] says.
    ///
    /// ```
    /// use twinedge::geometry::Point;
    /// use twinedge::map::{Builder, Locator, ZoneElement, Shape, QueryLine};
    ///
    /// let mut builder = Builder::new();
    /// let square = [[1.0, 0.0], [5.0, 0.0], [5.0, 4.0], [1.0, 4.0]].map(Point::from).to_vec();
    /// builder.shape(&Shape::Polygon(vec![square]))?;
    /// builder.shape(&Shape::Point(Point::new(3.0, 2.0)))?;
    /// let map = builder.build()?;
    ///
    /// let met = Locator::new(&map)?.zone(&QueryLine::Segment(Point::new(0.0, 2.0), Point::new(5.0, 2.0)))?;
    /// assert!(matches!(
    ///     met[..],
    ///     [ZoneElement::Face(sea), ZoneElement::Edge(coast), ZoneElement::Face(land), ZoneElement::Vertex(_), ZoneElement::Face(still_land), ZoneElement::Edge(_)]
    ///         if land == still_land && map.dcel().face(sea)?.is_unbounded() && map.dcel().half_edge(coast)?.face().key() == land
    /// ));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn zone(&self, stretch: &QueryLine) -> Result<Vec<ZoneElement>, LocateError> {
        let (QueryLine::Segment(from, through) | QueryLine::Ray(from, through) | QueryLine::Line(from, through)) =
            *stretch;
        check(from)?;
        check(through)?;
        if from == through {
            return Err(LocateError::NoDirection(from));
        }
        let line = Line { from, through };
        let first = match stretch {
            QueryLine::Line(..) => None,
            QueryLine::Segment(..) | QueryLine::Ray(..) => Some(Place::At(from)),
        };
        let to = if let QueryLine::Segment(..) = stretch { Some(through) } else { None };

        let mut events = Vec::new();
        self.boxes.each_event(self.map, &line, stretch, |event| {
            if first.is_none_or(|first| line.order(first, event.place).is_lt())
                && to.is_none_or(|to| line.order(event.place, Place::At(to)).is_le())
            {
                events.push(event);
            }
        });
        events.sort_unstable_by(|a, b| line.order(a.place, b.place));
        events.dedup_by(|a, b| line.order(a.place, b.place).is_eq());

        let begin = match first {
            None => Begin::Piece(Piece::Face(self.map.dcel().unbounded_face()), None),
            Some(_) => self.begin(&line)?,
        };
        let mut met = Vec::with_capacity(2 * events.len() + 2);
        let mut events = events.into_iter();
        follow(self.map, &line, to, begin, |_, _| events.next(), |what| met.push(what))?;
        Ok(met)
    }

    /// What there is where a line begins.
    fn begin(&self, line: &Line) -> Result<Begin<'_>, LocateError> {
        let dcel = self.map.dcel();
        let at = Place::At(line.from);
        Ok(match self.locate(line.from)? {
            Located::Face(face) => Begin::Piece(Piece::Face(dcel.face(face)?), Some(at)),
            Located::Vertex(vertex) => Begin::Event(Line::at(self.map, dcel.vertex(vertex)?)),
            Located::Edge(half_edge) => {
                let h = dcel.half_edge(half_edge)?;
                let [origin, target] = [h.origin(), h.target()].map(|v| {
                    let p = self.map.point(v.index());
                    (p, line.side(p))
                });
                match Line::crossing(h, origin, target) {
                    Some(event) => Begin::Event(event),
                    None if line.order(at, Place::At(target.0)).is_lt() => Begin::Piece(Piece::Along(h), Some(at)),
                    None => Begin::Piece(Piece::Along(h.twin()), Some(at)),
                }
            }
        })
    }
}

/// How a zone begins: with something met in a point, or in the middle of a piece, at a place unless it is infinitely far.
#[derive(Clone, Copy)]
enum Begin<'m> {
    Event(Event<'m>),
    Piece(Piece<'m>, Option<Place>),
}

/// Lists what a line meets up to a point, if there is an end. `next` gives what comes after a place, in a piece.
fn follow<'m>(
    map: &'m PlanarMap,
    line: &Line,
    to: Option<Point>,
    begin: Begin<'m>,
    mut next: impl FnMut(Piece<'m>, Option<Place>) -> Option<Event<'m>>,
    mut visit: impl FnMut(ZoneElement),
) -> Result<(), LocateError> {
    let (mut event, mut piece, mut at) = match begin {
        Begin::Event(event) => (Some(event), None, None),
        Begin::Piece(piece, at) => (None, Some(piece), at),
    };
    // A line meets nothing twice but faces.
    let mut left = map.dcel().vertex_count() + map.dcel().edge_count();
    loop {
        if let Some(event) = event {
            visit(match event.what {
                What::Vertex(vertex) => ZoneElement::Vertex(vertex.key()),
                What::Edge(h) => ZoneElement::Edge(h.key()),
            });
            if to.is_some_and(|to| line.order(event.place, Place::At(to)).is_ge()) {
                return Ok(());
            }
            left = left.checked_sub(1).ok_or(LocateError::NotPlane)?;
            at = Some(event.place);
            piece = Some(line.after(map, event));
        }
        let Some(through) = piece else { return Ok(()) };
        visit(match through {
            Piece::Face(face) => ZoneElement::Face(face.key()),
            Piece::Along(h) => ZoneElement::Along(h.key()),
        });
        event = next(through, at);
        let fits = match (through, event.map(|event| event.what)) {
            (_, None) | (Piece::Face(_), Some(What::Vertex(_))) => true,
            (Piece::Face(face), Some(What::Edge(h))) => h.twin().face() == face,
            (Piece::Along(h), Some(What::Vertex(vertex))) => h.target() == vertex,
            (Piece::Along(_), Some(What::Edge(_))) => false,
        };
        if !fits {
            return Err(LocateError::NotPlane);
        }
        if event.is_none() {
            return Ok(());
        }
    }
}
