//! Storage for the features of a map until its tiles are judged.

use std::borrow::Cow;
use std::io;
use twinedge_coverage::tile::{Cuts, Grid, Piece, Tile};
use twinedge_map::Feature;

/// Stores the features of a map, and returns the pieces of them that a tile needs.
pub trait Shelf: Send + Sync {
    /// Stores the next feature.
    ///
    /// # Errors
    /// Returns the storage's errors.
    fn put(&mut self, feature: Feature) -> io::Result<()>;

    /// Calls `show` for each feature, in order.
    ///
    /// # Errors
    /// Returns the storage's errors.
    fn each(&mut self, show: &mut dyn FnMut(&Feature)) -> io::Result<()>;

    /// Files each feature under the tiles of a grid. Afterwards there are only its pieces.
    ///
    /// # Errors
    /// Returns the storage's errors, and [`Cuts::pieces`]'s errors as others.
    fn file(&mut self, grid: &Grid, cuts: &Cuts) -> io::Result<()>;

    /// Returns the pieces filed under a tile; it may return others as well.
    ///
    /// # Errors
    /// As [`file`](Self::file).
    fn of_tile(&self, tile: Tile) -> io::Result<Vec<Cow<'_, Piece>>>;
}

/// Features in memory.
#[derive(Debug, Default)]
pub struct InMemory {
    features: Vec<Feature>,
    filed: Vec<Vec<Piece>>,
}

impl Shelf for InMemory {
    fn put(&mut self, feature: Feature) -> io::Result<()> {
        self.features.push(feature);
        Ok(())
    }

    fn each(&mut self, show: &mut dyn FnMut(&Feature)) -> io::Result<()> {
        self.features.iter().for_each(show);
        Ok(())
    }

    fn file(&mut self, grid: &Grid, cuts: &Cuts) -> io::Result<()> {
        self.filed = vec![Vec::new(); grid.len()];
        for (number, feature) in (0..).zip(std::mem::take(&mut self.features)) {
            for piece in cuts.pieces(grid, number, &feature).map_err(io::Error::other)? {
                self.filed[piece.tile().0 as usize].push(piece);
            }
        }
        Ok(())
    }

    fn of_tile(&self, tile: Tile) -> io::Result<Vec<Cow<'_, Piece>>> {
        Ok(self.filed.get(tile.0 as usize).into_iter().flatten().map(Cow::Borrowed).collect())
    }
}
