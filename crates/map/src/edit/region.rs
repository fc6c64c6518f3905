//! The part of a map that a snapped segment may change.

use super::error::EditError;
use crate::feature_tries::SetId;
use crate::locate::Located;
use crate::planar_map::PlanarMap;
use rstar::{AABB, RTree, primitives::Rectangle};
use rustc_hash::FxHashSet;
use twinedge::dcel::{Face, FaceKey, HalfEdgeKey, VertexKey};
use twinedge_geometry::Point;
use twinedge_geometry::noding::{Noded, Snap, node};
use twinedge_geometry::predicates::{Meeting, meeting};

/// An edge of the region, before anything changes.
#[derive(Clone, Copy)]
pub(super) struct RegionEdge {
    pub(super) key: HalfEdgeKey,
    pub(super) ends: [VertexKey; 2],
    pub(super) along: SetId,
    /// The features that cover the faces to its left and right.
    pub(super) covers: [SetId; 2],
    /// For each of these faces, true if it is in the region.
    pub(super) inside: [bool; 2],
}

#[derive(Default)]
pub(super) struct Region {
    faces: FxHashSet<FaceKey>,
    order: Vec<FaceKey>,
    pub(super) edges: Vec<RegionEdge>,
    /// Edges by half the index of their half-edges.
    seen: FxHashSet<usize>,
    isolated: Vec<VertexKey>,
    /// The edges and isolated vertices that are near enough to matter, by their indices above, and the others.
    pub(super) near: Vec<usize>,
    far: Vec<usize>,
    pub(super) near_isolated: Vec<VertexKey>,
}

/// The parts of the drawing that may change, and the distance within which an edge matters.
struct Reach {
    way: [Point; 2],
    changed: RTree<Rectangle<[f64; 2]>>,
    margin: f64,
}

impl Reach {
    /// Returns true if some point of a segment may be within the margin of the way, or of a box around a changing edge. Rounding
    /// errors of the distances are added to the margin, so there are no false negatives.
    fn is_near(&self, [a, b]: [Point; 2]) -> bool {
        let [p, q] = self.way;
        let largest = [a, b, p, q].iter().fold(0.0, |largest: f64, p| largest.max(p.x.abs()).max(p.y.abs()));
        let margin = self.margin + largest * f64::EPSILON * 8.0;
        let low = [a.x.min(b.x) - margin, a.y.min(b.y) - margin];
        let high = [a.x.max(b.x) + margin, a.y.max(b.y) + margin];
        if self.changed.locate_in_envelope_intersecting(AABB::from_corners(low, high)).next().is_some() {
            return true;
        }
        let beside = high[0] < p.x.min(q.x) || p.x.max(q.x) < low[0] || high[1] < p.y.min(q.y) || p.y.max(q.y) < low[1];
        let (x, y) = (q.x - p.x, q.y - p.y);
        let distance = |c: Point| (x * (c.y - p.y) - y * (c.x - p.x)) / x.hypot(y);
        let (of_a, of_b) = (distance(a), distance(b));
        !beside && of_a.min(of_b) <= margin && of_a.max(of_b) >= -margin
    }
}

impl Region {
    fn add(&mut self, face: Face<'_>) {
        if self.faces.insert(face.key()) {
            self.order.push(face.key());
        }
    }
}

impl PlanarMap {
    /// Collects the faces along a segment, and the faces adjacent to edges that change when the segment is noded together with
    /// the boundaries of these faces. Also returns the noded drawing, first of the segment, then of the nearby edges.
    ///
    /// Records beyond have no influence. Noding deforms a drawing without anything ever passing anything else
    /// ([`noding`](twinedge_geometry::noding)), so deformed edges stay inside the unchanged edges around them, and the region
    /// grows until all edges on its border are unchanged. A chain stays within `(rounds + 1) / 2` cells of its segment in each
    /// direction, and visits pixels within half a cell of itself. So records more than a few cells away from the segment and from
    /// all changing edges play no part.
    pub(super) fn region(&self, start: Located, way: [Point; 2], cell: f64) -> Result<(Region, Noded), EditError> {
        let [p, q] = way;
        let mut region = Region::default();
        match start {
            Located::Vertex(v) => {
                let v = self.dcel.vertex(v)?;
                if let Some(face) = v.leaving().map(|h| h.face()).or_else(|| v.isolated().map(|b| b.face())) {
                    region.add(face);
                }
            }
            Located::Edge(h) => region.add(self.dcel.half_edge(h)?.face()),
            Located::Face(f) => region.add(self.dcel.face(f)?),
        }
        let mut looked_at = 0;
        let mut reach = Reach { way, changed: RTree::new(), margin: 4.0 * cell };
        let mut noded: Option<Noded> = None;
        loop {
            while let Some(face) = region.order.get(looked_at).copied() {
                looked_at += 1;
                self.look_around(&mut region, self.dcel.face(face)?, [p, q]);
            }
            let taken = self.take_near(&mut region, &reach)?;
            if let Some(noded) = noded.take_if(|_| !taken) {
                for edge in &mut region.edges {
                    let h = self.dcel.half_edge(edge.key)?;
                    edge.inside = [h, h.twin()].map(|h| region.faces.contains(&h.face().key()));
                }
                return Ok((region, noded));
            }
            let now = self.noded(&region, way, Snap::Size(cell))?;
            let mut boxes = Vec::new();
            for i in 0..region.near.len() {
                if now.chain(i + 1).is_some_and(|chain| chain.len() > 2) {
                    let h = self.dcel.half_edge(region.edges[region.near[i]].key)?;
                    region.add(h.face());
                    region.add(h.twin().face());
                    let [tail, head] = self.ends(h);
                    boxes.push(Rectangle::from_corners(tail.into(), head.into()));
                }
            }
            reach.changed = RTree::bulk_load(boxes);
            reach.margin = (now.summary.rounds as f64 / 2.0 + 4.0) * cell;
            noded = Some(now);
        }
    }

    /// Moves records within reach from the far ones to the near ones. Returns true if there were any.
    fn take_near(&self, region: &mut Region, reach: &Reach) -> Result<bool, EditError> {
        let before = (region.near.len(), region.near_isolated.len());
        let mut far = Vec::new();
        for i in core::mem::take(&mut region.far) {
            let [v, w] = region.edges[i].ends;
            let near = reach.is_near([self.position(v)?, self.position(w)?]);
            if near { &mut region.near } else { &mut far }.push(i);
        }
        region.far = far;
        let mut isolated = Vec::new();
        for v in core::mem::take(&mut region.isolated) {
            let near = reach.is_near([self.position(v)?; 2]);
            if near { &mut region.near_isolated } else { &mut isolated }.push(v);
        }
        region.isolated = isolated;
        Ok(before != (region.near.len(), region.near_isolated.len()))
    }

    /// Adds a face's boundary to the region, and the faces beyond edges that a segment meets, including all around a vertex on
    /// it.
    fn look_around(&self, region: &mut Region, face: Face<'_>, [p, q]: [Point; 2]) {
        for h in face.half_edges() {
            if !region.seen.insert(h.index() / 2) {
                continue;
            }
            let covers = [h, h.twin()].map(|h| self.features.of_face(h.face().index()));
            region.far.push(region.edges.len());
            region.edges.push(RegionEdge {
                key: h.key(),
                ends: [h.origin().key(), h.target().key()],
                along: self.features.along(h.index()),
                covers,
                inside: [false; 2],
            });
            let [tail, head] = self.ends(h);
            if meeting(p, q, tail, head) != Meeting::Disjoint {
                region.add(h.face());
                region.add(h.twin().face());
            }
        }
        region.isolated.extend(face.inner().filter_map(|b| b.isolated_vertex()).map(|v| v.key()));
    }

    /// Nodes a segment together with the nearby records of a region. No vertex may move.
    fn noded(&self, region: &Region, way: [Point; 2], snap: Snap) -> Result<Noded, EditError> {
        let mut segments = vec![way];
        for i in &region.near {
            let [v, w] = region.edges[*i].ends;
            segments.push([self.position(v)?, self.position(w)?]);
        }
        let points = region.near_isolated.iter().map(|v| self.position(*v)).collect::<Result<Vec<Point>, _>>()?;
        let noded = node(&segments, &points, snap).map_err(|error| EditError::of_noding(error, &segments, &points))?;
        let moved = |p: Point, number: Option<u32>| number.is_none_or(|n| noded.points[n as usize] != p);
        for ((i, ends), segment) in region.near.iter().zip(&segments[1..]).zip(1..) {
            let Some(mut chain) = noded.chain(segment) else { continue };
            let first = chain.next();
            let last = chain.next_back().or(first);
            for ((number, p), v) in [first, last].into_iter().zip(ends).zip(region.edges[*i].ends) {
                if moved(*p, number) {
                    return Err(EditError::NotOnGrid(v));
                }
            }
        }
        for ((v, p), i) in region.near_isolated.iter().zip(&points).zip(0..) {
            if moved(*p, noded.vertex_of_point(i)) {
                return Err(EditError::NotOnGrid(*v));
            }
        }
        Ok(noded)
    }
}
