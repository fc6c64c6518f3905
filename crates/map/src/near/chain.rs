//! The winding number of closed walks around a point infinitely close to a half-edge.

use core::cmp::Ordering;
use rstar::{AABB, RTree, RTreeObject};
use rustc_hash::FxHashMap;
use twinedge_geometry::Point;
use twinedge_geometry::predicates::{Orientation, compare_lexicographic, orientation};
use twinedge_geometry::steps::count_step;

/// A point infinitely close to the start of a half-edge: on it, and then infinitely less far to its left.
#[derive(Clone, Copy, Debug)]
pub(super) struct Beside {
    pub(super) at: Point,
    /// The other end of the half-edge, at another point.
    pub(super) towards: Point,
}

impl Beside {
    /// Returns a point close to an isolated point, on an arbitrary side.
    pub(super) fn isolated(at: Point) -> Self {
        Self { at, towards: Point::new(if at.x == 0.0 { 1.0 } else { 0.0 }, at.y) }
    }

    /// Returns true if it is to the left of another point; it is never straight above or below.
    fn is_left_of(&self, p: Point) -> bool {
        let Self { at, towards } = self;
        let by_x = |a: f64, b: f64| a.partial_cmp(&b).unwrap_or(Ordering::Equal);
        // The left side of an upward half-edge faces left.
        by_x(at.x, p.x).then(by_x(towards.x, at.x)).then(by_x(at.y, towards.y)).is_lt()
    }

    /// Returns true if it is above a segment that runs from left to right and passes above or below it.
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

/// A segment with its ends in order. Its weight counts traversals from left to right minus traversals from right to left.
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

/// A sum of closed walks, without parts that cancel out.
#[derive(Debug, Default)]
pub(super) struct Chain {
    segments: Vec<WeightedSegment>,
}

impl Chain {
    pub(super) fn add(&mut self, [from, to]: [Point; 2], weight: i64) {
        let [from, to] = [from, to].map(|p| Point::new(p.x + 0.0, p.y + 0.0));
        let rises = compare_lexicographic(from, to).is_lt();
        let (low, high, weight) = if rises { (from, to, weight) } else { (to, from, -weight) };
        self.segments.push(WeightedSegment { low, high, weight });
    }

    /// Returns the sum of all added segments. O(k log k).
    pub(super) fn summed(mut self) -> SummedChain {
        self.cancel();
        self.straighten();
        self.cancel();
        SummedChain(RTree::bulk_load(self.segments))
    }

    /// Merges equal segments and drops those with weight 0.
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

    /// Joins collinear segments, for example of a split edge.
    fn straighten(&mut self) {
        let ends = self.segments.iter().enumerate().map(|(i, segment)| (segment.high.hash_key(), i));
        let ends: FxHashMap<(u64, u64), usize> = ends.collect();
        // From left to right, so that the segment behind is already joined to its predecessors.
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

#[derive(Debug)]
pub(super) struct SummedChain(RTree<WeightedSegment>);

impl SummedChain {
    /// Returns the bounding box, unless everything cancels out.
    pub(super) fn envelope(&self) -> Option<AABB<[f64; 2]>> {
        (self.0.size() > 0).then(|| self.0.root().envelope())
    }

    /// Returns the winding number of the chain around a point. O(log k), plus finding the segments below it in an R-tree.
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
