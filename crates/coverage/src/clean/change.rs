//! The options of cleaning, and the changes that it reports.

use core::fmt;
use twinedge::dcel::FaceKey;
use twinedge_geometry::Point;
use twinedge_map::FeatureId;

/// The choice among the features that claim a face.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Winner {
    /// One that lies within another one, but for a tenth of its area at most; the smallest of those. If none does, the one that claims
    /// the largest area.
    #[default]
    Inner,
    /// The one that claims the largest area on the map; the first of those.
    Larger,
    /// The one that claims the smallest area; the first of those.
    Smaller,
    /// The first in order of input.
    First,
    /// The last.
    Last,
}

impl Winner {
    /// The names, and what they stand for.
    const NAMES: [(&'static str, Self); 5] = [
        ("inner", Self::Inner),
        ("larger", Self::Larger),
        ("smaller", Self::Smaller),
        ("first", Self::First),
        ("last", Self::Last),
    ];

    /// The choice of this name: `inner`, `larger`, `smaller`, `first` or `last`; none of another.
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
    /// The greatest mean width of a gap that is filled. By default only small gaps are.
    pub gap_width: Option<f64>,
    /// The greatest mean width of a gap that is to be said of those left, as for [coverages](crate::Limits).
    pub lake_width: Option<f64>,
    /// A point inside each gap that is left as it is, whatever its width and area.
    pub accepted_gaps: Vec<Point>,
    /// The area below which gaps are filled, and thin parts of features given away. Default: a thousandth of the median area of all
    /// parts.
    pub sliver_area: Option<f64>,
    /// The thinness below which a small part of a feature is a sliver, as for [coverages](crate::Limits).
    pub thinness: f64,
    /// The features, by number, one of which gets each gap that is filled: the neighbour among them with the longest common border,
    /// or else the first. Their parts are no slivers. Without any, the neighbours are all.
    pub gaps_to: Vec<usize>,
    /// The closed box in which gaps are filled and slivers given away, by its lower left and upper right corner: what reaches out of it stays.
    /// Default: everywhere. Overlaps are resolved wherever they are.
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

/// A cause for which faces change hands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum ChangeKind {
    /// Several features claimed them.
    Overlap,
    /// No feature claimed them.
    Gap,
    /// They were a sliver.
    Sliver,
}

impl ChangeKind {
    /// The name.
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
    /// The features that had them: those that claimed the overlap, the one of the sliver, none for a gap.
    pub from: Vec<FeatureId>,
    /// The feature that got them; none for a sliver that was dropped.
    pub to: Option<FeatureId>,
    /// Their area.
    pub area: f64,
    /// Their mean width: twice the area by the length of the border.
    pub width: f64,
    /// A point inside.
    pub at: Point,
    /// The faces.
    pub faces: Vec<FaceKey>,
}
