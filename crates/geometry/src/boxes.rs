//! Boxes in a tree packed along a [curve](super::curve), and pairs of boxes that meet.
//!
//! The boxes themselves are not stored. The tree contains the number of each box, a box around every eight of them, and so on for
//! each level above: nine bytes for each box.

use super::bounds::Bounds;
use super::curve::Curve;
use super::point::Point;
use super::threads;
use core::ops::Range;

const FAN: usize = 8;

/// Below this number of groups, the work is not divided among threads.
const MANY: usize = if cfg!(test) { 2 } else { 1 << 11 };

/// Numbered boxes.
pub struct Boxes<'a> {
    of: &'a (dyn Fn(u32) -> Bounds + Sync),
    order: Vec<u32>,
    /// The boxes around the groups of each level, lowest level first.
    levels: Vec<Vec<Bounds>>,
}

impl<'a> Boxes<'a> {
    /// Packs the boxes with these numbers. O(n log n).
    pub fn new(numbers: impl Iterator<Item = u32>, of: &'a (dyn Fn(u32) -> Bounds + Sync)) -> Self {
        Self::packed(numbers.map(|number| (0, number)).collect(), of)
    }

    /// Packs numbers, computing the position of each on the curve.
    fn packed(mut places: Vec<(u32, u32)>, of: &'a (dyn Fn(u32) -> Bounds + Sync)) -> Self {
        let all = places.iter().map(|(_, number)| of(*number)).reduce(Bounds::joined);
        if let Some(curve) = all.map(Curve::through) {
            for (place, number) in &mut places {
                let Bounds { low, high } = of(*number);
                *place = curve.place(Point::new(f64::midpoint(low.x, high.x), f64::midpoint(low.y, high.y)));
            }
        }
        threads::sort_unstable_by(&mut places, Ord::cmp);
        let order: Vec<u32> = places.into_iter().map(|(_, number)| number).collect();
        let around = |boxes: &mut dyn Iterator<Item = Bounds>| boxes.reduce(Bounds::joined);
        let lowest = order.chunks(FAN).filter_map(|group| around(&mut group.iter().map(|number| of(*number))));
        let mut levels: Vec<Vec<Bounds>> = vec![lowest.collect()];
        while let Some(level) = levels.last().filter(|level| level.len() > FAN) {
            let above = level.chunks(FAN).filter_map(|group| around(&mut group.iter().copied())).collect();
            levels.push(above);
        }
        Self { of, order, levels }
    }

    /// Passes each number to `each`, with all others whose boxes meet its own box after growing it by `by` on all sides, in any
    /// order. `new` makes accumulators and `merge` joins them; the result must not depend on the order. O(n log n + p) for p
    /// pairs in practice; large boxes that meet few others take longer.
    pub fn pairs<A: Send>(
        &self,
        by: f64,
        new: &(impl Fn() -> A + Sync),
        each: &(impl Fn(&mut A, u32, &[u32]) + Sync),
        merge: &(impl Fn(A, A) -> A + Sync),
    ) -> A {
        self.pairs_of(0..self.levels[0].len(), by, new, each, merge)
    }

    fn pairs_of<A: Send>(
        &self,
        groups: Range<usize>,
        by: f64,
        new: &(impl Fn() -> A + Sync),
        each: &(impl Fn(&mut A, u32, &[u32]) + Sync),
        merge: &(impl Fn(A, A) -> A + Sync),
    ) -> A {
        if groups.len() > MANY {
            let middle = usize::midpoint(groups.start, groups.end);
            let (one, other) = threads::join(
                || self.pairs_of(groups.start..middle, by, new, each, merge),
                || self.pairs_of(middle..groups.end, by, new, each, merge),
            );
            return merge(one, other);
        }
        let mut found = new();
        self.visit(groups, by, &mut |number, others| each(&mut found, number, others));
        found
    }

    /// Passes the numbers of these groups to `visit`, as `pairs` does.
    fn visit(&self, groups: Range<usize>, by: f64, visit: &mut dyn FnMut(u32, &[u32])) {
        let (mut near, mut above) = (Vec::new(), Vec::new());
        let (mut members, mut others): (Vec<(u32, Bounds)>, Vec<u32>) = (Vec::new(), Vec::new());
        for group in groups {
            self.groups_near(&self.levels[0][group].grown(by), &mut near, &mut above);
            members.clear();
            for other in &near {
                members.extend(self.members(*other).iter().map(|number| (*number, (self.of)(*number))));
            }
            for number in self.members(group) {
                let bounds = (self.of)(*number).grown(by);
                others.clear();
                // All groups are full except the last.
                for (other, members) in near.iter().zip(members.chunks(FAN)) {
                    if self.levels[0][*other].meets(&bounds) {
                        let meeting = members.iter().filter(|(other, of)| other != number && of.meets(&bounds));
                        others.extend(meeting.map(|(other, _)| *other));
                    }
                }
                visit(*number, &others);
            }
        }
    }

    /// Returns the numbers of the boxes that meet another one. O(log n + k) for k of them, in practice.
    #[must_use]
    pub fn meeting(&self, bounds: &Bounds) -> Vec<u32> {
        let mut near = Vec::new();
        self.groups_near(bounds, &mut near, &mut Vec::new());
        let members = near.iter().flat_map(|group| self.members(*group)).copied();
        members.filter(|number| (self.of)(*number).meets(bounds)).collect()
    }

    fn members(&self, group: usize) -> &[u32] {
        &self.order[group * FAN..self.order.len().min(group * FAN + FAN)]
    }

    /// Collects the groups of the lowest level whose boxes meet another one, in order.
    fn groups_near(&self, bounds: &Bounds, near: &mut Vec<usize>, above: &mut Vec<usize>) {
        near.clear();
        near.extend(0..self.levels.last().map_or(0, Vec::len));
        for (number, level) in self.levels.iter().enumerate().rev() {
            near.retain(|group| level[*group].meets(bounds));
            if let Some(below) = number.checked_sub(1) {
                core::mem::swap(near, above);
                near.clear();
                let last = self.levels[below].len();
                near.extend(above.iter().flat_map(|group| group * FAN..last.min(group * FAN + FAN)));
            }
        }
    }
}

#[cfg(test)]
mod tests;
