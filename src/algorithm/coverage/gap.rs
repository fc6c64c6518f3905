//! C2 gap: no bounded face is unclaimed.
//!
//! Unclaimed faces that hang together across lines are one gap; if they hang together with the unbounded face, they are
//! outside. Holes that a single feature has are gaps as well: nothing on the map says that they are meant.

use super::claims::features_of;
use super::finding::{CoverageRule, Finding, Limits};
use super::region::{border, connected, finding};
use crate::dcel::Face;
use crate::map::{FeatureId, PlanarMap};
use rustc_hash::FxHashMap;

/// The gaps, and the unclaimed faces that are none.
#[derive(Default)]
pub(super) struct Gaps {
    pub(super) findings: Vec<Finding>,
    /// The gaps that are wider than asked for.
    pub(super) wider: Vec<Finding>,
    /// The outside and the wider gaps: for each of their faces, by index, the index of one that it hangs together with.
    pub(super) spaces: FxHashMap<usize, usize>,
}

/// Finds the gaps. O(n log n).
pub(super) fn gaps(map: &PlanarMap, limits: &Limits) -> Gaps {
    let unclaimed = |face: Face<'_>| features_of(map, face).next().is_none().then_some(());
    let mut found = Gaps::default();
    for space in connected(map.dcel().faces(), unclaimed) {
        let is_outside = space.iter().any(|face| face.is_unbounded());
        if !is_outside {
            let gap = finding(map, CoverageRule::Gap, around(map, &space), &space);
            if limits.gap_width.is_none_or(|width| gap.width <= width) {
                found.findings.push(gap);
                continue;
            }
            found.wider.push(gap);
        }
        found.spaces.extend(space.iter().map(|face| (face.index(), space[0].index())));
    }
    found
}

/// The features around a set of faces.
fn around(map: &PlanarMap, faces: &[Face<'_>]) -> Vec<FeatureId> {
    let mut features: Vec<FeatureId> =
        border(faces).into_iter().flat_map(|h| features_of(map, h.twin().face())).collect();
    features.sort_unstable();
    features.dedup();
    features
}
