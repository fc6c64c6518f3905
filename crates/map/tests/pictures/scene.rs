//! A structure with the positions of its vertices.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use twinedge::dcel::{Dcel, FaceKey, HalfEdge, HalfEdgeKey, Vertex, VertexKey};
use twinedge_map::{Builder, Embedding};

pub(crate) type Place = [f64; 2];

/// A structure, with the position of each of its vertices, by index.
#[derive(Clone)]
pub(crate) struct Scene {
    pub dcel: Dcel,
    pub places: BTreeMap<usize, Place>,
}

impl Scene {
    /// The map of these chains of points.
    pub(crate) fn new(chains: &[&[Place]]) -> Self {
        let mut builder = Builder::new();
        for pair in chains.iter().flat_map(|chain| chain.windows(2)) {
            builder.segment(pair[0], pair[1]).expect("coordinates in range");
        }
        let map = builder.build().expect("a plane map");
        let dcel = map.dcel().clone();
        let places = dcel.vertices().map(|v| (v.index(), map.point(v.index()))).map(|(v, p)| (v, [p.x, p.y])).collect();
        Self { dcel, places }
    }

    pub(crate) fn place(&self, v: Vertex<'_>) -> Place {
        self.places[&v.index()]
    }

    pub(crate) fn vertex(&self, place: Place) -> VertexKey {
        self.dcel.vertices().find(|v| self.place(*v) == place).expect("a vertex there").key()
    }

    pub(crate) fn half_edge(&self, from: Place, to: Place) -> HalfEdgeKey {
        let found = self.dcel.half_edges().find(|h| self.place(h.origin()) == from && self.place(h.target()) == to);
        found.expect("a half-edge there").key()
    }

    /// The face to the left of that half-edge.
    pub(crate) fn face(&self, from: Place, to: Place) -> FaceKey {
        self.dcel.half_edge(self.half_edge(from, to)).expect("it is live").face().key()
    }

    /// The half-edge whose corner at this vertex faces that way.
    pub(crate) fn corner(&self, at: Place, towards: Place) -> HalfEdgeKey {
        let direction = angle(at, towards);
        let vertex = self.dcel.vertex(self.vertex(at)).expect("it is live");
        let turn = |h: &HalfEdge<'_>| (direction - self.angle(*h)).rem_euclid(TAU);
        vertex.rotation().min_by(|a, b| turn(a).total_cmp(&turn(b))).expect("it is not isolated").key()
    }

    /// The middle of the corner of a half-edge.
    pub(crate) fn corner_direction(&self, h: HalfEdge<'_>) -> f64 {
        let from = self.angle(h);
        let width = (self.angle(h.counter_clockwise()) - from).rem_euclid(TAU);
        from + if width == 0.0 { TAU / 2.0 } else { width / 2.0 }
    }

    fn angle(&self, h: HalfEdge<'_>) -> f64 {
        angle(self.place(h.origin()), self.place(h.target()))
    }
}

fn angle(from: Place, to: Place) -> f64 {
    (to[1] - from[1]).atan2(to[0] - from[0])
}
