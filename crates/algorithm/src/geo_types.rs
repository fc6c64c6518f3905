//! Outlines as types of the crate [geo-types](::geo_types), shared by the Rust geospatial crates.
//!
//! ```
//! use geo_types::{Geometry, MultiPolygon, polygon};
//! use twinedge_algorithm::contour;
//! use twinedge_map::{Builder, Feature};
//!
//! let west = polygon![(x: 0.0, y: 0.0), (x: 1.0, y: 0.0), (x: 1.0, y: 1.0), (x: 0.0, y: 1.0)];
//! let east = polygon![(x: 1.0, y: 0.0), (x: 2.0, y: 0.0), (x: 2.0, y: 1.0), (x: 1.0, y: 1.0)];
//! let both = Geometry::MultiPolygon(MultiPolygon(vec![west, east]));
//!
//! let mut builder = Builder::new();
//! let feature = builder.feature(&Feature::from(&both))?;
//! let map = builder.build()?;
//! assert_eq!(map.dcel().face_count(), 3);
//!
//! // The contour has no edge between the two.
//! let outline = MultiPolygon::from(&contour::of_feature(&map, feature)?);
//! assert_eq!(outline.0.len(), 1);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use crate::contour::{Contour, Polygon};
use ::geo_types as geo;
use twinedge_geometry::Point;

fn line(points: &[Point]) -> geo::LineString<f64> {
    geo::LineString(points.iter().copied().map(Into::into).collect())
}

impl From<&Polygon> for geo::Polygon<f64> {
    fn from(polygon: &Polygon) -> Self {
        Self::new(line(&polygon.outer), polygon.holes.iter().map(|hole| line(hole)).collect())
    }
}

impl From<&Contour> for geo::MultiPolygon<f64> {
    fn from(contour: &Contour) -> Self {
        Self(contour.polygons.iter().map(geo::Polygon::from).collect())
    }
}
