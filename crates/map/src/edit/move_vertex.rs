//! Moving a vertex with its edges.

use super::at::At;
use super::error::EditError;
use crate::index::{TreeRecord, is_small};
use crate::planar_map::PlanarMap;
use twinedge::dcel::{Face, HalfEdge, Vertex, VertexKey};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::{Meeting, Orientation, meeting, on_segment, orientation};

impl PlanarMap {
    /// Moves a vertex, with the ends of its edges, in a straight line to another point. Only coordinates change.
    ///
    /// ```text
    ///        u                     u
    ///       ╱ ╲                   ╱   ╲          Each edge sweeps over the triangle between
    ///      ╱   ╲         ──►     ╱      ╲        the other end and the two positions.
    ///     v ─────── w           ╱   v ─── w
    /// ```
    ///
    /// Refused if the vertex would run into an edge or a vertex on its way, or one of its edges into a vertex. Otherwise the map
    /// is deformed while remaining plane, so rotations, faces and nesting are unchanged. (An edge can only be met at its ends or
    /// by the vertex.)
    ///
    /// O(sizes of the faces around the vertex), counted once per corner of the face there. For a large face, the cost is the
    /// number of edges in the box around the swept area, plus the cost of finding them in the index.
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
                    // The path may start inside a face at the vertex; there it first meets one of the two edges of the corner.
                    self.free_way(v, h.face(), to, &[h, h.counter_clockwise()])?;
                }
            }
        }
        self.put_at(vertex, to)
    }

    /// Checks that nothing on the boundary of a face is in the way of a vertex, and no vertex there in the way of its edges.
    fn free_way(&self, v: Vertex<'_>, face: Face<'_>, to: Point, edges: &[HalfEdge<'_>]) -> Result<(), EditError> {
        let from = self.at(v);
        let (half_edges, isolated) = self.around(face, edges.iter().map(|h| self.at(h.target())).chain([from, to]));
        let met = |w: &Vertex<'_>| {
            let p = self.at(*w);
            let swept = |h: &HalfEdge<'_>| h.target() != *w && in_triangle(p, [from, to, self.at(h.target())]);
            *w != v && (on_segment(p, from, to) || edges.iter().any(swept))
        };
        let vertices = half_edges.iter().flat_map(|h| [h.origin(), h.target()]);
        // The smallest index, since the tree yields vertices in any order.
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

    /// Returns the half-edges and isolated vertices on the boundary of a face. For a large face, returns all records that meet
    /// the box around some points: if a record of another face is in the way there, so is a record of this face.
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

/// Returns true if a point lies in a closed triangle, possibly flat.
pub(super) fn in_triangle(p: Point, [a, b, c]: [Point; 3]) -> bool {
    let turns = [orientation(a, b, p), orientation(b, c, p), orientation(c, a, p)];
    let turn = |t: Orientation| turns.contains(&t);
    match (turn(Orientation::CounterClockwise), turn(Orientation::Clockwise)) {
        (true, true) => false,
        (false, false) => on_segment(p, a, b) || on_segment(p, b, c) || on_segment(p, c, a),
        _ => true,
    }
}
