//! The steps of drawing: a vertex where there is none, an edge between two vertices. What is drawn is known to cross nothing.

use super::error::EditError;
use super::outcome::Edited;
use super::trace::Towards;
use crate::feature_tries::SetId;
use crate::locate::Located;
use crate::not_plane::NotPlane;
use crate::planar_map::PlanarMap;
use twinedge::dcel::{Corner, FaceKey, HalfEdge, HalfEdgeKey, Room, Split, VertexKey};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::on_segment;

impl PlanarMap {
    /// Checks that there is room to draw straight edges through `vertices` vertices, new or existing.
    pub(super) fn room_for_drawing(&self, vertices: usize) -> Result<(), EditError> {
        // A plane drawing has fewer than 3 edges per vertex, and a vertex may split one edge.
        let edges = vertices.saturating_mul(4);
        Ok(self.dcel.room_for(Room { vertices, edges, boundaries: edges, faces: edges })?)
    }

    /// Makes a vertex at a point unless there is one.
    pub(super) fn realise(&mut self, p: Point, place: Located, edited: &mut Edited) -> Result<VertexKey, EditError> {
        match place {
            Located::Vertex(v) => Ok(v),
            Located::Face(face) => self.make_isolated(p, face, edited),
            Located::Edge(h) => {
                // The edge may have been split since the place was found. Its parts follow each other, in one direction or,
                // if it was split as the edge of the twin, in the other.
                let on = |part: &HalfEdge<'_>| on_segment(p, self.at(part.origin()), self.at(part.target()));
                let cycle = self.dcel.half_edge(h)?.boundary_cycle();
                let both_ways = cycle.clone().zip(cycle.rev()).flat_map(|(ahead, behind)| [ahead, behind]);
                // A plane map has one.
                let part = { both_ways }.find(on).ok_or(NotPlane::default())?;
                if let Some(end) = [part.origin(), part.target()].into_iter().find(|v| self.at(*v) == p) {
                    return Ok(end.key());
                }
                let part = part.key();
                self.split(part, p, edited)
            }
        }
    }

    pub(super) fn make_isolated(
        &mut self,
        p: Point,
        face: FaceKey,
        edited: &mut Edited,
    ) -> Result<VertexKey, EditError> {
        let v = self.add_isolated(p, face)?;
        edited.vertices_made.push(v);
        Ok(v)
    }

    /// Puts a new vertex on an edge.
    pub(super) fn split(&mut self, h: HalfEdgeKey, p: Point, edited: &mut Edited) -> Result<VertexKey, EditError> {
        let made = self.split_at(h, p)?;
        let set = self.features.along(self.dcel.half_edge(h)?.index());
        self.cover_edge(self.dcel.half_edge(made.half_edge)?.index(), set);
        edited.vertices_made.push(made.vertex);
        edited.edges_split.push((h, made.half_edge));
        Ok(made.vertex)
    }

    /// The half-edge from one vertex to another, with nothing between them, save an edge perhaps; it is made unless it is there.
    ///
    /// O(degrees + length of the shorter cycle, and what [`sides`](Self::sides) takes).
    pub(super) fn join(
        &mut self,
        from: VertexKey,
        to: VertexKey,
        edited: &mut Edited,
    ) -> Result<HalfEdgeKey, EditError> {
        let (v, w) = (self.dcel.vertex(from)?, self.dcel.vertex(to)?);
        let (at_v, at_w) = match (self.towards(v, self.at(w)), self.towards(w, self.at(v))) {
            (Towards::Along(h), _) => return Ok(h.key()),
            (_, Towards::Along(h)) => return Ok(h.twin().key()),
            (at_v, at_w) => (at_v.corner(), at_w.corner()),
        };
        let mut inner = Vec::new();
        let mut split = Split::default();
        let mut set = SetId::default();
        match (at_v, at_w) {
            (Some(a), Some(b)) if a.boundary() == b.boundary() => (split.new_face, inner) = self.sides(a, b)?,
            _ => {}
        }
        let face = at_v.map(|h| h.face().key());
        if let Some(h) = at_v {
            set = self.features.of_face(h.face().index());
        }
        let corner = |at: Option<HalfEdge<'_>>, v: VertexKey| at.map_or(Corner::Isolated(v), |h| Corner::At(h.key()));
        let (at_v, at_w) = (corner(at_v, from), corner(at_w, to));
        split.inner = &inner;
        let connected = self.connect(at_v, at_w, split)?;
        // The slot may have belonged to another edge or face.
        let half_edge = connected.half_edge;
        self.cover_edge(self.dcel.half_edge(half_edge)?.index(), SetId::default());
        edited.edges_made.push(half_edge);
        if let (Some(kept), Some(made)) = (face, connected.new_face()) {
            self.cover_face(self.dcel.face(made)?.index(), set);
            edited.faces_split.push((kept, made));
        }
        Ok(half_edge)
    }
}
