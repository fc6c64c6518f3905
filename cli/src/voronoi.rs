//! `twinedge voronoi`: the cells of the points of a file.

use crate::extension::format_of;
use crate::input::LayerFile;
use crate::outline::ring;
use crate::output::{counted, plain, print, print_answer};
use crate::output_file::write_file;
use crate::status::{Failure, Verdict};
use serde_json::{Map, Value, json};
use std::path::{Path, PathBuf};
use twinedge::algorithm::voronoi::{Delaunay, Voronoi, delaunay, voronoi};
use twinedge::dcel::FaceKey;
use twinedge::geometry::Point;
use twinedge::io::svg::{self, Options};
use twinedge::map::PlanarMap;
use twinedge_formats::layer::{Layer, Shape};

/// Make the Voronoi diagram of points: for each the part of the plane that is nearest to it.
///
/// Each cell has the properties of its point, and `site`, the number of the point, counted from 0. Points at the same place have
/// one cell, that of the first. Unbounded cells are closed by a box, the one given or one that is a tenth wider than the points;
/// it is the `bbox` of the output.
#[derive(Debug, clap::Args)]
#[command(
    name = "voronoi",
    after_help = "Examples:
  twinedge voronoi stations.geojson -o cells.geojson
  twinedge voronoi stations.gpkg --layer active --bounds 5.5 45.5 11 48 -o cells.svg
  twinedge voronoi stations.geojson --delaunay -o triangles.geojson

Exit status: 0 the diagram is made; 2 the input could not be read or has something else than points, or a point lies outside \
the bounds."
)]
pub(crate) struct MakeVoronoi {
    #[command(flatten)]
    points: LayerFile,

    /// Lower left and upper right corner of the box that closes the cells.
    #[arg(long, num_args = 4, value_names = ["X0", "Y0", "X1", "Y1"], allow_negative_numbers = true, conflicts_with = "delaunay")]
    bounds: Option<Vec<f64>>,

    /// Make the triangles of the Delaunay triangulation instead, without properties but `sites`, the numbers of their corners.
    #[arg(long)]
    delaunay: bool,

    /// File to write, GeoJSON or, by the ending .svg, a picture; `-` is GeoJSON on standard output, and the default.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// Points and the properties of their features.
#[derive(Default)]
struct Sites {
    points: Vec<Point>,
    properties: Vec<Map<String, Value>>,
}

impl MakeVoronoi {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        let file = self.output.as_deref().filter(|path| *path != Path::new("-"));
        let is_svg = format_of(file, &[("geojson", false), ("json", false), ("svg", true)])?.unwrap_or(false);
        let (name, sites) = self.read()?;
        let failed = |error: twinedge::algorithm::voronoi::VoronoiError| Failure(format!("{name}: {error}"));
        let (map, collection, what) = if self.delaunay {
            let found = delaunay(&sites.points).map_err(failed)?;
            let (collection, what) = triangles(&found)?;
            (found.map, collection, what)
        } else {
            let bounds = match self.bounds.as_deref() {
                Some(&[x0, y0, x1, y1]) => Some([Point::new(x0, y0), Point::new(x1, y1)]),
                _ => None,
            };
            let found = voronoi(&sites.points, bounds).map_err(failed)?;
            let (collection, what) = cells(&found, &sites)?;
            (coloured(found)?, collection, what)
        };
        let Some(path) = file else {
            print_answer(&collection)?;
            return Ok(Verdict::Sound);
        };
        let text = if is_svg { svg::draw(&map, &Options::default()) } else { collection };
        write_file(path, self.points.path(), text.as_bytes())?;
        print(&format!("{}: {what}\n", plain(&name)))?;
        Ok(Verdict::Sound)
    }

    fn read(&self) -> Result<(String, Sites), Failure> {
        let (name, layer) = self.points.read()?;
        let sites = Sites::new(&layer).map_err(|error| Failure(format!("{name}: {error}")))?;
        Ok((name, sites))
    }
}

/// Why a layer has no points.
#[derive(Debug, thiserror::Error)]
#[error("feature {feature}: its geometry is no point but {kind}")]
struct OtherGeometry {
    feature: usize,
    kind: &'static str,
}

impl Sites {
    fn new(layer: &Layer) -> Result<Self, OtherGeometry> {
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

/// A polygon without holes, closed.
fn polygon(map: &PlanarMap, face: FaceKey, properties: &Map<String, Value>) -> Result<Value, Failure> {
    let geometry = json!({"type": "Polygon", "coordinates": [ring(map, face)?]});
    Ok(json!({"type": "Feature", "properties": properties, "geometry": geometry}))
}

/// The cells, and what they are in a line.
fn cells(found: &Voronoi, sites: &Sites) -> Result<(String, String), Failure> {
    let mut features = Vec::new();
    let mut seen = std::collections::HashSet::new();
    for (site, cell) in found.cells.iter().enumerate().filter(|(_, cell)| seen.insert(**cell)) {
        let mut properties = sites.properties[site].clone();
        properties.insert("site".to_owned(), json!(site));
        features.push(polygon(&found.map, *cell, &properties)?);
    }
    let [low, high] = found.bounds;
    let (points, cells) = (counted(found.cells.len(), "point"), counted(features.len(), "cell"));
    let what = format!("{points}, {cells} in the box from ({}, {}) to ({}, {})", low.x, low.y, high.x, high.y);
    let collection = json!({"type": "FeatureCollection", "bbox": [low.x, low.y, high.x, high.y], "features": features});
    Ok((collection.to_string() + "\n", what))
}

/// The triangles, and what they are in a line.
fn triangles(found: &Delaunay) -> Result<(String, String), Failure> {
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

/// The map with a feature for each cell, so that neighbours are drawn in different colours.
fn coloured(found: Voronoi) -> Result<PlanarMap, Failure> {
    let mut map = found.map;
    for cell in found.cells {
        let feature = map.add_feature(None);
        map.set_features_of(cell, [feature])?;
    }
    Ok(map)
}
