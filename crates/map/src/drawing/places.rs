//! Locating violations.

use super::embedding::Embedding;
use twinedge::validate::{Record, Start, Violation};
use twinedge_geometry::{MAX_COORDINATE, Point};

/// Returns points that show the location of a violation: the ends of its half-edges and its vertices. For edges with bends,
/// returns the bends and the ends of the segments that the violation names.
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
