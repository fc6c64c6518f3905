//! The place to look at.

use super::Position;

/// Returns the crossing of two segments, given their four ends, or else the middle of the points.
///
/// ```
/// use twinedge_diagnosis::middle;
/// assert_eq!(middle(&[[0.0, 0.0], [4.0, 4.0], [0.0, 2.0], [4.0, 2.0]]), Some([2.0, 2.0]));
/// // The lines of these two cross, and they do not.
/// assert_eq!(middle(&[[0.0, 0.0], [1.0, 1.0], [0.0, 3.0], [3.0, 2.0]]), Some([1.0, 1.5]));
/// assert_eq!(middle(&[[2.0, 0.0], [4.0, 0.0]]), Some([3.0, 0.0]));
/// assert_eq!(middle(&[]), None);
/// ```
#[must_use]
pub fn middle(points: &[Position]) -> Option<Position> {
    if let [a, b, c, d] = *points
        && let Some(crossing) = crossing([a, b], [c, d])
    {
        return Some(crossing);
    }
    let count = points.len() as f64;
    let sum = points.iter().fold([0.0; 2], |sum, p| [sum[0] + p[0] / count, sum[1] + p[1] / count]);
    (!points.is_empty()).then_some(sum)
}

/// Returns the approximate crossing of two segments.
fn crossing([a, b]: [Position; 2], [c, d]: [Position; 2]) -> Option<Position> {
    let [u, v, w] = [(a, b), (c, d), (a, c)].map(|(p, q)| [q[0] - p[0], q[1] - p[1]]);
    let cross = |p: Position, q: Position| p[0] * q[1] - p[1] * q[0];
    let (s, t) = (cross(w, u) / cross(u, v), cross(w, v) / cross(u, v));
    let is_inside = |t: f64| (0.0..=1.0).contains(&t);
    (is_inside(s) && is_inside(t)).then(|| [a[0] + t * u[0], a[1] + t * u[1]])
}
