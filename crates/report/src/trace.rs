//! The places of findings on a map, and their shapes of points, lines and polygons.

use std::collections::HashSet;
use twinedge::dcel::FaceKey;
use twinedge::validate::{Record, Rule, Start, Violation};
use twinedge_algorithm::contour::of_faces;
use twinedge_coverage::Finding;
use twinedge_diagnosis::{Diagnosis, Position, Trace, middle};
use twinedge_geometry::{MAX_COORDINATE, Point};
use twinedge_map::{Embedding, PlanarMap, places};

/// Returns the extent of a coverage finding: its faces, the stretches of borders of a near miss, or the segments that lack vertices, with the
/// vertices.
pub(crate) fn of_finding(map: &PlanarMap, finding: &Finding) -> Trace {
    let mut trace = of_extent(map, &finding.faces, &finding.stretches, finding.at);
    if trace.points.is_empty() {
        trace.points = finding.missing.iter().map(|vertex| position(vertex.at)).collect();
    } else {
        // If the map was judged by tiles, a corner of the faces is all that is known.
        trace.points.push(position(finding.corner));
    }
    trace
}

/// Returns faces as polygons and stretches as lines; the place if there are neither.
pub(crate) fn of_extent(map: &PlanarMap, faces: &[FaceKey], stretches: &[[Point; 2]], at: Point) -> Trace {
    let lines = stretches.iter().map(|stretch| stretch.map(position).to_vec()).collect();
    let contour = of_faces(map, faces.iter().copied()).unwrap_or_default();
    let ring = |ring: &[Point]| ring.iter().copied().map(position).collect();
    let polygons: Vec<_> = contour.polygons.iter().map(|polygon| polygon.rings().map(ring).collect()).collect();
    let points = if polygons.is_empty() && stretches.is_empty() { vec![position(at)] } else { Vec::new() };
    Trace { points, lines, polygons }
}

/// Returns the records of a violation: half-edges and cycles as lines, faces as polygons if their outer cycles are counter-clockwise, vertices as
/// points.
fn of_violation<E: Embedding + ?Sized>(embedding: &E, violation: &Violation) -> Trace {
    let mut trace = Trace::default();
    for record in violation.records().into_iter().flatten() {
        match record {
            Record::HalfEdge(h) => add_line(&mut trace, half_edge(embedding, h)),
            Record::Vertex(v) => trace.points.extend(vertex(embedding, Some(v))),
            Record::Boundary(b) if b < embedding.boundary_slots() => match embedding.boundary_start(b) {
                Some(Start::HalfEdge(h)) => add_line(&mut trace, cycle(embedding, h)),
                Some(Start::Vertex(v)) => trace.points.extend(vertex(embedding, Some(v))),
                None => {}
            },
            Record::Face(f) if f < embedding.face_slots() => {
                let outer = embedding.outer(f).filter(|b| *b < embedding.boundary_slots());
                let start = match outer.and_then(|b| embedding.boundary_start(b)) {
                    Some(Start::HalfEdge(h)) => Some(h),
                    _ => embedding.outer_half_edge(f),
                };
                let ring = start.map_or_else(Vec::new, |h| cycle(embedding, h));
                if is_outer_ring(&ring) { trace.polygons.push(vec![ring]) } else { add_line(&mut trace, ring) }
            }
            _ => {}
        }
    }
    if trace == Trace::default() {
        trace.points.extend(places(embedding, violation).into_iter().map(position));
    }
    trace
}

/// Adds a line, or a point if the line has no length.
fn add_line(trace: &mut Trace, line: Vec<Position>) {
    match line.first() {
        Some(first) if line.iter().all(|p| Some(p) == line.first()) => trace.points.push(*first),
        Some(_) => trace.lines.push(line),
        None => {}
    }
}

pub(crate) fn placed<E: Embedding + ?Sized>(embedding: &E, violation: &Violation) -> Diagnosis {
    Diagnosis {
        places: Some(places(embedding, violation).into_iter().map(position).collect()),
        look: place(embedding, violation),
        trace: of_violation(embedding, violation),
        ..violation.into()
    }
}

/// Returns false for a component that does not fit in the plane because its borders cross: the corner that represents it is not at fault.
pub(crate) fn has_place(one: &Diagnosis) -> bool {
    one.rule != Some(Rule::T3.id()) || one.follows_from.is_none()
}

/// Converts a point, removing the sign of zeros.
pub(crate) fn position(point: Point) -> Position {
    [point.x + 0.0, point.y + 0.0]
}

/// The place to look at: the violation's vertex if it comes first, the crossing of two segments, or else the centre of its places.
fn place<E: Embedding + ?Sized>(embedding: &E, violation: &Violation) -> Option<Position> {
    if let [Some(Record::Vertex(v)), _] = violation.records()
        && let Some(at) = vertex(embedding, Some(v))
    {
        return Some(at);
    }
    let all: Vec<Position> = places(embedding, violation).into_iter().map(position).collect();
    middle(&all)
}

/// Returns the position if it is a point of the plane.
pub(crate) fn finite(point: Point) -> Option<Position> {
    (point.x.abs() <= MAX_COORDINATE && point.y.abs() <= MAX_COORDINATE).then(|| position(point))
}

fn vertex<E: Embedding + ?Sized>(embedding: &E, vertex: Option<usize>) -> Option<Position> {
    let vertex = vertex.filter(|v| *v < embedding.vertex_slots() && embedding.is_vertex(*v))?;
    finite(embedding.point(vertex))
}

/// The line from the origin through the bends to the target, as far as known.
fn half_edge<E: Embedding + ?Sized>(embedding: &E, h: usize) -> Vec<Position> {
    if h >= embedding.half_edge_slots() || !embedding.is_half_edge(h) {
        return Vec::new();
    }
    let bends = (0..embedding.bends(h)).filter_map(|i| finite(embedding.bend(h, i)));
    let origin = vertex(embedding, embedding.origin(h));
    origin.into_iter().chain(bends).chain(vertex(embedding, target(embedding, h))).collect()
}

/// The target of a half-edge: the origin of its twin, or else of its next.
pub(crate) fn target<E: Embedding + ?Sized>(embedding: &E, h: usize) -> Option<usize> {
    let live = |h: &usize| *h < embedding.half_edge_slots() && embedding.is_half_edge(*h);
    let by_twin = embedding.twin(h).filter(live).and_then(|twin| embedding.origin(twin));
    by_twin.or_else(|| embedding.next(h).filter(live).and_then(|next| embedding.origin(next)))
}

/// The maximal number of points of a line along a cycle: broken cycles may share most of their half-edges.
const LONGEST: usize = 50_000;

/// The line along `next` from a half-edge until one repeats.
fn cycle<E: Embedding + ?Sized>(embedding: &E, start: usize) -> Vec<Position> {
    let mut line: Vec<Position> = Vec::new();
    let mut seen = HashSet::new();
    let mut h = Some(start);
    while let Some(this) = h.filter(|h| line.len() < LONGEST && *h < embedding.half_edge_slots() && seen.insert(*h)) {
        let points = half_edge(embedding, this);
        let is_continued = line.last().is_some() && line.last() == points.first();
        line.extend(points.into_iter().skip(usize::from(is_continued)));
        h = embedding.next(this);
    }
    line
}

/// Returns true if a line is closed, has at least three sides, and turns counter-clockwise.
fn is_outer_ring(line: &[Position]) -> bool {
    let Some(first) = line.first() else { return false };
    let twice = |pair: &[Position]| {
        let [p, q] = [pair[0], pair[1]].map(|p| [p[0] - first[0], p[1] - first[1]]);
        p[0] * q[1] - p[1] * q[0]
    };
    line.len() >= 4 && line.first() == line.last() && line.windows(2).map(twice).sum::<f64>() > 0.0
}

#[cfg(test)]
mod tests {
    use super::{Trace, is_outer_ring, of_violation, place};
    use crate::textbook::Textbook;
    use twinedge::validate::Violation;

    /// A triangle; e3,1 has no next.
    const TRIANGLE: &str = "v1 (0, 0) e1,1\nv2 (4, 0) e2,1\nv3 (0, 4) e3,1\nf1 nil e1,2\nf2 e1,1 nil
        e1,1 v1 e1,2 f2 e2,1 e3,1\ne1,2 v2 e1,1 f1 e3,2 e2,2\ne2,1 v2 e2,2 f2 e3,1 e1,1\ne2,2 v3 e2,1 f1 e1,2 e3,2
        e3,1 v3 e3,2 f2 nil e2,1\ne3,2 v1 e3,1 f1 e2,2 e1,2";

    #[test]
    fn only_a_closed_ring_to_the_left_is_a_polygon() {
        let mut ring = vec![[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [0.0, 0.0]];
        assert!(is_outer_ring(&ring) && !is_outer_ring(&ring[..3]) && !is_outer_ring(&[]));
        ring.reverse();
        assert!(!is_outer_ring(&ring));
    }

    #[test]
    fn links_that_lead_nowhere_have_a_trace_all_the_same() {
        let tables: Textbook = TRIANGLE.parse().expect("it is one");
        let of = |violation| of_violation(&tables, &violation);
        let side = of(Violation::TwinIsSelf { half_edge: 4 });
        assert_eq!(side.lines, [[[0.0, 4.0], [0.0, 0.0]]]);
        // The face's cycle does not close.
        let face = of(Violation::NoOuter { face: 1 });
        assert_eq!(face.polygons.len(), 1);
        assert_eq!(of(Violation::TwinIsSelf { half_edge: 99 }), Trace::default());
        assert_eq!(place(&tables, &Violation::TwinIsSelf { half_edge: 99 }), None);
    }
}
