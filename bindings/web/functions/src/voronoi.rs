//! `voronoi`: the cells or the triangles of points.

use crate::error::CallError;
use crate::source::{Buffer, NamedFile, layer};
use serde::Deserialize;
use serde_json::{Map, Value, json};
use twinedge_algorithm::voronoi::{delaunay, voronoi, voronoi_merging};
use twinedge_geometry::Point;
use twinedge_report::voronoi::{Sites, cells, triangles};
use twinedge_web_bridge::Buffers;

#[derive(Deserialize)]
pub(crate) struct Request {
    #[serde(default)]
    files: Vec<NamedFile>,
    points: Option<Vec<[f64; 2]>>,
    options: Asked,
}

#[derive(Clone, Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase", deny_unknown_fields)]
struct Asked {
    layer: Option<String>,
    bounds: Option<[f64; 4]>,
    delaunay: bool,
    merge_close: bool,
}

pub(crate) fn answer(asked: Request, buffers: &mut Buffers) -> Result<Value, CallError> {
    let sites = if let Some(points) = asked.points {
        Sites { properties: vec![Map::new(); points.len()], points: points.into_iter().map(Point::from).collect() }
    } else {
        let (name, layer) = layer(asked.files, asked.options.layer.as_deref(), buffers)?;
        Sites::new(&layer).map_err(|error| CallError::from(error).of(&name))?
    };
    let (collection, _) = if asked.options.delaunay {
        triangles(&delaunay(&sites.points)?)?
    } else {
        let bounds = asked.options.bounds.map(|[x0, y0, x1, y1]| [Point::new(x0, y0), Point::new(x1, y1)]);
        let make = if asked.options.merge_close { voronoi_merging } else { voronoi };
        cells(&make(&sites.points, bounds)?, &sites)?
    };
    Ok(json!({ "answer": Buffer::put(buffers, collection.into_bytes()) }))
}
