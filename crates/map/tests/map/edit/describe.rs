//! Descriptions of maps that do not depend on their keys.

use crate::support::exact::Grid;
use std::collections::BTreeSet;
use twinedge::dcel::{Face, HalfEdge, Vertex};
use twinedge_map::{Builder, PlanarMap, Shape};

/// A closed walk, starting at its smallest half-edge; a single point for an isolated vertex.
pub(crate) type Walk = Vec<Grid>;

/// The outer walk of a face, if it has one, and its inner ones.
pub(crate) type Walls = (Option<Walk>, BTreeSet<Walk>);

pub(crate) fn grid(map: &PlanarMap, v: Vertex<'_>) -> Grid {
    let p = map.position(v.key()).expect("it is of this map");
    assert!(p.x.fract() == 0.0 && p.y.fract() == 0.0, "{p:?} is not whole");
    (p.x as i32, p.y as i32)
}

/// An edge by its ends, the smaller first.
pub(crate) fn ends(map: &PlanarMap, h: HalfEdge<'_>) -> [Grid; 2] {
    let mut ends = [grid(map, h.origin()), grid(map, h.target())];
    ends.sort_unstable();
    ends
}

fn walk(map: &PlanarMap, start: HalfEdge<'_>) -> Walk {
    let places: Vec<Grid> = start.boundary_cycle().map(|h| grid(map, h.origin())).collect();
    let turned = |i: usize| -> Walk { places[i..].iter().chain(&places[..i]).copied().collect() };
    (0..places.len()).map(turned).min().expect("a cycle has a half-edge")
}

pub(crate) fn walls(map: &PlanarMap, face: Face<'_>) -> Walls {
    let inner = face.inner().map(|b| match b.start() {
        Some(start) => walk(map, start),
        None => b.isolated_vertex().map(|v| grid(map, v)).into_iter().collect(),
    });
    (face.outer_half_edge().map(|start| walk(map, start)), inner.collect())
}

/// The drawing of a map: vertices, edges, and faces by their walls.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Description {
    pub(crate) vertices: BTreeSet<Grid>,
    pub(crate) edges: BTreeSet<[Grid; 2]>,
    pub(crate) faces: BTreeSet<Walls>,
}

pub(crate) fn describe(map: &PlanarMap) -> Description {
    Description {
        vertices: map.dcel().vertices().map(|v| grid(map, v)).collect(),
        edges: map.dcel().edges().map(|h| ends(map, h)).collect(),
        faces: map.dcel().faces().map(|f| walls(map, f)).collect(),
    }
}

/// Builds a map from these vertices and edges at once.
pub(crate) fn built(vertices: &BTreeSet<Grid>, edges: &BTreeSet<[Grid; 2]>) -> PlanarMap {
    let mut builder = Builder::new();
    for p in vertices {
        builder.shape(&Shape::Point(crate::support::exact::point(*p))).expect("small integers are in range");
    }
    for ends in edges {
        let [a, b] = ends.map(crate::support::exact::point);
        builder.segment(a, b).expect("small integers are in range");
    }
    builder.build().expect("a small map fits")
}

/// A map in full: itself, and its saved form, which includes the vacant slots. Only plane maps can be saved.
pub(crate) fn dump(map: &PlanarMap) -> (PlanarMap, Option<serde_json::Value>) {
    (map.clone(), serde_json::to_value(map).ok())
}
