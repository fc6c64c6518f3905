//! Violations, in red, with a number each, and the legend.

use super::frame::Frame;
use super::text::{escaped, put, text};
use twinedge::dcel::HalfEdge;
use twinedge::validate::{Record, Violation};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::{Meeting, meeting};
use twinedge_map::{Embedding, PlanarMap, places};

/// The largest number of times that a number is moved.
const MOVES: usize = 12;
/// The largest number of rows of the legend; `ROW` is the height of each.
const ROWS: usize = 40;
const ROW: f64 = 16.0;
const LETTER: f64 = 5.8;

/// Marks each violation in the panel: its edges, a circle around the place, and its number next to it. O(v²) for v violations.
pub(super) fn draw(out: &mut String, map: &PlanarMap, frame: &Frame, violations: &[Violation]) {
    let mut taken: Vec<[f64; 2]> = Vec::new();
    for (violation, number) in violations.iter().zip(1..) {
        let half_edges = violation.records().into_iter().flatten().filter_map(|record| match record {
            Record::HalfEdge(h) => map.dcel().half_edge_at(h),
            _ => None,
        });
        let edges: Vec<[Point; 2]> = half_edges.map(|h| ends(map, h)).collect();
        for [a, b] in edges.iter().filter(|edge| frame.shows(**edge)).map(|edge| edge.map(|p| frame.at(p))) {
            put(out, format_args!("<path class=\"bad\" d=\"M{:.2} {:.2}L{:.2} {:.2}\"/>\n", a[0], a[1], b[0], b[1]));
        }
        let Some(place) = place(map, violation, &edges).filter(|place| frame.shows([*place])) else { continue };
        let [x, y] = frame.at(place);
        let title = escaped(&violation.message());
        put(
            out,
            format_args!("<circle class=\"bad\" cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"9\"><title>{title}</title></circle>\n"),
        );
        // Numbers move down from the earlier ones that they cover, a few times.
        let mut at = [x + 13.0, y + 4.0];
        let covers =
            |at: [f64; 2], other: &[f64; 2]| (at[0] - other[0]).abs() < 22.0 && (at[1] - other[1]).abs() < 13.0;
        for _ in 0..MOVES {
            let Some(other) = taken.iter().find(|other| covers(at, other)) else { break };
            at[1] = other[1] + 13.5;
        }
        taken.push(at);
        if at[1] - y > 10.0 {
            let [to_x, to_y] = [at[0], at[1] - 4.0];
            put(out, format_args!("<path class=\"bad thin\" d=\"M{x:.1} {y:.1}L{to_x:.1} {to_y:.1}\"/>\n"));
        }
        text(out, "rule", at, &number.to_string());
    }
}

pub(super) fn legend_height(violations: usize) -> f64 {
    let rows = violations.min(ROWS) + usize::from(violations > ROWS);
    if rows == 0 { 0.0 } else { ROW * (rows + 1) as f64 }
}

/// Writes the legend: the number and the message of each violation, cut at the edge of the picture.
pub(super) fn legend(out: &mut String, violations: &[Violation], [left, top]: [f64; 2], width: f64) {
    let room = width - 2.0 * left;
    let mut row = top;
    for (violation, number) in violations.iter().zip(1..).take(ROWS) {
        row += ROW;
        let whole = format!("{number}  {} {}", violation.rule().id(), violation.message());
        let shown = whole.chars().zip(1..).take_while(|(_, n)| f64::from(*n) * LETTER < room);
        let mut line: String = shown.map(|(letter, _)| letter).collect();
        if line.len() < whole.len() {
            line.pop();
            line.push('…');
        }
        let [title, line] = [&whole, &line].map(|text| escaped(text));
        put(
            out,
            format_args!("<text class=\"legend\" x=\"{left}\" y=\"{row:.0}\"><title>{title}</title>{line}</text>\n"),
        );
    }
    if violations.len() > ROWS {
        let (more, row) = (violations.len() - ROWS, row + ROW);
        put(out, format_args!("<text class=\"legend\" x=\"{left}\" y=\"{row:.0}\">… and {more} more</text>\n"));
    }
}

fn ends(map: &PlanarMap, h: HalfEdge<'_>) -> [Point; 2] {
    [h.origin(), h.target()].map(|v| map.point(v.index()))
}

/// Returns the place to show: the crossing of two edges, or else the middle of the places of the violation.
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

/// Returns the approximate crossing of two segments.
fn crossing([a, b]: [Point; 2], [c, d]: [Point; 2]) -> Option<Point> {
    let (u, v, w) = ([b.x - a.x, b.y - a.y], [d.x - c.x, d.y - c.y], [c.x - a.x, c.y - a.y]);
    let cross = |p: [f64; 2], q: [f64; 2]| p[0] * q[1] - p[1] * q[0];
    let t = cross(w, v) / cross(u, v);
    (0.0..=1.0).contains(&t).then(|| Point::new(a.x + t * u[0], a.y + t * u[1]))
}
