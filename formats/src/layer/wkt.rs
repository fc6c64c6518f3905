//! Well-known text, a geometry per line. The crate `wkt` reads and writes the geometries.

use super::each::Each;
use super::error::{ReadError, WriteError};
use super::model::{Dimensions, Feature, Geometry, Header, Layer, Line, Position, Shape};
use ::wkt::Wkt;
use ::wkt::types::{
    Coord, Dimension, GeometryCollection, LineString, MultiLineString, MultiPoint, MultiPolygon, Point, Polygon,
};
use std::io::{Read, Write};
use twinedge::io::wkt::read_geometries;
use twinedge::io::{ReadCause, ReadError as TextError, TextPlace};

/// Reads a feature per line.
pub(super) fn read(reader: &mut dyn Read, each: &mut Each<'_>) -> Result<Header, ReadError> {
    read_geometries(reader, |line, geometry| {
        let geometry = converted(geometry);
        let mut is_finite = true;
        geometry.shape.visit(&mut |p| is_finite &= p.x.is_finite() && p.y.is_finite());
        if !is_finite {
            return Err(ReadError::Text(TextError::new(TextPlace::line(line), ReadCause::OutOfRange)));
        }
        each(Feature { geometry: Some(geometry), ..Feature::default() })
    })?;
    Ok(Header::default())
}

/// The recursion is as deep as collections are nested, which the reader bounds.
fn converted(geometry: Wkt<f64>) -> Geometry {
    fn position(coord: &Coord<f64>) -> Position {
        Position { x: coord.x, y: coord.y, more: [coord.z, coord.m].into_iter().flatten().collect() }
    }
    fn line(line: &LineString<f64>) -> Line {
        line.coords().iter().map(position).collect()
    }
    fn polygon(polygon: &Polygon<f64>) -> Vec<Line> {
        polygon.rings().iter().map(line).collect()
    }
    let (shape, dimension) = match geometry {
        Wkt::Point(point) => (Shape::Point(point.coord().map(position)), point.dimension()),
        Wkt::MultiPoint(points) => (
            Shape::MultiPoint(points.points().iter().filter_map(|point| point.coord().map(position)).collect()),
            points.dimension(),
        ),
        Wkt::LineString(all) => (Shape::Line(line(&all)), all.dimension()),
        Wkt::MultiLineString(lines) => {
            (Shape::MultiLine(lines.line_strings().iter().map(line).collect()), lines.dimension())
        }
        Wkt::Polygon(rings) => (Shape::Polygon(polygon(&rings)), rings.dimension()),
        Wkt::MultiPolygon(polygons) => {
            (Shape::MultiPolygon(polygons.polygons().iter().map(polygon).collect()), polygons.dimension())
        }
        Wkt::GeometryCollection(all) => {
            let (geometries, dimension) = all.into_inner();
            (Shape::Collection(geometries.into_iter().map(converted).collect()), dimension)
        }
    };
    let dimensions = match dimension {
        Dimension::XY => Dimensions::Xy,
        Dimension::XYZ => Dimensions::Xyz,
        Dimension::XYM => Dimensions::Xym,
        Dimension::XYZM => Dimensions::Xyzm,
    };
    Geometry::new(dimensions, shape)
}

/// Writes a geometry per line; a feature without one is an empty collection.
pub(super) fn write(layer: &Layer, out: &mut dyn Write) -> Result<(), WriteError> {
    for feature in &layer.features {
        let empty = || GeometryCollection::new(Vec::new(), Dimension::XY).into();
        let geometry = feature.geometry.as_ref().map_or_else(empty, written);
        writeln!(out, "{geometry}")?;
    }
    Ok(())
}

fn written(geometry: &Geometry) -> Wkt<f64> {
    let dimension = match geometry.dimensions {
        Dimensions::Xy => Dimension::XY,
        Dimensions::Xyz => Dimension::XYZ,
        Dimensions::Xym => Dimension::XYM,
        Dimensions::Xyzm => Dimension::XYZM,
    };
    let coord = |position: &Position| {
        let number = |i: usize| Some(position.more.get(i).copied().unwrap_or_default());
        let (z, m) = match dimension {
            Dimension::XY => (None, None),
            Dimension::XYZ => (number(0), None),
            Dimension::XYM => (None, number(0)),
            Dimension::XYZM => (number(0), number(1)),
        };
        Coord { x: position.x, y: position.y, z, m }
    };
    let line = |line: &Line| LineString::new(line.iter().map(coord).collect(), dimension);
    let polygon = |rings: &Vec<Line>| Polygon::new(rings.iter().map(line).collect(), dimension);
    let point = |position: &Position| Point::new(Some(coord(position)), dimension);
    match &geometry.shape {
        Shape::Point(position) => Point::new(position.as_ref().map(coord), dimension).into(),
        Shape::MultiPoint(points) => MultiPoint::new(points.iter().map(point).collect(), dimension).into(),
        Shape::Line(all) => line(all).into(),
        Shape::MultiLine(lines) => MultiLineString::new(lines.iter().map(line).collect(), dimension).into(),
        Shape::Polygon(rings) => polygon(rings).into(),
        Shape::MultiPolygon(polygons) => MultiPolygon::new(polygons.iter().map(polygon).collect(), dimension).into(),
        Shape::Collection(geometries) => {
            GeometryCollection::new(geometries.iter().map(written).collect(), dimension).into()
        }
    }
}
