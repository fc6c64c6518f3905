//! The options of cleaning, and the reported changes.

use core::fmt;
use twinedge::dcel::FaceKey;
use twinedge_geometry::Point;
use twinedge_map::FeatureId;

/// The choice among the features that claim a face.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Winner {
    /// The smallest feature at least 90 % inside another one; otherwise the one with the largest area.
    #[default]
    Inner,
    /// The feature with the largest area on the map; the first on a tie.
    Larger,
    /// The feature with the smallest area; the first on a tie.
    Smaller,
    /// The first feature in order of input.
    First,
    /// The last feature in order of input.
    Last,
}

impl Winner {
    const NAMES: [(&'static str, Self); 5] = [
        ("inner", Self::Inner),
        ("larger", Self::Larger),
        ("smaller", Self::Smaller),
        ("first", Self::First),
        ("last", Self::Last),
    ];

    /// Returns the choice with this name: `inner`, `larger`, `smaller`, `first` or `last`; `None` for any other name.
    #[must_use]
    pub fn of_name(name: &str) -> Option<Self> {
        Self::NAMES.iter().find(|(known, _)| *known == name).map(|(_, winner)| *winner)
    }
}

/// The options of cleaning.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// The choice of the feature that gets a face claimed by several.
    pub winner: Winner,
    /// The greatest mean width of a gap that is filled. By default only small gaps are filled.
    pub gap_width: Option<f64>,
    /// The greatest mean width of a remaining gap that is reported, as for [coverages](crate::Limits).
    pub lake_width: Option<f64>,
    /// A point inside each gap that is left as it is, independent of width and area.
    pub accepted_gaps: Vec<Point>,
    /// The area below which gaps are filled, and thin parts given away. Default: a thousandth of the median area of all parts.
    pub sliver_area: Option<f64>,
    /// The thinness below which a small part of a feature is a sliver, as for [coverages](crate::Limits).
    pub thinness: f64,
    /// The features, by number, that may get filled gaps: the neighbour among them with the longest common border, or else the
    /// first. Their parts are no slivers. By default, all neighbours qualify.
    pub gaps_to: Vec<usize>,
    /// The closed box in which gaps are filled and slivers given away, by its lower left and upper right corner; areas that reach
    /// out of it stay. Default: everywhere. Overlaps are resolved everywhere.
    pub window: Option<[Point; 2]>,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            winner: Winner::Inner,
            gap_width: None,
            lake_width: None,
            accepted_gaps: Vec::new(),
            sliver_area: None,
            thinness: 0.2,
            gaps_to: Vec::new(),
            window: None,
        }
    }
}

/// A reason why faces change hands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum ChangeKind {
    /// Several features claimed the faces.
    Overlap,
    /// No feature claimed the faces.
    Gap,
    /// The faces were a sliver.
    Sliver,
}

impl ChangeKind {
    /// Returns the name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Overlap => "overlap",
            Self::Gap => "gap",
            Self::Sliver => "sliver",
        }
    }
}

impl fmt::Display for ChangeKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// Connected faces that changed hands. Lengths and areas are in the units of the coordinates.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Change {
    /// The reason.
    pub kind: ChangeKind,
    /// The previous features: the claimants of an overlap, the owner of a sliver, empty for a gap.
    pub from: Vec<FeatureId>,
    /// The feature that got the faces; `None` if a sliver was dropped.
    pub to: Option<FeatureId>,
    /// The area of the faces.
    pub area: f64,
    /// The mean width: twice the area divided by the length of the border.
    pub width: f64,
    /// A point inside.
    pub at: Point,
    /// The faces.
    pub faces: Vec<FaceKey>,
}
