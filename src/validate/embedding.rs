//! Structures whose vertices have coordinates.

use super::record::Record;
use super::view::{Start, View};
use super::violation::Violation;
use crate::geometry::{MAX_COORDINATE, Point};

/// A structure whose vertices have coordinates.
pub trait Embedding: View {
    /// Where the vertex lies. It is asked of live vertices only.
    fn point(&self, vertex: usize) -> Point;
}

impl<E: Embedding + ?Sized> Embedding for &E {
    fn point(&self, vertex: usize) -> Point {
        (**self).point(vertex)
    }
}

impl<E: Embedding + ?Sized> Embedding for alloc::boxed::Box<E> {
    fn point(&self, vertex: usize) -> Point {
        (**self).point(vertex)
    }
}

/// The records of a violation as points, to show where it is: ends of half-edges, places of vertices.
#[must_use]
pub fn places<E: Embedding + ?Sized>(embedding: &E, violation: &Violation) -> Vec<Point> {
    let bound = 2.0 * MAX_COORDINATE;
    let vertex = |v: usize| {
        let live = v < embedding.vertex_slots() && embedding.is_vertex(v);
        live.then(|| embedding.point(v)).filter(|p| p.x.abs() < bound)
    };
    let half_edge = |h: usize| Some(h).filter(|h| *h < embedding.half_edge_slots());
    let origin = |h: usize| embedding.origin(half_edge(h)?).and_then(vertex);
    let mut points = Vec::new();
    for record in violation.records().into_iter().flatten() {
        match record {
            Record::Vertex(v) => points.extend(vertex(v)),
            Record::HalfEdge(h) => {
                points.extend(origin(h));
                points.extend(half_edge(h).and_then(|h| embedding.twin(h)).and_then(origin));
            }
            Record::Boundary(b) if b < embedding.boundary_slots() => {
                points.extend(embedding.boundary_start(b).and_then(|start| match start {
                    Start::HalfEdge(h) => origin(h),
                    Start::Vertex(v) => vertex(v),
                }));
            }
            Record::Boundary(_) | Record::Face(_) => {}
        }
    }
    points
}
