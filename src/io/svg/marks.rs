//! Violations, in red.

use super::frame::Frame;
use super::text::{escaped, put, text};
use crate::dcel::HalfEdge;
use crate::geometry::Point;
use crate::geometry::predicates::{Meeting, meeting};
use crate::map::PlanarMap;
use crate::validate::{Embedding, places};
use crate::validate::{Record, Violation};

/// How often a label is moved.
const MOVES: usize = 12;

/// Marks each violation: its edges, a circle around the place, and beside it the rule and the records.
pub(super) fn draw(out: &mut String, map: &PlanarMap, frame: &Frame, violations: &[Violation]) {
    let mut taken: Vec<[f64; 2]> = Vec::new();
    for violation in violations {
        let mut edges = Vec::new();
        let mut label = violation.rule().id().to_owned();
        for record in violation.records().into_iter().flatten() {
            let (letter, index) = match record {
                Record::Vertex(v) => ('v', v),
                Record::HalfEdge(h) => ('h', h),
                Record::Boundary(b) => ('b', b),
                Record::Face(f) => ('f', f),
            };
            put(&mut label, format_args!(" {letter}{index}"));
            if let Record::HalfEdge(h) = record {
                edges.extend(map.dcel().half_edge_at(h).map(|h| ends(map, h)));
            }
        }
        for [a, b] in edges.iter().map(|edge| edge.map(|p| frame.at(p))) {
            put(out, format_args!("<path class=\"bad\" d=\"M{:.2} {:.2}L{:.2} {:.2}\"/>\n", a[0], a[1], b[0], b[1]));
        }
        let Some(place) = place(map, violation, &edges) else { continue };
        let [x, y] = frame.at(place);
        let title = escaped(&violation.to_string());
        put(
            out,
            format_args!("<circle class=\"bad\" cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"9\"><title>{title}</title></circle>\n"),
        );
        // Labels move down from the ones before that they cover, a few times.
        let mut at = [x + 13.0, y + 4.0];
        let covers = |at: [f64; 2], other: &[f64; 2]| {
            (at[0] - other[0]).abs() < 7.0 * label.len() as f64 && (at[1] - other[1]).abs() < 13.0
        };
        for _ in 0..MOVES {
            let Some(other) = taken.iter().find(|other| covers(at, other)) else { break };
            at[1] = other[1] + 13.5;
        }
        taken.push(at);
        text(out, "rule", at, &label);
    }
}

fn ends(map: &PlanarMap, h: HalfEdge<'_>) -> [Point; 2] {
    [h.origin(), h.target()].map(|v| map.point(v.index()))
}

/// Where to look: where two edges cross, or else the middle of the places of the violation.
fn place(map: &PlanarMap, violation: &Violation, edges: &[[Point; 2]]) -> Option<Point> {
    let crossing = match *edges {
        [[a, b], [c, d]] if meeting(a, b, c, d) == Meeting::Cross => crossing([a, b], [c, d]),
        _ => None,
    };
    if crossing.is_some() {
        return crossing;
    }
    let all = places(map, violation);
    let count = all.len() as f64;
    let sum = all.iter().fold(Point::default(), |sum, p| Point::new(sum.x + p.x / count, sum.y + p.y / count));
    (!all.is_empty()).then_some(sum)
}

/// About where two segments cross.
fn crossing([a, b]: [Point; 2], [c, d]: [Point; 2]) -> Option<Point> {
    let (u, v, w) = ([b.x - a.x, b.y - a.y], [d.x - c.x, d.y - c.y], [c.x - a.x, c.y - a.y]);
    let cross = |p: [f64; 2], q: [f64; 2]| p[0] * q[1] - p[1] * q[0];
    let t = cross(w, v) / cross(u, v);
    (0.0..=1.0).contains(&t).then(|| Point::new(a.x + t * u[0], a.y + t * u[1]))
}
