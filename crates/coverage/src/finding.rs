//! The rules of a coverage, and their findings.

use core::cmp::Ordering;
use core::fmt;
use twinedge::dcel::FaceKey;
use twinedge_geometry::Point;
use twinedge_geometry::predicates::compare_lexicographic;
use twinedge_map::FeatureId;

/// A rule of a coverage: areas side by side, which keep all of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum CoverageRule {
    /// C1: no face is claimed by two features.
    Overlap,
    /// C2: no bounded face is unclaimed.
    Gap,
    /// C3: borders of two features coincide or are farther apart than a given width.
    NearMiss,
    /// C4: no part of a feature is both small and thin.
    Sliver,
    /// C5: no two features claim the same faces.
    Duplicate,
    /// C6: the polygons of each feature are valid by the rules of the OGC.
    Validity,
    /// C7: where the borders of two features, or two rings of one feature, meet, both have a vertex.
    Mismatch,
}

impl CoverageRule {
    /// All rules, in order of their ids.
    pub const ALL: [Self; 7] =
        [Self::Overlap, Self::Gap, Self::NearMiss, Self::Sliver, Self::Duplicate, Self::Validity, Self::Mismatch];

    /// Returns the id: `C1` to `C7`.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Overlap => "C1",
            Self::Gap => "C2",
            Self::NearMiss => "C3",
            Self::Sliver => "C4",
            Self::Duplicate => "C5",
            Self::Validity => "C6",
            Self::Mismatch => "C7",
        }
    }

    /// Returns the name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Overlap => "overlap",
            Self::Gap => "gap",
            Self::NearMiss => "near miss",
            Self::Sliver => "sliver",
            Self::Duplicate => "duplicate",
            Self::Validity => "OGC validity",
            Self::Mismatch => "mismatch",
        }
    }
}

impl fmt::Display for CoverageRule {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.id(), self.name())
    }
}

/// A violation of a rule of a coverage. Lengths and areas are in the units of the coordinates.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Finding {
    /// The rule.
    pub rule: CoverageRule,
    /// The features involved, in order: claimants of the overlap or duplicate, neighbours of the gap, both features of a near
    /// miss or mismatch, or the one feature of a sliver or of a mismatch of its own rings.
    pub features: Vec<FeatureId>,
    /// The area of the overlap, the gap, the sliver, one of the duplicates, or the space between the borders of a near miss
    /// without ends where they move apart; 0 for a mismatch.
    pub area: f64,
    /// The mean width: twice the area divided by the length of the borders. It is the width of a strip, and half the width of a
    /// disk or square. 0 for a mismatch.
    pub width: f64,
    /// The length of the borders involved: all around the faces, both sides of a near miss, or the segments that lack a vertex.
    pub length: f64,
    /// A point inside; for a mismatch, the first missing vertex.
    pub at: Point,
    /// The leftmost corner of the faces or stretches, and the lowest on a tie.
    pub corner: Point,
    /// The faces that make it up; empty for a near miss or a mismatch, and in audits by tiles.
    pub faces: Vec<FaceKey>,
    /// For a near miss, the stretches of facing borders; for a mismatch, the segments that lack a vertex; otherwise empty.
    pub stretches: Vec<[Point; 2]>,
    /// The missing vertices of a mismatch, in order of their coordinates; otherwise empty.
    pub missing: Vec<MissingVertex>,
}

impl Finding {
    /// Compares findings of one rule, independent of the numbers of faces.
    pub(super) fn compare(&self, other: &Self) -> Ordering {
        (other.area.total_cmp(&self.area))
            .then_with(|| compare_lexicographic(self.corner, other.corner))
            .then_with(|| self.features.cmp(&other.features))
            .then_with(|| compare_lexicographic(self.at, other.at))
    }
}

/// A vertex that the border of a feature lacks.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct MissingVertex {
    /// The location, between two vertices of the border.
    pub at: Point,
    /// The feature.
    pub feature: FeatureId,
}

/// The limits of width and thinness for gaps, near misses and slivers.
///
/// ```
/// use twinedge_coverage::Limits;
///
/// let limits = Limits { gap_width: Some(0.5), lake_width: Some(100.0), ..Limits::default() };
/// assert_eq!(limits.thinness, 0.2);
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Limits {
    /// The greatest width of a near miss, and of a reported gap unless `lake_width` is set. By default gaps of all widths are
    /// found, and a near miss is at most as wide as a hundredth of the median length of the edges.
    pub gap_width: Option<f64>,
    /// The greatest width of a reported gap. Wider ones are lakes, counted and searched for near misses. Default: `gap_width`.
    pub lake_width: Option<f64>,
    /// A point inside each gap that is accepted at any width.
    pub accepted_gaps: Vec<Point>,
    /// The area below which a thin part of a feature is a sliver. Default: a thousandth of the median area of all parts.
    pub sliver_area: Option<f64>,
    /// The thinness below which a small part of a feature is a sliver: 4πA/P² for area A and perimeter P, which is 1 for a disk,
    /// 0.79 for a square, and 0.2 for a rectangle 14 times as long as wide.
    pub thinness: f64,
}

impl Default for Limits {
    fn default() -> Self {
        Self { gap_width: None, lake_width: None, accepted_gaps: Vec::new(), sliver_area: None, thinness: 0.2 }
    }
}
