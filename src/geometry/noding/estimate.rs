//! How often segments will be cut, estimated before any is.

use super::pixel::{Pixels, Segment};

/// How many pairs are tried.
const PAIRS: u64 = 4096;

/// Estimates from fewer crossings than this are worth nothing.
const ENOUGH: u64 = 64;

/// About how many times segments are cut where two of them cross, each crossing counted twice; none if there are too few
/// to tell. O(1).
///
/// The pairs are those of a fixed pseudo-random sequence. Of s crossings found, the estimate is off by a part of 1 / √s, as a
/// rule.
pub(super) fn crossing_cuts(pixels: Pixels, segments: &[Segment]) -> Option<u64> {
    let count = segments.len() as u64;
    let mut state = 0_u64;
    // SplitMix64 (G. Steele, D. Lea, C. Flood, 2014).
    let mut some = || {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut random = state;
        random = (random ^ (random >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        random = (random ^ (random >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        random ^= random >> 31;
        &segments[((u128::from(random) * u128::from(count)) >> 64) as usize]
    };
    if segments.is_empty() {
        return None;
    }
    let found = (0..PAIRS).filter(|_| pixels.crossing(some(), some()).is_some()).count() as u64;
    // Of n² pairs in order, each crossing is two.
    (found >= ENOUGH).then(|| ((u128::from(count) * u128::from(count) * u128::from(found)) / u128::from(PAIRS)) as u64)
}

#[cfg(test)]
mod tests {
    use super::{Pixels, Segment, crossing_cuts};

    #[test]
    fn the_estimate_is_near_the_number() {
        let segment = |a: [i64; 2], b: [i64; 2]| Segment { a, b, ends: [0, 1] };
        // A grid of n lines across n lines: each of 2n lines is cut n times.
        for n in [10, 300] {
            let level = (0..n).map(|i| segment([-1, i], [n, i]));
            let lines: Vec<Segment> = level.chain((0..n).map(|i| segment([i, -1], [i, n]))).collect();
            let cuts = u64::try_from(2 * n * n).unwrap();
            let estimate = crossing_cuts(Pixels::ONE_STEP, &lines).unwrap();
            assert!(estimate.abs_diff(cuts) < cuts / 8, "{estimate} for {cuts}");
        }
        let apart: Vec<Segment> = (0..100).map(|i| segment([0, i], [9, i])).collect();
        assert_eq!(crossing_cuts(Pixels::ONE_STEP, &apart), None);
        assert_eq!(crossing_cuts(Pixels::ONE_STEP, &[]), None);
    }
}
