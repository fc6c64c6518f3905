//! Quadrangles that close narrow spaces between two borders, made from stretches that face each other.
//!
//! ```text
//!   ───────p0─────────p1──────   a stretch of one border, with the space to its left
//!          │ filled   │
//!   ───────q0─────────q1──────   the nearest points on stretches of the other, which run the other way
//! ```

use twinedge_coverage::Finding;
use twinedge_geometry::Point;
use twinedge_map::Shape;

/// Slightly more than the width, as positions on borders are rounded.
const TOLERANCE: f64 = 1.0 + 1e-9;

/// Returns the quadrangles for near misses of at most this width. O(k²) for the k stretches of each.
pub(super) fn fillers(near_misses: &[Finding], width: f64) -> Vec<Shape> {
    let of_one = |stretches: &[[Point; 2]]| {
        let quadrangles = stretches.iter().filter_map(|stretch| quadrangle(*stretch, stretches, width * TOLERANCE));
        quadrangles.collect::<Vec<_>>()
    };
    near_misses.iter().flat_map(|finding| of_one(&finding.stretches)).collect()
}

fn quadrangle(stretch: [Point; 2], all: &[[Point; 2]], width: f64) -> Option<Shape> {
    let [p0, p1] = stretch;
    let across = |p: Point| {
        let others = all.iter().filter(|other| run_against(stretch, **other)).map(|other| nearest(p, *other));
        let distance = |q: &Point| (q.x - p.x).hypot(q.y - p.y);
        others.min_by(|a, b| distance(a).total_cmp(&distance(b))).filter(|q| distance(q) <= width)
    };
    let mut ring = vec![p0, p1, across(p1)?, across(p0)?];
    ring.dedup();
    if ring.len() > 1 && ring.first() == ring.last() {
        ring.pop();
    }
    ring.extend(ring.first().copied());
    (ring.len() > 3).then(|| Shape::Polygon(vec![ring]))
}

fn run_against([a, b]: [Point; 2], [c, d]: [Point; 2]) -> bool {
    (b.x - a.x) * (d.x - c.x) + (b.y - a.y) * (d.y - c.y) < 0.0
}

/// Returns the nearest point of a segment, rounded.
fn nearest(p: Point, [a, b]: [Point; 2]) -> Point {
    let (x, y) = (b.x - a.x, b.y - a.y);
    let part = ((p.x - a.x) * x + (p.y - a.y) * y) / (x * x + y * y);
    if part <= 0.0 || !part.is_finite() {
        a
    } else if part >= 1.0 {
        b
    } else {
        Point::new(a.x + part * x, a.y + part * y)
    }
}
