//! A summary of a file and of its dropped parts.

use twinedge_map::{Feature, Shape};

/// The contents of a file and its dropped parts, counted while it was read.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct ReadSummary {
    /// Features passed on; a geometry without a feature around it counts as one.
    pub features: usize,
    /// Features without any shape: their geometry was null, absent or empty.
    pub without_geometry: usize,
    /// Polygons, with multi-polygons counted as several.
    pub polygons: usize,
    /// Lines, with multi-lines counted as several.
    pub lines: usize,
    /// Single points, with multi-points counted as several.
    pub points: usize,
    /// Positions in all these shapes, including the repeated end of a closed ring.
    pub positions: usize,
    /// Positions with more than two numbers; the numbers beyond x and y were dropped.
    pub with_extra_dimensions: usize,
    /// Dropped properties of features, other than the name.
    pub dropped_properties: usize,
    /// Dropped empty points, lines and polygons.
    pub dropped_empty: usize,
    /// Objects that name a coordinate reference system (`crs`, or `SRID` before a geometry) other than longitude and latitude on
    /// WGS 84. It was ignored, as RFC 7946 requires.
    pub other_crs: usize,
}

impl ReadSummary {
    /// Counts a feature, with its numbers of positions with further dimensions and of empty shapes. O(shapes).
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
