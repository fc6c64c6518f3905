//! C4 sliver: no part of a feature is both small and thin.
//!
//! A part is a set of the feature's faces connected across edges: a polygon of its [contour](twinedge_algorithm::contour).
//! Overlaps and gaps that are slivers are reported as overlaps and gaps.

use super::finding::{CoverageRule, Finding, Limits};
use super::region::{border, connected, finding, size};
use core::f64::consts::PI;
use rustc_hash::FxHashSet;
use twinedge::dcel::{Face, FaceKey};
use twinedge_geometry::threads;
use twinedge_map::PlanarMap;

/// Returns the slivers, and the largest area of a sliver. O(n + half-edges of the faces of each feature), expected.
pub(super) fn slivers(map: &PlanarMap, faces: &[Vec<FaceKey>], limits: &Limits) -> (Vec<Finding>, f64) {
    let parts_of = |keys: &[FaceKey]| {
        let own: Vec<Face<'_>> = keys.iter().filter_map(|key| map.dcel().face(*key).ok()).collect();
        if own.len() == 1 {
            return vec![own];
        }
        let indices: FxHashSet<usize> = own.iter().map(|face| face.index()).collect();
        connected(own, |face| indices.contains(&face.index()).then_some(()))
    };
    let size = |part: &Vec<Face<'_>>| size(map, part, &border(part));
    let sizes = threads::map(faces, |keys| parts_of(keys).iter().map(size).collect::<Vec<_>>());
    let limit =
        limits.sliver_area.unwrap_or_else(|| chosen_area(sizes.iter().flatten().map(|(area, _)| *area).collect()));
    let is_sliver = |(area, length): &(f64, f64)| *area < limit && is_thin(*area, *length, limits);
    // There may be one part per face, but few are slivers: only these become findings.
    let mut found = Vec::new();
    for ((feature, keys), sizes) in map.features().zip(faces).zip(&sizes) {
        if sizes.iter().any(is_sliver) {
            let slivers = parts_of(keys).into_iter().zip(sizes).filter(|(_, size)| is_sliver(size));
            found.extend(slivers.map(|(part, _)| finding(map, CoverageRule::Sliver, vec![feature], &part)));
        }
    }
    (found, limit)
}

/// Returns the default area of slivers, from the areas of all parts. O(n), expected.
pub(crate) fn chosen_area(areas: Vec<f64>) -> f64 {
    median(areas) / 1_000.0
}

/// Returns true if a part with this area and border length is thin enough for a sliver.
pub(crate) fn is_thin(area: f64, length: f64, limits: &Limits) -> bool {
    4.0 * PI * area < limits.thinness * length * length
}

/// Returns the median of some numbers, or 0 if there are none. O(n), expected; O(n log n) for WebAssembly.
pub(crate) fn median(mut numbers: Vec<f64>) -> f64 {
    let middle = numbers.len() / 2;
    // A standard library built for minimal size selects among equal numbers in O(n²).
    if cfg!(target_family = "wasm") {
        numbers.sort_by(f64::total_cmp);
    } else if middle > 0 {
        numbers.select_nth_unstable_by(middle, f64::total_cmp);
    }
    numbers.get(middle).copied().unwrap_or_default()
}
