//! Storage for the features of a map until its tiles are judged.

use std::borrow::Cow;
use std::io;
use twinedge_geometry::Point;
use twinedge_map::Feature;

/// Stores the features of a map, and returns the features of a tile.
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

    /// Files each feature under its tiles. `windows` has, for each tile, the corners of a box around the features to file under it.
    ///
    /// # Errors
    /// Returns the storage's errors.
    fn file(&mut self, windows: &[[Point; 2]], tiles_of: &dyn Fn(&Feature) -> Vec<usize>) -> io::Result<()>;

    /// Returns the features filed under a tile with their numbers, in order; it may return others as well.
    ///
    /// # Errors
    /// Returns the storage's errors.
    fn of_tile(&self, tile: usize) -> io::Result<Vec<(u32, Cow<'_, Feature>)>>;
}

/// Features in memory.
#[derive(Debug, Default)]
pub struct InMemory {
    features: Vec<Feature>,
    filed: Vec<Vec<u32>>,
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

    fn file(&mut self, windows: &[[Point; 2]], tiles_of: &dyn Fn(&Feature) -> Vec<usize>) -> io::Result<()> {
        self.filed = vec![Vec::new(); windows.len()];
        for (number, feature) in (0..).zip(&self.features) {
            for tile in tiles_of(feature) {
                self.filed[tile].push(number);
            }
        }
        Ok(())
    }

    fn of_tile(&self, tile: usize) -> io::Result<Vec<(u32, Cow<'_, Feature>)>> {
        let filed = self.filed.get(tile).into_iter().flatten();
        Ok(filed.map(|number| (*number, Cow::Borrowed(&self.features[*number as usize]))).collect())
    }
}
