//! C2 gap: no bounded face is unclaimed.
//!
//! Unclaimed faces connected across lines are one gap; if they are connected with the unbounded face, they are outside. Holes of
//! a single feature are also gaps: nothing on the map says that they are intended.

use super::finding::{CoverageRule, Finding, Limits};
use super::region::{border, connected, finding};
use rustc_hash::{FxHashMap, FxHashSet};
use twinedge::dcel::Face;
use twinedge_algorithm::claims::features_of;
use twinedge_geometry::Point;
use twinedge_map::{FeatureId, PlanarMap};

/// The gaps, and the unclaimed faces that are not gaps.
#[derive(Default)]
pub(crate) struct Gaps {
    pub(super) findings: Vec<Finding>,
    /// The gaps wider than the limit.
    pub(super) wider: Vec<Finding>,
    /// The gaps accepted by a point inside.
    pub(super) accepted: Vec<Finding>,
    /// The outside, and the gaps searched for near misses: for each of their faces, by index, a representative face of the same
    /// space.
    pub(super) spaces: FxHashMap<usize, usize>,
}

impl Gaps {
    /// Adds a gap. Returns true if it is searched for near misses.
    pub(crate) fn take(&mut self, gap: Finding, is_accepted: bool, limits: &Limits, near_miss_width: f64) -> bool {
        let is_wide = gap.width > near_miss_width;
        let greatest = limits.lake_width.or(limits.gap_width);
        let is_narrow = greatest.is_none_or(|width| gap.width <= width);
        let kept = match (is_accepted, is_narrow) {
            (true, _) => &mut self.accepted,
            (false, true) => &mut self.findings,
            (false, false) => &mut self.wider,
        };
        kept.push(gap);
        is_wide && (limits.gap_width.is_some() || !is_narrow || is_accepted)
    }
}

/// Finds the gaps. Gaps wider than `near_miss_width` are searched for near misses, unless all gaps are findings. O(n log n).
pub(super) fn gaps(map: &PlanarMap, limits: &Limits, near_miss_width: f64) -> Gaps {
    let accepted = accepted_faces(map, &limits.accepted_gaps);
    let unclaimed = |face: Face<'_>| features_of(map, face).next().is_none().then_some(());
    let mut found = Gaps::default();
    for space in connected(map.dcel().faces(), unclaimed) {
        let is_outside = space.iter().any(|face| face.is_unbounded());
        if !is_outside {
            let gap = finding(map, CoverageRule::Gap, around(map, &space), &space);
            let is_accepted = space.iter().any(|face| accepted.contains(&face.index()));
            if !found.take(gap, is_accepted, limits, near_miss_width) {
                continue;
            }
        }
        found.spaces.extend(space.iter().map(|face| (face.index(), space[0].index())));
    }
    found
}

/// Returns the faces that contain these points, possibly as isolated vertices, by index. O(n log n) if there are points.
pub(crate) fn accepted_faces(map: &PlanarMap, points: &[Point]) -> FxHashSet<usize> {
    points.iter().filter_map(|p| map.face_at(*p)).map(Face::index).collect()
}

/// Returns the features around a set of faces.
fn around(map: &PlanarMap, faces: &[Face<'_>]) -> Vec<FeatureId> {
    let mut features: Vec<FeatureId> =
        border(faces).into_iter().flat_map(|h| features_of(map, h.twin().face())).collect();
    features.sort_unstable();
    features.dedup();
    features
}
