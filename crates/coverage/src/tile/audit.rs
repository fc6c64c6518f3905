//! The audit of a map by its tiles on one machine.

use super::cuts::{Cuts, Found};
use super::error::{AuditError, TileError};
use super::finish::Outcome;
use super::grid::{Grid, Tile};
use super::summary::Summary;
use crate::Limits;
use core::borrow::Borrow;
use twinedge_geometry::threads;
use twinedge_map::{BuildError, Feature};

/// Audits a map by its tiles. `features` returns the features of a tile, as assigned by [`Cuts::tiles_of`], with their numbers in
/// the map. It is called once for each tile, and a few more times if edges meet other than at vertices. `cuts` must be new.
///
/// With the feature `rayon`, tiles are audited on the threads of the current pool, with the same result. Memory holds one tile
/// per thread and the summaries. O(n log n) for the features of each tile.
///
/// ```
/// use twinedge_coverage::{CoverageRule, Limits};
/// use twinedge_map::{Feature, Shape};
/// use twinedge_coverage::tile::{Cuts, Grid, audit};
///
/// // The left one of two fields has a corner that the right one lacks.
/// let field = |ring: &[[f64; 2]]| Feature { shapes: vec![Shape::polygon(ring.to_vec())], ..Feature::default() };
/// let west = field(&[[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [2.0, 2.0], [0.0, 2.0]]);
/// let east = field(&[[2.0, 0.0], [4.0, 0.0], [4.0, 2.0], [2.0, 2.0]]);
/// let grid = Grid::new([0.0, 0.0], [4.0, 2.0], 2, 2)?;
/// let of_tile = |_| Ok::<_, std::convert::Infallible>(vec![(0, &west), (1, &east)]);
/// let outcome = audit(&grid, &Limits::default(), Cuts::new(4.0)?, of_tile)?;
/// assert!(!outcome.is_valid());
/// let coverage = outcome.coverage.unwrap();
/// assert_eq!((coverage.findings.len(), coverage.findings[0].rule), (1, CoverageRule::Mismatch));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`AuditError`]. Edges that meet too often to be cut are no error: the coverage is unknown then.
pub fn audit<F: Borrow<Feature>, E: Send>(
    grid: &Grid,
    limits: &Limits,
    mut cuts: Cuts,
    features: impl Fn(Tile) -> Result<Vec<(u32, F)>, E> + Sync,
) -> Result<Outcome, AuditError<E>> {
    let plain = Tiles {
        grid,
        of: &|tile| Ok(Summary::new(grid, tile, borrowed(&features(tile).map_err(AuditError::Features)?), limits)?),
    };
    let mut outcome = plain.merged()?;
    if !outcome.needs_cut() {
        return Ok(outcome);
    }
    if let Err(why) = complete(grid, &mut cuts, &features)? {
        outcome.uncut = Some(why);
        return Ok(outcome);
    }
    let cut = Tiles {
        grid,
        of: &|tile| {
            Ok(Summary::cut(grid, tile, borrowed(&features(tile).map_err(AuditError::Features)?), limits, &cuts)?)
        },
    };
    Ok(outcome.with_cut(cut.merged()?))
}

fn borrowed<F: Borrow<Feature>>(features: &[(u32, F)]) -> impl Iterator<Item = (u32, &Feature)> {
    features.iter().map(|(number, feature)| (*number, feature.borrow()))
}

/// Finds all cuts; the inner error means that there are too many.
fn complete<F: Borrow<Feature>, E: Send>(
    grid: &Grid,
    cuts: &mut Cuts,
    features: &(impl Fn(Tile) -> Result<Vec<(u32, F)>, E> + Sync),
) -> Result<Result<(), BuildError>, AuditError<E>> {
    while !cuts.is_complete() {
        let concerned: Vec<Tile> = grid.tiles().filter(|tile| cuts.concern(grid, *tile)).collect();
        let found = threads::map(&concerned, |tile| {
            let features = features(*tile).map_err(AuditError::Features)?;
            Ok(cuts.search(grid, *tile, borrowed(&features))?)
        });
        let found = found.into_iter().collect::<Result<Vec<Found>, AuditError<E>>>();
        match found.and_then(|found| Ok(cuts.take(found)?)) {
            Ok(()) => {}
            Err(AuditError::Tile(TileError::Build(why @ BuildError::TooManyCuts { .. }))) => return Ok(Err(why)),
            Err(error) => return Err(error),
        }
    }
    Ok(Ok(()))
}

/// The tiles of a grid, and the function that makes the summary of one.
struct Tiles<'a, E> {
    grid: &'a Grid,
    of: &'a (dyn Fn(Tile) -> Result<Summary, AuditError<E>> + Sync),
}

impl<E: Send> Tiles<'_, E> {
    fn merged(&self) -> Result<Outcome, AuditError<E>> {
        Ok(self.block([0, 0], self.grid.size())?.finish()?)
    }

    /// Returns the summary of a block of tiles by merging its halves, so that summaries have short borders.
    fn block(&self, low: [u32; 2], high: [u32; 2]) -> Result<Summary, AuditError<E>> {
        let [width, height] = [0, 1].map(|axis| high[axis] - low[axis]);
        if width <= 1 && height <= 1 {
            return (self.of)(Tile { column: low[0], row: low[1] });
        }
        let axis = usize::from(height > width);
        let (mut middle, mut from) = (high, low);
        middle[axis] = low[axis].midpoint(high[axis]);
        from[axis] = middle[axis];
        let (one, other) = threads::join(|| self.block(low, middle), || self.block(from, high));
        Ok(one?.merge(other?)?)
    }
}
