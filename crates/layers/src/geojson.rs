//! GeoJSON (RFC 7946) and newline-delimited GeoJSON, read without dropping anything, and written.

use super::crs::Crs;
use super::each::Each;
use super::error::{ReadError, WriteError};
use super::geojson_cut::{Piece, read_parts};
use super::geojson_feature::{Rows, with_box};
use super::json::{self, InDegrees, Names};
use super::losses::is_reserved_in_json;
use super::model::{Feature, Geometry, Header, Id, Layer, Position, Shape, Value, json_number};
use crate::io::geojson::{Documents, Part};
use ::geojson::{Feature as Parsed, Geometry as ParsedGeometry, GeometryValue, feature};
use serde_json::Value as Json;
use std::io::{self, Read, Write};

/// Reads features, passing each to `each`.
pub(super) fn read(reader: &mut dyn Read, documents: Documents, each: &mut Each<'_>) -> Result<Header, ReadError> {
    let mut header = Header::default();
    let mut rows = Rows::default();
    let mut in_degrees = InDegrees::default();
    read_parts(reader, documents, |piece| {
        let feature = match piece {
            Piece::Feature(text) => match text.feature(&mut rows) {
                Some(feature) => feature,
                None => return Ok(false),
            },
            Piece::Part(Part::Feature(parsed)) => feature(*parsed, &mut rows.names),
            Piece::Part(Part::Member(name, member)) => {
                match member {
                    member if name == "crs" => header.crs = Some(Crs::of_member(member)),
                    Json::String(text) if name == "name" => header.name = Some(text),
                    member => drop(header.members.insert(name, member)),
                }
                return Ok(true);
            }
        };
        if let Some(geometry) = &feature.geometry {
            in_degrees.look_at(geometry);
        }
        each(feature)?;
        Ok(true)
    })?;
    header.crs = header.crs.or_else(|| in_degrees.crs());
    Ok(header)
}

fn feature(parsed: Parsed, names: &mut Names) -> Feature {
    let Parsed { bbox, geometry, id, properties, foreign_members } = parsed;
    let attributes = properties.into_iter().flatten();
    Feature {
        id: id.map(|id| match id {
            feature::Id::String(text) => Id::Text(text),
            feature::Id::Number(number) => Id::Number(number),
        }),
        geometry: geometry.map(converted),
        attributes: attributes.map(|(name, value)| (names.get(&name), Value::of_json(value))).collect(),
        members: with_box(bbox, foreign_members.unwrap_or_default()),
    }
}

fn converted(ParsedGeometry { bbox, value, foreign_members }: ParsedGeometry) -> Geometry {
    fn position(numbers: &::geojson::Position) -> Position {
        // The reader has checked that there are two.
        let numbers = numbers.as_slice();
        let number = |i: usize| numbers.get(i).copied().unwrap_or_default();
        Position { x: number(0), y: number(1), more: numbers.get(2..).unwrap_or_default().into() }
    }
    fn line(positions: &[::geojson::Position]) -> Vec<Position> {
        positions.iter().map(position).collect()
    }
    fn rings(rings: &[Vec<::geojson::Position>]) -> Vec<Vec<Position>> {
        rings.iter().map(|ring| line(ring)).collect()
    }
    let shape = match value {
        GeometryValue::Point { coordinates } => Shape::Point(Some(position(&coordinates))),
        GeometryValue::MultiPoint { coordinates } => {
            Shape::MultiPoint(line(&coordinates).into_iter().map(Some).collect())
        }
        GeometryValue::LineString { coordinates } => Shape::Line(line(&coordinates)),
        GeometryValue::MultiLineString { coordinates } => Shape::MultiLine(rings(&coordinates)),
        GeometryValue::Polygon { coordinates } => Shape::Polygon(rings(&coordinates)),
        GeometryValue::MultiPolygon { coordinates } => {
            Shape::MultiPolygon(coordinates.iter().map(|polygon| rings(polygon)).collect())
        }
        GeometryValue::GeometryCollection { geometries } => {
            Shape::Collection(geometries.into_iter().map(converted).collect())
        }
    };
    json::geometry(shape, with_box(bbox, foreign_members.unwrap_or_default()))
}

/// Writes one object, with one feature per line.
pub(super) fn write(layer: &Layer, out: &mut dyn Write) -> Result<(), WriteError> {
    out.write_all(b"{\"type\":\"FeatureCollection\",\n")?;
    if let Some(name) = &layer.header.name {
        member(out, "name", &Json::from(name.as_str()))?;
    }
    if let Some(crs) = layer.header.crs.as_ref().and_then(written_crs) {
        member(out, "crs", &crs)?;
    }
    for (name, value) in &layer.header.members {
        member(out, name, value)?;
    }
    out.write_all(b"\"features\":[")?;
    for (number, feature) in layer.features.iter().enumerate() {
        out.write_all(if number == 0 { b"\n" } else { b",\n" })?;
        write_feature(feature, out)?;
    }
    out.write_all(b"\n]}\n")?;
    Ok(())
}

/// Writes one feature per line.
pub(super) fn write_sequence(layer: &Layer, out: &mut dyn Write) -> Result<(), WriteError> {
    for feature in &layer.features {
        write_feature(feature, out)?;
        out.write_all(b"\n")?;
    }
    Ok(())
}

/// Returns the member `crs` of a layer in another system than longitude and latitude on WGS 84, if its number is known.
fn written_crs(crs: &Crs) -> Option<Json> {
    let of_code = || {
        let (authority, code) = crs.code.as_ref().filter(|_| crs.is_other())?;
        let name = format!("urn:ogc:def:crs:{authority}::{code}");
        Some(serde_json::json!({"type": "name", "properties": {"name": name}}))
    };
    crs.member.clone().or_else(of_code)
}

fn member(out: &mut dyn Write, name: &str, value: &Json) -> io::Result<()> {
    writeln!(out, "{}:{value},", Json::from(name))
}

pub(super) fn write_feature(feature: &Feature, out: &mut dyn Write) -> io::Result<()> {
    out.write_all(b"{\"type\":\"Feature\"")?;
    match &feature.id {
        Some(Id::Text(text)) => write!(out, ",\"id\":{}", Json::from(text.as_str()))?,
        Some(Id::Number(number)) => write!(out, ",\"id\":{number}")?,
        None => {}
    }
    for (name, value) in &feature.members {
        write!(out, ",{}:{value}", Json::from(name.as_str()))?;
    }
    out.write_all(b",\"properties\":{")?;
    for (number, (name, value)) in feature.attributes.iter().enumerate() {
        let comma = if number == 0 { "" } else { "," };
        write!(out, "{comma}{}:{}", Json::from(&**name), value.to_json())?;
    }
    out.write_all(b"},\"geometry\":")?;
    match &feature.geometry {
        Some(geometry) => write_geometry(geometry, out)?,
        None => out.write_all(b"null")?,
    }
    out.write_all(b"}")
}

pub(super) fn write_geometry(geometry: &Geometry, out: &mut dyn Write) -> io::Result<()> {
    let name = match &geometry.shape {
        Shape::Point(None) => "MultiPoint",
        shape => shape.name(),
    };
    if let Shape::Collection(geometries) = &geometry.shape {
        write!(out, "{{\"type\":\"{name}\",\"geometries\":")?;
        list(geometries, out, write_geometry)?;
    } else {
        write!(out, "{{\"type\":\"{name}\",\"coordinates\":")?;
        match &geometry.shape {
            Shape::Point(Some(point)) => write_position(point, out)?,
            Shape::Point(None) | Shape::Collection(_) => out.write_all(b"[]")?,
            // There is no empty position.
            Shape::MultiPoint(points) => list(points.iter().flatten(), out, write_position)?,
            Shape::Line(points) => write_line(points, out)?,
            Shape::MultiLine(lines) | Shape::Polygon(lines) => list(lines, out, |line, out| write_line(line, out))?,
            Shape::MultiPolygon(polygons) => {
                list(polygons, out, |rings, out| list(rings, out, |ring, out| write_line(ring, out)))?;
            }
        }
    }
    for (name, value) in geometry.members.iter().filter(|(name, _)| !is_reserved_in_json(name)) {
        write!(out, ",{}:{value}", Json::from(name.as_str()))?;
    }
    out.write_all(b"}")
}

fn write_line(positions: &[Position], out: &mut dyn Write) -> io::Result<()> {
    list(positions, out, write_position)
}

fn write_position(position: &Position, out: &mut dyn Write) -> io::Result<()> {
    out.write_all(b"[")?;
    write_number(position.x, out)?;
    for number in [&position.y].into_iter().chain(&position.more) {
        out.write_all(b",")?;
        write_number(*number, out)?;
    }
    out.write_all(b"]")
}

/// Writes the shortest text that parses to this number.
fn write_number(number: f64, out: &mut dyn Write) -> io::Result<()> {
    write!(out, "{}", json_number(number))
}

fn list<T>(
    items: impl IntoIterator<Item = T>,
    out: &mut dyn Write,
    mut each: impl FnMut(T, &mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    out.write_all(b"[")?;
    for (number, item) in items.into_iter().enumerate() {
        if number > 0 {
            out.write_all(b",")?;
        }
        each(item, out)?;
    }
    out.write_all(b"]")
}
