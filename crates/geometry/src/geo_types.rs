//! Points from and to the types of the crate [geo-types](::geo_types).

use crate::Point;
use ::geo_types as geo;

impl From<geo::Coord<f64>> for Point {
    fn from(coord: geo::Coord<f64>) -> Self {
        Self { x: coord.x, y: coord.y }
    }
}

impl From<Point> for geo::Coord<f64> {
    fn from(p: Point) -> Self {
        Self { x: p.x, y: p.y }
    }
}

impl From<Point> for geo::Point<f64> {
    fn from(p: Point) -> Self {
        Self(p.into())
    }
}
