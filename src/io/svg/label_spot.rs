//! The place in a face with room for a label.

use super::frame::{Frame, sides};
use crate::dcel::Face;
use crate::map::PlanarMap;

/// A horizontal stretch inside a face.
pub(super) struct LabelSpot {
    pub(super) middle: [f64; 2],
    pub(super) width: f64,
}

/// The heights at which to look, as parts of the height of the face.
const HEIGHTS: [f64; 7] = [0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8];

/// The widest stretch at one of a few heights; none for the unbounded face. O(half-edges · log).
pub(super) fn widest(map: &PlanarMap, frame: &Frame, face: Face<'_>) -> Option<LabelSpot> {
    face.outer()?;
    let ends = sides(map, frame, face).flatten();
    let (low, high) = ends.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), [_, y]| (low.min(y), high.max(y)));
    let stretches = HEIGHTS.into_iter().filter_map(|part| {
        let y = low + part * (high - low);
        let mut crossed: Vec<f64> = sides(map, frame, face)
            .filter(|[a, b]| (a[1] <= y) != (b[1] <= y))
            .map(|[a, b]| a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
            .collect();
        crossed.sort_unstable_by(f64::total_cmp);
        // Edges with the face on both sides are crossed twice, which leaves the others in pairs.
        let inside = crossed
            .chunks_exact(2)
            .map(|pair| LabelSpot { middle: [f64::midpoint(pair[0], pair[1]), y], width: pair[1] - pair[0] });
        inside.max_by(|a, b| a.width.total_cmp(&b.width))
    });
    // Of almost equal ones the first, which is nearer to the middle.
    stretches.reduce(|best, next| if next.width > 1.15 * best.width { next } else { best })
}
