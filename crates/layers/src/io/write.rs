//! Common code and errors of the writers.

use std::io;
use thiserror::Error;
use twinedge_geometry::Point;
use twinedge_map::{Feature, Shape};

/// The error of the writers.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum WriteError {
    /// The underlying writer failed.
    #[error(transparent)]
    Io(#[from] io::Error),
    /// A coordinate is NaN or infinite, which the format cannot represent.
    #[error("feature {feature}: the coordinates ({x}, {y}) are not finite")]
    NotFinite {
        /// The feature, counted from 0.
        feature: usize,
        /// The first coordinate.
        x: f64,
        /// The second coordinate.
        y: f64,
    },
}

fn points_of(shape: &Shape) -> impl Iterator<Item = &Point> {
    let (rings, rest) = match shape {
        Shape::Polygon(rings) => (rings.as_slice(), &[][..]),
        Shape::Line(points) => (&[][..], points.as_slice()),
        Shape::Point(p) => (&[][..], core::slice::from_ref(p)),
    };
    rings.iter().flatten().chain(rest)
}

/// Checks all features before anything is written.
pub(super) fn check(features: &[Feature]) -> Result<(), WriteError> {
    for (feature, what) in features.iter().enumerate() {
        let mut points = what.shapes.iter().flat_map(points_of);
        if let Some(&Point { x, y }) = points.find(|p| !(p.x.is_finite() && p.y.is_finite())) {
            return Err(WriteError::NotFinite { feature, x, y });
        }
    }
    Ok(())
}

/// One geometry of a format, with at least one point in each part.
pub(super) enum GeometryPiece {
    Points(Vec<Point>),
    Lines(Vec<Vec<Point>>),
    Polygons(Vec<Vec<Vec<Point>>>),
}

/// Groups the shapes of a feature in order, joining neighbours of one kind. Rings, lines and polygons without points are left
/// out: not all formats can express them.
pub(super) fn pieces(feature: &Feature) -> Vec<GeometryPiece> {
    let mut pieces = Vec::new();
    for shape in feature.shapes.iter().filter(|shape| points_of(shape).next().is_some()) {
        match (shape, pieces.last_mut()) {
            (Shape::Point(p), Some(GeometryPiece::Points(points))) => points.push(*p),
            (Shape::Point(p), _) => pieces.push(GeometryPiece::Points(vec![*p])),
            (Shape::Line(line), Some(GeometryPiece::Lines(lines))) => lines.push(line.clone()),
            (Shape::Line(line), _) => pieces.push(GeometryPiece::Lines(vec![line.clone()])),
            (Shape::Polygon(rings), last) => {
                let rings = rings.iter().filter(|ring| !ring.is_empty()).cloned().collect();
                match last {
                    Some(GeometryPiece::Polygons(polygons)) => polygons.push(rings),
                    _ => pieces.push(GeometryPiece::Polygons(vec![rings])),
                }
            }
        }
    }
    pieces
}
