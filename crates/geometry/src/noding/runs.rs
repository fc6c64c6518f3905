//! Runs: unions of overlapping collinear segments.
//!
//! A thousand overlapping segments on one line have a million pieces in total, but only thousands of different ones. So
//! overlapping collinear segments, including equal ones, are first joined into a *run*; runs are noded, and each segment becomes
//! a range of the chain of its run. That changes nothing: a run visits the pixels of its segments, in the same order.

use super::pixel::{Segment, cross, minus};
use crate::threads;
use core::cmp::Ordering;
use core::hash::Hasher;
use rustc_hash::{FxHashMap, FxHashSet, FxHasher};

pub(super) struct Runs {
    pub(super) joined: Vec<Segment>,
    pub(super) of: Vec<u32>,
    /// The number of segments that equal an earlier one.
    pub(super) duplicates: usize,
}

/// Joins the overlapping segments of each line. Segments that only share an end stay separate.
///
/// Cost: O(n) expected, plus O(g log g) for g segments of one line.
pub(super) fn join(segments: Vec<Segment>) -> Runs {
    // Linked lists of segments on one line. Different lines rarely share a list, and the exact order separates them.
    const NONE: u32 = u32::MAX;
    let lines: Vec<u64> = segments.iter().map(line).collect();
    let again = repeated(&lines);
    let mut last = FxHashMap::default();
    let mut before = Vec::new();
    for (id, line) in lines.iter().enumerate().filter(|(_, line)| again.contains(line)) {
        if let Some(earlier) = last.insert(*line, id as u32) {
            before.resize(segments.len(), NONE);
            before[id] = earlier;
        }
    }
    if before.is_empty() {
        // No two share a line.
        let of = (0..segments.len() as u32).collect();
        return Runs { joined: segments, of, duplicates: 0 };
    }
    let mut runs = Runs { joined: Vec::with_capacity(segments.len()), of: vec![NONE; segments.len()], duplicates: 0 };
    let mut group = Vec::new();
    for id in (0..segments.len() as u32).rev() {
        if runs.of[id as usize] != NONE {
            continue;
        }
        if before[id as usize] == NONE {
            runs.of[id as usize] = runs.joined.len() as u32;
            runs.joined.push(segments[id as usize]);
            continue;
        }
        group.clear();
        let mut next = id;
        while next != NONE {
            group.push(next);
            next = before[next as usize];
        }
        threads::sort_unstable_by(&mut group, |&i, &j| {
            order(&segments[i as usize], &segments[j as usize]).then(i.cmp(&j))
        });
        runs.sweep(&segments, &group);
    }
    runs
}

/// Returns the numbers that occur more than once, and some others: a bit table much larger than the list filters candidates.
fn repeated(numbers: &[u64]) -> FxHashSet<u64> {
    let words = numbers.len().div_ceil(4).next_power_of_two();
    let mut seen = vec![0_u64; words];
    let mut repeated = FxHashSet::default();
    for number in numbers {
        let (word, bit) = (&mut seen[(*number >> 6) as usize & (words - 1)], 1 << (*number & 63));
        if *word & bit != 0 {
            repeated.insert(*number);
        }
        *word |= bit;
    }
    repeated
}

impl Runs {
    /// Adds the runs of some segments, given in order.
    fn sweep(&mut self, segments: &[Segment], group: &[u32]) {
        let mut previous: Option<&Segment> = None;
        for &id in group {
            let segment = &segments[id as usize];
            match (self.joined.last_mut(), previous) {
                (Some(run), Some(before)) if same_line(run, segment) && segment.a < run.b => {
                    self.duplicates += usize::from((before.a, before.b) == (segment.a, segment.b));
                    if run.b < segment.b {
                        run.b = segment.b;
                        run.ends[1] = segment.ends[1];
                    }
                }
                _ => self.joined.push(*segment),
            }
            previous = Some(segment);
            self.of[id as usize] = self.joined.len() as u32 - 1;
        }
    }
}

/// Returns a number that all segments of a line share.
///
/// It combines slope and intercept, as residues modulo 2^64. Without common powers of two, one of the differences `dx`, `dy` is
/// odd and so has an inverse; the slope `dy / dx` does not depend on the other common factors, and the intercept `y − slope · x`
/// is equal at all lattice points of the line.
fn line(s: &Segment) -> u64 {
    let [dx, dy] = s.direction();
    let twos = (dx | dy).trailing_zeros();
    let [dx, dy, x, y] = [dx >> twos, dy >> twos, s.a[0], s.a[1]].map(i64::cast_unsigned);
    let steep = dx % 2 == 0;
    let [along, across, from, to] = if steep { [dy, dx, y, x] } else { [dx, dy, x, y] };
    let slope = across.wrapping_mul(inverse(along));
    let intercept = to.wrapping_sub(slope.wrapping_mul(from));
    let mut hasher = FxHasher::default();
    hasher.write_u64(slope);
    hasher.write_u64(intercept);
    hasher.write_u8(u8::from(steep));
    hasher.finish()
}

/// Returns the inverse of an odd number modulo 2^64, by Newton's method: each round doubles the number of correct bits.
fn inverse(odd: u64) -> u64 {
    let mut inverse = odd.wrapping_mul(3) ^ 2;
    for _ in 0..4 {
        inverse = inverse.wrapping_mul(2_u64.wrapping_sub(odd.wrapping_mul(inverse)));
    }
    inverse
}

/// Compares segments so that the segments of one line are adjacent, ordered along the line.
fn order(s: &Segment, t: &Segment) -> Ordering {
    let d = s.direction();
    // All directions are in one half-plane, so the sign of the cross product orders them.
    0.cmp(&cross(d, t.direction()))
        .then_with(|| 0.cmp(&cross(d, minus(t.a, s.a))))
        .then_with(|| (s.a, s.b).cmp(&(t.a, t.b)))
}

fn same_line(s: &Segment, t: &Segment) -> bool {
    let d = s.direction();
    cross(d, t.direction()) == 0 && cross(d, minus(t.a, s.a)) == 0
}

#[cfg(test)]
mod tests;
