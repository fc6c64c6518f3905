//! Structures whose vertices have coordinates.

use super::record::Record;
use super::view::{Start, View};
use super::violation::Violation;
use crate::geometry::{MAX_COORDINATE, Point};

/// A structure whose vertices have coordinates.
pub trait Embedding: View {
    /// Where the vertex lies. It is asked of live vertices only.
    fn point(&self, vertex: usize) -> Point;

    /// How many bends the half-edge has: 0 for a straight edge.
    ///
    /// It is asked of one half-edge of each edge, the one with the smaller index. Those of its twin are the same in reverse. A bend is
    /// no vertex: no other edge ends there, and G4 is broken if one does.
    fn bends(&self, half_edge: usize) -> usize {
        let _ = half_edge;
        0
    }

    /// Where the half-edge bends for the `bend`-th time on the way from its origin to its target, counted from 0. It is asked for
    /// numbers below [`bends`](Self::bends) only.
    ///
    /// ```
    /// use twinedge::geometry::Point;
    /// use twinedge::validate::{Collect, Embedding, Expectation, Link, Part, Rule, View, Violation, validate_embedding};
    ///
    /// /// One edge from (0, 0) to (4, 0), drawn as a line with bends.
    /// struct Road(Vec<[f64; 2]>);
    ///
    /// impl View for Road {
    ///     fn vertex_slots(&self) -> usize { 2 }
    ///     fn half_edge_slots(&self) -> usize { 2 }
    ///     fn origin(&self, half_edge: usize) -> Link { Some(half_edge) }
    ///     fn twin(&self, half_edge: usize) -> Link { Some(1 - half_edge) }
    ///     fn next(&self, half_edge: usize) -> Link { Some(1 - half_edge) }
    /// }
    ///
    /// impl Embedding for Road {
    ///     fn point(&self, vertex: usize) -> Point { [[0.0, 0.0], [4.0, 0.0]][vertex].into() }
    ///     fn bends(&self, _: usize) -> usize { self.0.len() }
    ///     fn bend(&self, _: usize, bend: usize) -> Point { self.0[bend].into() }
    /// }
    ///
    /// let expectation = Expectation::plane().without(Part::Faces).without(Part::Prev).without(Part::Leaving);
    /// let judge = |road: &Road| validate_embedding(road, &expectation, Collect::All);
    /// assert!(judge(&Road(vec![[1.0, 1.0], [3.0, 1.0]])).is_valid());
    /// let crossing = judge(&Road(vec![[3.0, 1.0], [3.0, -1.0], [1.0, -1.0], [1.0, 2.0], [4.0, 2.0]]));
    /// let violation = crossing.violations()[0];
    /// assert_eq!(violation, Violation::SegmentsCross { first: 0, first_segment: 0, second: 0, second_segment: 3 });
    /// ```
    fn bend(&self, half_edge: usize, bend: usize) -> Point {
        let _ = (half_edge, bend);
        Point::default()
    }
}

impl<E: Embedding + ?Sized> Embedding for &E {
    fn point(&self, vertex: usize) -> Point {
        (**self).point(vertex)
    }

    fn bends(&self, half_edge: usize) -> usize {
        (**self).bends(half_edge)
    }

    fn bend(&self, half_edge: usize, bend: usize) -> Point {
        (**self).bend(half_edge, bend)
    }
}

impl<E: Embedding + ?Sized> Embedding for alloc::boxed::Box<E> {
    fn point(&self, vertex: usize) -> Point {
        (**self).point(vertex)
    }

    fn bends(&self, half_edge: usize) -> usize {
        (**self).bends(half_edge)
    }

    fn bend(&self, half_edge: usize, bend: usize) -> Point {
        (**self).bend(half_edge, bend)
    }
}

/// The records of a violation as points, to show where it is: ends of half-edges, places of vertices. Of an edge with bends, the
/// bends and the ends of the segments that the violation names.
#[must_use]
pub fn places<E: Embedding + ?Sized>(embedding: &E, violation: &Violation) -> Vec<Point> {
    let bound = 2.0 * MAX_COORDINATE;
    let vertex = |v: usize| {
        let live = v < embedding.vertex_slots() && embedding.is_vertex(v);
        live.then(|| embedding.point(v)).filter(|p| p.x.abs() < bound)
    };
    let half_edge = |h: usize| Some(h).filter(|h| *h < embedding.half_edge_slots());
    let origin = |h: usize| embedding.origin(half_edge(h)?).and_then(vertex);
    let target = |h: usize| half_edge(h).and_then(|h| embedding.twin(h)).and_then(origin);
    let bend = |h: usize, i: usize| {
        let h = half_edge(h).filter(|h| i < embedding.bends(*h))?;
        Some(embedding.bend(h, i)).filter(|p| p.x.abs() < bound)
    };
    let segment = |h: usize, i: usize| {
        let from = i.checked_sub(1).map_or_else(|| origin(h), |before| bend(h, before));
        [from, bend(h, i).or_else(|| target(h))]
    };
    let mut points = Vec::new();
    match *violation {
        Violation::SegmentZeroLength { half_edge, segment: i } => points.extend(segment(half_edge, i)[0]),
        Violation::SegmentsCross { first, first_segment, second, second_segment }
        | Violation::SegmentsOverlap { first, first_segment, second, second_segment } => {
            points.extend(segment(first, first_segment).into_iter().chain(segment(second, second_segment)).flatten());
        }
        Violation::VertexInSegment { vertex: v, .. } | Violation::BendAtVertex { vertex: v, .. } => {
            points.extend(vertex(v));
        }
        Violation::BendNotFinite { half_edge, bend: i }
        | Violation::BendInSegment { half_edge, bend: i, .. }
        | Violation::BendsAtSamePlace { first: half_edge, first_bend: i, .. } => points.extend(bend(half_edge, i)),
        _ => {}
    }
    if !points.is_empty() {
        return points;
    }
    for record in violation.records().into_iter().flatten() {
        match record {
            Record::Vertex(v) => points.extend(vertex(v)),
            Record::HalfEdge(h) => {
                points.extend(origin(h));
                points.extend(target(h));
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
