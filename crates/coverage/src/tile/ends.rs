//! Edges by their ends.

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
