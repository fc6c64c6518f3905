//! Workloads that the benchmarks share.

#![allow(dead_code, unreachable_pub, reason = "each benchmark uses its part")]

use twinedge::dcel::{Dcel, Face, HalfEdge, Vertex};
use twinedge::map::{Builder, Feature, PlanarMap};

/// A grid of `side` × `side` vertices, each square cut in two triangles.
pub fn triangulated_grid(side: u32) -> PlanarMap {
    let at = |x: u32, y: u32| [f64::from(x), f64::from(y)];
    let mut builder = Builder::new();
    let mut add = |from, to| {
        builder.segment(from, to).expect("small integers are in range");
    };
    for y in 0..side {
        for x in 0..side {
            if x + 1 < side {
                add(at(x, y), at(x + 1, y));
            }
            if y + 1 < side {
                add(at(x, y), at(x, y + 1));
            }
            if x + 1 < side && y + 1 < side {
                add(at(x, y), at(x + 1, y + 1));
            }
        }
    }
    builder.build().expect("a grid fits")
}

/// The same links as plain arrays of `u32`, with the same numbering: what a structure without keys would be.
pub struct PlainArrays {
    pub origin: Vec<u32>,
    pub twin: Vec<u32>,
    pub next: Vec<u32>,
    /// Per vertex a half-edge that leaves it, `u32::MAX` where there is no vertex.
    pub leaving: Vec<u32>,
    /// Per face a half-edge of its outer cycle, `u32::MAX` where there is none.
    pub outer: Vec<u32>,
}

impl PlainArrays {
    pub fn of(dcel: &Dcel) -> Self {
        let end = |last: Option<usize>| last.map_or(0, |last| last + 1);
        let half_edges = end(dcel.half_edges().map(HalfEdge::index).max());
        let mut plain = Self {
            origin: vec![u32::MAX; half_edges],
            twin: vec![u32::MAX; half_edges],
            next: vec![u32::MAX; half_edges],
            leaving: vec![u32::MAX; end(dcel.vertices().map(Vertex::index).max())],
            outer: vec![u32::MAX; end(dcel.faces().map(Face::index).max())],
        };
        for h in dcel.half_edges() {
            plain.origin[h.index()] = h.origin().index() as u32;
            plain.twin[h.index()] = h.twin().index() as u32;
            plain.next[h.index()] = h.next().index() as u32;
        }
        for v in dcel.vertices() {
            plain.leaving[v.index()] = v.leaving().map_or(u32::MAX, |h| h.index() as u32);
        }
        for f in dcel.faces() {
            plain.outer[f.index()] = f.outer_half_edge().map_or(u32::MAX, |h| h.index() as u32);
        }
        plain
    }
}

/// The features of `world-50m`.
pub fn world_50m_features() -> Vec<Feature> {
    let file = include_bytes!("../../tests/data/world-50m.geojson");
    let mut features = Vec::new();
    twinedge::io::geojson::read(file.as_slice(), |feature| {
        features.push(feature);
        Ok::<(), twinedge::io::ReadError>(())
    })
    .expect("the file is GeoJSON");
    features
}

/// The map of `world-50m`.
pub fn world_50m() -> PlanarMap {
    let mut builder = Builder::new();
    for feature in world_50m_features() {
        builder.feature(&feature).expect("longitudes and latitudes are in range");
    }
    builder.build().expect("the world fits")
}
