//! The shape of one ring: its turning direction, where it touches itself, and where it turns straight back.

use super::gathered::{Dart, origin, target};
use core::cmp::Ordering;
use twinedge_geometry::Point;
use twinedge_geometry::predicates::{Orientation, compare_angle, compare_lexicographic, orientation};

/// The future half-edges of a ring, each with the position of its starting point.
pub(super) struct Ring<'a> {
    pub(super) points: &'a [Point],
    pub(super) segments: &'a [[u32; 2]],
    pub(super) darts: &'a [Dart],
    pub(super) starts: &'a [u32],
}

#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct RingShape {
    /// `None` if the ring encloses nothing.
    pub(super) counter_clockwise: Option<bool>,
    /// The position of the first point that the ring visits again.
    pub(super) touches: Option<u32>,
    /// The positions of the points where the ring turns straight back.
    pub(super) spikes: Vec<u32>,
}

impl Ring<'_> {
    fn tail(&self, i: usize) -> u32 {
        origin(self.segments, self.darts[i % self.darts.len()])
    }

    fn point(&self, vertex: u32) -> Point {
        self.points[vertex as usize]
    }

    /// Computes the shape of the ring. O(n log n).
    pub(super) fn shape(&self) -> RingShape {
        let count = self.darts.len();
        if count < 3 {
            return RingShape::default();
        }
        let mut shape = RingShape::default();
        for i in 0..count {
            let [a, b, c] = [i, i + 1, i + 2].map(|i| self.tail(i));
            let back = || compare_angle(self.point(b), self.point(a), self.point(c)) == Ordering::Equal;
            if a == c || back() {
                shape.spikes.push(self.starts[(i + 1) % count]);
            }
        }
        shape.touches = self.touches();
        shape.counter_clockwise =
            if shape.touches.is_none() && shape.spikes.is_empty() { self.simple_turn() } else { self.turn() };
        shape
    }

    /// Returns the first position where the ring, without its spikes, visits a point again.
    fn touches(&self) -> Option<u32> {
        let mut trimmed: Vec<(u32, u32)> = Vec::with_capacity(self.darts.len());
        for (i, start) in self.starts.iter().enumerate() {
            let v = self.tail(i);
            match trimmed.iter().nth_back(1) {
                Some((before, _)) if *before == v => drop(trimmed.pop()),
                _ => trimmed.push((v, *start)),
            }
        }
        // Remove spikes that run across the end of the list.
        let mut rest = &mut trimmed[..];
        while let [first, second, .., last_but_one, last] = *rest {
            let count = rest.len();
            rest = if second.0 == last.0 {
                &mut rest[1..count - 1]
            } else if first.0 == last_but_one.0 {
                &mut rest[..count - 2]
            } else {
                break;
            };
        }
        rest.sort_unstable();
        rest.windows(2).filter(|pair| pair[0].0 == pair[1].0).map(|pair| pair[1].1).min()
    }

    /// Returns true if a simple ring turns counter-clockwise. At the lexicographically smallest point nothing lies to the left,
    /// so the turn there has the direction of the whole ring.
    fn simple_turn(&self) -> Option<bool> {
        let low = (0..self.darts.len())
            .min_by(|i, j| compare_lexicographic(self.point(self.tail(*i)), self.point(self.tail(*j))))?;
        let [a, b, c] = [low + self.darts.len() - 1, low, low + 1].map(|i| self.point(self.tail(i)));
        Some(orientation(a, b, c) == Orientation::CounterClockwise)
    }

    /// Returns true if the ring turns counter-clockwise. Consider the segments that the ring uses an odd number of times. The
    /// least steep of them at the smallest point has the outside below; the ring turns so if it runs to the right there.
    fn turn(&self) -> Option<bool> {
        let mut sorted = self.darts.to_vec();
        sorted.sort_unstable();
        let odd = sorted.chunk_by(|a, b| a >> 1 == b >> 1).filter(|same| same.len() % 2 == 1);
        // Of an odd number of uses, the middle one in sorted order has the direction used more often.
        let net = odd.map(|same| same[same.len() / 2]);
        let rises = |d: Dart| {
            let [a, b] = [origin(self.segments, d), target(self.segments, d)].map(|v| self.point(v));
            if compare_lexicographic(a, b) == Ordering::Less { (a, b, true) } else { (b, a, false) }
        };
        let lowest = net.map(rises).min_by(|(low, high, _), (other, head, _)| {
            compare_lexicographic(*low, *other).then_with(|| match orientation(*low, *high, *head) {
                Orientation::CounterClockwise => Ordering::Less,
                Orientation::Collinear => Ordering::Equal,
                Orientation::Clockwise => Ordering::Greater,
            })
        });
        lowest.map(|(.., rightwards)| rightwards)
    }
}
