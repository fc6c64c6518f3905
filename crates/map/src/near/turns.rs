//! G3 as a sum over corners, adding up only the changed ones.

use super::drawing::{Drawing, sorted};
use twinedge::validate::Start;
use twinedge::validate::near::changes::{Row, Time};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::{Orientation, orientation};

/// The two times, with the signs of their terms in the change of a sum.
const SIGNS: [(Time, i64); 2] = [(Time::Before, -1), (Time::After, 1)];

impl Drawing<'_> {
    /// Checks G3: an outer cycle turns once counter-clockwise, an inner one once clockwise.
    pub(super) fn winding(&self) -> Option<()> {
        // The corners at the start or end of these half-edges.
        let prev = |time: Time, h: usize| self.twin(time, h).map(|_| self.row(time, h).prev as usize);
        let before = SIGNS.iter().flat_map(|(time, _)| self.half_edges.iter().filter_map(|h| prev(*time, *h)));
        let half_edges = sorted(self.half_edges.iter().copied().chain(before).collect());
        let mut terms: Vec<(usize, i64)> = self.labels.iter().map(|b| (*b, 0)).collect();
        for h in half_edges {
            for (time, sign) in SIGNS {
                let Some(line) = self.line(time, h) else { continue };
                let next = self.line(time, self.row(time, h).next as usize)?;
                terms.push((self.label_of(time, h)?, sign * turn(line.points, next.points[1])));
            }
        }
        terms.sort_unstable();
        let turns = |time: Time, b: usize| {
            let label = self.label(time, b);
            match (label.is_live(), label.start()) {
                (true, Start::HalfEdge(_)) if label.inner().is_some() => -1,
                (true, Start::HalfEdge(_)) => 1,
                _ => 0,
            }
        };
        let keeps = |terms: &[(usize, i64)]| {
            let (b, difference) = (terms[0].0, terms.iter().map(|(_, term)| term).sum::<i64>());
            turns(Time::Before, b) + difference == turns(Time::After, b)
        };
        terms.chunk_by(|one, other| one.0 == other.0).all(keeps).then_some(())
    }
}

/// Returns 1 or −1 if the direction of a walk passes the direction of the x axis, counter-clockwise or clockwise, and 0
/// otherwise. The walk comes along a segment and goes on to a point, turning by less than half a turn, or clockwise by half a
/// turn.
fn turn([from, at]: [Point; 2], to: Point) -> i64 {
    let is_upper = |from: Point, to: Point| (to.y, to.x) > (from.y, from.x);
    match (is_upper(from, at), is_upper(at, to)) {
        (false, true) if orientation(from, at, to) == Orientation::CounterClockwise => 1,
        (true, false) if orientation(from, at, to) != Orientation::CounterClockwise => -1,
        _ => 0,
    }
}
