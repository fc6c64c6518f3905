//! The extent of features.

use crate::geometry::Point;
use crate::map::{Feature, Shape};

/// The corners of the box around a feature.
pub(super) fn corners(feature: &Feature) -> Option<(Point, Point)> {
    let mut points = feature.shapes.iter().flat_map(points);
    let first = points.next()?;
    Some(points.fold((first, first), |(low, high), p| {
        (Point::new(low.x.min(p.x), low.y.min(p.y)), Point::new(high.x.max(p.x), high.y.max(p.y)))
    }))
}

/// All points of a shape.
pub(super) fn points(shape: &Shape) -> Box<dyn Iterator<Item = Point> + '_> {
    match shape {
        Shape::Polygon(rings) => Box::new(rings.iter().flatten().copied()),
        Shape::Line(points) => Box::new(points.iter().copied()),
        Shape::Point(point) => Box::new(core::iter::once(*point)),
    }
}
