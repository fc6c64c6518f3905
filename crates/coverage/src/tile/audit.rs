//! The audit of a map by its tiles on one machine.

use super::cuts::{Cuts, Found};
use super::error::{AuditError, TileError};
use super::finish::Outcome;
use super::grid::{Grid, Node, Tile};
use super::piece::Piece;
use super::summary::Summary;
use crate::Limits;
use core::borrow::Borrow;
use twinedge_geometry::threads;
use twinedge_map::BuildError;

/// Audits a map by its tiles. `pieces` returns the pieces of a tile, as divided by [`Cuts::pieces`]. It is called once for each tile, and a
/// few more times if edges meet other than at vertices. `cuts` must be new.
///
/// With the feature `rayon`, tiles are audited on the threads of the current pool, with the same result. Memory holds one tile
/// per thread and the summaries. O(n log n) for the pieces of each tile.
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
/// let cuts = Cuts::new(4.0)?;
/// let pieces = [cuts.pieces(&grid, 0, &west)?, cuts.pieces(&grid, 1, &east)?].concat();
/// // Pieces of other tiles have no effect.
/// let outcome = audit(&grid, &Limits::default(), cuts, |_| Ok::<_, std::convert::Infallible>(pieces.clone()))?;
/// assert!(!outcome.is_valid());
/// let coverage = outcome.coverage.unwrap();
/// assert_eq!((coverage.findings.len(), coverage.findings[0].rule), (1, CoverageRule::Mismatch));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`AuditError`]. Edges that meet too often to be cut are no error: the coverage is unknown then.
pub fn audit<P: Borrow<Piece>, E: Send>(
    grid: &Grid,
    limits: &Limits,
    mut cuts: Cuts,
    pieces: impl Fn(Tile) -> Result<Vec<P>, E> + Sync,
) -> Result<Outcome, AuditError<E>> {
    let plain = Tiles {
        grid,
        of: &|tile| Ok(Summary::new(grid, tile, borrowed(&pieces(tile).map_err(AuditError::Pieces)?), limits)?),
    };
    let mut outcome = plain.merged()?;
    if !outcome.needs_cut() {
        return Ok(outcome);
    }
    if let Err(why) = complete(grid, &mut cuts, &pieces)? {
        outcome.uncut = Some(why);
        return Ok(outcome);
    }
    let cut = Tiles {
        grid,
        of: &|tile| Ok(Summary::cut(grid, tile, borrowed(&pieces(tile).map_err(AuditError::Pieces)?), limits, &cuts)?),
    };
    Ok(outcome.with_cut(cut.merged()?))
}

fn borrowed<P: Borrow<Piece>>(pieces: &[P]) -> impl Iterator<Item = &Piece> {
    pieces.iter().map(Borrow::borrow)
}

/// Finds all cuts; the inner error means that there are too many.
fn complete<P: Borrow<Piece>, E: Send>(
    grid: &Grid,
    cuts: &mut Cuts,
    pieces: &(impl Fn(Tile) -> Result<Vec<P>, E> + Sync),
) -> Result<Result<(), BuildError>, AuditError<E>> {
    while !cuts.is_complete() {
        let concerned: Vec<Tile> = grid.tiles().filter(|tile| cuts.concern(grid, *tile)).collect();
        let found = threads::map(&concerned, |tile| {
            let pieces = pieces(*tile).map_err(AuditError::Pieces)?;
            Ok(cuts.search(grid, *tile, borrowed(&pieces))?)
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
        Ok(self.of_part(0)?.finish()?)
    }

    /// Returns the summary of a part of the grid by merging its halves, so that summaries have short borders.
    fn of_part(&self, node: usize) -> Result<Summary, AuditError<E>> {
        match self.grid.node(node) {
            Node::Tile(tile) => (self.of)(tile),
            Node::Divided(_, above) => {
                let (one, other) = threads::join(|| self.of_part(node + 1), || self.of_part(above));
                Ok(one?.merge(other?)?)
            }
        }
    }
}
