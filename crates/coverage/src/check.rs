//! Checking a map against all coverage rules that a map can answer.

use super::finding::{CoverageRule, Finding, Limits};
use super::gap::{Gaps, gaps};
use super::near_miss::{chosen_width, near_misses};
use super::overlap::{duplicates, first_like, overlaps};
use super::sliver::slivers;
use rustc_hash::FxHashSet;
use thiserror::Error;
use twinedge::dcel::FaceKey;
use twinedge_algorithm::claims::faces_by_feature;
use twinedge_geometry::{Point, threads};
use twinedge_map::{NotPlane, PlanarMap};

/// The findings of C1 … C5 on a map.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Coverage {
    /// By rule; within one rule by falling area, then by corner, features and location.
    pub findings: Vec<Finding>,
    /// The gaps wider than the limit, if there is one, by falling area. They are not findings.
    pub wider_gaps: Vec<Finding>,
    /// The gaps accepted by a point inside, by falling area. They are not findings.
    pub accepted_gaps: Vec<Finding>,
    /// The requested or chosen greatest width of a near miss.
    pub gap_width: f64,
    /// The requested or chosen area of slivers.
    pub sliver_area: f64,
}

impl Coverage {
    /// Returns the findings of one rule. O(findings).
    pub fn of(&self, rule: CoverageRule) -> impl Iterator<Item = &Finding> {
        self.findings.iter().filter(move |finding| finding.rule == rule)
    }

    /// Returns the points of [`Limits::accepted_gaps`] that lie in no accepted gap of the map, usually by mistake. O(n log n).
    #[must_use]
    pub fn unmet_places(&self, map: &PlanarMap, limits: &Limits) -> Vec<Point> {
        let faces: FxHashSet<FaceKey> = self.accepted_gaps.iter().flat_map(|gap| &gap.faces).copied().collect();
        let is_met = |place: &&Point| map.face_at(**place).is_some_and(|face| faces.contains(&face.key()));
        limits.accepted_gaps.iter().filter(|place| !is_met(place)).copied().collect()
    }
}

/// The error of [`check`] and of cleaning.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum CoverageError {
    /// The map is not plane, so the extents of its features are unknown.
    #[error("it is not known what the features cover: {0}")]
    NotPlane(#[from] NotPlane),
}

/// Finds violations of C1 … C5. For C6 and C7 see [`defects`](super::defects), [`mismatches`](super::mismatches).
///
/// With the feature `rayon`, runs on the threads of the current pool. O(n log n + c) for n half-edges and faces, each counted
/// once for each feature that covers it, and c pairs of outside edges whose boxes come within the width.
///
/// ```
/// use twinedge_coverage::{CoverageRule, Limits, check};
/// use twinedge_map::{Builder, Noding, Shape};
///
/// // Two parcels; the right one begins half a unit inside the left one.
/// let parcel = |x: f64| [[x, 0.0], [x + 10.0, 0.0], [x + 10.0, 10.0], [x, 10.0]];
/// let mut builder = Builder::new();
/// builder.shape(&Shape::polygon(parcel(0.0)))?;
/// builder.shape(&Shape::polygon(parcel(9.5)))?;
/// let map = builder.build_with(Noding::Exact)?;
/// let coverage = check(&map, &Limits::default())?;
/// let [overlap] = &coverage.findings[..] else { unreachable!("nothing else is wrong") };
/// assert_eq!((overlap.rule, overlap.area, overlap.length), (CoverageRule::Overlap, 5.0, 21.0));
/// assert!((overlap.width - 0.476).abs() < 0.001);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`CoverageError::NotPlane`]; build such a map [with snapping](twinedge_map::Noding::Snap).
pub fn check(map: &PlanarMap, limits: &Limits) -> Result<Coverage, CoverageError> {
    map.plane()?;
    let faces = faces_by_feature(map);
    let first_like = first_like(map, &faces);
    let unclaimed = || {
        let gap_width = limits.gap_width.unwrap_or_else(|| chosen_width(map));
        let gaps = gaps(map, limits, gap_width);
        (near_misses(map, &gaps.spaces, gap_width), gaps, gap_width)
    };
    let claimed = || {
        let (slivers, sliver_area) = slivers(map, &faces, limits);
        (overlaps(map, &first_like), slivers, sliver_area, duplicates(map, &faces, &first_like))
    };
    let ((near_misses, gaps, gap_width), (overlaps, slivers, sliver_area, duplicates)) =
        threads::join(unclaimed, claimed);
    Ok(Found { overlaps, gaps, near_misses, slivers, duplicates, gap_width, sliver_area }.sorted())
}

pub(crate) struct Found {
    pub(crate) overlaps: Vec<Finding>,
    pub(crate) gaps: Gaps,
    pub(crate) near_misses: Vec<Finding>,
    pub(crate) slivers: Vec<Finding>,
    pub(crate) duplicates: Vec<Finding>,
    pub(crate) gap_width: f64,
    pub(crate) sliver_area: f64,
}

impl Found {
    pub(crate) fn sorted(self) -> Coverage {
        let Self { overlaps, gaps, near_misses, slivers, duplicates, gap_width, sliver_area } = self;
        let Gaps { findings: narrow, mut wider, mut accepted, .. } = gaps;
        for kept in [&mut wider, &mut accepted] {
            kept.sort_by(Finding::compare);
        }
        let mut findings = Vec::new();
        for mut found in [overlaps, narrow, near_misses, slivers, duplicates] {
            found.sort_by(Finding::compare);
            findings.append(&mut found);
        }
        Coverage { findings, wider_gaps: wider, accepted_gaps: accepted, gap_width, sliver_area }
    }
}
