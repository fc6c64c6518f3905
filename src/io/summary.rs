//! What a reader has read.

use crate::map::{Feature, Shape};

/// How much of what a file held, counted while it was read.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct ReadSummary {
    /// Features handed over; a geometry without a feature around it counts as one.
    pub features: usize,
    /// Features without any shape: their geometry was null, absent or empty.
    pub without_geometry: usize,
    /// Polygons, those of multi-polygons counted one by one.
    pub polygons: usize,
    /// Lines, those of multi-lines counted one by one.
    pub lines: usize,
    /// Single points, those of multi-points counted one by one.
    pub points: usize,
    /// Positions in all these shapes, the repeated end of a closed ring included.
    pub positions: usize,
    /// Positions that had more than two numbers; what goes beyond x and y was dropped.
    pub with_extra_dimensions: usize,
}

impl ReadSummary {
    /// Counts one more feature.
    pub(super) fn add(&mut self, feature: &Feature, with_extra_dimensions: usize) {
        self.features += 1;
        self.without_geometry += usize::from(feature.shapes.is_empty());
        self.with_extra_dimensions += with_extra_dimensions;
        for shape in &feature.shapes {
            match shape {
                Shape::Polygon(rings) => {
                    self.polygons += 1;
                    self.positions += rings.iter().map(Vec::len).sum::<usize>();
                }
                Shape::Line(points) => {
                    self.lines += 1;
                    self.positions += points.len();
                }
                Shape::Point(_) => {
                    self.points += 1;
                    self.positions += 1;
                }
            }
        }
    }
}
