//! Moving a vertex with its edges.

use super::at::At;
use super::error::EditError;
use crate::dcel::{Face, HalfEdge, Vertex, VertexKey};
use crate::geometry::Point;
use crate::geometry::predicates::{Meeting, Orientation, meeting, on_segment, orientation};
use crate::map::planar_map::PlanarMap;

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
    /// O(sizes of the faces around the vertex), each counted as often as it has a corner there.
    ///
    /// ```
    /// use twinedge::geometry::Point;
    /// use twinedge::map::PlanarMap;
    /// use twinedge::map::edit::EditError;
    ///
    /// let mut map = PlanarMap::new();
    /// let ring = map.insert_ring([[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]])?;
    /// let stone = map.insert_point([1.0, 1.0])?.vertices[0];
    /// let [corner, ..] = ring.vertices[..] else { unreachable!("a ring has vertices") };
    /// assert_eq!(map.move_vertex(corner, [2.0, 1.5]), Err(EditError::VertexInTheWay(stone)));
    /// map.move_vertex(corner, [0.5, 0.5])?;
    /// assert_eq!(map.position(corner)?, Point::new(0.5, 0.5));
    /// assert!(map.validate().is_valid());
    /// # Ok::<(), twinedge::map::edit::EditError>(())
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
                    // What is met first is met from within a face at the vertex, by one of the two edges beside the corner.
                    self.free_way(v, h.face(), to, &[h, h.counter_clockwise()])?;
                }
            }
        }
        let index = v.index();
        self.points[index] = to;
        Ok(())
    }

    /// Checks that nothing on the boundary of a face is in the way of a vertex, nor any vertex there in the way of some of
    /// its edges.
    fn free_way(&self, v: Vertex<'_>, face: Face<'_>, to: Point, edges: &[HalfEdge<'_>]) -> Result<(), EditError> {
        let from = self.at(v);
        let met = |w: Vertex<'_>| {
            let p = self.at(w);
            let swept = |h: &HalfEdge<'_>| h.target() != w && in_triangle(p, [from, to, self.at(h.target())]);
            w != v && (on_segment(p, from, to) || edges.iter().any(swept))
        };
        let vertices = face.half_edges().map(|h| h.origin());
        let isolated = face.inner().filter_map(|b| b.isolated_vertex());
        if let Some(w) = vertices.chain(isolated).find(|w| met(*w)) {
            return Err(EditError::VertexInTheWay(w.key()));
        }
        let met = |h: &HalfEdge<'_>| {
            let [tail, head] = self.ends(*h);
            h.origin() != v && h.target() != v && meeting(from, to, tail, head) != Meeting::Disjoint
        };
        match face.half_edges().find(met) {
            Some(h) => Err(EditError::EdgeInTheWay(h.key())),
            None => Ok(()),
        }
    }
}

/// Whether a point lies in a closed triangle, which may be flat.
fn in_triangle(p: Point, [a, b, c]: [Point; 3]) -> bool {
    let turns = [orientation(a, b, p), orientation(b, c, p), orientation(c, a, p)];
    let turn = |t: Orientation| turns.contains(&t);
    match (turn(Orientation::CounterClockwise), turn(Orientation::Clockwise)) {
        (true, true) => false,
        (false, false) => on_segment(p, a, b) || on_segment(p, b, c) || on_segment(p, c, a),
        _ => true,
    }
}
