//! Shapes and features from and to the types of the crate [geo-types](::geo_types), which the Rust geospatial crates share.

use crate::feature::{Feature, Shape};
use ::geo_types as geo;
use twinedge_geometry::Point;

fn points(line: &geo::LineString<f64>) -> Vec<Point> {
    line.coords().copied().map(Point::from).collect()
}

fn line(points: &[Point]) -> geo::LineString<f64> {
    geo::LineString(points.iter().copied().map(Into::into).collect())
}

impl From<geo::Point<f64>> for Shape {
    fn from(point: geo::Point<f64>) -> Self {
        Self::Point(point.0.into())
    }
}

impl From<&geo::LineString<f64>> for Shape {
    fn from(line: &geo::LineString<f64>) -> Self {
        Self::Line(points(line))
    }
}

impl From<&geo::Polygon<f64>> for Shape {
    fn from(polygon: &geo::Polygon<f64>) -> Self {
        Self::Polygon(core::iter::once(polygon.exterior()).chain(polygon.interiors()).map(points).collect())
    }
}

/// A polygon gets closed rings; a polygon without rings is empty.
impl From<&Shape> for geo::Geometry<f64> {
    fn from(shape: &Shape) -> Self {
        match shape {
            Shape::Polygon(rings) => {
                let mut rings = rings.iter().map(|ring| line(ring));
                let outer = rings.next().unwrap_or_else(|| line(&[]));
                Self::Polygon(geo::Polygon::new(outer, rings.collect()))
            }
            Shape::Line(points) => Self::LineString(line(points)),
            Shape::Point(p) => Self::Point((*p).into()),
        }
    }
}

/// Takes all shapes of the geometry, including nested collections of any depth; empty shapes draw nothing. O(coordinates).
impl From<&geo::Geometry<f64>> for Feature {
    fn from(geometry: &geo::Geometry<f64>) -> Self {
        let mut shapes = Vec::new();
        let mut stack = vec![geometry];
        while let Some(geometry) = stack.pop() {
            match geometry {
                geo::Geometry::Point(point) => shapes.push((*point).into()),
                geo::Geometry::Line(line) => shapes.push(Shape::Line(vec![line.start.into(), line.end.into()])),
                geo::Geometry::LineString(line) => shapes.push(line.into()),
                geo::Geometry::Polygon(polygon) => shapes.push(polygon.into()),
                geo::Geometry::MultiPoint(points) => shapes.extend(points.iter().map(|p| Shape::from(*p))),
                geo::Geometry::MultiLineString(lines) => shapes.extend(lines.iter().map(Shape::from)),
                geo::Geometry::MultiPolygon(polygons) => shapes.extend(polygons.iter().map(Shape::from)),
                geo::Geometry::GeometryCollection(all) => stack.extend(all.0.iter().rev()),
                geo::Geometry::Rect(rect) => shapes.push((&rect.to_polygon()).into()),
                geo::Geometry::Triangle(triangle) => shapes.push((&triangle.to_polygon()).into()),
            }
        }
        shapes.retain(|shape| match shape {
            Shape::Polygon(rings) => rings.iter().any(|ring| !ring.is_empty()),
            Shape::Line(points) => !points.is_empty(),
            Shape::Point(_) => true,
        });
        Self { shapes, ..Self::default() }
    }
}

/// Makes one geometry for each shape.
impl From<&Feature> for geo::GeometryCollection<f64> {
    fn from(feature: &Feature) -> Self {
        Self(feature.shapes.iter().map(geo::Geometry::from).collect())
    }
}
