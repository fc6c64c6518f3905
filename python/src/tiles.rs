//! Tiles of maps: geometries as well-known binary, summaries as bytes.

use crate::audit::{LimitsAsked, MapAsked, Told, told};
use crate::source::Failure;
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use pyo3::types::PyBytes;
use twinedge::io::ReadSummary;
use twinedge::map::{Feature, Shape};
use twinedge::tile::{Grid, Summary, Tile};
use twinedge_formats::layer::{Feature as LayerFeature, geometry_of_wkb, to_map};
use twinedge_report::{audit_summary, merged};

/// A grid: the corners of its box, and the numbers of columns and rows.
type GridArguments = ([f64; 4], u32, u32);

/// Geometries as well-known binary.
type Geometries = Vec<Option<PyBackedBytes>>;

/// The positions of geometries, and the tile of each.
type Assignment<'py> = (Bound<'py, PyArray1<u64>>, Bound<'py, PyArray1<u64>>);

fn grid(([x0, y0, x1, y1], columns, rows): GridArguments) -> Result<Grid, Failure> {
    Grid::new([x0, y0], [x1, y1], columns, rows).map_err(Failure::value)
}

/// Tiles are numbered row by row, from the lower left.
fn number(grid: &Grid, tile: Tile) -> u64 {
    u64::from(tile.row) * u64::from(grid.size()[0]) + u64::from(tile.column)
}

fn tile(grid: &Grid, number: u64) -> Result<Tile, Failure> {
    let columns = u64::from(grid.size()[0]);
    let none = || Failure::Value(format!("tile: the grid has no tile {number}"));
    let narrow = |number: u64| u32::try_from(number).map_err(|_| none());
    let tile = Tile { column: narrow(number % columns)?, row: narrow(number / columns)? };
    if grid.has(tile) { Ok(tile) } else { Err(none()) }
}

/// The feature of a geometry, which may be missing.
fn feature(place: usize, geometry: Option<&PyBackedBytes>) -> Result<Feature, Failure> {
    let geometry = geometry.map(|bytes| geometry_of_wkb(bytes)).transpose();
    let geometry = geometry.map_err(|error| Failure::Value(format!("geometry {place}: {error}")))?;
    Ok(to_map(&LayerFeature { geometry, ..LayerFeature::default() }, &mut ReadSummary::default()))
}

/// The tiles that each geometry is to be given to.
#[pyfunction]
pub(crate) fn tiles_of(py: Python<'_>, of: GridArguments, geometries: Geometries) -> PyResult<Assignment<'_>> {
    let found = py.detach(|| {
        let grid = grid(of)?;
        let (mut places, mut tiles) = (Vec::new(), Vec::new());
        for (place, geometry) in geometries.iter().enumerate() {
            for tile in grid.tiles_of(&feature(place, geometry.as_ref())?) {
                places.push(place as u64);
                tiles.push(number(&grid, tile));
            }
        }
        Ok::<_, Failure>((places, tiles))
    });
    let (places, tiles) = found?;
    Ok((places.into_pyarray(py), tiles.into_pyarray(py)))
}

/// The box around geometries; none, if they have no points.
#[pyfunction]
pub(crate) fn bounds(py: Python<'_>, geometries: Geometries) -> PyResult<Option<[f64; 4]>> {
    let found = py.detach(|| {
        let mut found: Option<[f64; 4]> = None;
        for (place, geometry) in geometries.iter().enumerate() {
            for shape in &feature(place, geometry.as_ref())?.shapes {
                let points = match shape {
                    Shape::Polygon(rings) => rings.iter().flatten().collect(),
                    Shape::Line(points) => points.iter().collect(),
                    Shape::Point(point) => vec![point],
                };
                for p in points {
                    let [x0, y0, x1, y1] = found.unwrap_or([p.x, p.y, p.x, p.y]);
                    found = Some([x0.min(p.x), y0.min(p.y), x1.max(p.x), y1.max(p.y)]);
                }
            }
        }
        Ok::<_, Failure>(found)
    });
    Ok(found?)
}

/// The summary of a tile, from the features that meet it, each with its number in the map.
#[pyfunction]
pub(crate) fn summarise<'py>(
    py: Python<'py>,
    of: GridArguments,
    at: u64,
    numbers: PyReadonlyArray1<'py, u32>,
    geometries: Geometries,
    limits: LimitsAsked,
) -> PyResult<Bound<'py, PyBytes>> {
    let numbers = numbers.as_array().to_vec();
    let bytes = py.detach(|| {
        let grid = grid(of)?;
        let features = geometries.iter().enumerate().map(|(place, geometry)| feature(place, geometry.as_ref()));
        let features: Vec<Feature> = features.collect::<Result<_, _>>()?;
        let given = numbers.into_iter().zip(&features);
        let summary = Summary::new(&grid, tile(&grid, at)?, given, &limits.limits()).map_err(Failure::value)?;
        serde_json::to_vec(&summary).map_err(Failure::value)
    });
    Ok(PyBytes::new(py, &bytes?))
}

fn sum(summaries: &[PyBackedBytes]) -> Result<Option<Summary>, Failure> {
    let read = |(place, bytes): (usize, &PyBackedBytes)| {
        serde_json::from_slice(bytes).map_err(|error| Failure::Value(format!("summary {place}: {error}")))
    };
    let all: Vec<Summary> = summaries.iter().enumerate().map(read).collect::<Result<_, _>>()?;
    Ok(merged(all)?)
}

/// One summary of several; none, if there is none.
#[pyfunction]
pub(crate) fn merge(py: Python<'_>, summaries: Vec<PyBackedBytes>) -> PyResult<Option<Bound<'_, PyBytes>>> {
    let bytes = py.detach(|| {
        let whole = sum(&summaries)?;
        whole.map(|whole| serde_json::to_vec(&whole)).transpose().map_err(Failure::value)
    });
    Ok(bytes?.map(|bytes| PyBytes::new(py, &bytes)))
}

/// The tiles of a summary.
#[pyfunction]
pub(crate) fn tiles_in(summary: &[u8]) -> PyResult<Vec<u64>> {
    let summary: Summary = serde_json::from_slice(summary).map_err(Failure::value)?;
    let grid = summary.grid();
    Ok(summary.tiles().iter().map(|tile| number(grid, *tile)).collect())
}

/// The report that the summaries of all tiles make.
#[pyfunction]
pub(crate) fn finish(py: Python<'_>, summaries: Vec<PyBackedBytes>, asked: MapAsked) -> PyResult<Told> {
    let found = py.detach(|| {
        let whole = sum(&summaries)?.ok_or_else(|| Failure::Value("there is no summary".to_owned()))?;
        let options = asked.options()?;
        // Only the whole map knows the cuts of edges that meet elsewhere than at vertices.
        told(&audit_summary(whole, None, &options)?, options.accepted.as_ref())
    });
    Ok(found?)
}
