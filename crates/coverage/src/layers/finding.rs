//! The rules between layers, and their findings.

use crate::region::{Extent, extent};
use core::fmt;
use twinedge::dcel::{Face, FaceKey};
use twinedge_geometry::Point;
use twinedge_map::{FeatureId, PlanarMap};

/// A rule between two layers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum LayerRule {
    /// X1: each feature lies within one feature of the other layer.
    Within,
    /// X2: both layers cover the same places.
    Cover,
    /// X3: each border of the other layer is a border of this one.
    Border,
    /// X4: each parent is made up exactly by its parts.
    Parent,
    /// X5: each line runs along borders of the other layer.
    Line,
    /// X6: each point lies inside a feature of the other layer.
    Point,
}

impl LayerRule {
    /// All rules, in order of their ids.
    pub const ALL: [Self; 6] = [Self::Within, Self::Cover, Self::Border, Self::Parent, Self::Line, Self::Point];

    /// Returns the id: `X1` to `X6`.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Within => "X1",
            Self::Cover => "X2",
            Self::Border => "X3",
            Self::Parent => "X4",
            Self::Line => "X5",
            Self::Point => "X6",
        }
    }

    /// Returns the name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Within => "within",
            Self::Cover => "cover",
            Self::Border => "border",
            Self::Parent => "parent",
            Self::Line => "line",
            Self::Point => "point",
        }
    }

    /// Returns a sentence that states the rule.
    #[must_use]
    pub const fn statement(self) -> &'static str {
        match self {
            Self::Within => "each feature lies within one feature of the other layer",
            Self::Cover => "both layers cover the same places",
            Self::Border => "each border of the other layer is a border of this one",
            Self::Parent => "each parent is made up exactly by its parts",
            Self::Line => "each line runs along borders of the other layer",
            Self::Point => "each point lies inside a feature of the other layer",
        }
    }
}

impl fmt::Display for LayerRule {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.id(), self.name())
    }
}

/// A kind of violation of a rule between layers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Deviation {
    /// X1: a feature is not entirely within one feature of the other layer.
    NotWithin,
    /// X2: an area that only the audited layer covers.
    OnlyHere,
    /// X2: an area that only the other layer covers.
    OnlyThere,
    /// X3: a border of the other layer that is no border of the audited one.
    NoBorder,
    /// X4: a part lies wholly or partly outside its parent.
    OutsideParent,
    /// X4: an area of a parent that none of its parts covers.
    ParentNotCovered,
    /// X4: a part with an unknown parent.
    UnknownParent,
    /// X5: a line where the other layer has no border.
    OffBorder,
    /// X6: a point that does not lie inside one feature of the other layer.
    NotInside,
}

impl Deviation {
    /// All kinds, in the order of their rules.
    pub const ALL: [Self; 9] = [
        Self::NotWithin,
        Self::OnlyHere,
        Self::OnlyThere,
        Self::NoBorder,
        Self::OutsideParent,
        Self::ParentNotCovered,
        Self::UnknownParent,
        Self::OffBorder,
        Self::NotInside,
    ];

    /// Returns the rule that it breaks.
    #[must_use]
    pub const fn rule(self) -> LayerRule {
        match self {
            Self::NotWithin => LayerRule::Within,
            Self::OnlyHere | Self::OnlyThere => LayerRule::Cover,
            Self::NoBorder => LayerRule::Border,
            Self::OutsideParent | Self::ParentNotCovered | Self::UnknownParent => LayerRule::Parent,
            Self::OffBorder => LayerRule::Line,
            Self::NotInside => LayerRule::Point,
        }
    }

    /// Returns the name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::NotWithin => "not_within",
            Self::OnlyHere => "only_here",
            Self::OnlyThere => "only_there",
            Self::NoBorder => "no_border",
            Self::OutsideParent => "outside_parent",
            Self::ParentNotCovered => "parent_not_covered",
            Self::UnknownParent => "unknown_parent",
            Self::OffBorder => "off_border",
            Self::NotInside => "not_inside",
        }
    }
}

/// A violation of a rule between layers. Lengths and areas are in the units of the coordinates.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct LayerFinding {
    /// The kind of violation.
    pub deviation: Deviation,
    /// The features of the audited layer, in order: the faulty feature, or the features that cover the area or lie at the border.
    pub features: Vec<FeatureId>,
    /// The features of the other layer, in order: the feature that contains most of the faulty one, then the others; the features
    /// that cover the area or have the border; or the parent.
    pub others: Vec<FeatureId>,
    /// The area of the faces; 0 without faces.
    pub area: f64,
    /// The mean width of the faces, [defined](crate::Finding::width) as for a coverage.
    pub width: f64,
    /// The total border length of the faces or length of the stretches; 0 for a point.
    pub length: f64,
    /// A point inside the largest face, the middle of the longest stretch, or the point; the origin for a part without area.
    pub at: Point,
    /// The faulty faces; for X1, the faces outside the first of `others`.
    pub faces: Vec<FaceKey>,
    /// The faulty edges of X3 and X5.
    pub stretches: Vec<[Point; 2]>,
}

impl LayerFinding {
    /// Returns the broken rule.
    #[must_use]
    pub const fn rule(&self) -> LayerRule {
        self.deviation.rule()
    }

    pub(super) fn of_faces(
        map: &PlanarMap,
        deviation: Deviation,
        [features, others]: [Vec<FeatureId>; 2],
        faces: &[Face<'_>],
    ) -> Self {
        let Extent { area, width, length, at, .. } = extent(map, faces);
        let faces = faces.iter().map(|face| face.key()).collect();
        Self { deviation, features, others, area, width, length, at, faces, stretches: Vec::new() }
    }
}

/// Sorts findings by rule and deviation, then by falling area and length.
pub(super) fn sort(findings: &mut [LayerFinding]) {
    findings.sort_by(|a, b| {
        let by_kind = (a.rule(), a.deviation).cmp(&(b.rule(), b.deviation));
        by_kind.then(b.area.total_cmp(&a.area)).then(b.length.total_cmp(&a.length))
    });
}
