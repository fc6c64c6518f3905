//! Overlays of two layers: the pieces that their features cut each other into, of whole maps and tile by tile.
//!
//! Each piece comes from one tile, and whole. A feature begins in the tile that has the lower left corner of its box,
//! and a piece in the tile of one of its features. A tile is given all features near the features that begin in it, so
//! it knows everything that covers them.

use crate::geometries::{Column, features, given};
use crate::source::Failure;
use crate::tiles::{Assignment, assignment, bounds_of, grid, joined, tile};
use numpy::PyReadonlyArray1;
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use pyo3::types::PyBytes;
use std::collections::{BTreeMap, BTreeSet};
use twinedge::dcel::{Face, FaceKey};
use twinedge_algorithm::contour::of_faces;
use twinedge_coverage::tile::Grid;
use twinedge_geometry::Point;
use twinedge_geometry::noding::Snap;
use twinedge_geometry::predicates::MIN_COORDINATE;
use twinedge_layers::{Geometry, wkb_of_geometry};
use twinedge_map::{Builder, FeatureId, Noding, PlanarMap, Shape};

/// The distance within which features are given to a tile, as a part of the largest coordinate: 2^-44. Crossings are
/// rounded to a grid, which moves edges by a cell or two of it; this is at least 32 cells.
const NEAR: f64 = f64::from_bits((1023 - 44) << 52);

/// The distance for the smallest maps, on whose grid a cell is 2^-400.
const NEAR_OF_TINY: f64 = 64.0 * MIN_COORDINATE;

/// A tile, and the box around the features that begin in it.
type Extent = (u64, [f64; 4]);

/// The features that cover a face, by layer.
pub(crate) type Covered = [BTreeSet<usize>; 2];

/// A piece: the numbers of the features that cover it in either layer, and its outline as well-known binary.
type TilePiece<'py> = (Vec<usize>, Vec<usize>, Bound<'py, PyBytes>);

/// The numbers of the features of a layer, and their geometries.
type Layer<'py> = (PyReadonlyArray1<'py, u32>, Vec<Column<'py>>);

/// Returns the faces of each piece, by the features that cover it. `owner` returns the layer of a feature and its
/// number there.
pub(crate) fn pieces(
    map: &PlanarMap,
    owner: impl Fn(FeatureId) -> Option<(usize, usize)>,
) -> BTreeMap<Covered, Vec<FaceKey>> {
    let mut found: BTreeMap<Covered, Vec<FaceKey>> = BTreeMap::new();
    for face in map.dcel().faces().filter(|face| !face.is_unbounded()).map(Face::key) {
        let mut covered = Covered::default();
        for (layer, number) in map.features_of(face).into_iter().flatten().filter_map(&owner) {
            covered[layer].insert(number);
        }
        if covered.iter().any(|of_layer| !of_layer.is_empty()) {
            found.entry(covered).or_default().push(face);
        }
    }
    found
}

/// Returns the number of the tile in which a feature begins.
fn home(grid: &Grid, [x0, y0, ..]: [f64; 4]) -> u64 {
    u64::from(grid.tile_of(Point::new(x0, y0)).0)
}

/// Returns the tiles in which geometries begin, and the boxes around these.
#[pyfunction]
pub(crate) fn extents(py: Python<'_>, of: PyBackedBytes, geometries: Column<'_>) -> PyResult<Vec<Extent>> {
    let columns = [geometries];
    let columns = given(&columns)?;
    let found = py.detach(|| {
        let grid = grid(&of)?;
        let mut found: BTreeMap<u64, [f64; 4]> = BTreeMap::new();
        for feature in features(columns)? {
            if let Some(around) = bounds_of(&feature) {
                let all = found.entry(home(&grid, around)).or_insert(around);
                *all = joined(*all, around);
            }
        }
        Ok::<_, Failure>(found.into_iter().collect())
    });
    Ok(found?)
}

/// Returns the tiles to give each geometry to: the tiles with features near it. Extents are in order of their tiles,
/// and `largest` is the largest coordinate of all.
#[pyfunction]
pub(crate) fn tiles_near<'py>(
    py: Python<'py>,
    of: PyBackedBytes,
    geometries: Column<'py>,
    extents: Vec<Extent>,
    largest: f64,
) -> PyResult<Assignment<'py>> {
    let columns = [geometries];
    let columns = given(&columns)?;
    let by = (NEAR * largest).max(NEAR_OF_TINY);
    let found = py.detach(|| {
        let grid = grid(&of)?;
        let (mut places, mut tiles) = (Vec::new(), Vec::new());
        for (place, feature) in features(columns)?.iter().enumerate() {
            let Some(around) = bounds_of(feature) else { continue };
            let home = home(&grid, around);
            let known = extents.binary_search_by_key(&home, |(tile, _)| *tile).map(|at| extents[at].1);
            let reach = |known: [f64; 4]| (0..2).all(|i| known[i] <= around[i] && around[i + 2] <= known[i + 2]);
            if !known.is_ok_and(reach) {
                let why = "it lies outside of what is known of the features of its tile: extents are those of all features of both layers";
                return Err(Failure::Value(format!("geometry {place}: {why}")));
            }
            for (tile, _) in extents.iter().filter(|(_, extent)| meets(*extent, around, by)) {
                places.push(place as u64);
                tiles.push(*tile);
            }
        }
        Ok((places, tiles))
    });
    Ok(assignment(py, found?))
}

/// Returns the pieces that begin in a tile, from the features of either layer that were given to it. `keeps` selects
/// pieces that both layers cover, and pieces that only one of them covers.
#[pyfunction]
pub(crate) fn overlay_tile<'py>(
    py: Python<'py>,
    of: PyBackedBytes,
    at: u64,
    layers: [Layer<'py>; 2],
    largest: f64,
    keeps: [bool; 3],
) -> PyResult<Vec<TilePiece<'py>>> {
    let mut read = Vec::new();
    for (numbers, columns) in &layers {
        read.push((numbers.as_array().to_vec(), given(columns)?));
    }
    let found = py.detach(|| {
        let grid = grid(&of)?;
        let tile = tile(&grid, at)?;
        let mut builder = Builder::new();
        let mut owners = Vec::new();
        let (mut all, mut beginning) = (Covered::default(), Covered::default());
        for (layer, (numbers, columns)) in read.into_iter().enumerate() {
            for (number, feature) in numbers.into_iter().zip(features(columns)?) {
                let number = number as usize;
                if !all[layer].insert(number) {
                    return Err(Failure::Value(format!("two features have the number {number}")));
                }
                if bounds_of(&feature).is_some_and(|around| home(&grid, around) == u64::from(tile.0)) {
                    beginning[layer].insert(number);
                }
                builder.feature(&feature).map_err(Failure::value)?;
                owners.push((layer, number));
            }
        }
        // The largest coordinate determines the precision of all others: with it, as in the whole. Nothing lies beyond
        // that corner.
        builder.shape(&Shape::Point(Point::new(largest, largest))).map_err(Failure::value)?;
        let map = builder.build_with(Noding::Snap(Snap::Auto)).map_err(Failure::value)?;
        let mut pieces = pieces(&map, |feature| owners.get(feature.index()).copied());
        pieces.retain(|[left, right], _| {
            let is_here = |layer: usize, number: &usize| beginning[layer].contains(number);
            match (left.first(), right.first()) {
                (Some(first), other) => keeps[usize::from(other.is_none())] && is_here(0, first),
                (None, Some(first)) => keeps[2] && is_here(1, first),
                (None, None) => false,
            }
        });
        let outlined = |(covered, faces): (Covered, Vec<FaceKey>)| {
            let contour = of_faces(&map, faces).map_err(Failure::value)?;
            Ok((
                covered.map(|of_layer| of_layer.into_iter().collect::<Vec<_>>()),
                wkb_of_geometry(&Geometry::from(&contour)),
            ))
        };
        pieces.into_iter().map(outlined).collect::<Result<Vec<_>, _>>()
    });
    Ok(found?.into_iter().map(|([left, right], outline)| (left, right, PyBytes::new(py, &outline))).collect())
}

/// Returns true if boxes come this near each other.
fn meets(one: [f64; 4], other: [f64; 4], by: f64) -> bool {
    [0, 1].iter().all(|axis| one[*axis] <= other[axis + 2] + by && other[*axis] <= one[axis + 2] + by)
}
