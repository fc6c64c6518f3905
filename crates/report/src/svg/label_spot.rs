//! The place in a face with room for a label.

use super::frame::{Frame, sides};
use twinedge::dcel::Face;
use twinedge_geometry::Point;
use twinedge_map::PlanarMap;

pub(super) struct LabelSpot {
    pub(super) middle: [f64; 2],
    pub(super) width: f64,
}

/// The heights to try, as fractions of the height of the face.
const HEIGHTS: [f64; 7] = [0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8];

/// Returns the widest stretch at one of a few heights; none for the unbounded face. O(half-edges · log).
pub(super) fn widest(map: &PlanarMap, frame: &Frame, face: Face<'_>) -> Option<LabelSpot> {
    face.outer()?;
    let sides: Vec<Side> = sides(map, frame, face).collect();
    widest_between(heights(&sides), &sides)
}

/// Returns the widest stretch inside these rings, by the even-odd rule, at one of a few heights of the largest. O(points · log).
pub(super) fn widest_within(frame: &Frame, rings: &[Vec<Point>]) -> Option<LabelSpot> {
    let sides_of = |ring: &Vec<Point>| -> Vec<Side> {
        let at = |p: &Point| frame.at(*p);
        ring.iter().zip(ring.iter().cycle().skip(1)).map(|(a, b)| [at(a), at(b)]).collect()
    };
    let rings: Vec<Vec<Side>> = rings.iter().map(sides_of).collect();
    let height = |[low, high]: [f64; 2]| high - low;
    let largest = rings.iter().map(|ring| heights(ring)).max_by(|a, b| height(*a).total_cmp(&height(*b)))?;
    widest_between(largest, &rings.concat())
}

type Side = [[f64; 2]; 2];

fn heights(sides: &[Side]) -> [f64; 2] {
    sides.iter().flatten().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], [_, y]| [low.min(*y), high.max(*y)])
}

fn widest_between([low, high]: [f64; 2], sides: &[Side]) -> Option<LabelSpot> {
    let stretches = HEIGHTS.into_iter().filter_map(|part| {
        let y = low + part * (high - low);
        let mut crossed: Vec<f64> = sides
            .iter()
            .filter(|[a, b]| (a[1] <= y) != (b[1] <= y))
            .map(|[a, b]| a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
            .collect();
        crossed.sort_by(f64::total_cmp);
        // Edges with the face on both sides are crossed twice, which leaves the others in pairs.
        let inside = crossed
            .chunks_exact(2)
            .map(|pair| LabelSpot { middle: [f64::midpoint(pair[0], pair[1]), y], width: pair[1] - pair[0] });
        inside.max_by(|a, b| a.width.total_cmp(&b.width))
    });
    // Among almost equal ones the first, which is nearer to the middle.
    stretches.reduce(|best, next| if next.width > 1.15 * best.width { next } else { best })
}
