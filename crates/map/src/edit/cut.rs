//! Cutting a face by a line, merging two faces, and joining the edges at a superfluous vertex.

use super::at::At;
use super::error::EditError;
use super::move_vertex::in_triangle;
use super::outcome::Edited;
use crate::not_plane::NotPlane;
use crate::planar_map::PlanarMap;
use crate::zone::{QueryLine, ZoneElement};
use twinedge::dcel::{FaceKey, HalfEdge, HalfEdgeKey, OperatorError, Vertex, VertexKey};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::{Meeting, Orientation, meeting, on_segment, orientation};

impl PlanarMap {
    /// Splits a face along the line through two points, wherever the line passes through the face.
    ///
    /// ```text
    ///   ·──────────·               ·────·─────·
    ///   │          │               │     ╲    │        The points at which the line crosses edges are rounded, and
    ///   │          │      ──►      │      ╲   │        the edges are bent there: they end at the new vertices,
    ///   │          │               │       ╲  │        whatever the slant of the line.
    ///   ·──────────·               ·────────·─·
    /// ```
    ///
    /// The points may lie outside the face. Rarely is a double exactly on the crossing of a line and an edge:
    /// [`insert_segment`](Self::insert_segment) with a rounded end leaves a gap or crosses the edge. This method splits the edge
    /// at the rounded point, as if a vertex on it [moved](Self::move_vertex) there. No other record may change sides; otherwise
    /// the edit is refused.
    ///
    /// [`Edited::vertices`] contains the two ends of each stretch of the line in the face, in the direction of the line.
    ///
    /// The cost of a [`zone`](Self::zone) of the whole line, and of [`insert_segment`](Self::insert_segment) for each stretch.
    ///
    /// ```
    /// use twinedge_map::PlanarMap;
    ///
    /// let mut map = PlanarMap::new();
    /// let parcel = map.insert_ring([[0.0, 0.0], [4.0, 0.0], [3.0, 4.0], [0.5, 3.0]])?.faces_split[0].1;
    /// let cut = map.split_face(parcel, [0.1, 0.2], [0.3, 0.7])?;
    /// assert_eq!((cut.faces_split.len(), cut.vertices.len(), map.dcel().face_count()), (1, 2, 3));
    /// assert!(map.validate().is_valid());
    /// # Ok::<(), twinedge_map::edit::EditError>(())
    /// ```
    ///
    /// # Errors
    /// [`EditError::NotThrough`]; [`EditError::NoLength`]; [`EditError::NotPlane`]; [`EditError::NotFinite`];
    /// [`EditError::OutOfRange`]; [`EditError::VertexInTheWay`], [`EditError::EdgeInTheWay`] or [`EditError::Crosses`] near a
    /// rounded line or crossing; [`EditError::Operator`] for a stale key, a full map or a refusing policy.
    pub fn split_face(
        &mut self,
        face: FaceKey,
        from: impl Into<Point>,
        through: impl Into<Point>,
    ) -> Result<Edited, EditError> {
        self.editable()?;
        self.dcel.face(face)?;
        let line = [self.point_of(At::Point(from.into()))?, self.point_of(At::Point(through.into()))?];
        let [Point { x, y }, through] = line;
        if line[0] == through {
            return Err(EditError::NoLength { x, y });
        }
        let zone = self.zone(&QueryLine::Line(line[0], through)).map_err(|_| NotPlane::default())?;
        let inside = zone.windows(3).filter(|part| part[1] == ZoneElement::Face(face));
        let stretches: Vec<_> = inside.map(|part| [part[0], part[2]]).collect();
        if stretches.is_empty() {
            return Err(EditError::NotThrough(face));
        }
        self.rewinding(|map| {
            let mut edited = Edited::default();
            // An edge may end one stretch and begin the next.
            let mut last = None;
            for element in stretches.into_iter().flatten() {
                let vertex = match (element, last) {
                    (element, Some((before, vertex))) if element == before => vertex,
                    (ZoneElement::Edge(h), _) => map.cut_edge(h, line, &mut edited)?,
                    (ZoneElement::Vertex(v), _) => v,
                    (ZoneElement::Face(_) | ZoneElement::Along(_), _) => continue,
                };
                last = Some((element, vertex));
                edited.vertices.push(vertex);
            }
            for pair in edited.vertices.clone().chunks_exact(2) {
                // Both ends of a short edge may round to one vertex.
                if pair[0] != pair[1] {
                    let drawn = map.draw(&[At::Vertex(pair[0]), At::Vertex(pair[1])], false)?;
                    edited.way.extend(drawn.way);
                    edited.edges_made.extend(drawn.edges_made);
                    edited.faces_split.extend(drawn.faces_split);
                }
            }
            Ok(edited)
        })
    }

    /// Puts a vertex where a line crosses an edge, as exactly as doubles allow.
    fn cut_edge(&mut self, h: HalfEdgeKey, line: [Point; 2], edited: &mut Edited) -> Result<VertexKey, EditError> {
        let edge = self.dcel.half_edge(h)?;
        let ends = self.ends(edge);
        let p = self.point_of(At::Point(crossing(line, ends)))?;
        let beyond = orientation(ends[0], ends[1], p) == Orientation::Collinear && !on_segment(p, ends[0], ends[1]);
        let distance = |q: Point| (q.x - p.x).hypot(q.y - p.y);
        if ends.contains(&p) || beyond {
            let nearest = if distance(ends[0]) <= distance(ends[1]) { edge.origin() } else { edge.target() };
            return Ok(nearest.key());
        }
        self.sweep(&[edge], [ends[0], p, ends[1]], &[[ends[0], p], [p, ends[1]]])?;
        self.split(h, p, edited)
    }

    /// Merges two faces: removes every edge between them, and vertices without other edges. Keeps the first face unless the other
    /// surrounds it or is unbounded. The merged face is covered by the features that covered both ([why](super#features)).
    ///
    /// [`Edited::vertices`] has the surviving ends of removed edges; [`join_edges`](Self::join_edges) drops superfluous ones.
    ///
    /// The cost of removing each of the edges, plus O(boundary of the first face).
    ///
    /// ```
    /// use twinedge_map::PlanarMap;
    ///
    /// let mut map = PlanarMap::new();
    /// let parcel = map.insert_ring([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]])?.faces_split[0].1;
    /// let cut = map.split_face(parcel, [0.1, 0.0], [0.3, 4.0])?;
    /// let (kept, made) = cut.faces_split[0];
    /// let merged = map.merge_faces(kept, made)?;
    /// for end in merged.vertices {
    ///     map.join_edges(end)?;
    /// }
    /// assert_eq!((map.dcel().face_count(), map.dcel().vertex_count()), (2, 4));
    /// # Ok::<(), twinedge_map::edit::EditError>(())
    /// ```
    ///
    /// # Errors
    /// [`EditError::NoEdgeBetween`]; and as for [`remove_edge`](Self::remove_edge).
    pub fn merge_faces(&mut self, kept: FaceKey, dropped: FaceKey) -> Result<Edited, EditError> {
        self.editable()?;
        self.dcel.face(dropped)?;
        let between = |h: &HalfEdge<'_>| kept != dropped && h.twin().face().key() == dropped;
        let edges: Vec<HalfEdge<'_>> = self.dcel.face(kept)?.half_edges().filter(between).collect();
        if edges.is_empty() {
            return Err(EditError::NoEdgeBetween(kept, dropped));
        }
        let mut ends: Vec<VertexKey> = edges.iter().flat_map(|h| [h.origin().key(), h.target().key()]).collect();
        let edges: Vec<HalfEdgeKey> = edges.into_iter().map(HalfEdge::key).collect();
        ends.sort_unstable();
        ends.dedup();
        self.rewinding(|map| {
            let mut edited = Edited::default();
            for h in edges {
                map.erase(h, &mut edited)?;
            }
            for v in ends {
                if map.dcel.vertex(v)?.isolated().is_some() {
                    map.remove_isolated(v)?;
                    edited.vertices_dropped.push(v);
                } else {
                    edited.vertices.push(v);
                }
            }
            Ok(edited)
        })
    }

    /// Joins the two edges at a vertex to one straight edge and drops the vertex. If they are not collinear, this moves a border.
    ///
    /// The joined edge has the features that run along both. It reuses the edge with the smaller indices, and [`Edited::way`]
    /// contains one of its half-edges. The other edge and the vertex are [dropped](Edited::edges_dropped).
    ///
    /// O(sizes of the two faces); for larger faces, the cost of finding nearby records in the index.
    ///
    /// ```
    /// use twinedge_map::PlanarMap;
    ///
    /// let mut map = PlanarMap::new();
    /// let wall = map.insert_segment([0.0, 0.0], [4.0, 0.0])?.way[0];
    /// let post = map.insert_point([1.0, 0.0])?.vertices[0];
    /// let joined = map.join_edges(post)?;
    /// assert_eq!((joined.way.len(), joined.vertices_dropped, map.dcel().edge_count()), (1, vec![post], 1));
    /// # let _ = wall;
    /// # Ok::<(), twinedge_map::edit::EditError>(())
    /// ```
    ///
    /// # Errors
    /// [`OperatorError::DegreeNotTwo`] if the vertex doesn't have exactly two edges; [`OperatorError::Loop`] if both edges join
    /// the same vertices; [`EditError::VertexInTheWay`], [`EditError::EdgeInTheWay`] if the joined edge would sweep over
    /// something; [`EditError::NotPlane`]; [`EditError::Operator`] for a stale key or a refusing policy.
    pub fn join_edges(&mut self, vertex: VertexKey) -> Result<Edited, EditError> {
        self.editable()?;
        let v = self.dcel.vertex(vertex)?;
        let leaving: Vec<HalfEdge<'_>> = v.rotation().take(3).collect();
        let [one, other] = leaving[..] else {
            // Any half-edge that leaves the vertex, or null.
            return Err(
                OperatorError::DegreeNotTwo(leaving.first().map_or_else(HalfEdgeKey::default, |h| h.key())).into()
            );
        };
        // The kept edge is usually the older one.
        let (back, ahead) = if one.index() < other.index() { (one, other) } else { (other, one) };
        let (from, to) = (back.target(), ahead.target());
        if from == to || from == v {
            return Err(OperatorError::Loop(back.key()).into());
        }
        let [a, p, b] = [from, v, to].map(|v| self.at(v));
        self.sweep(&[back, ahead], [a, p, b], &[[a, b]])?;
        let sets = [back, ahead].map(|h| self.features.along(h.index()));
        let h = back.twin().key();
        let joined = self.join_at(h, ahead.key())?;
        let common = self.features.common(sets[0], sets[1]);
        self.cover_edge(self.dcel.half_edge(h)?.index(), common);
        Ok(Edited { way: vec![h], vertices_dropped: vec![vertex], edges_dropped: vec![joined], ..Edited::default() })
    }

    /// Checks that nothing else lies in the triangle swept when edges turn into these segments.
    fn sweep(&self, edges: &[HalfEdge<'_>], triangle: [Point; 3], to: &[[Point; 2]]) -> Result<(), EditError> {
        let own = |h: &HalfEdge<'_>| edges.iter().any(|edge| edge.index() / 2 == h.index() / 2);
        for face in [edges[0].face(), edges[0].twin().face()] {
            let (half_edges, isolated) = self.around(face, triangle.into_iter());
            let vertices = half_edges.iter().flat_map(ends).chain(isolated);
            let is_end = |v: &Vertex<'_>| edges.iter().flat_map(ends).any(|end| end == *v);
            let met = |v: &Vertex<'_>| !is_end(v) && in_triangle(self.at(*v), triangle);
            if let Some(v) = vertices.filter(met).min_by_key(|v| v.index()) {
                return Err(EditError::VertexInTheWay(v.key()));
            }
            let met = |h: &HalfEdge<'_>| {
                let [tail, head] = self.ends(*h);
                let meets = |[a, b]: &[Point; 2]| {
                    !matches!(meeting(*a, *b, tail, head), Meeting::Disjoint | Meeting::SharedEndpoint)
                };
                !own(h) && to.iter().any(meets)
            };
            if let Some(h) = half_edges.into_iter().filter(met).min_by_key(|h| h.index()) {
                return Err(EditError::EdgeInTheWay(h.key()));
            }
        }
        Ok(())
    }
}

fn ends<'a>(h: &HalfEdge<'a>) -> [Vertex<'a>; 2] {
    [h.origin(), h.target()]
}

/// Returns the point where a line crosses a segment, rounded.
fn crossing([from, through]: [Point; 2], [tail, head]: [Point; 2]) -> Point {
    let (d, e) = ([through.x - from.x, through.y - from.y], [head.x - tail.x, head.y - tail.y]);
    let part = ((from.x - tail.x) * d[1] - (from.y - tail.y) * d[0]) / (e[0] * d[1] - e[1] * d[0]);
    let part = if part.is_finite() { part.clamp(0.0, 1.0) } else { 0.5 };
    // Measured from the nearer end; exact on an axis-parallel line.
    let along = |tail: f64, head: f64, e: f64| if part <= 0.5 { tail + part * e } else { head - (1.0 - part) * e };
    let x = if d[0] == 0.0 { from.x } else { along(tail.x, head.x, e[0]) };
    let y = if d[1] == 0.0 { from.y } else { along(tail.y, head.y, e[1]) };
    Point::new(x, y)
}
