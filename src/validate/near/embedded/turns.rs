//! G2 and G3 as sums over corners, of which only those that have changed are added up.

use super::drawing::{Drawing, sorted};
use crate::geometry::Point;
use crate::geometry::predicates::{Orientation, compare_angle, orientation};
use crate::validate::near::column::{TIMES, Time};
use crate::validate::structure::Start;

/// What has come to the sum of each group, by its number, sorted: the change of the sum.
fn differences(mut terms: Vec<(usize, i64)>) -> Vec<(usize, i64)> {
    terms.sort_unstable();
    terms.dedup_by(|term, sum| {
        let same = term.0 == sum.0;
        if same {
            sum.1 += term.1;
        }
        same
    });
    terms
}

/// The sign with which a term counts.
const fn sign(time: Time) -> i64 {
    match time {
        Time::Before => -1,
        Time::After => 1,
    }
}

impl Drawing<'_> {
    /// These half-edges, and of each the one that a step leads to, before and after.
    fn with(&self, step: impl Fn(Time, usize) -> Option<usize>) -> Vec<usize> {
        let others = TIMES.into_iter().flat_map(|time| self.half_edges.iter().map(move |h| (time, *h)));
        let others: Vec<usize> = others.filter_map(|(time, h)| step(time, h)).collect();
        sorted(self.half_edges.iter().copied().chain(others).collect())
    }

    fn prev(&self, time: Time, h: usize) -> Option<usize> {
        self.twin(time, h).map(|_| self.row(time, h).prev as usize)
    }

    /// G2: turning clockwise once around a vertex, the angle rises once at most.
    pub(super) fn angles(&self) -> Option<()> {
        let mut terms = Vec::new();
        for h in self.with(|time, h| self.twin(time, self.prev(time, h)?)) {
            for time in TIMES {
                let Some(line) = self.line(time, h) else { continue };
                let after = self.line(time, self.clockwise(time, h)?)?;
                let rises = compare_angle(line.points[0], line.points[1], after.points[1]).is_lt();
                terms.push((line.vertices[0] as usize, sign(time) * i64::from(rises)));
            }
        }
        let keeps = |(v, difference): &(usize, i64)| {
            let leaving = self.vertex(Time::Before, *v).leaving as usize;
            let turns = self.clockwise(Time::Before, leaving).is_some_and(|next| next != leaving);
            i64::from(turns) + difference <= 1
        };
        differences(terms).iter().all(keeps).then_some(())
    }

    /// G3: an outer cycle turns once counter-clockwise, an inner one once clockwise.
    pub(super) fn winding(&self) -> Option<()> {
        let mut terms: Vec<(usize, i64)> = self.labels.iter().map(|b| (*b, 0)).collect();
        for h in self.with(|time, h| self.prev(time, h)) {
            for time in TIMES {
                let Some(line) = self.line(time, h) else { continue };
                let next = self.line(time, self.row(time, h).next as usize)?;
                terms.push((self.label_of(time, h)?, sign(time) * turn(line.points, next.points[1])));
            }
        }
        let turns = |time: Time, b: usize| {
            let label = self.label(time, b);
            match (label.is_live(), label.start()) {
                (true, Start::HalfEdge(_)) if label.inner().is_some() => -1,
                (true, Start::HalfEdge(_)) => 1,
                _ => 0,
            }
        };
        let keeps = |(b, difference): &(usize, i64)| turns(Time::Before, *b) + difference == turns(Time::After, *b);
        differences(terms).iter().all(keeps).then_some(())
    }
}

/// How often the direction of a walk passes that of the x axis where it comes along a segment and goes on to a point, turning
/// by less than half a turn, or clockwise by half a turn: 1 if it does so counter-clockwise, −1 clockwise.
fn turn([from, at]: [Point; 2], to: Point) -> i64 {
    let is_upper = |from: Point, to: Point| (to.y, to.x) > (from.y, from.x);
    match (is_upper(from, at), is_upper(at, to)) {
        (false, true) if orientation(from, at, to) == Orientation::CounterClockwise => 1,
        (true, false) if orientation(from, at, to) != Orientation::CounterClockwise => -1,
        _ => 0,
    }
}

#[cfg(test)]
mod tests {
    use super::{Point, turn};

    /// The turns of a closed walk.
    fn turns(walk: &[[f64; 2]]) -> i64 {
        let at = |i: usize| Point::from(walk[i % walk.len()]);
        (0..walk.len()).map(|i| turn([at(i), at(i + 1)], at(i + 2))).sum()
    }

    #[test]
    fn a_walk_around_turns_once_wherever_it_begins() {
        let shapes: [&[[f64; 2]]; 4] = [
            &[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]],
            &[[0.0, 0.0], [4.0, 1.0], [2.0, 1.0], [5.0, 3.0], [1.0, 4.0], [2.0, 2.0]],
            // Collinear corners.
            &[[0.0, 0.0], [2.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [0.0, 1.0]],
            &[[0.0, 0.0], [1.0, -3.0], [2.0, -3.0], [2.0, -2.0], [1.0, -2.5]],
        ];
        for shape in shapes {
            for mirrored in [false, true] {
                let mut walk: Vec<[f64; 2]> = shape.to_vec();
                for _ in 0..4 {
                    for [x, y] in &mut walk {
                        (*x, *y) = (-*y, *x);
                    }
                    let there: Vec<[f64; 2]> =
                        if mirrored { walk.iter().rev().copied().collect() } else { walk.clone() };
                    assert_eq!(turns(&there), if mirrored { -1 } else { 1 }, "{there:?}");
                }
            }
        }
    }

    #[test]
    fn a_spike_into_the_face_makes_no_difference() {
        let [corner, inside, outside] = [[4.0, 4.0], [3.0, 3.0], [5.0, 5.0]];
        assert_eq!(turns(&[[0.0, 0.0], [4.0, 0.0], corner, inside, corner, [0.0, 4.0]]), 1);
        assert_eq!(turns(&[[0.0, 0.0], [0.0, 4.0], corner, outside, corner, [4.0, 0.0]]), -1);
    }

    #[test]
    fn there_and_back_is_a_turn_clockwise() {
        for [x, y] in [[1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [-1.0, 0.0], [-1.0, -1.0], [0.0, -1.0]] {
            assert_eq!(turns(&[[0.0, 0.0], [x, y]]), -1);
        }
    }

    #[test]
    fn a_star_of_five_turns_twice() {
        let star = [[0.0, 3.0], [-2.0, -3.0], [3.0, 1.0], [-3.0, 1.0], [2.0, -3.0]];
        assert_eq!(turns(&star), 2);
    }
}
