//! Lengths and areas in the units of the coordinates or in metres along the earth.

use crate::error::Error;
use crate::imported::Imported;
use geographiclib_rs::{Geodesic, InverseGeodesic};
use std::collections::HashSet;
use twinedge::dcel::{Face, FaceKey, Vertex};
use twinedge_algorithm::area::face_area;
use twinedge_coverage::layers::LayerFinding;
use twinedge_coverage::{CoverageRule, Finding};
use twinedge_geometry::Point;
use twinedge_layers::Crs;
use twinedge_map::{Embedding, PlanarMap};

/// The units of lengths and areas.
#[derive(Debug)]
pub enum Units {
    /// The named unit of the coordinates.
    Plane(&'static str),
    /// Metres along the earth.
    Geodesic(Box<Geodesic>),
}

impl Units {
    /// The unit of lengths along the earth.
    pub const METRES: &'static str = "metres";
    /// The unit of longitudes and latitudes.
    pub const DEGREES: &'static str = "degrees";
    /// The name for an unknown unit of coordinates.
    pub const UNKNOWN: &'static str = "units of the coordinates";

    /// Returns the units for a map: metres along the earth, or the units of the coordinates.
    ///
    /// # Errors
    /// [`Error::NotDegrees`].
    pub fn of(imported: &Imported, geodesic: bool) -> Result<Self, Error> {
        let degrees = imported.noted.look_like_degrees(&imported.read);
        let of_crs = imported.crs.as_ref().and_then(Crs::unit).unwrap_or(Self::UNKNOWN);
        match (geodesic, degrees) {
            (false, true) => Ok(Self::Plane(Self::DEGREES)),
            (false, false) => Ok(Self::Plane(of_crs)),
            (true, true) => Ok(Self::Geodesic(Box::new(Geodesic::wgs84()))),
            (true, false) => Err(Error::NotDegrees),
        }
    }

    /// Returns the unit of lengths; areas are in its square.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Plane(unit) => unit,
            Self::Geodesic(_) => Self::METRES,
        }
    }

    /// Returns a sentence on the units that mentions the alternative.
    #[must_use]
    pub fn sentence(&self) -> String {
        match self {
            Self::Plane(Self::DEGREES) => {
                "lengths in degrees and areas in square degrees, if the coordinates are what they look like; --geodesic: metres".to_owned()
            }
            Self::Plane(Self::UNKNOWN) => "lengths and areas in the units of the coordinates".to_owned(),
            Self::Plane(unit) => format!("lengths in {unit} and areas in square {unit}, the units of the reference system"),
            Self::Geodesic(_) => "lengths in metres and areas in square metres, on the ellipsoid WGS 84".to_owned(),
        }
    }

    /// Returns the length of a chain.
    #[must_use]
    pub fn length(&self, chain: &[Point]) -> f64 {
        chain.windows(2).map(|pair| self.distance(pair[0], pair[1])).sum()
    }

    fn distance(&self, a: Point, b: Point) -> f64 {
        match self {
            Self::Plane(_) => (b.x - a.x).hypot(b.y - a.y),
            Self::Geodesic(earth) => earth.inverse(a.y, a.x, b.y, b.x),
        }
    }

    /// Returns the area of a bounded face. Edges are straight in longitude and latitude, as on the map, so areas add up and none is negative.
    #[must_use]
    pub fn area(&self, map: &PlanarMap, face: Face<'_>) -> f64 {
        let Self::Geodesic(earth) = self else { return face_area(map, face.key()).unwrap_or_default() };
        let base = face.half_edges().next().map_or(0.0, |h| point(map, h.origin()).y);
        let ends = face.half_edges().map(|h| [point(map, h.origin()), point(map, h.target())]);
        // The inside lies to the left: above an edge that runs east.
        -ends.map(|edge| area_above(earth, base, edge)).sum::<f64>()
    }

    /// The area of a set of faces, and the length of their boundary.
    fn area_and_length(&self, map: &PlanarMap, faces: &[FaceKey]) -> (f64, f64) {
        let faces: Vec<Face<'_>> = faces.iter().filter_map(|f| map.dcel().face(*f).ok()).collect();
        let inside: HashSet<usize> = faces.iter().map(|face| face.index()).collect();
        let border = faces.iter().flat_map(|f| f.half_edges()).filter(|h| !inside.contains(&h.twin().face().index()));
        let length = border.map(|h| self.distance(point(map, h.origin()), point(map, h.target()))).sum();
        (faces.iter().map(|face| self.area(map, *face)).sum(), length)
    }

    pub(crate) fn convert_between(&self, map: &PlanarMap, finding: &mut LayerFinding) {
        let Self::Geodesic(_) = self else { return };
        if finding.faces.is_empty() {
            finding.length = finding.stretches.iter().map(|stretch| self.length(stretch)).sum();
            return;
        }
        (finding.area, finding.length) = self.area_and_length(map, &finding.faces);
        finding.width = if finding.length > 0.0 { 2.0 * finding.area / finding.length } else { 0.0 };
    }

    /// Converts a finding to these units. A near miss has no faces, so its area is scaled as at its place.
    pub(crate) fn convert(&self, map: &PlanarMap, finding: &mut Finding) {
        let Self::Geodesic(_) = self else { return };
        if finding.rule == CoverageRule::Mismatch {
            finding.length = finding.stretches.iter().map(|stretch| self.length(stretch)).sum();
            return;
        }
        if finding.rule == CoverageRule::NearMiss {
            let Point { x, y } = finding.at;
            let step = 1e-3;
            let by_degree = |to: Point| self.distance(finding.at, to) / step;
            finding.area *= by_degree(Point::new(x + step, y)) * by_degree(Point::new(x, y - step.copysign(y)));
            finding.length = finding.stretches.iter().map(|stretch| self.length(stretch)).sum();
        } else {
            (finding.area, finding.length) = self.area_and_length(map, &finding.faces);
        }
        finding.width = if finding.length > 0.0 { 2.0 * finding.area / finding.length } else { 0.0 };
    }
}

/// The area on the ellipsoid between a parallel and an edge; negative if the edge lies below the parallel or runs west.
fn area_above(earth: &Geodesic, parallel: f64, [a, b]: [Point; 2]) -> f64 {
    let squared = earth.f * (2.0 - earth.f);
    // The area of a small rectangle of longitudes and latitudes, in radians.
    let density = |latitude: f64| {
        let (sine, cosine) = latitude.to_radians().sin_cos();
        earth.a * earth.a * (1.0 - squared) * cosine / (1.0 - squared * sine * sine).powi(2)
    };
    let column = |height: f64| height.to_radians() * mean(|part| density(parallel + height * part));
    (b.x - a.x).to_radians() * mean(|part| column(a.y - parallel + (b.y - a.y) * part))
}

/// The mean of a smooth function from 0 to 1, by Gauss–Legendre quadrature with five nodes.
fn mean(function: impl Fn(f64) -> f64) -> f64 {
    const NODES: [(f64, f64); 3] = [
        (0.0, 0.568_888_888_888_888_9),
        (0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
        (0.906_179_845_938_664, 0.236_926_885_056_189_08),
    ];
    let [middle, inner, outer] = NODES;
    let both = |(node, weight): (f64, f64)| weight * (function(0.5 - node / 2.0) + function(0.5 + node / 2.0));
    (middle.1 * function(0.5) + both(inner) + both(outer)) / 2.0
}

fn point(map: &PlanarMap, vertex: Vertex<'_>) -> Point {
    map.point(vertex.index())
}

#[cfg(test)]
mod tests {
    use super::Units;
    use geographiclib_rs::Geodesic;
    use twinedge_geometry::Point;
    use twinedge_map::{Builder, Shape};

    fn earth() -> Units {
        Units::Geodesic(Box::new(Geodesic::wgs84()))
    }

    fn area(points: &[[f64; 2]]) -> f64 {
        let mut builder = Builder::new();
        builder.shape(&Shape::Polygon(vec![points.iter().copied().map(Point::from).collect()])).expect("in range");
        let map = builder.build().expect("small");
        let face = map.dcel().faces().find(|face| !face.is_unbounded()).expect("one");
        earth().area(&map, face)
    }

    /// A square of one degree at the equator has a perimeter of 443770.917 m (the documentation of `PolygonArea` in the library `GeographicLib`). The
    /// area is the limit of `PolygonArea` with 100, 1000 and 4000 points on each side: with the corners alone, edges would be geodesics.
    #[test]
    fn a_degree_at_the_equator_is_as_large_as_geographiclib_says() {
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.0, 0.0]];
        let points = square.map(Point::from);
        assert!((earth().length(&points) - 443_770.917).abs() < 1e-3);
        assert!((Units::Plane(Units::DEGREES).length(&points) - 4.0).abs() < 1e-12);
        assert!((area(&square) - 12_308_463_893.975).abs() < 0.05, "{}", area(&square));
    }

    /// The parallel of 60 degrees lies south of the geodesic between its ends: with geodesics, this strip has an area of -2.6e9 m². The expected area
    /// is the limit of `PolygonArea` with more and more points on each side.
    #[test]
    fn a_thin_strip_has_no_negative_area() {
        let strip = area(&[[0.0, 60.0], [10.0, 60.0], [5.0, 60.01], [0.0, 60.0]]);
        assert!((strip / 310_809_178.0 - 1.0).abs() < 1e-6, "{strip}");
    }
}
