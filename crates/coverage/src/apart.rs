//! Rings that meet nowhere, as in most features: one sweep verifies this and finds their nesting.

use super::rings::Ring;
use twinedge_geometry::Point;
use twinedge_geometry::predicates::{Meeting, Orientation, compare_lexicographic, meeting, orientation};
use twinedge_geometry::sweep::sweep_plane;

/// For a single ring of at most this many points, all pairs of segments are tried.
const FEW: usize = if cfg!(test) { 4 } else { 12 };

/// For each ring, the rings that contain it, in order; `None` if rings meet or a ring meets itself. O(n log n) for n points.
pub(super) fn containers(rings: &[Ring]) -> Option<Vec<Vec<usize>>> {
    match rings {
        [] => return Some(Vec::new()),
        [ring] if ring.points.len() <= FEW => return is_simple(&ring.points).then(|| vec![Vec::new()]),
        _ => {}
    }
    let points: Vec<Point> = rings.iter().flat_map(|ring| &ring.points).copied().collect();
    let (mut segments, mut starts) = (Vec::with_capacity(points.len()), Vec::new());
    let (mut lowest, mut is_counter_clockwise) = (Vec::new(), Vec::new());
    for ring in rings {
        let first = segments.len() as u32;
        let after = first + ring.points.len() as u32;
        segments.extend((first..after).map(|from| [from, if from + 1 < after { from + 1 } else { first }]));
        starts.push(first);
        let count = ring.points.len();
        let low = (0..count).min_by(|a, b| compare_lexicographic(ring.points[*a], ring.points[*b]))?;
        let [before, at, behind] = [low + count - 1, low, low + 1].map(|i| ring.points[i % count]);
        is_counter_clockwise.push(orientation(before, at, behind) == Orientation::CounterClockwise);
        lowest.push(first + low as u32);
    }
    // Other checks report coordinates that are out of range.
    let below = sweep_plane(&points, &segments).ok()??.of(&lowest);
    let at = |point: u32| points[point as usize];
    // Left to right, so the nesting of the ring below is known.
    let mut order: Vec<usize> = (0..rings.len()).collect();
    order.sort_by(|a, b| compare_lexicographic(at(lowest[*a]), at(lowest[*b])));
    let mut containers = vec![Vec::new(); rings.len()];
    for ring in order {
        let Some(segment) = below[ring] else { continue };
        let other = starts.partition_point(|start| *start <= segment) - 1;
        let [from, to] = segments[segment as usize].map(at);
        let rises = compare_lexicographic(from, to).is_lt();
        let mut of: Vec<usize> = containers[other].clone();
        // The inside is to the left of a counter-clockwise ring.
        if rises == is_counter_clockwise[other] {
            of.push(other);
            of.sort_unstable();
        }
        containers[ring] = of;
    }
    Some(containers)
}

/// Returns true if the segments of a ring meet only where one follows the other.
fn is_simple(ring: &[Point]) -> bool {
    let count = ring.len();
    let segment = |i: usize| [ring[i], ring[(i + 1) % count]];
    (0..count).all(|i| {
        (i + 1..count).all(|j| {
            let ([a, b], [c, d]) = (segment(i), segment(j));
            let follows = j == i + 1 || i == 0 && j == count - 1;
            meeting(a, b, c, d) == if follows { Meeting::SharedEndpoint } else { Meeting::Disjoint }
        })
    })
}

#[cfg(test)]
mod tests;
