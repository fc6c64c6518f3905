//! Features as the library takes them.

use super::crs::Crs;
use super::error::ReadError;
use super::model::{Feature, Geometry, Line, Position, Shape};
use super::read::{ReadOptions, read};
use crate::io::ReadSummary;
use std::io::Read;
use twinedge_geometry::Point;

/// Returns the feature for a map, with its name and id, and counts it in a summary. Further dimensions and empty shapes are
/// dropped, collections flattened. O(positions).
///
/// ```
/// use twinedge_layers::io::ReadSummary;
/// use twinedge_map::Shape as MapShape;
/// use twinedge_layers::{Dimensions, Feature, Geometry, Position, Shape, to_map};
///
/// let shape = Shape::Point(Some(Position { more: Box::from([4478.0]), ..Position::new(7.66, 45.98) }));
/// let peak = Feature { geometry: Some(Geometry::new(Dimensions::Xyz, shape)), ..Feature::default() };
/// let mut summary = ReadSummary::default();
/// assert!(matches!(to_map(&peak, &mut summary).shapes[..], [MapShape::Point(_)]));
/// assert_eq!((summary.points, summary.with_extra_dimensions), (1, 1));
/// ```
#[must_use]
pub fn to_map(feature: &Feature, summary: &mut ReadSummary) -> twinedge_map::Feature {
    let mut shapes = Vec::new();
    let (mut further, mut empty) = (0, 0);
    if let Some(geometry) = &feature.geometry {
        geometry.shape.visit(&mut |position| further += usize::from(!position.more.is_empty()));
        add(geometry, &mut shapes, &mut empty);
    }
    let name = feature.name();
    summary.dropped_properties += feature.attributes.len() - usize::from(name.is_some());
    let feature = twinedge_map::Feature { name, id: feature.id.as_ref().map(ToString::to_string), shapes };
    summary.add(&feature, further, empty);
    feature
}

/// Reads the features of a map, for a [`Builder`](twinedge_map::Builder), and counts the parts that a map does not have.
///
/// ```
/// use twinedge_layers::{ReadOptions, read_for_map};
/// use twinedge_map::Builder;
///
/// # #[cfg(feature = "wkt")] {
/// let text = "# two parcels\nPOLYGON((0 0, 1 0, 1 1, 0 0))\nPOLYGON((0 0, 1 1, 0 1, 0 0))\n";
/// let (features, summary) = read_for_map(&mut text.as_bytes(), &ReadOptions::default())?;
/// assert_eq!((summary.features, summary.polygons), (2, 2));
/// let mut builder = Builder::new();
/// for feature in &features {
///     builder.feature(feature)?;
/// }
/// assert_eq!(builder.build()?.dcel().face_count(), 3);
/// # }
/// # Ok::<_, Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// As for [`read`].
pub fn read_for_map(
    reader: &mut dyn Read,
    options: &ReadOptions,
) -> Result<(Vec<twinedge_map::Feature>, ReadSummary), ReadError> {
    let (mut features, mut summary) = (Vec::new(), ReadSummary::default());
    let header = read(reader, None, options, &mut |feature| {
        features.push(to_map(&feature, &mut summary));
        Ok(())
    })?;
    summary.other_crs = usize::from(header.crs.as_ref().is_some_and(Crs::is_other));
    Ok((features, summary))
}

/// The recursion is as deep as collections are nested.
fn add(geometry: &Geometry, shapes: &mut Vec<twinedge_map::Shape>, empty: &mut usize) {
    fn line(positions: &Line) -> Vec<Point> {
        positions.iter().map(|p| Point::new(p.x, p.y)).collect()
    }
    let mut put = |shape: Option<twinedge_map::Shape>| match shape {
        Some(shape) => shapes.push(shape),
        None => *empty += 1,
    };
    let of_point = |point: Option<&Position>| point.map(|p| twinedge_map::Shape::Point(Point::new(p.x, p.y)));
    let of_line = |positions: &Line| (!positions.is_empty()).then(|| twinedge_map::Shape::Line(line(positions)));
    let of_rings =
        |rings: &Vec<Line>| (!rings.is_empty()).then(|| twinedge_map::Shape::Polygon(rings.iter().map(line).collect()));
    match &geometry.shape {
        Shape::Point(point) => put(of_point(point.as_ref())),
        Shape::MultiPoint(points) => points.iter().for_each(|point| put(of_point(point.as_ref()))),
        Shape::Line(positions) => put(of_line(positions)),
        Shape::MultiLine(lines) => lines.iter().for_each(|positions| put(of_line(positions))),
        Shape::Polygon(rings) => put(of_rings(rings)),
        Shape::MultiPolygon(polygons) => polygons.iter().for_each(|rings| put(of_rings(rings))),
        Shape::Collection(geometries) => geometries.iter().for_each(|geometry| add(geometry, shapes, empty)),
    }
}
