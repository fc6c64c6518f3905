//! A summary of a file that was read, and of what was dropped.

use twinedge_map::{Feature, Shape};

/// The contents of a file, and the parts of it that were dropped, counted while it was read.
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
    /// Positions with more than two numbers, of which those beyond x and y were dropped.
    pub with_extra_dimensions: usize,
    /// Properties of features other than the name, which were dropped.
    pub dropped_properties: usize,
    /// Empty points, lines and polygons, which were dropped.
    pub dropped_empty: usize,
    /// Objects that name a coordinate reference system (`crs`, or `SRID` before a geometry) other than longitude and latitude on
    /// WGS 84. It was ignored, as RFC 7946 asks for.
    pub other_crs: usize,
}

impl ReadSummary {
    /// Counts one more feature, of which so many positions had further dimensions and so many shapes were empty. O(shapes).
    pub fn add(&mut self, feature: &Feature, with_extra_dimensions: usize, empty: usize) {
        self.features += 1;
        self.without_geometry += usize::from(feature.shapes.is_empty());
        self.with_extra_dimensions += with_extra_dimensions;
        self.dropped_empty += empty;
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
