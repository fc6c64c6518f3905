//! The number of times that closed walks go around a point that is as close to a half-edge as can be.

use core::cmp::Ordering;
use rstar::{AABB, RTree, RTreeObject};
use rustc_hash::FxHashMap;
use twinedge_geometry::Point;
use twinedge_geometry::predicates::{Orientation, compare_lexicographic, orientation};
use twinedge_geometry::steps::count_step;

/// A point infinitely close to the beginning of a half-edge, on it, and then infinitely less far to its left.
#[derive(Clone, Copy, Debug)]
pub(super) struct Beside {
    pub(super) at: Point,
    /// The other end of the half-edge, which is elsewhere.
    pub(super) towards: Point,
}

impl Beside {
    /// Close to an isolated point, on some side of it.
    pub(super) fn isolated(at: Point) -> Self {
        Self { at, towards: Point::new(if at.x == 0.0 { 1.0 } else { 0.0 }, at.y) }
    }

    /// Returns true if it is to the left of another point; it is never straight above or below.
    fn is_left_of(&self, p: Point) -> bool {
        let Self { at, towards } = self;
        let by_x = |a: f64, b: f64| a.partial_cmp(&b).unwrap_or(Ordering::Equal);
        // To the left of upwards is to the left.
        by_x(at.x, p.x).then(by_x(towards.x, at.x)).then(by_x(at.y, towards.y)).is_lt()
    }

    /// Returns true if it is above a segment from left to right that passes above or below it.
    fn is_above(&self, low: Point, high: Point) -> bool {
        let above = match orientation(low, high, self.at) {
            Orientation::Collinear => orientation(low, high, self.towards),
            side => side,
        };
        match above {
            Orientation::CounterClockwise => true,
            Orientation::Clockwise => false,
            Orientation::Collinear => compare_lexicographic(self.at, self.towards).is_lt(),
        }
    }
}

/// A segment with its ends in order, and how often walks take it from left to right, less how often from right to left.
#[derive(Clone, Copy, Debug)]
struct WeightedSegment {
    low: Point,
    high: Point,
    weight: i64,
}

impl RTreeObject for WeightedSegment {
    type Envelope = AABB<[f64; 2]>;

    fn envelope(&self) -> Self::Envelope {
        AABB::from_corners(self.low.into(), self.high.into())
    }
}

/// A sum of closed walks. What cancels out is left out.
#[derive(Debug, Default)]
pub(super) struct Chain {
    segments: Vec<WeightedSegment>,
}

impl Chain {
    /// Adds a segment, as often as `weight` says.
    pub(super) fn add(&mut self, [from, to]: [Point; 2], weight: i64) {
        let [from, to] = [from, to].map(|p| Point::new(p.x + 0.0, p.y + 0.0));
        let rises = compare_lexicographic(from, to).is_lt();
        let (low, high, weight) = if rises { (from, to, weight) } else { (to, from, -weight) };
        self.segments.push(WeightedSegment { low, high, weight });
    }

    /// The sum of what was added. O(k log k).
    pub(super) fn summed(mut self) -> SummedChain {
        self.cancel();
        self.straighten();
        self.cancel();
        SummedChain(RTree::bulk_load(self.segments))
    }

    /// Each segment once.
    fn cancel(&mut self) {
        self.segments.sort_by(|a, b| compare_lexicographic(a.low, b.low).then(compare_lexicographic(a.high, b.high)));
        self.segments.dedup_by(|next, sum| {
            let same = next.low == sum.low && next.high == sum.high;
            if same {
                sum.weight += next.weight;
            }
            same
        });
        self.segments.retain(|segment| segment.weight != 0);
    }

    /// Joins segments that go on straight, as where an edge was split.
    fn straighten(&mut self) {
        let ends = self.segments.iter().enumerate().map(|(i, segment)| (segment.high.hash_key(), i));
        let ends: FxHashMap<(u64, u64), usize> = ends.collect();
        // From left to right, so that what is behind a segment is joined to it already.
        for i in 0..self.segments.len() {
            let after = self.segments[i];
            let Some(j) = ends.get(&after.low.hash_key()) else { continue };
            let before = self.segments[*j];
            let straight = orientation(before.low, after.low, after.high) == Orientation::Collinear;
            if straight && before.weight == after.weight {
                self.segments[i].low = before.low;
                self.segments[*j].weight = 0;
            }
        }
    }
}

/// A sum of closed walks, to be asked.
#[derive(Debug)]
pub(super) struct SummedChain(RTree<WeightedSegment>);

impl SummedChain {
    /// The box around it, unless nothing is left of it.
    pub(super) fn envelope(&self) -> Option<AABB<[f64; 2]>> {
        (self.0.size() > 0).then(|| self.0.root().envelope())
    }

    /// The number of times that it goes around a point counter-clockwise. O(log k), and what an R-tree takes to find what is below the point.
    pub(super) fn around(&self, p: Beside) -> i64 {
        let below = AABB::from_corners([p.at.x, f64::MIN], p.at.into());
        let passes = |segment: &&WeightedSegment| {
            count_step();
            !p.is_left_of(segment.low) && p.is_left_of(segment.high) && p.is_above(segment.low, segment.high)
        };
        self.0.locate_in_envelope_intersecting(below).filter(passes).map(|segment| segment.weight).sum()
    }
}

#[cfg(test)]
mod tests;
