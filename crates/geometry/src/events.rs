//! The points of a drawing in lexicographic order, from left to right and upwards: the order in which a sweep line passes them.

use super::point::Point;
use super::predicates::compare_lexicographic;
use super::threads;
use crate::NIL;

/// A point, and its number.
#[derive(Clone, Copy)]
pub(super) struct Event {
    pub(super) at: Point,
    pub(super) vertex: u32,
}

/// The points in lexicographic order, and those in the same place by number.
///
/// Cuts the width into as many strips as there are points, deals the points out to them, and sorts each strip. That
/// is O(n) for points that are spread evenly, and O(n log n) at worst, as sorting.
pub(super) fn sorted(points: &[Point]) -> Vec<Event> {
    let (left, right) = points.iter().fold((f64::MAX, f64::MIN), |(left, right), p| (left.min(p.x), right.max(p.x)));
    let per_width = if left < right { points.len() as f64 / (right - left) } else { 0.0 };
    // Rounding may move a point to a neighbouring strip, but never past another point: it is monotone.
    #[expect(clippy::cast_sign_loss, reason = "x is not less than left")]
    let strip = |p: Point| (((p.x - left) * per_width) as usize).min(points.len());

    // Counting sort, two places ahead: summed up, `first[i + 1]` is where those of strip i begin, and filing them moves it to where they end.
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

/// Turns numbers into the sums of all numbers up to them.
pub(super) fn accumulate(numbers: &mut [u32]) {
    let mut sum = 0;
    for number in numbers {
        sum += *number;
        *number = sum;
    }
}
