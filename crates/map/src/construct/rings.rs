//! The shape of one ring: its turning direction, where it touches itself, and where it turns straight back.

use super::gathered::{Dart, origin, target};
use core::cmp::Ordering;
use twinedge_geometry::Point;
use twinedge_geometry::predicates::{Orientation, compare_lexicographic, orientation};

/// A ring and its future half-edges.
pub(super) struct Ring<'a> {
    /// The points of the input.
    pub(super) input: &'a [Point],
    /// The position of the point where each half-edge starts.
    pub(super) starts: &'a [u32],
    /// False if no two half-edges start at one vertex.
    pub(super) returns: bool,
    pub(super) points: &'a [Point],
    pub(super) segments: &'a [[u32; 2]],
    pub(super) darts: &'a [Dart],
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

/// Returns true if a path from `a` over `b` to `c` turns straight back at `b`.
#[expect(clippy::needless_bitwise_bool, reason = "which condition fails is unforeseeable, so there is one branch")]
fn is_spike(a: Point, b: Point, c: Point) -> bool {
    // Half-open quadrants around `b` contain no two opposite directions, so collinear points of one quadrant lie in one direction.
    let same_quadrant = ((a.x < b.x) == (c.x < b.x)) & ((a.y < b.y) == (c.y < b.y));
    same_quadrant && orientation(a, b, c) == Orientation::Collinear
}

impl Ring<'_> {
    /// Computes the shape of the ring. O(n), or O(n log n) if it visits a vertex twice.
    pub(super) fn shape(&self) -> RingShape {
        let mut shape = RingShape::default();
        let [first, second, rest @ ..] = self.starts else { return shape };
        if rest.is_empty() {
            return shape;
        }
        let corner = |start: u32| self.input[start as usize];
        let (mut a, mut b, mut at) = (corner(*first), corner(*second), *second);
        // The lexicographically smallest corner between two others.
        let mut lowest = [a, b, a];
        for start in rest.iter().chain([first, second]) {
            let c = corner(*start);
            if is_spike(a, b, c) {
                shape.spikes.push(at);
            }
            if b <= lowest[1] {
                lowest = [a, b, c];
            }
            (a, b, at) = (b, c, *start);
        }
        shape.touches = if self.returns { self.touches() } else { None };
        shape.counter_clockwise = if shape.touches.is_none() && shape.spikes.is_empty() {
            // Nothing lies to the left of the corner, so the turn there has the direction of the whole ring.
            let [a, b, c] = lowest;
            Some(orientation(a, b, c) == Orientation::CounterClockwise)
        } else {
            self.turn()
        };
        shape
    }

    /// Returns the first position where the ring, without its spikes, visits a point again.
    fn touches(&self) -> Option<u32> {
        let mut trimmed: Vec<(u32, u32)> = Vec::with_capacity(self.darts.len());
        for (dart, start) in self.darts.iter().zip(self.starts) {
            let v = origin(self.segments, *dart);
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

    /// Returns true if the ring turns counter-clockwise. Consider the segments that the ring uses an odd number of times. The
    /// least steep of them at the smallest point has the outside below; the ring turns so if it runs to the right there.
    fn turn(&self) -> Option<bool> {
        let mut sorted = self.darts.to_vec();
        sorted.sort_unstable();
        let odd = sorted.chunk_by(|a, b| a >> 1 == b >> 1).filter(|same| same.len() % 2 == 1);
        // Of an odd number of uses, the middle one in sorted order has the direction used more often.
        let net = odd.map(|same| same[same.len() / 2]);
        let rises = |d: Dart| {
            let [a, b] = [origin(self.segments, d), target(self.segments, d)].map(|v| self.points[v as usize]);
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
