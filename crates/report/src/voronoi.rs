//! The Voronoi cells and the Delaunay triangles of points, as GeoJSON.

use crate::outline::ring;
use crate::words::counted;
use serde_json::{Map, Value, json};
use twinedge::dcel::{FaceKey, StaleKey};
use twinedge_algorithm::voronoi::{Delaunay, Voronoi};
use twinedge_geometry::Point;
use twinedge_layers::{Layer, Shape};
use twinedge_map::PlanarMap;

/// Points and the properties of their features.
#[derive(Clone, Debug, Default)]
pub struct Sites {
    /// The points.
    pub points: Vec<Point>,
    /// The properties of each point's feature.
    pub properties: Vec<Map<String, Value>>,
}

/// The error for a feature whose geometry is not points.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("feature {feature}: its geometry is no point but {kind}")]
pub struct OtherGeometry {
    /// The feature, counted from 0.
    pub feature: usize,
    /// The kind of its geometry.
    pub kind: &'static str,
}

impl Sites {
    /// Returns the points of a layer.
    ///
    /// # Errors
    /// [`OtherGeometry`].
    pub fn new(layer: &Layer) -> Result<Self, OtherGeometry> {
        let mut sites = Self::default();
        for (number, feature) in layer.features.iter().enumerate() {
            let Some(geometry) = &feature.geometry else { continue };
            if !matches!(geometry.shape, Shape::Point(_) | Shape::MultiPoint(_)) {
                return Err(OtherGeometry { feature: number, kind: geometry.shape.name() });
            }
            let attributes = feature.attributes.iter().map(|(name, value)| (name.to_string(), value.to_json()));
            let properties: Map<String, Value> = attributes.collect();
            geometry.shape.visit(&mut |position| {
                sites.points.push(Point::new(position.x, position.y));
                sites.properties.push(properties.clone());
            });
        }
        Ok(sites)
    }
}

fn polygon(map: &PlanarMap, face: FaceKey, properties: &Map<String, Value>) -> Result<Value, StaleKey> {
    let geometry = json!({"type": "Polygon", "coordinates": [ring(map, face)?]});
    Ok(json!({"type": "Feature", "properties": properties, "geometry": geometry}))
}

/// Returns the cells as a feature collection, and a one-line summary. If points are too close to have separate cells, one feature has the cell and
/// lists the others as `merged`.
///
/// # Errors
/// Never: each cell is a face of the map.
pub fn cells(found: &Voronoi, sites: &Sites) -> Result<(String, String), StaleKey> {
    let mut features = Vec::new();
    let mut seen = std::collections::HashSet::new();
    for (site, cell) in found.cells.iter().enumerate().filter(|(_, cell)| seen.insert(**cell)) {
        let mut properties = sites.properties[site].clone();
        properties.insert("site".to_owned(), json!(site));
        let merged: Vec<usize> = found.merged.iter().filter(|one| one[1] == site).map(|one| one[0]).collect();
        if !merged.is_empty() {
            properties.insert("merged".to_owned(), json!(merged));
        }
        features.push(polygon(&found.map, *cell, &properties)?);
    }
    let [low, high] = found.bounds;
    let (points, cells) = (counted(found.cells.len(), "point"), counted(features.len(), "cell"));
    let mut what = format!("{points}, {cells} in the box from ({}, {}) to ({}, {})", low.x, low.y, high.x, high.y);
    if let Some(shared) = shared(found) {
        what = format!("{what}; {shared}");
    }
    let collection = json!({"type": "FeatureCollection", "bbox": [low.x, low.y, high.x, high.y], "features": features});
    Ok((collection.to_string() + "\n", what))
}

/// Describes the points that share another point's cell; `None` if no point does.
#[must_use]
pub fn shared(found: &Voronoi) -> Option<String> {
    const LISTED: usize = 5;
    let of_each = |[site, with]: &[usize; 2]| format!("{site} that of {with}");
    let listed: Vec<String> = found.merged.iter().take(LISTED).map(of_each).collect();
    let more = if found.merged.len() > LISTED { ", …" } else { "" };
    let points = counted(found.merged.len(), "point");
    let shared = || format!("{points} too close to others for a cell of their own: site {}{more}", listed.join(", "));
    (!found.merged.is_empty()).then(shared)
}

/// Returns the triangles as a feature collection, and a one-line summary.
///
/// # Errors
/// Never: each triangle is a face of the map.
pub fn triangles(found: &Delaunay) -> Result<(String, String), StaleKey> {
    let mut first = std::collections::HashMap::new();
    for (site, vertex) in found.vertices.iter().enumerate() {
        first.entry(*vertex).or_insert(site);
    }
    let mut features = Vec::new();
    for face in found.map.dcel().faces().filter(|face| !face.is_unbounded()) {
        let sites: Vec<usize> = face.half_edges().filter_map(|h| first.get(&h.origin().key()).copied()).collect();
        let properties = Map::from_iter([("sites".to_owned(), json!(sites))]);
        features.push(polygon(&found.map, face.key(), &properties)?);
    }
    let what = format!("{}, {}", counted(found.vertices.len(), "point"), counted(features.len(), "triangle"));
    Ok((json!({"type": "FeatureCollection", "features": features}).to_string() + "\n", what))
}
