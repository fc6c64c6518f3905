//! Points and edges by their ends.

use core::cmp::Ordering;
use twinedge_geometry::Point;

/// An edge by its ends, the lexicographically smaller one first.
pub(super) type Ends = [Point; 2];

/// Compares points by a total order: lexicographical for finite points without −0.
pub(super) fn compare_points(a: Point, b: Point) -> Ordering {
    a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y))
}

/// Compares edges by their ends.
pub(super) fn compare_edges(e: &Ends, f: &Ends) -> Ordering {
    compare_points(e[0], f[0]).then_with(|| compare_points(e[1], f[1]))
}

pub(super) fn in_order([a, b]: Ends) -> Ends {
    if compare_points(a, b).is_le() { [a, b] } else { [b, a] }
}

/// Returns the ends of an edge with the lower one first.
pub(super) fn upwards([a, b]: Ends) -> Ends {
    if a.y < b.y { [a, b] } else { [b, a] }
}

pub(super) fn unsigned(p: Point) -> Point {
    Point::new(p.x + 0.0, p.y + 0.0)
}

/// Returns the corners of the box around some points.
pub(super) fn around(mut points: impl Iterator<Item = Point>) -> Option<[Point; 2]> {
    let first = points.next()?;
    Some(points.fold([first; 2], |[low, high], p| {
        [Point::new(low.x.min(p.x), low.y.min(p.y)), Point::new(high.x.max(p.x), high.y.max(p.y))]
    }))
}
