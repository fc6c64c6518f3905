//! Closing open rings, which no format permits.

use super::model::{Geometry, Layer, Line, Shape};
use std::borrow::Cow;

/// Returns the layer with all rings closed, repeating the first position of open ones. O(positions), with a copy if a ring is
/// open.
pub(super) fn closed(layer: &Layer) -> Cow<'_, Layer> {
    let mut layer = Cow::Borrowed(layer);
    if open_rings(&layer) > 0 {
        let features = &mut layer.to_mut().features;
        features.iter_mut().filter_map(|feature| feature.geometry.as_mut()).for_each(close);
    }
    layer
}

/// Returns the number of open rings. O(rings).
pub(super) fn open_rings(layer: &Layer) -> usize {
    layer.features.iter().filter_map(|feature| feature.geometry.as_ref()).map(count).sum()
}

/// The recursion is as deep as collections are nested.
fn count(geometry: &Geometry) -> usize {
    let of_polygon = |rings: &Vec<Line>| rings.iter().filter(|ring| is_open(ring)).count();
    match &geometry.shape {
        Shape::Polygon(rings) => of_polygon(rings),
        Shape::MultiPolygon(polygons) => polygons.iter().map(of_polygon).sum(),
        Shape::Collection(parts) => parts.iter().map(count).sum(),
        _ => 0,
    }
}

/// The recursion is as deep as collections are nested.
fn close(geometry: &mut Geometry) {
    let of_polygon = |rings: &mut Vec<Line>| {
        for ring in rings.iter_mut().filter(|ring| is_open(ring)) {
            ring.extend(ring.first().cloned());
        }
    };
    match &mut geometry.shape {
        Shape::Polygon(rings) => of_polygon(rings),
        Shape::MultiPolygon(polygons) => polygons.iter_mut().for_each(of_polygon),
        Shape::Collection(parts) => parts.iter_mut().for_each(close),
        _ => {}
    }
}

fn is_open(ring: &Line) -> bool {
    ring.first().zip(ring.last()).is_some_and(|(first, last)| (first.x, first.y) != (last.x, last.y))
}
