//! Tiles of maps: geometries as columns of Arrow, summaries and cuts as bytes.

use crate::audit::{Told, options, told};
use crate::geometries::{Column, features, given};
use crate::source::Failure;
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use pyo3::types::PyBytes;
use std::time::Instant;
use twinedge_coverage::tile::{Cuts, Found, Grid, Portion, Source, Tile, TileError};
use twinedge_geometry::Point;
use twinedge_map::{BuildError, Feature, Shape};
use twinedge_report::{TiledLayer, audit_portion, merged, refuse_without_cuts};

/// A grid: the corners of its box, and the numbers of columns and rows.
pub(crate) type GridArguments = ([f64; 4], u32, u32);

/// The positions of geometries, and the tile of each.
pub(crate) type Assignment<'py> = (Bound<'py, PyArray1<u64>>, Bound<'py, PyArray1<u64>>);

pub(crate) fn grid(([x0, y0, x1, y1], columns, rows): GridArguments) -> Result<Grid, Failure> {
    Grid::new([x0, y0], [x1, y1], columns, rows).map_err(Failure::value)
}

/// Tiles are numbered row by row, from the lower left.
pub(crate) fn number(grid: &Grid, tile: Tile) -> u64 {
    u64::from(tile.row) * u64::from(grid.size()[0]) + u64::from(tile.column)
}

pub(crate) fn tile(grid: &Grid, number: u64) -> Result<Tile, Failure> {
    let columns = u64::from(grid.size()[0]);
    let none = || Failure::Value(format!("tile: the grid has no tile {number}"));
    let narrow = |number: u64| u32::try_from(number).map_err(|_| none());
    let tile = Tile { column: narrow(number % columns)?, row: narrow(number / columns)? };
    if grid.has(tile) { Ok(tile) } else { Err(none()) }
}

fn cuts(bytes: &[u8]) -> Result<Cuts, Failure> {
    serde_json::from_slice(bytes).map_err(|error| Failure::Value(format!("cuts: {error}")))
}

fn refused(error: TileError) -> Failure {
    match error {
        TileError::Build(BuildError::TooManyCuts { .. }) => {
            Failure::Value(format!("the coverage cannot be judged in tiles: {error}"))
        }
        TileError::Build(BuildError::OutOfReach { x, y }) => {
            Failure::Value(format!("({x}, {y}) lies farther out than the box of the cuts"))
        }
        error => Failure::value(error),
    }
}

/// Returns the tiles to give each geometry to.
#[pyfunction]
pub(crate) fn tiles_of<'py>(
    py: Python<'py>,
    of: GridArguments,
    geometries: Column<'py>,
    cut: Option<PyBackedBytes>,
) -> PyResult<Assignment<'py>> {
    let columns = given(vec![geometries])?;
    let found = py.detach(|| {
        let grid = grid(of)?;
        let cuts = cut.map(|bytes| cuts(&bytes)).transpose()?;
        let (mut places, mut tiles) = (Vec::new(), Vec::new());
        for (place, feature) in features(columns)?.iter().enumerate() {
            let met: Vec<Tile> = match &cuts {
                Some(cuts) => cuts.tiles_of(&grid, feature).collect(),
                None => grid.tiles_of(feature).collect(),
            };
            for tile in met {
                places.push(place as u64);
                tiles.push(number(&grid, tile));
            }
        }
        Ok::<_, Failure>((places, tiles))
    });
    Ok(assignment(py, found?))
}

pub(crate) fn assignment(py: Python<'_>, (places, tiles): (Vec<u64>, Vec<u64>)) -> Assignment<'_> {
    (places.into_pyarray(py), tiles.into_pyarray(py))
}

/// Returns the box around geometries; `None` if they have no points.
#[pyfunction]
pub(crate) fn bounds(py: Python<'_>, geometries: Column<'_>) -> PyResult<Option<[f64; 4]>> {
    let columns = given(vec![geometries])?;
    let found = py.detach(|| Ok::<_, Failure>(features(columns)?.iter().filter_map(bounds_of).reduce(joined)));
    Ok(found?)
}

/// Returns the box around a feature; `None` if it has no points.
pub(crate) fn bounds_of(feature: &Feature) -> Option<[f64; 4]> {
    let of_points = |points: &[Point]| points.iter().map(|p| [p.x, p.y, p.x, p.y]).reduce(joined);
    let of_shape = |shape: &Shape| match shape {
        Shape::Polygon(rings) => rings.iter().filter_map(|ring| of_points(ring)).reduce(joined),
        Shape::Line(points) => of_points(points),
        Shape::Point(point) => of_points(&[*point]),
    };
    feature.shapes.iter().filter_map(of_shape).reduce(joined)
}

pub(crate) fn joined(one: [f64; 4], other: [f64; 4]) -> [f64; 4] {
    [one[0].min(other[0]), one[1].min(other[1]), one[2].max(other[2]), one[3].max(other[3])]
}

fn source(text: Option<&str>) -> Source {
    text.map(|text| ("source".to_owned(), text.to_owned())).into_iter().collect()
}

/// Returns no cuts yet, of a map of this source whose coordinates are at most `largest`.
#[pyfunction]
pub(crate) fn no_cuts<'py>(py: Python<'py>, largest: f64, of_source: Option<&str>) -> PyResult<Bound<'py, PyBytes>> {
    let cuts = Cuts::new(largest).map_err(Failure::value)?.with_source(source(of_source));
    Ok(PyBytes::new(py, &serde_json::to_vec(&cuts).map_err(Failure::value)?))
}

/// Returns the tiles that must search in this round; `None` if all cuts are found.
#[pyfunction]
pub(crate) fn tiles_to_search(py: Python<'_>, cut: PyBackedBytes, of: GridArguments) -> PyResult<Vec<u64>> {
    let found = py.detach(|| {
        let (cuts, grid) = (cuts(&cut)?, grid(of)?);
        let concerned = grid.tiles().filter(|tile| cuts.concern(&grid, *tile));
        Ok::<_, Failure>(concerned.map(|tile| number(&grid, tile)).collect())
    });
    Ok(found?)
}

/// Returns the cuts that a tile finds in this round, from the features near it.
#[pyfunction]
pub(crate) fn search<'py>(
    py: Python<'py>,
    cut: PyBackedBytes,
    of: GridArguments,
    at: u64,
    geometries: Vec<Column<'py>>,
) -> PyResult<Bound<'py, PyBytes>> {
    let columns = given(geometries)?;
    let bytes = py.detach(|| {
        let (cuts, grid) = (cuts(&cut)?, grid(of)?);
        let features = features(columns)?;
        let found = cuts.search(&grid, tile(&grid, at)?, (0..).zip(&features)).map_err(refused)?;
        serde_json::to_vec(&found).map_err(Failure::value)
    });
    Ok(PyBytes::new(py, &bytes?))
}

/// Returns the cuts after a round in which tiles found these.
#[pyfunction]
pub(crate) fn take(py: Python<'_>, cut: PyBackedBytes, found: Vec<PyBackedBytes>) -> PyResult<Bound<'_, PyBytes>> {
    let bytes = py.detach(|| {
        let mut cuts = cuts(&cut)?;
        let read = |(place, bytes): (usize, &PyBackedBytes)| {
            serde_json::from_slice(bytes).map_err(|error| Failure::Value(format!("found {place}: {error}")))
        };
        let found: Vec<Found> = found.iter().enumerate().map(read).collect::<Result<_, _>>()?;
        cuts.take(found).map_err(refused)?;
        serde_json::to_vec(&cuts).map_err(Failure::value)
    });
    Ok(PyBytes::new(py, &bytes?))
}

/// Returns the summary of a tile, from the features that meet it, each with its number in the map; the source is that of the cuts, if there are some.
#[pyfunction]
#[allow(clippy::too_many_arguments, reason = "they are those of Python")]
pub(crate) fn summarise<'py>(
    py: Python<'py>,
    of: GridArguments,
    at: u64,
    numbers: PyReadonlyArray1<'py, u32>,
    geometries: Vec<Column<'_>>,
    asked: &str,
    cut: Option<PyBackedBytes>,
    of_source: Option<&str>,
) -> PyResult<Bound<'py, PyBytes>> {
    let numbers = numbers.as_array().to_vec();
    let columns = given(geometries)?;
    let bytes = py.detach(|| {
        let grid = grid(of)?;
        let limits = options(asked, None)?.coverage.limits.limits();
        let (features, tile) = (features(columns)?, tile(&grid, at)?);
        let given = numbers.iter().copied().zip(&features);
        let cuts = cut.map(|bytes| cuts(&bytes)).transpose()?;
        if cuts.as_ref().is_some_and(|cuts| !cuts.is_complete()) {
            return Err(Failure::Value("cuts: not all of them are found yet".to_owned()));
        }
        let portion = Portion::new(&grid, tile, given, &limits, cuts.as_ref()).map_err(refused)?;
        Ok(if cuts.is_some() { portion } else { portion.with_source(source(of_source)) }.to_bytes())
    });
    Ok(PyBytes::new(py, &bytes?))
}

/// Returns the sum of some summaries; `None` if there are none.
fn sum(summaries: &[PyBackedBytes]) -> Result<Option<Portion>, Failure> {
    let read = |(place, bytes): (usize, &PyBackedBytes)| {
        Portion::from_bytes(bytes).map_err(|error| Failure::Value(format!("summary {place}: {error}")))
    };
    let all: Vec<Portion> = summaries.iter().enumerate().map(read).collect::<Result<_, _>>()?;
    let sum = merged(all)?;
    sum.as_ref().map_or(Ok(()), refuse_without_cuts)?;
    Ok(sum)
}

/// Merges several summaries; `None` if there are none.
#[pyfunction]
pub(crate) fn merge(py: Python<'_>, summaries: Vec<PyBackedBytes>) -> PyResult<Option<Bound<'_, PyBytes>>> {
    let bytes = py.detach(|| Ok::<_, Failure>(sum(&summaries)?.map(|sum| sum.to_bytes())));
    Ok(bytes?.map(|bytes| PyBytes::new(py, &bytes)))
}

/// Returns the report from the summaries of all tiles. With a grid, the tiles that are missing are those of nothing. Features have these ids, or none.
#[pyfunction]
pub(crate) fn finish(
    py: Python<'_>,
    summaries: Vec<PyBackedBytes>,
    of: Option<GridArguments>,
    asked: &str,
    accept: Option<&str>,
    ids: Vec<Option<String>>,
) -> PyResult<Told> {
    let start = Instant::now();
    let found = py.detach(|| {
        let options = options(asked, accept)?;
        let mut all = sum(&summaries)?;
        if let Some(grid) = of.map(grid).transpose()? {
            let limits = options.coverage.limits.limits();
            let known = all.as_ref().map(|all| all.summary().tiles().to_vec()).unwrap_or_default();
            let (is_cut, source) =
                all.as_ref().map(|all| (all.cut().is_some(), all.source().clone())).unwrap_or_default();
            let nothing = |tile| {
                Ok(Portion::of_nothing(&grid, tile, &limits, is_cut).map_err(refused)?.with_source(source.clone()))
            };
            let missing = grid.tiles().filter(|tile| known.binary_search(tile).is_err());
            let missing = missing.map(nothing).collect::<Result<Vec<_>, Failure>>()?;
            all = merged(all.into_iter().chain(missing).collect())?;
        }
        let all = all.ok_or_else(|| Failure::Value("there is no summary".to_owned()))?;
        let mut audited = audit_portion(all, TiledLayer::Unread { ids, crs: None }, &options)?;
        audited.took(start.elapsed().as_secs_f64() * 1000.0);
        told(&audited, options.accepted.as_ref())
    });
    Ok(found?)
}
