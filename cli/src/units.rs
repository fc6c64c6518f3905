//! Lengths and areas, in the units of the coordinates or along the earth.

use crate::input::Imported;
use crate::status::Failure;
use geographiclib_rs::{Geodesic, InverseGeodesic, PolygonArea, Winding};
use twinedge::algorithm::area::face_area;
use twinedge::algorithm::coverage::{CoverageRule, Finding};
use twinedge::dcel::{Face, HalfEdge, Vertex};
use twinedge::geometry::Point;
use twinedge::map::PlanarMap;
use twinedge::validate::Embedding;

/// The measure of lengths and areas.
#[derive(Debug, clap::Args)]
pub(crate) struct Measured {
    /// Lengths in metres along geodesics and areas in square metres, on the ellipsoid WGS 84. Only for coordinates that are
    /// longitudes and latitudes in degrees.
    #[arg(long)]
    geodesic: bool,
}

impl Measured {
    /// The units for a map.
    pub(crate) fn units(&self, imported: &Imported) -> Result<Units, Failure> {
        let degrees = imported.noted.look_like_degrees(&imported.read);
        match (self.geodesic, degrees) {
            (false, degrees) => Ok(Units::Plane { degrees }),
            (true, true) => Ok(Units::Geodesic(Box::new(Geodesic::wgs84()))),
            (true, false) => Err(Failure(format!(
                "{}: --geodesic is for longitudes and latitudes, and the coordinates are not in their range, or the file names \
another coordinate reference system",
                imported.name
            ))),
        }
    }
}

/// The units of lengths and areas.
#[derive(Debug)]
pub(crate) enum Units {
    /// Those of the coordinates.
    Plane {
        /// True if these look like degrees.
        degrees: bool,
    },
    /// Metres.
    Geodesic(Box<Geodesic>),
}

impl Units {
    /// The unit of lengths; areas are in its square.
    pub(crate) const fn name(&self) -> &'static str {
        match self {
            Self::Plane { degrees: true } => "degrees",
            Self::Plane { degrees: false } => "units of the coordinates",
            Self::Geodesic(_) => "metres",
        }
    }

    /// A sentence about the units, with the offer of others.
    pub(crate) const fn sentence(&self) -> &'static str {
        match self {
            Self::Plane { degrees: true } => {
                "lengths in degrees and areas in square degrees, if the coordinates are what they look like; --geodesic: metres"
            }
            Self::Plane { degrees: false } => "lengths and areas in the units of the coordinates",
            Self::Geodesic(_) => "lengths in metres and areas in square metres, on the ellipsoid WGS 84",
        }
    }

    /// The length of a chain.
    pub(crate) fn length(&self, chain: &[Point]) -> f64 {
        chain.windows(2).map(|pair| self.distance(pair[0], pair[1])).sum()
    }

    fn distance(&self, a: Point, b: Point) -> f64 {
        match self {
            Self::Plane { .. } => (b.x - a.x).hypot(b.y - a.y),
            Self::Geodesic(earth) => earth.inverse(a.y, a.x, b.y, b.x),
        }
    }

    /// The area of a bounded face.
    pub(crate) fn area(&self, map: &PlanarMap, face: Face<'_>) -> f64 {
        let Self::Geodesic(earth) = self else { return face_area(map, face.key()).unwrap_or_default() };
        let ring = |half_edges: &mut dyn Iterator<Item = HalfEdge<'_>>| {
            let mut polygon = PolygonArea::new(earth, Winding::CounterClockwise);
            for h in half_edges {
                let p = point(map, h.origin());
                polygon.add_point(p.y, p.x);
            }
            // Negative for holes, which turn clockwise.
            polygon.compute(true).1
        };
        face.boundaries().map(|boundary| ring(&mut boundary.half_edges())).sum()
    }

    /// A finding in these units. The area of a near miss is scaled as at its place: it has no faces.
    pub(crate) fn convert(&self, map: &PlanarMap, finding: &mut Finding) {
        let Self::Geodesic(_) = self else { return };
        if finding.rule == CoverageRule::NearMiss {
            let Point { x, y } = finding.at;
            let step = 1e-3;
            let by_degree = |to: Point| self.distance(finding.at, to) / step;
            finding.area *= by_degree(Point::new(x + step, y)) * by_degree(Point::new(x, y - step.copysign(y)));
            finding.length = finding.stretches.iter().map(|stretch| self.length(stretch)).sum();
        } else {
            let faces: Vec<Face<'_>> = finding.faces.iter().filter_map(|f| map.dcel().face(*f).ok()).collect();
            let border = faces.iter().flat_map(|f| f.half_edges()).filter(|h| !faces.contains(&h.twin().face()));
            finding.length = border.map(|h| self.distance(point(map, h.origin()), point(map, h.target()))).sum();
            finding.area = faces.iter().map(|face| self.area(map, *face)).sum();
        }
        finding.width = if finding.length > 0.0 { 2.0 * finding.area / finding.length } else { 0.0 };
    }
}

fn point(map: &PlanarMap, vertex: Vertex<'_>) -> Point {
    map.point(vertex.index())
}

#[cfg(test)]
mod tests {
    use super::Units;
    use geographiclib_rs::Geodesic;
    use twinedge::geometry::Point;
    use twinedge::map::{Builder, Shape};

    /// A square of one degree at the equator has an area of 12308778361.469 m² and a perimeter of 443770.917 m
    /// (the documentation of `PolygonArea` in the library `GeographicLib`).
    #[test]
    fn a_degree_at_the_equator_is_as_large_as_geographiclib_says() {
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.0, 0.0]].map(Point::from);
        let earth = Units::Geodesic(Box::new(Geodesic::wgs84()));
        assert!((earth.length(&square) - 443_770.917).abs() < 1e-3);
        let mut builder = Builder::new();
        builder.shape(&Shape::Polygon(vec![square.to_vec()])).expect("in range");
        let map = builder.build().expect("small");
        let face = map.dcel().faces().find(|face| !face.is_unbounded()).expect("the square");
        assert!((earth.area(&map, face) - 12_308_778_361.469).abs() < 1e-2);
        assert!((Units::Plane { degrees: true }.length(&square) - 4.0).abs() < 1e-12);
    }
}
