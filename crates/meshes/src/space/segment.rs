//! Segments and triangles in space: exact tests.

use super::places::{Corner, Place, axis_of, side, turn};
use std::cmp::Ordering;

/// Returns true if a segment and a triangle with area have a point in common.
///
/// Source: P. Guigue, O. Devillers, "Fast and Robust Triangle-Triangle Overlap Test Using Orientation Predicates", Journal of
/// Graphics Tools 8 (2003), 25–32: an edge outside the plane meets the triangle unless it sees two sides from different sides.
pub(super) fn meets([p, q]: [Place; 2], triangle: [Place; 3]) -> bool {
    let sides = [side(triangle, p), side(triangle, q)];
    match sides {
        [Ordering::Equal, Ordering::Equal] => meets_in_plane([p, q], triangle),
        [a, b] if a == b => false,
        _ => {
            let seen = sides_seen([p, q], triangle);
            !(seen.contains(&Ordering::Less) && seen.contains(&Ordering::Greater))
        }
    }
}

/// Returns the sides on which the line through two places passes the sides of a triangle.
pub(super) fn sides_seen([p, q]: [Place; 2], [a, b, c]: [Place; 3]) -> [Ordering; 3] {
    [[a, b], [b, c], [c, a]].map(|[from, to]| side([p, q, from], to))
}

fn meets_in_plane([p, q]: [Place; 2], triangle: [Place; 3]) -> bool {
    let Some(axis) = axis_of(triangle) else { return false };
    let [a, b, c] = triangle;
    let is_inside = |p: Place| {
        let turns = [[a, b], [b, c], [c, a]].map(|[from, to]| turn([from, to, p], axis));
        !(turns.contains(&Ordering::Less) && turns.contains(&Ordering::Greater))
    };
    let crosses = |[a, b]: [Place; 2]| {
        let across = |[p, q]: [Place; 2], [a, b]: [Place; 2]| turn([p, q, a], axis) != turn([p, q, b], axis);
        // Ends that touch lie inside, or are found from the other segment.
        across([p, q], [a, b]) && across([a, b], [p, q])
    };
    is_inside(p) || is_inside(q) || [[a, b], [b, c], [c, a]].into_iter().any(crosses)
}

/// Returns true if two triangles with area have a common point outside their common corners and edges.
pub(super) fn cross(one: &[Corner; 3], other: &[Corner; 3]) -> bool {
    let is_in = |corner: &Corner, triangle: &[Corner; 3]| triangle.iter().any(|it| it.number == corner.number);
    let places = |triangle: &[Corner; 3]| triangle.map(|corner| corner.at);
    let shared: Vec<Corner> = one.iter().filter(|corner| is_in(corner, other)).copied().collect();
    // The corners of a triangle that are not shared.
    let free = |triangle: &[Corner; 3], than: &[Corner; 3]| -> Vec<Place> {
        triangle.iter().filter(|corner| !is_in(corner, than)).map(|corner| corner.at).collect()
    };
    match shared[..] {
        [] => {
            let meet = |one: &[Corner; 3], other: &[Corner; 3]| {
                let [a, b, c] = places(one);
                [[a, b], [b, c], [c, a]].into_iter().any(|edge| meets(edge, places(other)))
            };
            meet(one, other) || meet(other, one)
        }
        // Both are convex, so the segment from the shared corner to any common point leads out through one of the opposite sides.
        [_] => [(one, other), (other, one)].into_iter().any(|(triangle, than)| match free(triangle, than)[..] {
            [p, q] => meets([p, q], places(than)),
            _ => false,
        }),
        [a, b] => match (&free(one, other)[..], &free(other, one)[..]) {
            ([c], [d]) if side([a.at, b.at, *c], *d).is_eq() => axis_of([a.at, b.at, *c])
                .is_some_and(|axis| turn([a.at, b.at, *c], axis) == turn([a.at, b.at, *d], axis)),
            _ => false,
        },
        _ => true,
    }
}
