//! Tiles of maps: geometries as columns of Arrow, summaries and cuts as bytes.

use crate::audit::{Told, options, told};
use crate::geometries::{Binary, Column, Values, given, rows};
use crate::source::Failure;
use numpy::{IntoPyArray, PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use pyo3::types::PyBytes;
use std::time::Instant;
use twinedge_coverage::tile::{Cuts, Found, Grid, Piece, Portion, Source, Tile, TileError};
use twinedge_geometry::Point;
use twinedge_map::{BuildError, Feature};
use twinedge_report::{TiledLayer, audit_portion, merged, refuse_without_cuts};

/// The tile of each row, and the position of each row.
pub(crate) type Assignment<'py> = (Bound<'py, PyArray1<u64>>, Bound<'py, PyArray1<u64>>);

/// The tile of each piece, and the pieces: where they end, after the start of the first, and their bytes.
type Pieces<'py> = (Bound<'py, PyArray1<i64>>, Bound<'py, PyArray1<i64>>, Bound<'py, PyBytes>);

pub(crate) fn grid(bytes: &[u8]) -> Result<Grid, Failure> {
    Grid::from_bytes(bytes).map_err(|error| Failure::Value(format!("grid: {error}")))
}

pub(crate) fn tile(grid: &Grid, number: u64) -> Result<Tile, Failure> {
    let tile = u32::try_from(number).map(Tile).ok().filter(|tile| grid.has(*tile));
    tile.ok_or_else(|| Failure::Value(format!("tile: the grid has no tile {number}")))
}

fn cuts(bytes: &[u8]) -> Result<Cuts, Failure> {
    Cuts::from_bytes(bytes).map_err(|error| Failure::Value(format!("cuts: {error}")))
}

/// Returns the pieces in columns, of any tiles.
fn pieces(columns: &[Values<'_>]) -> Result<Vec<Piece>, Failure> {
    let read = |(place, bytes): (usize, Result<Option<&[u8]>, Failure>)| {
        let wrong = |error| Failure::Value(format!("piece {place}: {error}"));
        bytes?.map(|bytes| Piece::from_bytes(bytes).map_err(wrong)).transpose()
    };
    let all = columns.iter().flat_map(Values::each).enumerate().map(read);
    all.filter_map(Result::transpose).collect()
}

fn values<'c>(columns: &'c [Binary<'_>]) -> Result<Vec<Values<'c>>, Failure> {
    columns.iter().map(Binary::values).collect()
}

/// Returns the grid that divides a box evenly.
#[pyfunction]
pub(crate) fn even_grid(py: Python<'_>, corners: [f64; 4], columns: u32, rows: u32) -> PyResult<Bound<'_, PyBytes>> {
    let [x0, y0, x1, y1] = corners;
    let grid = Grid::new([x0, y0], [x1, y1], columns, rows).map_err(Failure::value)?;
    Ok(PyBytes::new(py, &grid.to_bytes()))
}

/// One of this many vertices is in the sample of a survey.
const SAMPLED: u64 = 64;

/// The number of vertices, the box around them, and a sample of them, as rows.
type Survey<'py> = (u64, Option<[f64; 4]>, Bound<'py, PyArray2<f64>>);

/// Returns what a grid is fitted to. The sample depends on the vertices only, not on how they are spread over columns.
#[pyfunction]
pub(crate) fn survey<'py>(py: Python<'py>, geometries: Column<'py>) -> PyResult<Survey<'py>> {
    let columns = [geometries];
    let columns = given(&columns)?;
    let found = py.detach(|| {
        let (mut vertices, mut around, mut sample) = (0, None, Vec::new());
        let rows = rows(columns)?;
        // What cannot be read is a finding, and lies nowhere.
        let known = rows.iter().flatten().filter(|feature| feature.check(0).is_ok());
        for p in known.flat_map(Feature::points) {
            vertices += 1;
            let here = [p.x, p.y, p.x, p.y];
            around = Some(around.map_or(here, |around| joined(around, here)));
            let (x, y) = p.hash_key();
            // Multiplied by the golden ratio, as Knuth's hashing does.
            if (x.rotate_left(32) ^ y).wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 32 & (SAMPLED - 1) == 0 {
                sample.extend([p.x, p.y]);
            }
        }
        Ok::<_, Failure>((vertices, around, sample))
    });
    let (vertices, around, sample) = found?;
    let rows = [sample.len() / 2, 2];
    Ok((vertices, around, sample.into_pyarray(py).reshape(rows)?))
}

/// Returns the grid whose tiles each have about `most` vertices, by a sample of them.
#[pyfunction]
pub(crate) fn fitted_grid<'py>(
    py: Python<'py>,
    sample: PyReadonlyArray2<'py, f64>,
    most: u64,
) -> PyResult<Bound<'py, PyBytes>> {
    let points = sample.as_array().rows().into_iter().map(|row| Point::new(row[0], row[1])).collect();
    let grid = Grid::fitted(points, (most / SAMPLED) as usize).map_err(Failure::value)?;
    Ok(PyBytes::new(py, &grid.to_bytes()))
}

/// Returns the boxes of all tiles, infinite where the grid ends.
#[pyfunction]
pub(crate) fn boxes(of: PyBackedBytes) -> PyResult<Vec<[f64; 4]>> {
    let grid = grid(&of)?;
    let corners = grid.tiles().filter_map(|tile| grid.corners_of(tile));
    Ok(corners.map(|[low, high]| [low.x, low.y, high.x, high.y]).collect())
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

/// Returns the pieces of the features that tiles need.
#[pyfunction]
pub(crate) fn divide<'py>(
    py: Python<'py>,
    of: PyBackedBytes,
    cut: PyBackedBytes,
    numbers: PyReadonlyArray1<'py, u32>,
    geometries: Column<'py>,
) -> PyResult<Pieces<'py>> {
    let numbers = numbers.as_array().to_vec();
    let columns = [geometries];
    let columns = given(&columns)?;
    let found = py.detach(|| {
        let (grid, cuts) = (grid(&of)?, cuts(&cut)?);
        let (mut tiles, mut ends, mut bytes) = (Vec::new(), vec![0], Vec::new());
        for (number, row) in numbers.into_iter().zip(rows(columns)?) {
            let pieces = match row.map(|feature| cuts.pieces(&grid, number, &feature)) {
                Ok(Ok(pieces)) => pieces,
                Ok(Err(BuildError::NotFinite { .. })) => vec![Piece::unreadable(number, "a coordinate is not finite")],
                Ok(Err(BuildError::OutOfRange { x, y, .. })) => {
                    vec![Piece::unreadable(number, format!("the coordinates ({x}, {y}) are out of range"))]
                }
                Ok(Err(error)) => return Err(refused(error.into())),
                Err(why) => vec![Piece::unreadable(number, why)],
            };
            for piece in pieces {
                tiles.push(i64::from(piece.tile().0));
                bytes.extend(piece.to_bytes());
                ends.push(i64::try_from(bytes.len()).map_err(Failure::value)?);
            }
        }
        Ok::<_, Failure>((tiles, ends, bytes))
    });
    let (tiles, ends, bytes) = found?;
    Ok((tiles.into_pyarray(py), ends.into_pyarray(py), PyBytes::new(py, &bytes)))
}

pub(crate) fn assignment(py: Python<'_>, (places, tiles): (Vec<u64>, Vec<u64>)) -> Assignment<'_> {
    (places.into_pyarray(py), tiles.into_pyarray(py))
}

/// Returns the box around a feature; `None` if it has no points.
pub(crate) fn bounds_of(feature: &Feature) -> Option<[f64; 4]> {
    feature.points().map(|p| [p.x, p.y, p.x, p.y]).reduce(joined)
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
    Ok(PyBytes::new(py, &cuts.to_bytes()))
}

/// Returns the tiles that must search in this round; `None` if all cuts are found.
#[pyfunction]
pub(crate) fn tiles_to_search(py: Python<'_>, cut: PyBackedBytes, of: PyBackedBytes) -> PyResult<Vec<u32>> {
    let found = py.detach(|| {
        let (cuts, grid) = (cuts(&cut)?, grid(&of)?);
        let concerned = grid.tiles().filter(|tile| cuts.concern(&grid, *tile));
        Ok::<_, Failure>(concerned.map(|tile| tile.0).collect())
    });
    Ok(found?)
}

/// Returns the cuts that a tile finds in this round, from its pieces.
#[pyfunction]
pub(crate) fn search<'py>(
    py: Python<'py>,
    cut: PyBackedBytes,
    of: PyBackedBytes,
    at: u64,
    given: Vec<Binary<'py>>,
) -> PyResult<Bound<'py, PyBytes>> {
    let columns = values(&given)?;
    let bytes = py.detach(|| {
        let (cuts, grid) = (cuts(&cut)?, grid(&of)?);
        let found = cuts.search(&grid, tile(&grid, at)?, &pieces(&columns)?).map_err(refused)?;
        Ok::<_, Failure>(found.to_bytes())
    });
    Ok(PyBytes::new(py, &bytes?))
}

/// Returns the cuts after a round in which tiles found these.
#[pyfunction]
pub(crate) fn take(py: Python<'_>, cut: PyBackedBytes, found: Vec<PyBackedBytes>) -> PyResult<Bound<'_, PyBytes>> {
    let bytes = py.detach(|| {
        let mut cuts = cuts(&cut)?;
        let read = |(place, bytes): (usize, &PyBackedBytes)| {
            Found::from_bytes(bytes).map_err(|error| Failure::Value(format!("found {place}: {error}")))
        };
        let found: Vec<Found> = found.iter().enumerate().map(read).collect::<Result<_, _>>()?;
        cuts.take(found).map_err(refused)?;
        Ok::<_, Failure>(cuts.to_bytes())
    });
    Ok(PyBytes::new(py, &bytes?))
}

/// Returns the summary of a tile, from its pieces. Cuts bring their own source.
#[pyfunction]
#[allow(clippy::too_many_arguments, reason = "they are those of Python")]
pub(crate) fn summarise<'py>(
    py: Python<'py>,
    of: PyBackedBytes,
    at: u64,
    given: Vec<Binary<'py>>,
    asked: &str,
    cut: Option<PyBackedBytes>,
    of_source: Option<&str>,
) -> PyResult<Bound<'py, PyBytes>> {
    let columns = values(&given)?;
    let bytes = py.detach(|| {
        let grid = grid(&of)?;
        let limits = options(asked, None)?.coverage.limits.limits();
        let (pieces, tile) = (pieces(&columns)?, tile(&grid, at)?);
        let cuts = cut.map(|bytes| cuts(&bytes)).transpose()?;
        if cuts.as_ref().is_some_and(|cuts| !cuts.is_complete()) {
            return Err(Failure::Value("cuts: not all of them are found yet".to_owned()));
        }
        let portion = Portion::new(&grid, tile, &pieces, &limits, cuts.as_ref()).map_err(refused)?;
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
    of: Option<PyBackedBytes>,
    asked: &str,
    accept: Option<&str>,
    ids: Vec<Option<String>>,
    are_all: bool,
) -> PyResult<Told> {
    let start = Instant::now();
    let found = py.detach(|| {
        let options = options(asked, accept)?;
        let mut all = sum(&summaries)?;
        if let Some(grid) = of.map(|bytes| grid(&bytes)).transpose()? {
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
        let mut audited = audit_portion(all, TiledLayer::Unread { ids, are_all, crs: None }, &options)?;
        audited.took(start.elapsed().as_secs_f64() * 1000.0);
        told(&audited, options.accepted.as_ref())
    });
    Ok(found?)
}
