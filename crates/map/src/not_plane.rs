//! The place where a map is not plane.

use core::fmt;
use thiserror::Error;
use twinedge_geometry::Point;
use twinedge_geometry::crossing::Clash;
use twinedge_geometry::predicates::on_segment;

/// Edges of a map meet where there is no vertex, so locations on it are undefined. `Display` suggests a remedy.
#[derive(Clone, Copy, Debug, Default, PartialEq, Error)]
#[non_exhaustive]
pub struct NotPlane {
    /// A meeting point, rounded; there may be more.
    pub at: Option<Point>,
}

impl NotPlane {
    /// Locates a clash of segments.
    pub(super) fn at(clash: Clash, points: &[Point], segments: &[[u32; 2]]) -> Self {
        let point = |v: u32| points[v as usize];
        let ends = |segment: u32| segments[segment as usize].map(point);
        Self {
            at: Some(match clash {
                Clash::SamePlace { a, .. } => point(a),
                Clash::Touch { vertex, .. } => point(vertex),
                Clash::Overlap { a, b } => {
                    let [[from, to], other] = [a, b].map(ends);
                    if on_segment(from, other[0], other[1]) { from } else { to }
                }
                Clash::Cross { a, b } => crossing(ends(a), ends(b)),
            }),
        }
    }
}

/// Returns the rounded point at which segments cross.
fn crossing([a, b]: [Point; 2], [c, d]: [Point; 2]) -> Point {
    let side = |p: Point| (d.x - c.x) * (p.y - c.y) - (d.y - c.y) * (p.x - c.x);
    let (before, after) = (side(a), side(b));
    let along = before / (before - after);
    let along = if along.is_finite() { along.clamp(0.0, 1.0) } else { 0.5 };
    Point::new(a.x + along * (b.x - a.x), a.y + along * (b.y - a.y))
}

impl fmt::Display for NotPlane {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the map is not plane: edges meet where no vertex is")?;
        if let Some(Point { x, y }) = self.at {
            write!(f, ", as at ({x}, {y})")?;
        }
        f.write_str(
            "; `Builder::build_with(Noding::Snap(Snap::Auto))` cuts them there, `PlanarMap::validate` lists all places",
        )
    }
}
