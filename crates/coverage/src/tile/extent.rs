//! The extent of features.

use twinedge_geometry::Point;
use twinedge_map::{Feature, Shape};

pub(super) fn corners(feature: &Feature) -> Option<(Point, Point)> {
    around(feature.shapes.iter().flat_map(points)).map(|[low, high]| (low, high))
}

/// Returns the corners of the box around some points.
pub(super) fn around(mut points: impl Iterator<Item = Point>) -> Option<[Point; 2]> {
    let first = points.next()?;
    Some(points.fold([first; 2], |[low, high], p| {
        [Point::new(low.x.min(p.x), low.y.min(p.y)), Point::new(high.x.max(p.x), high.y.max(p.y))]
    }))
}

/// Returns the rings of a polygon, or nothing for other shapes.
pub(super) fn rings(shape: &Shape) -> &[Vec<Point>] {
    if let Shape::Polygon(rings) = shape { rings } else { &[] }
}

pub(super) fn points(shape: &Shape) -> Box<dyn Iterator<Item = Point> + '_> {
    match shape {
        Shape::Polygon(rings) => Box::new(rings.iter().flatten().copied()),
        Shape::Line(points) => Box::new(points.iter().copied()),
        Shape::Point(point) => Box::new(core::iter::once(*point)),
    }
}
