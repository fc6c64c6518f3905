//! The box that closes the unbounded cells.

use super::error::VoronoiError;
use twinedge_geometry::Point;
use twinedge_geometry::predicates::in_range;

const LARGEST: f64 = f64::from_bits((1023 + 202) << 52);

/// Returns the given bounds, if the sites lie in them, or bounds that suit the sites.
pub(super) fn bounds(sites: &[Point], given: Option<[Point; 2]>) -> Result<[Point; 2], VoronoiError> {
    let (Some(first), rest) = (sites.first(), sites) else { return Err(VoronoiError::NoSites) };
    if let Some([low, high]) = given {
        let fits = |p: Point| in_range(p) && p.x.abs() <= LARGEST && p.y.abs() <= LARGEST;
        if !(fits(low) && fits(high) && low.x < high.x && low.y < high.y) {
            return Err(VoronoiError::Bounds);
        }
        let inside = |p: &Point| low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y;
        if let Some((site, Point { x, y })) = sites.iter().enumerate().find(|(_, p)| !inside(p)) {
            return Err(VoronoiError::Outside { site, x: *x, y: *y });
        }
        return Ok([low, high].map(|p| Point::new(p.x + 0.0, p.y + 0.0)));
    }
    let (mut low, mut high) = (*first, *first);
    for p in rest {
        (low.x, low.y) = (low.x.min(p.x), low.y.min(p.y));
        (high.x, high.y) = (high.x.max(p.x), high.y.max(p.y));
    }
    let extent = (high.x - low.x).max(high.y - low.y);
    let largest = [low.x, low.y, high.x, high.y].into_iter().fold(0.0, |largest: f64, c| largest.max(c.abs()));
    let margin = if extent > 0.0 {
        // Wide enough not to be lost in the coordinates.
        (0.1 * extent).max(largest * 2_f64.powi(-40))
    } else if largest > 0.0 {
        largest / 2.0
    } else {
        1.0
    };
    Ok([Point::new(low.x - margin, low.y - margin), Point::new(high.x + margin, high.y + margin)])
}
