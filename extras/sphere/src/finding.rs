//! Findings of the rules of a coverage.

use twinedge_coverage::CoverageRule;
use twinedge_geometry::Point;

/// A violation of a rule of a coverage. Lengths are in metres, areas in square metres.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// The rule.
    pub rule: CoverageRule,
    /// The features involved, in order, as in [`twinedge_coverage::Finding`].
    pub features: Vec<u32>,
    /// The area.
    pub area: f64,
    /// Twice the area, divided by the length.
    pub width: f64,
    /// The length of the border.
    pub length: f64,
    /// A place inside, in degrees; on the border, if no inner place was easy to find.
    pub at: Point,
    /// The arcs of the border, in degrees, with the finding to the left. For a mismatch, the arcs that lack a vertex.
    pub border: Vec<[Point; 2]>,
    /// The missing vertices of a mismatch, in order of their coordinates; empty for the other rules.
    pub missing: Vec<MissingVertex>,
}

/// A vertex that the border of a feature lacks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MissingVertex {
    /// The place, in degrees, between two vertices of the border.
    pub at: Point,
    /// The feature.
    pub feature: u32,
}
