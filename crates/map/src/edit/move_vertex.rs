//! Moving a vertex with its edges.

use super::at::At;
use super::error::EditError;
use crate::index::{TreeRecord, is_small};
use crate::planar_map::PlanarMap;
use twinedge::dcel::{Face, HalfEdge, Vertex, VertexKey};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::{Meeting, Orientation, meeting, on_segment, orientation};

impl PlanarMap {
    /// Moves a vertex, and with it the ends of its edges, straight to another point. Nothing changes but coordinates.
    ///
    /// ```text
    ///        u                     u
    ///       ╱ ╲                   ╱   ╲          Each edge sweeps over the triangle between
    ///      ╱   ╲         ──►     ╱      ╲        the other end and the two positions.
    ///     v ─────── w           ╱   v ─── w
    /// ```
    ///
    /// Refused if the vertex would run into an edge or a vertex on its way, or one of its edges into a vertex. Where nothing
    /// is met, the map is deformed without ever ceasing to be plane, so the rotations, the faces and what lies in them are
    /// what they were. (An edge that is met without its ends being met, is met by the vertex.)
    ///
    /// O(sizes of the faces around the vertex), each counted as often as it has a corner there; where one is not small, the edges
    /// in the box around what is swept over, and what the index takes to find them.
    ///
    /// ```
    /// use twinedge_geometry::Point;
    /// use twinedge_map::PlanarMap;
    /// use twinedge_map::edit::EditError;
    ///
    /// let mut map = PlanarMap::new();
    /// let ring = map.insert_ring([[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]])?;
    /// let stone = map.insert_point([1.0, 1.0])?.vertices[0];
    /// let [corner, ..] = ring.vertices[..] else { unreachable!("a ring has vertices") };
    /// assert_eq!(map.move_vertex(corner, [2.0, 1.5]), Err(EditError::VertexInTheWay(stone)));
    /// map.move_vertex(corner, [0.5, 0.5])?;
    /// assert_eq!(map.position(corner)?, Point::new(0.5, 0.5));
    /// assert!(map.validate().is_valid());
    /// # Ok::<(), twinedge_map::edit::EditError>(())
    /// ```
    ///
    /// # Errors
    /// [`EditError::NotPlane`]; [`EditError::NotFinite`]; [`EditError::OutOfRange`]; [`EditError::VertexInTheWay`];
    /// [`EditError::EdgeInTheWay`]; [`EditError::Operator`] for a stale key.
    pub fn move_vertex(&mut self, vertex: VertexKey, to: impl Into<Point>) -> Result<(), EditError> {
        self.editable()?;
        let v = self.dcel.vertex(vertex)?;
        let to = self.point_of(At::Point(to.into()))?;
        match v.isolated() {
            Some(b) => self.free_way(v, b.face(), to, &[])?,
            None => {
                for h in v.rotation() {
                    // The way may start in a face at the vertex, and there it meets first one of the two edges beside the corner.
                    self.free_way(v, h.face(), to, &[h, h.counter_clockwise()])?;
                }
            }
        }
        self.put_at(vertex, to)
    }

    /// Checks that nothing on the boundary of a face is in the way of a vertex, nor any vertex there in the way of some of
    /// its edges.
    fn free_way(&self, v: Vertex<'_>, face: Face<'_>, to: Point, edges: &[HalfEdge<'_>]) -> Result<(), EditError> {
        let from = self.at(v);
        let (half_edges, isolated) = self.around(face, edges.iter().map(|h| self.at(h.target())).chain([from, to]));
        let met = |w: &Vertex<'_>| {
            let p = self.at(*w);
            let swept = |h: &HalfEdge<'_>| h.target() != *w && in_triangle(p, [from, to, self.at(h.target())]);
            *w != v && (on_segment(p, from, to) || edges.iter().any(swept))
        };
        let vertices = half_edges.iter().flat_map(|h| [h.origin(), h.target()]);
        // Of all that is, the one with the smallest index, as the index finds them in any order.
        if let Some(w) = vertices.chain(isolated).filter(met).min_by_key(|w| w.index()) {
            return Err(EditError::VertexInTheWay(w.key()));
        }
        let met = |h: &HalfEdge<'_>| {
            let [tail, head] = self.ends(*h);
            h.origin() != v && h.target() != v && meeting(from, to, tail, head) != Meeting::Disjoint
        };
        match half_edges.into_iter().filter(met).min_by_key(|h| h.index()) {
            Some(h) => Err(EditError::EdgeInTheWay(h.key())),
            None => Ok(()),
        }
    }

    /// The half-edges and isolated vertices on the boundary of a face; where this is not small, all of the map instead that
    /// have a place in the box around some points. Whatever lies in the way there, something of the face is in the way, too.
    pub(super) fn around<'a>(
        &'a self,
        face: Face<'a>,
        points: impl Iterator<Item = Point>,
    ) -> (Vec<HalfEdge<'a>>, Vec<Vertex<'a>>) {
        if is_small(face) {
            return (face.half_edges().collect(), face.inner().filter_map(|b| b.isolated_vertex()).collect());
        }
        let infinite = Point::new(f64::INFINITY, f64::INFINITY);
        let (low, high) = points.fold((infinite, Point::new(-infinite.x, -infinite.y)), |(low, high), p| {
            (Point::new(low.x.min(p.x), low.y.min(p.y)), Point::new(high.x.max(p.x), high.y.max(p.y)))
        });
        let (mut half_edges, mut isolated) = (Vec::new(), Vec::new());
        for boxed in self.index().in_box(low, high) {
            match boxed.record {
                TreeRecord::Edge(h) => half_edges.extend(self.dcel.half_edge_at(h as usize)),
                TreeRecord::Vertex(v) => isolated.extend(self.dcel.vertex_at(v as usize)),
            }
        }
        (half_edges, isolated)
    }
}

/// Returns true if a point lies in a closed triangle, which may be flat.
pub(super) fn in_triangle(p: Point, [a, b, c]: [Point; 3]) -> bool {
    let turns = [orientation(a, b, p), orientation(b, c, p), orientation(c, a, p)];
    let turn = |t: Orientation| turns.contains(&t);
    match (turn(Orientation::CounterClockwise), turn(Orientation::Clockwise)) {
        (true, true) => false,
        (false, false) => on_segment(p, a, b) || on_segment(p, b, c) || on_segment(p, c, a),
        _ => true,
    }
}
