//! Restoring points that were rounded to a grid.

use super::super::model::Feature;
use rustc_hash::FxHashMap;
use std::borrow::Cow;
use twinedge_algorithm::contour::Polygon;
use twinedge_geometry::Point;
use twinedge_geometry::noding::NodingSummary;

/// Returns the bits of the coordinates, with −0 as 0.
pub(super) fn key(x: f64, y: f64) -> (u64, u64) {
    ((x + 0.0).to_bits(), (y + 0.0).to_bits())
}

/// The first input position in each cell, by the middle of the cell.
pub(super) struct Restoration(FxHashMap<(u64, u64), Point>);

impl Restoration {
    /// Records all positions. O(positions), expected.
    pub(super) fn new(features: &[Cow<'_, Feature>], noding: &NodingSummary) -> Self {
        let mut first = FxHashMap::default();
        for geometry in features.iter().filter_map(|feature| feature.geometry.as_ref()) {
            geometry.shape.visit(&mut |position| {
                let Point { x, y } = noding.snapped(Point::new(position.x, position.y));
                first.entry(key(x, y)).or_insert_with(|| Point::new(position.x + 0.0, position.y + 0.0));
            });
        }
        Self(first)
    }

    pub(super) fn polygon(&self, polygon: &mut Polygon) {
        for point in polygon.outer.iter_mut().chain(polygon.holes.iter_mut().flatten()) {
            if let Some(first) = self.0.get(&key(point.x, point.y)) {
                *point = *first;
            }
        }
    }
}
