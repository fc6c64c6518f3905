//! The extents of features: where their polygons lie, and how many vertices they have.

use super::super::model::Feature;
use super::rebuild::polygons_of;
use twinedge_geometry::Point;

/// The extent of a feature's polygons: the corners of their box, and the number of their vertices.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    /// The box; `None` if there are no polygons.
    pub corners: Option<[Point; 2]>,
    /// The number of vertices.
    pub vertices: u32,
}

impl Extent {
    /// Returns the corners of the box around several extents. O(extents).
    #[must_use]
    pub fn around(all: &[Self]) -> Option<[Point; 2]> {
        around(all.iter().filter_map(|extent| extent.corners))
    }

    /// Returns the largest absolute coordinate of several extents, 0 without any. O(extents).
    #[must_use]
    pub fn largest(all: &[Self]) -> f64 {
        let corners = Self::around(all).into_iter().flatten();
        corners.fold(0.0, |most: f64, p| most.max(p.x.abs()).max(p.y.abs()))
    }

    /// Returns the extent of a feature's polygons. O(vertices).
    #[must_use]
    pub fn of(feature: &Feature) -> Self {
        let polygons = feature.geometry.as_ref().map(polygons_of).unwrap_or_default();
        let points = || polygons.iter().flatten().flatten();
        Self {
            corners: around(points().map(|p| [*p, *p])),
            vertices: u32::try_from(points().count()).unwrap_or(u32::MAX),
        }
    }
}

/// Returns the box around several boxes.
pub(super) fn around(boxes: impl Iterator<Item = [Point; 2]>) -> Option<[Point; 2]> {
    boxes.reduce(|[a, b], [c, d]| [Point::new(a.x.min(c.x), a.y.min(c.y)), Point::new(b.x.max(d.x), b.y.max(d.y))])
}
