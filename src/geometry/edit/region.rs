//! The part of a map that a snapped segment may change.

use super::super::features::SetId;
use super::super::noding::{Noded, Snap, node};
use super::super::predicates::{Meeting, meeting, on_segment};
use super::super::{PlanarMap, Point};
use super::EditError;
use super::place::Place;
use crate::dcel::{Face, FaceKey, HalfEdgeKey, Vertex, VertexKey};
use rustc_hash::FxHashSet;

/// An edge of the region, before anything changes.
#[derive(Clone, Copy)]
pub(super) struct Edge {
    pub(super) half_edge: HalfEdgeKey,
    pub(super) ends: [VertexKey; 2],
    /// The features along it.
    pub(super) along: SetId,
    /// What covers the faces to its left and right.
    pub(super) covers: [SetId; 2],
    /// Whether these faces are in the region.
    pub(super) inside: [bool; 2],
}

/// Faces, and what bounds them.
#[derive(Default)]
pub(super) struct Region {
    faces: FxHashSet<FaceKey>,
    order: Vec<FaceKey>,
    pub(super) edges: Vec<Edge>,
    seen: FxHashSet<usize>,
    pub(super) isolated: Vec<VertexKey>,
}

impl Region {
    fn add(&mut self, face: Face<'_>) {
        if self.faces.insert(face.key()) {
            self.order.push(face.key());
        }
    }

    fn add_around(&mut self, v: Vertex<'_>) {
        v.rotation().for_each(|h| self.add(h.face()));
    }
}

impl PlanarMap {
    /// The faces that a segment passes, and those beside the edges that change when it is noded together with their
    /// boundaries; and the noded drawing, of the segment first and then of the edges in order.
    ///
    /// What lies beyond need not be looked at. Noding deforms a drawing without anything ever passing anything else
    /// ([`noding`](super::super::noding)), so what is deformed stays inside the unchanged edges around it, and the region
    /// grows until all edges on its border are unchanged.
    pub(super) fn region(&self, start: Place, [p, q]: [Point; 2], snap: Snap) -> Result<(Region, Noded), EditError> {
        let mut region = Region::default();
        match start {
            Place::Vertex(v) => match self.dcel.vertex(v)?.isolated() {
                Some(b) => region.add(b.face()),
                None => region.add_around(self.dcel.vertex(v)?),
            },
            Place::Edge(h) => {
                let h = self.dcel.half_edge(h)?;
                [h, h.twin()].into_iter().for_each(|h| region.add(h.face()));
            }
            Place::Face(f) => region.add(self.dcel.face(f)?),
        }
        let mut looked_at = 0;
        loop {
            while let Some(face) = region.order.get(looked_at).copied() {
                looked_at += 1;
                self.look_around(&mut region, self.dcel.face(face)?, [p, q]);
            }
            let noded = self.noded(&region, [p, q], snap)?;
            for i in 0..region.edges.len() {
                if noded.chain(i + 1).is_some_and(|chain| chain.len() > 2) {
                    let h = self.dcel.half_edge(region.edges[i].half_edge)?;
                    region.add(h.face());
                    region.add(h.twin().face());
                }
            }
            if looked_at == region.order.len() {
                for edge in &mut region.edges {
                    let h = self.dcel.half_edge(edge.half_edge)?;
                    edge.inside = [h, h.twin()].map(|h| region.faces.contains(&h.face().key()));
                }
                return Ok((region, noded));
            }
        }
    }

    /// Takes the boundary of a face into the region, and the faces that a segment enters across it.
    fn look_around(&self, region: &mut Region, face: Face<'_>, [p, q]: [Point; 2]) {
        for h in face.half_edges() {
            if !region.seen.insert(h.index() / 2) {
                continue;
            }
            let covers = [h, h.twin()].map(|h| self.features.of_face(h.face().index()));
            region.edges.push(Edge {
                half_edge: h.key(),
                ends: [h.origin().key(), h.target().key()],
                along: self.features.along(h.index()),
                covers,
                inside: [false; 2],
            });
            let [tail, head] = self.ends(h);
            if meeting(p, q, tail, head) != Meeting::Disjoint {
                region.add(h.face());
                region.add(h.twin().face());
                for v in [h.origin(), h.target()] {
                    if on_segment(self.at(v), p, q) {
                        region.add_around(v);
                    }
                }
            }
        }
        region.isolated.extend(face.inner().filter_map(|b| b.isolated_vertex()).map(|v| v.key()));
    }

    /// Nodes a segment together with a region, of which no vertex may move.
    fn noded(&self, region: &Region, way: [Point; 2], snap: Snap) -> Result<Noded, EditError> {
        let ends = |edge: &Edge| -> Result<[Point; 2], EditError> {
            Ok([self.position(edge.ends[0])?, self.position(edge.ends[1])?])
        };
        let mut segments = vec![way];
        for edge in &region.edges {
            segments.push(ends(edge)?);
        }
        let points = region.isolated.iter().map(|v| self.position(*v)).collect::<Result<Vec<Point>, _>>()?;
        let noded = node(&segments, &points, snap)?;
        let moved = |p: Point, number: Option<u32>| number.is_none_or(|n| noded.points[n as usize] != p);
        for ((edge, [from, to]), i) in region.edges.iter().zip(&segments[1..]).zip(1..) {
            let Some(chain) = noded.chain(i) else { continue };
            let (first, last) = (chain.clone().next(), chain.clone().next_back());
            if moved(*from, first) {
                return Err(EditError::NotOnGrid(edge.ends[0]));
            }
            if moved(*to, last) {
                return Err(EditError::NotOnGrid(edge.ends[1]));
            }
        }
        for ((v, p), i) in region.isolated.iter().zip(&points).zip(0..) {
            if moved(*p, noded.vertex_of_point(i)) {
                return Err(EditError::NotOnGrid(*v));
            }
        }
        Ok(noded)
    }
}
