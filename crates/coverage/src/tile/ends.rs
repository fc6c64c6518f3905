//! Edges by their ends.

use core::cmp::Ordering;
use twinedge_geometry::Point;

/// An edge by its ends, the lexicographically smaller one first.
pub(super) type Ends = [Point; 2];

/// A total order of points; of finite ones without −0 the lexicographical one.
pub(super) fn compare_points(a: Point, b: Point) -> Ordering {
    a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y))
}

/// The order of edges by their ends.
pub(super) fn compare_edges(e: &Ends, f: &Ends) -> Ordering {
    compare_points(e[0], f[0]).then_with(|| compare_points(e[1], f[1]))
}
