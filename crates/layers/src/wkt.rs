//! Well-known text, a geometry per line. The crate `wkt` reads the geometries. They are written here, because the crate panics at
//! a multi-polygon with an empty part.

use super::crs::Crs;
use super::each::Each;
use super::error::{ReadError, WriteError};
use super::model::{Dimensions, Feature, Geometry, Header, Layer, Line, Position, Shape};
use crate::io::wkt::read_geometries;
use crate::io::{ReadCause, ReadError as TextError, TextPlace};
use ::wkt::Wkt;
use ::wkt::types::{Coord, Dimension, LineString, Polygon};
use std::io::{self, Read, Write};

pub(super) fn read(reader: &mut dyn Read, each: &mut Each<'_>) -> Result<Header, ReadError> {
    let mut header = Header::default();
    read_geometries(reader, |line| {
        let geometry = converted(line.geometry);
        let mut is_finite = true;
        geometry.shape.visit(&mut |p| is_finite &= p.x.is_finite() && p.y.is_finite());
        if !is_finite {
            return Err(ReadError::Text(TextError::new(TextPlace::line(line.number), ReadCause::OutOfRange)));
        }
        header.crs = header.crs.take().or_else(|| line.srid.map(Crs::epsg));
        each(Feature { geometry: Some(geometry), ..Feature::default() })
    })?;
    Ok(header)
}

/// The recursion is as deep as collections are nested, which the reader limits.
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
            Shape::MultiPoint(points.points().iter().map(|point| point.coord().map(position)).collect()),
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
    let empty = Geometry::new(Dimensions::Xy, Shape::Collection(Vec::new()));
    for feature in &layer.features {
        write_geometry(feature.geometry.as_ref().unwrap_or(&empty), out)?;
        out.write_all(b"\n")?;
    }
    Ok(())
}

/// The recursion is as deep as collections are nested.
fn write_geometry(geometry: &Geometry, out: &mut dyn Write) -> io::Result<()> {
    let dimensions = match geometry.dimensions {
        Dimensions::Xy => "",
        Dimensions::Xyz => " Z",
        Dimensions::Xym => " M",
        Dimensions::Xyzm => " ZM",
    };
    write!(out, "{}{dimensions}", geometry.shape.name().to_ascii_uppercase())?;
    let more = geometry.dimensions.more();
    let position = |position: &Position, out: &mut dyn Write| write_position(position, more, out);
    let point = |point: &Option<Position>, out: &mut dyn Write| list("", point.as_slice(), out, position);
    let line = |line: &Line, out: &mut dyn Write| list("", line, out, position);
    let polygon = |rings: &Vec<Line>, out: &mut dyn Write| list("", rings, out, line);
    match &geometry.shape {
        Shape::Point(point) => list(" ", point.as_slice(), out, position),
        Shape::MultiPoint(points) => list(" ", points, out, point),
        Shape::Line(positions) => list(" ", positions, out, position),
        Shape::MultiLine(lines) | Shape::Polygon(lines) => list(" ", lines, out, line),
        Shape::MultiPolygon(polygons) => list(" ", polygons, out, polygon),
        Shape::Collection(geometries) => list(" ", geometries, out, write_geometry),
    }
}

/// Writes the parts of a geometry in brackets, or a space and `EMPTY`.
fn list<T>(
    space: &str,
    parts: &[T],
    out: &mut dyn Write,
    mut each: impl FnMut(&T, &mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    if parts.is_empty() {
        return write!(out, "{space}EMPTY");
    }
    for (number, part) in parts.iter().enumerate() {
        out.write_all(if number == 0 { b"(" } else { b"," })?;
        each(part, out)?;
    }
    out.write_all(b")")
}

fn write_position(position: &Position, more: usize, out: &mut dyn Write) -> io::Result<()> {
    write!(out, "{} {}", position.x, position.y)?;
    for i in 0..more {
        write!(out, " {}", position.more.get(i).copied().unwrap_or_default())?;
    }
    Ok(())
}
