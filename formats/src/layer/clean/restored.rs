//! Points that were rounded to a grid, back where they were.

use super::super::model::{Feature, Position};
use rustc_hash::FxHashMap;
use std::borrow::Cow;
use twinedge::algorithm::contour::Polygon;
use twinedge::geometry::Point;

/// The bits of the coordinates, −0 as 0.
pub(super) fn key(x: f64, y: f64) -> (u64, u64) {
    ((x + 0.0).to_bits(), (y + 0.0).to_bits())
}

/// The middle of the cell in which a position lies: halves go up, as where the map is built.
pub(super) fn rounded(position: &Position, cell: f64) -> Point {
    let up = |number: f64| {
        let (cells, below) = (number / cell, (number / cell).floor());
        // Adding a half could round.
        if cells - below >= 0.5 { below + 1.0 } else { below }
    };
    let [x, y] = [position.x, position.y].map(|number| up(number) * cell);
    Point::new(x + 0.0, y + 0.0)
}

/// By the middle of a cell, the first position of the input in it.
pub(super) struct Restoration(FxHashMap<(u64, u64), Point>);

impl Restoration {
    /// Notes all positions. O(positions), expected.
    pub(super) fn new(features: &[Cow<'_, Feature>], cell: f64) -> Self {
        let mut first = FxHashMap::default();
        for geometry in features.iter().filter_map(|feature| feature.geometry.as_ref()) {
            geometry.shape.visit(&mut |position| {
                let Point { x, y } = rounded(position, cell);
                first.entry(key(x, y)).or_insert_with(|| Point::new(position.x + 0.0, position.y + 0.0));
            });
        }
        Self(first)
    }

    /// Puts the points of a polygon back.
    pub(super) fn polygon(&self, polygon: &mut Polygon) {
        for point in polygon.outer.iter_mut().chain(polygon.holes.iter_mut().flatten()) {
            if let Some(first) = self.0.get(&key(point.x, point.y)) {
                *point = *first;
            }
        }
    }
}
