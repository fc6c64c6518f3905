//! What cleaning did.

use twinedge::algorithm::area::ring_area;
use twinedge::algorithm::clean::{Change, ChangeKind};
use twinedge::geometry::Point;
use twinedge::geometry::noding::NodingSummary;
use twinedge::map::FeatureId;

/// What cleaning did. Areas and widths are in the units of the coordinates.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct CleanReport {
    /// How many features have polygons.
    pub polygons: usize,
    /// What noding did.
    pub noding: Option<NodingSummary>,
    /// The area below which gaps were filled and slivers given away.
    pub sliver_area: f64,
    /// What changed hands, in the order in which it did.
    pub changes: Vec<LayerChange>,
    /// The features that have another geometry than before, in order.
    pub features: Vec<FeatureChange>,
    /// What still breaks C1 … C6; none if nothing does.
    pub left: Option<Left>,
}

/// An area that changed hands. Features are named by their numbers, counted from 0.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct LayerChange {
    /// Why.
    pub kind: ChangeKind,
    /// The features that had it.
    pub from: Vec<usize>,
    /// The feature that got it.
    pub to: Option<usize>,
    /// The area.
    pub area: f64,
    /// The mean width.
    pub width: f64,
    /// A point inside.
    pub at: Point,
}

/// A feature that has another geometry than before.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct FeatureChange {
    /// Its number, counted from 0.
    pub feature: usize,
    /// What its rings enclosed.
    pub area_before: f64,
    /// What they enclose now; 0 if nothing is left of it, and then it has no geometry.
    pub area_after: f64,
    /// The points of its rings, the repeated end of each included.
    pub points_before: usize,
    /// Those that it has now.
    pub points_after: usize,
}

/// How many findings of C1 … C6 are left.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Left {
    /// Whether borders meet at common vertices only; otherwise C1 … C4 are not known.
    pub is_plane: bool,
    /// C1.
    pub overlaps: usize,
    /// C2: gaps that are larger and wider than those that are filled.
    pub gaps: usize,
    /// C3: borders that nearly meet, beside a space that is open to the outside.
    pub near_misses: usize,
    /// C4: slivers that are all that there is of their feature.
    pub slivers: usize,
    /// C6: features that are not valid by the OGC.
    pub invalid: usize,
}

impl From<&Change> for LayerChange {
    fn from(change: &Change) -> Self {
        Self {
            kind: change.kind,
            from: change.from.iter().map(|feature| feature.index()).collect(),
            to: change.to.map(FeatureId::index),
            area: change.area,
            width: change.width,
            at: change.at,
        }
    }
}

impl FeatureChange {
    /// By the polygons before and after, the outer ring of each first.
    pub(super) fn new(feature: usize, before: &[Vec<Vec<Point>>], after: &[Vec<Vec<Point>>]) -> Self {
        let area = |rings: &Vec<Vec<Point>>| {
            let areas = rings.iter().map(|ring| ring_area(ring.iter().copied()).abs());
            areas.enumerate().map(|(i, area)| if i == 0 { area } else { -area }).sum::<f64>()
        };
        let points = |polygons: &[Vec<Vec<Point>>]| polygons.iter().flatten().map(Vec::len).sum();
        Self {
            feature,
            area_before: before.iter().map(area).sum(),
            area_after: after.iter().map(area).sum(),
            points_before: points(before),
            points_after: points(after),
        }
    }
}
