//! Writing features.

use crate::io::write;
use crate::io::write::{GeometryPiece, WriteError};
use ::geojson::feature::Id;
use ::geojson::{Error, Feature as Written, FeatureWriter, Geometry, GeometryValue, JsonObject, Position};
use std::io::{self, Write};
use twinedge_geometry::Point;
use twinedge_map::Feature;

/// Writes a feature collection.
///
/// A feature's name is written as its property `name`, and its id as the member `id`. One shape is written directly, several of a
/// kind as a multi-geometry, other mixtures as a collection, no shape as null. Numbers have enough digits to be read back
/// exactly. Points, lines and rings are written as they are, so rings should be closed and have the direction required by the
/// format, like the rings of a [contour](twinedge_algorithm::contour). The writer is not buffered inside. O(points).
///
/// # Errors
///
/// [`WriteError::NotFinite`], before anything is written, and [`WriteError::Io`].
///
/// ```
/// use twinedge_geometry::Point;
/// use twinedge_map::{Feature, Shape};
/// use twinedge_layers::io::geojson;
/// use twinedge_layers::{ReadOptions, read_for_map};
///
/// let peak = Shape::Point(Point::new(7.6585, 45.9764));
/// let feature = Feature { name: Some("Matterhorn".into()), id: Some("4478".into()), shapes: vec![peak] };
/// let mut text = Vec::new();
/// geojson::write(&mut text, &[feature.clone()])?;
/// assert_eq!(read_for_map(&mut text.as_slice(), &ReadOptions::default())?.0, [feature]);
/// # Ok::<_, Box<dyn std::error::Error>>(())
/// ```
pub fn write(mut writer: impl Write, features: &[Feature]) -> Result<(), WriteError> {
    write::check(features)?;
    let mut collection = FeatureWriter::from_writer(&mut writer);
    let mut written = features.iter().try_for_each(|feature| collection.write_feature(&converted(feature)));
    if written.is_ok() {
        written = collection.finish();
    }
    drop(collection);
    written.map_err(io_error)?;
    writeln!(writer)?;
    Ok(())
}

/// Unwraps the writer's error, which the crate wraps once or twice.
fn io_error(error: Error) -> io::Error {
    match error {
        Error::Io(error) => error,
        Error::MalformedGeoJson(error) => error.into(),
        other => io::Error::other(other),
    }
}

fn converted(feature: &Feature) -> Written {
    let mut geometries: Vec<Geometry> = write::pieces(feature).into_iter().map(|p| Geometry::new(value(p))).collect();
    let geometry = match geometries.pop() {
        Some(last) if !geometries.is_empty() => {
            geometries.push(last);
            Some(Geometry::new(GeometryValue::GeometryCollection { geometries }))
        }
        one_or_none => one_or_none,
    };
    let mut properties = JsonObject::new();
    if let Some(name) = &feature.name {
        properties.insert("name".to_owned(), name.as_str().into());
    }
    let id = feature.id.clone().map(Id::String);
    Written { bbox: None, geometry, id, properties: Some(properties), foreign_members: None }
}

fn value(piece: GeometryPiece) -> GeometryValue {
    fn position(p: Point) -> Position {
        Position::from([p.x, p.y])
    }
    fn line(points: Vec<Point>) -> Vec<Position> {
        points.into_iter().map(position).collect()
    }
    fn polygon(rings: Vec<Vec<Point>>) -> Vec<Vec<Position>> {
        rings.into_iter().map(line).collect()
    }
    match piece {
        GeometryPiece::Points(points) => match points[..] {
            [only] => GeometryValue::Point { coordinates: position(only) },
            _ => GeometryValue::MultiPoint { coordinates: line(points) },
        },
        GeometryPiece::Lines(mut lines) => match lines.pop() {
            Some(only) if lines.is_empty() => GeometryValue::LineString { coordinates: line(only) },
            last => GeometryValue::MultiLineString { coordinates: lines.into_iter().chain(last).map(line).collect() },
        },
        GeometryPiece::Polygons(mut polygons) => match polygons.pop() {
            Some(only) if polygons.is_empty() => GeometryValue::Polygon { coordinates: polygon(only) },
            last => {
                GeometryValue::MultiPolygon { coordinates: polygons.into_iter().chain(last).map(polygon).collect() }
            }
        },
    }
}
