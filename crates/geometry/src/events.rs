//! The points of a drawing in lexicographic order, left to right and upwards: the order of a sweep line.

use super::point::Point;
use super::predicates::compare_lexicographic;
use super::threads;
use crate::NIL;

#[derive(Clone, Copy)]
pub(super) struct Event {
    pub(super) at: Point,
    pub(super) vertex: u32,
}

/// Sorts the points lexicographically, and equal points by number.
///
/// Distributes the points to one strip each on average, and sorts each strip. O(n) for evenly spread points, O(n log n) at worst.
pub(super) fn sorted(points: &[Point]) -> Vec<Event> {
    let (left, right) = points.iter().fold((f64::MAX, f64::MIN), |(left, right), p| (left.min(p.x), right.max(p.x)));
    let per_width = if left < right { points.len() as f64 / (right - left) } else { 0.0 };
    // Rounding may move a point to a neighbouring strip, but never past another point: it is monotone.
    #[expect(clippy::cast_sign_loss, reason = "x is not less than left")]
    let strip = |p: Point| (((p.x - left) * per_width) as usize).min(points.len());

    // Counting sort, two entries ahead: after summation, `first[i + 1]` is the start of strip i, and filing moves it to the end.
    let mut first = vec![0; points.len() + 3];
    for &p in points {
        first[strip(p) + 2] += 1;
    }
    accumulate(&mut first);
    let mut events = vec![Event { at: Point::new(0.0, 0.0), vertex: NIL }; points.len()];
    for (vertex, &at) in (0..).zip(points) {
        let place = &mut first[strip(at) + 1];
        events[*place as usize] = Event { at, vertex };
        *place += 1;
    }
    for strip in first.windows(2) {
        let events = &mut events[strip[0] as usize..strip[1] as usize];
        threads::sort_unstable_by(events, |a, b| compare_lexicographic(a.at, b.at).then(a.vertex.cmp(&b.vertex)));
    }
    events
}

pub(super) fn accumulate(numbers: &mut [u32]) {
    let mut sum = 0;
    for number in numbers {
        sum += *number;
        *number = sum;
    }
}
