//! An estimate of the number of cuts, made before any segment is cut.

use super::pixel::{Pixel, Pixels, Segment};
use rustc_hash::FxHashMap;

/// The number of pairs that are tried.
const PAIRS: u64 = 4096;

/// Estimates from fewer crossings than this are worth nothing.
const ENOUGH: u64 = 64;

/// About how many times segments are cut where two of them cross; none if there are too few crossings to tell. O(1).
///
/// The pairs are those of a fixed pseudo-random sequence. Of s crossings found, the estimate is off by a part of 1 / √s, as a
/// rule. A segment is cut once in a pixel, by however many others. So where many crossings share few pixels, as those of lines
/// through one point, there are no more cuts than segments for each of those pixels, and their number is estimated from how many were
/// found once and how many twice (A. Chao, 1984).
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
    let mut times: FxHashMap<Pixel, u64> = FxHashMap::default();
    for pixel in (0..PAIRS).filter_map(|_| pixels.crossing(some(), some())) {
        *times.entry(pixel).or_default() += 1;
    }
    let found: u64 = times.values().sum();
    if found < ENOUGH {
        return None;
    }
    let exactly = |n: u64| times.values().filter(|times| **times == n).count() as u64;
    let unseen = exactly(1).pow(2).checked_div(2 * exactly(2)).unwrap_or(exactly(1).pow(2));
    // Of n² pairs in order, each crossing is two.
    let alone = (u128::from(count) * u128::from(count) * u128::from(found)) / u128::from(PAIRS);
    let shared = u128::from(count) * u128::from(times.len() as u64 + unseen);
    Some(u64::try_from(alone.min(shared)).unwrap_or(u64::MAX))
}

#[cfg(test)]
mod tests;
